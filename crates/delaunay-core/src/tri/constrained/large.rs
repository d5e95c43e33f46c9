//! Polygons with long walls: their corners are triangulated as points, in n log n time, and the part inside is taken over.
//!
//! In the Delaunay triangulation of the corners alone the base is an edge, since all other corners are on one side of it. A
//! wall edge is one too, unless something hides behind a segment; then it is made one, in that triangulation, which
//! has fewer vertices than this one. What it has inside the walls is therefore the constrained Delaunay triangulation of the
//! polygon, and that is unique.

use super::pocket::Pocket;
use super::triangulation::Constrained2;
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::tri::delaunay::Delaunay2;
use crate::tri::mesh::Face;

/// From this many wall edges on a polygon is worth a triangulation of its own.
pub(super) const LEAST_LARGE: usize = 48;

/// Polygons in polygons in polygons are not followed further down than this.
const GREATEST_DEPTH: usize = 24;

/// Label of the walls in the triangulation of the corners.
const WALL: u32 = 1;

impl Constrained2 {
    /// As [`fill_pocket`](Self::fill_pocket), for long walls.
    pub(super) fn fill_large(
        &mut self,
        pocket: &Pocket,
        slots: &[FaceId],
        depth: usize,
    ) -> HalfEdgeId {
        let of_corners = match depth < GREATEST_DEPTH {
            true => self.triangulation_of(pocket, depth),
            false => None,
        };
        match of_corners.and_then(|corners| Inside::of(corners, pocket)) {
            Some(inside) if inside.faces.len() == slots.len() => {
                self.take_over(&inside, pocket, slots)
            }
            _ => self.fill_pocket(pocket, slots),
        }
    }

    /// The corners as points, with the walls as segments.
    fn triangulation_of(&self, pocket: &Pocket, depth: usize) -> Option<Self> {
        let places = pocket.corners.iter().map(|v| self.coords[v.slot()]);
        let points: Vec<_> = places.collect();
        let mut corners = Self::of(Delaunay2::build(&points).ok()?);
        for wall in 0..pocket.walls.len() {
            let ends = [wall, wall + 1].map(|corner| corners.vertex_at(VertexId::new(corner)));
            corners.lay(ends, WALL, depth + 1).ok()?;
        }
        Some(corners)
    }

    /// Copies the faces inside into `slots` and gives the base.
    fn take_over(&mut self, inside: &Inside, pocket: &Pocket, slots: &[FaceId]) -> HalfEdgeId {
        let here = |h: HalfEdgeId| slots[inside.order[h.face().index()]].half_edge(h.corner());
        let mesh = &inside.corners.mesh;
        for &f in &inside.faces {
            let slot = slots[inside.order[f.index()]];
            let origin = mesh.face_vertices(f).map(|v| pocket.corners[v.index()]);
            let twin = f.half_edges().map(|h| match inside.is_wall(h) {
                true => here(h),
                false => here(mesh.twin(h)),
            });
            self.put_face(slot, Face { origin, twin });
        }
        let walls: Vec<HalfEdgeId> = inside.walls.iter().map(|&h| here(h)).collect();
        self.glue_walls(pocket, &walls);
        here(inside.base)
    }
}

/// The faces of the triangulation of the corners that are inside the polygon.
struct Inside {
    corners: Constrained2,
    faces: Vec<FaceId>,
    /// By face, its place in `faces`.
    order: Vec<usize>,
    /// The inner sides of the walls.
    walls: Vec<HalfEdgeId>,
    base: HalfEdgeId,
}

impl Inside {
    /// `None` when a wall is no edge.
    fn of(corners: Constrained2, pocket: &Pocket) -> Option<Self> {
        let vertex = |corner: usize| corners.vertex_at(VertexId::new(corner));
        let last = pocket.walls.len();
        let walls =
            (0..last).map(|wall| corners.mesh.find_half_edge(vertex(wall), vertex(wall + 1)));
        let walls = walls.collect::<Option<_>>()?;
        let base = corners.mesh.find_half_edge(vertex(last), vertex(0))?;
        let mut inside = Self {
            faces: Vec::new(),
            order: vec![usize::MAX; corners.mesh.face_count()],
            walls,
            base,
            corners,
        };
        inside.spread(base.face());
        Some(inside)
    }

    /// Whether the polygon ends at `h`.
    fn is_wall(&self, h: HalfEdgeId) -> bool {
        h == self.base || self.corners.is_constrained(h)
    }

    /// Finds all faces that are connected with the first one across edges that are no walls.
    fn spread(&mut self, first: FaceId) {
        let mut pending = vec![first];
        while let Some(f) = pending.pop() {
            if self.order[f.index()] != usize::MAX {
                continue;
            }
            self.order[f.index()] = self.faces.len();
            self.faces.push(f);
            for h in f.half_edges() {
                if !self.is_wall(h) {
                    pending.push(self.corners.mesh.twin(h).face());
                }
            }
        }
    }
}
