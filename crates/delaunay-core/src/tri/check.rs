//! Every invariant of the mesh and of the triangulation, as a typed [`Violation`].

use super::delaunay::Delaunay2;
use super::mesh::TriMesh;
use super::sight::precedes;
use super::subcomplex::Subcomplex2;
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use geo_predicates::{Sign, orient2d};
use thiserror::Error;

/// The first invariant found broken.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum Violation {
    /// The twin of the twin is another half-edge, or the half-edge is its own twin.
    #[error("{half_edge} has twin {twin}, whose twin is not {half_edge}")]
    TwinNotMutual {
        /// The half-edge.
        half_edge: HalfEdgeId,
        /// Its twin.
        twin: HalfEdgeId,
    },
    /// The twin does not run backwards along the same edge.
    #[error("{half_edge} and its twin {twin} do not join the same two vertices")]
    TwinEndsDiffer {
        /// The half-edge.
        half_edge: HalfEdgeId,
        /// Its twin.
        twin: HalfEdgeId,
    },
    /// Two corners of a face are the same vertex.
    #[error("{face} has a vertex twice")]
    RepeatedCorner {
        /// The face.
        face: FaceId,
    },
    /// The outgoing half-edge of a vertex leaves another one, or is missing, or does not reach all
    /// faces round the vertex.
    #[error("the outgoing half-edge of {vertex} is missing or does not lead round all its faces")]
    Outgoing {
        /// The vertex.
        vertex: VertexId,
    },
    /// A face cannot be reached from face 0.
    #[error("{face} is not connected with f0")]
    Disconnected {
        /// The face.
        face: FaceId,
    },
    /// The number of faces is not twice the number of vertices less two.
    #[error("{vertices} vertices have {faces} faces, ghosts included, instead of 2 n - 2")]
    Euler {
        /// Real vertices with a face.
        vertices: usize,
        /// Faces, ghosts included.
        faces: usize,
    },
    /// The corners of a triangle do not turn counterclockwise.
    #[error("the corners of {face} do not turn counterclockwise")]
    Orientation {
        /// The triangle.
        face: FaceId,
    },
    /// A hull edge and the next one turn clockwise or go back.
    #[error("the hull is not convex where {half_edge} ends")]
    HullNotConvex {
        /// The first of the two hull half-edges.
        half_edge: HalfEdgeId,
    },
    /// The vertex across an edge is inside the circumcircle, ties broken as everywhere.
    #[error("{vertex} is inside the circumcircle of the face of {half_edge}")]
    NotDelaunay {
        /// The half-edge of the triangle.
        half_edge: HalfEdgeId,
        /// The vertex across it.
        vertex: VertexId,
    },
}

impl TriMesh {
    /// Checks that twins are mutual and run along the same edge, that no face has a corner twice, and
    /// that the outgoing half-edge of each vertex leads round all its faces.
    ///
    /// Takes linear time.
    ///
    /// # Errors
    /// The first [`Violation`], by id.
    pub fn check(&self) -> Result<(), Violation> {
        self.check_glue()?;
        self.check_outgoing(VertexId::GHOST)
    }

    /// As [`check`](Self::check), but that the infinite vertex may have several rings of ghosts.
    pub(super) fn check_inside(&self) -> Result<(), Violation> {
        self.check_glue()?;
        self.check_outgoing(VertexId::new(0))
    }

    fn check_glue(&self) -> Result<(), Violation> {
        self.faces().try_for_each(|f| self.check_corners(f))?;
        self.half_edges().try_for_each(|h| self.check_twin(h))
    }

    fn check_corners(&self, face: FaceId) -> Result<(), Violation> {
        let [a, b, c] = self.face_vertices(face);
        require(
            a != b && b != c && c != a,
            Violation::RepeatedCorner { face },
        )
    }

    fn check_twin(&self, half_edge: HalfEdgeId) -> Result<(), Violation> {
        let twin = self.twin(half_edge);
        let exists = twin.face().index() < self.face_count() && twin.corner() < 3;
        require(
            exists && twin != half_edge && self.twin(twin) == half_edge,
            Violation::TwinNotMutual { half_edge, twin },
        )?;
        require(
            self.origin(twin) == self.target(half_edge)
                && self.target(twin) == self.origin(half_edge),
            Violation::TwinEndsDiffer { half_edge, twin },
        )
    }

    /// Checks the outgoing half-edges of the vertices from `first` on.
    fn check_outgoing(&self, first: VertexId) -> Result<(), Violation> {
        let mut degrees = vec![0; self.outgoing.len()];
        for h in self.half_edges() {
            let vertex = self.origin(h);
            let degree = degrees.get_mut(vertex.slot());
            *degree.ok_or(Violation::Outgoing { vertex })? += 1;
        }
        for (slot, degree) in degrees.into_iter().enumerate().skip(first.slot()) {
            let vertex = VertexId::from_slot(slot);
            let broken = Violation::Outgoing { vertex };
            if let Some(h) = self.outgoing(vertex) {
                let exists = h.face().index() < self.face_count() && h.corner() < 3;
                require(exists && self.origin(h) == vertex, broken)?;
            }
            require(self.around(vertex).count() == degree, broken)?;
        }
        Ok(())
    }
}

impl Delaunay2 {
    /// Checks every invariant: those of the [mesh](TriMesh::check), one connected sphere of 2 n - 2
    /// faces, counterclockwise triangles, a convex hull, and empty circumcircles with the tie rule.
    ///
    /// Together they say that this is *the* Delaunay triangulation of its vertices. Takes linear time.
    ///
    /// # Errors
    /// The first [`Violation`], in the order above, then by id.
    pub fn check(&self) -> Result<(), Violation> {
        self.mesh.check()?;
        self.check_sphere()?;
        self.faces().try_for_each(|f| self.check_orientation(f))?;
        self.check_hull()?;
        let mut half_edges = self.mesh.half_edges();
        half_edges.try_for_each(|h| self.check_empty_circle(h))
    }

    fn check_sphere(&self) -> Result<(), Violation> {
        let vertices = self.vertices().count();
        let faces = self.mesh.face_count();
        require(
            faces + 2 == 2 * vertices,
            Violation::Euler { vertices, faces },
        )?;
        let mut seen = vec![false; faces];
        let mut pending = vec![FaceId::new(0)];
        while let Some(f) = pending.pop() {
            if !std::mem::replace(&mut seen[f.index()], true) {
                pending.extend(f.half_edges().map(|h| self.mesh.twin(h).face()));
            }
        }
        let missed = self.mesh.faces().find(|f| !seen[f.index()]);
        missed.map_or(Ok(()), |face| Err(Violation::Disconnected { face }))
    }

    fn check_orientation(&self, face: FaceId) -> Result<(), Violation> {
        let [a, b, c] = self.triangle(face);
        require(
            orient2d(a, b, c) == Sign::Positive,
            Violation::Orientation { face },
        )
    }

    fn check_hull(&self) -> Result<(), Violation> {
        let hull: Vec<HalfEdgeId> = self.hull().collect();
        let following = hull.iter().skip(1).chain(hull.first());
        for (&half_edge, &next) in hull.iter().zip(following) {
            let [a, b] = [half_edge, next].map(|h| self.point_of(self.mesh.origin(h)));
            let c = self.point_of(self.mesh.target(next));
            let straight_on = precedes(a, b) == precedes(b, c);
            let convex = match orient2d(a, b, c) {
                Sign::Positive => true,
                Sign::Zero => straight_on,
                Sign::Negative => false,
            };
            require(convex, Violation::HullNotConvex { half_edge })?;
        }
        Ok(())
    }

    fn check_empty_circle(&self, half_edge: HalfEdgeId) -> Result<(), Violation> {
        let vertex = self.mesh.apex(self.mesh.twin(half_edge));
        let corners = self.mesh.face_vertices(half_edge.face());
        if vertex.is_ghost() || corners.contains(&VertexId::GHOST) {
            return Ok(());
        }
        let sight = self.sight(self.point_of(vertex));
        require(
            !sight.exact_conflict(corners),
            Violation::NotDelaunay { half_edge, vertex },
        )
    }
}

impl Subcomplex2 {
    /// Checks every invariant: those of the [mesh](TriMesh::check), except that the infinite vertex may have several rings
    /// of ghosts; counterclockwise triangles; and across every edge inside an empty circumcircle, with the tie rule.
    ///
    /// Takes linear time.
    ///
    /// # Errors
    /// The first [`Violation`], in the order above, then by id.
    pub fn check(&self) -> Result<(), Violation> {
        let mesh = self.mesh();
        mesh.check_inside()?;
        for face in self.faces() {
            let [a, b, c] = self.triangle(face);
            require(
                orient2d(a, b, c) == Sign::Positive,
                Violation::Orientation { face },
            )?;
        }
        let inner = self.faces().flat_map(FaceId::half_edges);
        for half_edge in inner.filter(|&h| !self.is_boundary(h)) {
            let vertex = mesh.apex(mesh.twin(half_edge));
            require(
                !self.in_conflict(self.point(vertex), half_edge.face()),
                Violation::NotDelaunay { half_edge, vertex },
            )?;
        }
        Ok(())
    }
}

fn require(holds: bool, violation: Violation) -> Result<(), Violation> {
    if holds { Ok(()) } else { Err(violation) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec2;

    fn kite() -> Delaunay2 {
        let points = [[0.0, 0.0], [3.0, -1.0], [4.0, 0.0], [3.0, 1.0]];
        Delaunay2::build(&points.map(DVec2::from)).unwrap()
    }

    /// The half-edge between the two triangles of the kite.
    fn diagonal(delaunay: &Delaunay2) -> HalfEdgeId {
        let inner = |h: &HalfEdgeId| {
            [*h, delaunay.mesh.twin(*h)]
                .iter()
                .all(|h| !delaunay.is_ghost_face(h.face()))
        };
        delaunay.mesh.half_edges().find(inner).unwrap()
    }

    #[test]
    fn a_built_triangulation_is_sound() {
        assert_eq!(kite().check(), Ok(()));
    }

    #[test]
    fn a_twin_that_points_elsewhere_is_found() {
        let mut broken = kite();
        let h = diagonal(&broken);
        broken.mesh.faces[h.face().index()].twin[h.corner()] = h;
        let found = broken.check();
        assert!(
            matches!(found, Err(Violation::TwinNotMutual { .. })),
            "{found:?}"
        );
    }

    #[test]
    fn a_moved_vertex_breaks_orientation_hull_or_circle() {
        let moved = |v: usize, p: [f64; 2]| {
            let mut broken = kite();
            broken.coords[v + 1] = DVec2::from(p);
            broken.check()
        };
        let flipped = moved(2, [-4.0, 0.0]);
        assert!(
            matches!(flipped, Err(Violation::Orientation { .. })),
            "{flipped:?}"
        );
        let dented = moved(1, [2.0, 0.1]);
        assert!(
            matches!(dented, Err(Violation::HullNotConvex { .. })),
            "{dented:?}"
        );
        let crowded = moved(0, [2.9, 0.0]);
        assert!(
            matches!(crowded, Err(Violation::NotDelaunay { .. })),
            "{crowded:?}"
        );
        let far = moved(0, [-90.0, 0.0]);
        assert_eq!(far, Ok(()));
    }

    #[test]
    fn a_lost_outgoing_half_edge_is_found() {
        let mut broken = kite();
        let vertex = VertexId::new(2);
        broken.mesh.forget_vertex(vertex);
        assert_eq!(broken.check(), Err(Violation::Outgoing { vertex }));
    }

    #[test]
    fn two_separate_spheres_are_found() {
        let mut broken = kite();
        let [a, b, c] = [0, 1, 2].map(VertexId::new);
        let front = broken.mesh.push_face([a, b, c]);
        let back = broken.mesh.push_face([a, c, b]);
        for (i, j) in [(0, 2), (1, 1), (2, 0)] {
            broken.mesh.glue(front.half_edge(i), back.half_edge(j));
        }
        // Each vertex has two fans of faces now, and only one is reached.
        let found = broken.check();
        assert!(
            matches!(found, Err(Violation::Outgoing { .. })),
            "{found:?}"
        );
    }

    #[test]
    fn a_vertex_too_many_breaks_the_count_of_faces() {
        let mut broken = kite();
        let more = [4, 5, 6].map(VertexId::new);
        broken.coords.extend([DVec2::ZERO; 3]);
        let [a, b, c] = more;
        let front = broken.mesh.push_face([a, b, c]);
        let back = broken.mesh.push_face([a, c, b]);
        for (i, j) in [(0, 2), (1, 1), (2, 0)] {
            broken.mesh.glue(front.half_edge(i), back.half_edge(j));
        }
        let slots = broken.coords.len();
        broken.mesh.index_vertices(slots);
        let (vertices, faces) = (7, 8);
        assert_eq!(broken.check(), Err(Violation::Euler { vertices, faces }));
    }

    #[test]
    fn violations_name_the_elements() {
        let [half_edge, twin] = [4, 9].map(HalfEdgeId::new);
        let (face, vertex) = (FaceId::new(2), VertexId::new(7));
        insta::assert_snapshot!(Violation::TwinNotMutual { half_edge, twin }, @"h4 has twin h9, whose twin is not h4");
        insta::assert_snapshot!(Violation::TwinEndsDiffer { half_edge, twin }, @"h4 and its twin h9 do not join the same two vertices");
        insta::assert_snapshot!(Violation::RepeatedCorner { face }, @"f2 has a vertex twice");
        insta::assert_snapshot!(Violation::Outgoing { vertex }, @"the outgoing half-edge of v7 is missing or does not lead round all its faces");
        insta::assert_snapshot!(Violation::Disconnected { face }, @"f2 is not connected with f0");
        insta::assert_snapshot!(Violation::Euler { vertices: 4, faces: 7 }, @"4 vertices have 7 faces, ghosts included, instead of 2 n - 2");
        insta::assert_snapshot!(Violation::Orientation { face }, @"the corners of f2 do not turn counterclockwise");
        insta::assert_snapshot!(Violation::HullNotConvex { half_edge }, @"the hull is not convex where h4 ends");
        insta::assert_snapshot!(Violation::NotDelaunay { half_edge, vertex }, @"v7 is inside the circumcircle of the face of h4");
    }
}
