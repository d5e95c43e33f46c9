//! Insertion of one point: its triangle or edge is divided, and flips restore the empty circles (Lawson 1977).

use super::triangulation::Constrained2;
use crate::error::InsertError;
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::tri::cavity::{Cavity, RimEdge};
use crate::tri::delaunay::Delaunay2;
use crate::tri::insert::Inserted;
use crate::tri::locate::Location;
use geo_predicates::in_circle_perturbed;
use glam::DVec2;

impl Constrained2 {
    /// Makes `p` a vertex, located by a walk from `hint`, a vertex near it. A segment that it is on is divided.
    ///
    /// `None` when `p` is outside the convex hull; nothing has changed then. Takes the time of the walk and usually of a few
    /// flips.
    ///
    /// # Errors
    /// [`InsertError`] when a coordinate of `p` is not accepted or the ids are used up; nothing has changed then.
    pub fn insert_near(
        &mut self,
        p: DVec2,
        hint: VertexId,
    ) -> Result<Option<Inserted>, InsertError> {
        let location = self.locate_near(p, hint)?;
        if self.coords.len() > Delaunay2::MAX_POINTS {
            return Err(InsertError::TooManyPoints {
                limit: Delaunay2::MAX_POINTS,
            });
        }
        Ok(match location {
            Location::Outside(_) => None,
            Location::Vertex(v) => Some(Inserted::Duplicate(v)),
            Location::Face(f) => Some(Inserted::New(self.divide_face(p, f))),
            Location::Edge(h) => Some(Inserted::New(self.divide_edge(p, h))),
        })
    }

    fn divide_face(&mut self, p: DVec2, f: FaceId) -> VertexId {
        let rim = f.half_edges().map(|h| self.rim_edge(h));
        let (v, star) = self.put_star(p, &[f], &rim);
        self.restore(star.iter().map(|f| f.half_edge(1)).collect());
        v
    }

    /// Puts `p` on the edge of `h`; its halves carry the edge's label.
    fn divide_edge(&mut self, p: DVec2, h: HalfEdgeId) -> VertexId {
        let label = self.labels[h.index()];
        let (twin, end, start) = (self.mesh.twin(h), self.mesh.target(h), self.mesh.origin(h));
        let rim = [h.next(), h.prev(), twin.next(), twin.prev()].map(|side| self.rim_edge(side));
        let (v, star) = self.put_star(p, &[h.face(), twin.face()], &rim);
        if label != 0 {
            // The first face of the star begins where the edge ended, and the third one where it started.
            for half in [star[0], star[2]].map(|f| f.half_edge(0)) {
                self.put_label(half, label);
            }
            self.paths.note(vec![start, v, end]);
        }
        self.restore(star.iter().map(|f| f.half_edge(1)).collect());
        v
    }

    fn rim_edge(&self, h: HalfEdgeId) -> RimEdge {
        RimEdge {
            origin: self.mesh.origin(h),
            outer: self.mesh.twin(h),
        }
    }

    /// Replaces faces by the star of a new vertex at `p`; gives it, with the rim on the half-edges 1 of its faces.
    fn put_star(&mut self, p: DVec2, faces: &[FaceId], rim: &[RimEdge]) -> (VertexId, Vec<FaceId>) {
        let v = VertexId::from_slot(self.coords.len());
        self.coords.push(p + DVec2::ZERO);
        let mut cavity = Cavity::default();
        cavity.assign(faces, rim);
        self.mesh.fill(&mut cavity, v);
        self.mesh.point_at_star(cavity.faces());
        self.labels.resize(4 * self.mesh.face_count(), 0);
        for f in cavity.faces() {
            let [before, on_rim, after] = f.half_edges();
            self.labels[before.index()] = 0;
            self.labels[on_rim.index()] = self.labels[self.mesh.twin(on_rim).index()];
            self.labels[after.index()] = 0;
        }
        (v, cavity.faces().to_vec())
    }

    /// Flips edges without segments whose circles are not empty, the suspects and what becomes suspect, until there are none.
    ///
    /// Each flip lowers the surface over the plane that the triangles have when their vertices are lifted to the
    /// paraboloid, so no edge comes back and the flips end.
    pub(super) fn restore(&mut self, mut suspects: Vec<HalfEdgeId>) {
        while let Some(h) = suspects.pop() {
            if !self.is_constrained(h) && self.is_in_circle(h) {
                suspects.extend(self.flip(h));
            }
        }
    }

    /// Whether the vertex across the edge of `h` is inside the circle of its face, ties broken; never for ghosts.
    pub(super) fn is_in_circle(&self, h: HalfEdgeId) -> bool {
        let corners = [
            self.mesh.origin(h),
            self.mesh.target(h),
            self.mesh.apex(h),
            self.mesh.apex(self.mesh.twin(h)),
        ];
        if corners.iter().any(|v| v.is_ghost()) {
            return false;
        }
        let [a, b, c, d] = corners.map(|v| self.coords[v.slot()]);
        in_circle_perturbed(a, b, c, d)
    }

    /// Turns the edge of `h` into the other diagonal; labels go with their edges. Gives the sides of the quadrilateral.
    fn flip(&mut self, h: HalfEdgeId) -> [HalfEdgeId; 4] {
        let labels = self
            .mesh
            .quadrilateral(h)
            .map(|side| self.labels[side.index()]);
        let sides = self.mesh.flip(h);
        for (side, label) in sides.into_iter().zip(labels) {
            self.labels[side.index()] = label;
        }
        for diagonal in [sides[0].next(), sides[2].next()] {
            self.labels[diagonal.index()] = 0;
        }
        sides
    }
}
