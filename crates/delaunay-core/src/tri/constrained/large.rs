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
use glam::DVec2;

/// From this many wall edges on a polygon is worth a triangulation of its own.
const LEAST_LARGE: usize = 48;

/// From this many wall edges on both sides they are worth a thread each.
const LEAST_SHARED: usize = 4096;

/// Polygons in polygons in polygons are not followed further down than this.
const GREATEST_DEPTH: usize = 24;

/// Label of the walls in the triangulation of the corners.
const WALL: u32 = 1;

impl Constrained2 {
    /// What is inside two polygons with long walls, found at the same time where both are very long; `None` for those without.
    pub(super) fn insides(&self, pockets: [&Pocket; 2], depth: usize) -> [Option<Inside>; 2] {
        let inside = |pocket: &Pocket| match pocket.walls.len() < LEAST_LARGE {
            false if depth < GREATEST_DEPTH => Inside::of(self, pocket, depth),
            _ => None,
        };
        let [right, left] = pockets;
        let shorter = right.walls.len().min(left.walls.len());
        match shorter < LEAST_SHARED {
            true => [inside(right), inside(left)],
            false => rayon::join(|| inside(right), || inside(left)).into(),
        }
    }

    /// Fills a polygon with what is inside, if that is known, and gives the base.
    pub(super) fn fill(
        &mut self,
        pocket: &Pocket,
        slots: &[FaceId],
        inside: Option<&Inside>,
    ) -> HalfEdgeId {
        match inside {
            Some(inside) if inside.faces.len() == slots.len() => {
                self.take_over(inside, pocket, slots)
            }
            _ => self.fill_pocket(pocket, slots),
        }
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
pub(super) struct Inside {
    corners: Constrained2,
    faces: Vec<FaceId>,
    /// By face, its place in `faces`.
    order: Vec<usize>,
    /// The inner sides of the walls.
    walls: Vec<HalfEdgeId>,
    base: HalfEdgeId,
}

impl Inside {
    /// `None` when the corners have no triangulation with the walls as edges.
    fn of(constrained: &Constrained2, pocket: &Pocket, depth: usize) -> Option<Self> {
        let places = pocket.corners.iter().map(|v| constrained.coords[v.slot()]);
        let points: Vec<DVec2> = places.collect();
        let mut corners = Constrained2::of(Delaunay2::build(&points).ok()?);
        let walls = corners.walls(pocket.walls.len(), depth)?;
        let ends = [pocket.walls.len(), 0].map(|corner| corners.vertex_at(VertexId::new(corner)));
        let base = corners.mesh.find_half_edge(ends[0], ends[1])?;
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

impl Constrained2 {
    /// Makes edges of the walls of a polygon whose corners the points are; gives their inner sides.
    fn walls(&mut self, count: usize, depth: usize) -> Option<Vec<HalfEdgeId>> {
        let mut walls = vec![HalfEdgeId::NONE; count];
        // Most are there already and join corners with numbers one after the other.
        for h in self.mesh.half_edges() {
            let [start, end] = [self.mesh.origin(h), self.mesh.target(h)].map(VertexId::index);
            if start < count && end == start + 1 {
                walls[start] = h;
            }
        }
        let (known, unknown): (Vec<usize>, Vec<usize>) =
            (0..count).partition(|&wall| walls[wall] != HalfEdgeId::NONE);
        for wall in known {
            self.put_label(walls[wall], WALL);
        }
        for &wall in &unknown {
            self.lay(self.corners_of(wall), WALL, depth + 1).ok()?;
        }
        if !unknown.is_empty() {
            // Laying edges has given new numbers to others.
            for (wall, h) in walls.iter_mut().enumerate() {
                let [start, end] = self.corners_of(wall);
                *h = self.mesh.find_half_edge(start, end)?;
            }
        }
        Some(walls)
    }

    /// The ends of a wall.
    fn corners_of(&self, wall: usize) -> [VertexId; 2] {
        [wall, wall + 1].map(|corner| self.vertex_at(VertexId::new(corner)))
    }
}
