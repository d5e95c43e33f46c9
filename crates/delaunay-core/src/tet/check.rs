//! Every invariant of the mesh and of the triangulation, as a typed [`Violation3`].

use super::delaunay::Delaunay3;
use super::mesh::TetMesh;
use super::sight::Sight3;
use crate::ids::{FacetId, TetId, VertexId};
use geo_predicates::{Sign, orient3d};
use glam::DVec3;
use thiserror::Error;

/// The first invariant found broken.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum Violation3 {
    /// Two corners of a tetrahedron are the same vertex.
    #[error("{tet} has a vertex twice")]
    RepeatedCorner {
        /// The tetrahedron.
        tet: TetId,
    },
    /// The vertex at infinity is a corner but not corner 3.
    #[error("{tet} has the vertex at infinity in the wrong place")]
    GhostCorner {
        /// The tetrahedron.
        tet: TetId,
    },
    /// The twin of the twin is another facet, or the facet is its own twin.
    #[error("{facet} has twin {twin}, whose twin is not {facet}")]
    TwinNotMutual {
        /// The facet.
        facet: FacetId,
        /// Its twin.
        twin: FacetId,
    },
    /// The twin does not have the same corners in the other sense of rotation.
    #[error("{facet} and its twin {twin} do not have the same corners, turning against each other")]
    TwinCornersDiffer {
        /// The facet.
        facet: FacetId,
        /// Its twin.
        twin: FacetId,
    },
    /// The home of a vertex does not have it as a corner, or is missing.
    #[error("the home of {vertex} is missing or has no such corner")]
    Home {
        /// The vertex.
        vertex: VertexId,
    },
    /// The tetrahedra round a vertex are not all connected through facets at the vertex.
    #[error("the tetrahedra round {vertex} are not connected")]
    BrokenStar {
        /// The vertex.
        vertex: VertexId,
    },
    /// The numbers of vertices, edges, facets and tetrahedra, ghosts included, do not make a sphere.
    #[error(
        "{vertices} vertices, {edges} edges, {facets} facets and {tets} tetrahedra do not close space"
    )]
    Euler {
        /// Vertices, the ghost included.
        vertices: usize,
        /// Edges, those to the ghost included.
        edges: usize,
        /// Facets, those of ghosts included.
        facets: usize,
        /// Tetrahedra, ghosts included.
        tets: usize,
    },
    /// The corners of a tetrahedron are left-handed or flat.
    #[error("the corners of {tet} are not right-handed")]
    Orientation {
        /// The tetrahedron.
        tet: TetId,
    },
    /// A vertex lies strictly outside a hull facet that shares an edge with one of its own.
    #[error("the hull is not convex: {vertex} is outside the hull facet of {tet}")]
    HullNotConvex {
        /// The ghost on the facet.
        tet: TetId,
        /// The vertex outside.
        vertex: VertexId,
    },
    /// The vertex across a facet is inside the circumsphere, ties broken as everywhere.
    #[error("{vertex} is inside the circumsphere of the tetrahedron of {facet}")]
    NotDelaunay {
        /// The facet of the tetrahedron.
        facet: FacetId,
        /// The vertex across it.
        vertex: VertexId,
    },
}

impl TetMesh {
    /// Checks that twins are mutual and have the same corners, that no tetrahedron has a corner twice or
    /// the ghost in a wrong place, and that every vertex has a home and one connected star.
    ///
    /// Takes linear time.
    ///
    /// # Errors
    /// The first [`Violation3`], by id.
    pub fn check(&self) -> Result<(), Violation3> {
        self.tets().try_for_each(|t| self.check_corners(t))?;
        self.facets().try_for_each(|f| self.check_twin(f))?;
        self.check_stars()
    }

    fn check_corners(&self, tet: TetId) -> Result<(), Violation3> {
        let corners = self.tet_vertices(tet);
        let repeated = (0..4).any(|i| corners[..i].contains(&corners[i]));
        require(!repeated, Violation3::RepeatedCorner { tet })?;
        let misplaced = corners[..3].iter().any(|v| v.is_ghost());
        require(!misplaced, Violation3::GhostCorner { tet })
    }

    fn check_twin(&self, facet: FacetId) -> Result<(), Violation3> {
        let twin = self.twin(facet);
        let exists = self.contains_tet(twin.tet());
        require(
            exists && twin != facet && self.twin(twin) == facet,
            Violation3::TwinNotMutual { facet, twin },
        )?;
        let [a, b, c] = self.facet_vertices(facet);
        let others = self.facet_vertices(twin);
        let same = [[a, c, b], [c, b, a], [b, a, c]].contains(&others);
        require(same, Violation3::TwinCornersDiffer { facet, twin })
    }

    fn check_stars(&self) -> Result<(), Violation3> {
        let mut degrees = vec![0_usize; self.homes.len()];
        for vertex in self.tets().flat_map(|t| self.tet_vertices(t)) {
            let degree = degrees.get_mut(vertex.slot());
            *degree.ok_or(Violation3::Home { vertex })? += 1;
        }
        for (slot, degree) in degrees.into_iter().enumerate() {
            let vertex = VertexId::from_slot(slot);
            let home = self.home(vertex);
            let at_home = home.map_or(degree == 0, |t| {
                self.contains_tet(t) && self.corner_of(t, vertex).is_some()
            });
            require(at_home, Violation3::Home { vertex })?;
            let connected = self.star(vertex).count() == degree;
            require(connected, Violation3::BrokenStar { vertex })?;
        }
        Ok(())
    }

    /// Vertices, edges, facets and tetrahedra, ghosts included.
    fn counts(&self) -> [usize; 4] {
        let vertices = (0..self.homes.len()).map(VertexId::from_slot);
        let vertices = vertices.filter(|&v| self.home(v).is_some());
        let (mut count, mut ends) = (0, 0);
        for v in vertices {
            count += 1;
            ends += self.neighbors(v).count();
        }
        [count, ends / 2, 2 * self.tet_count(), self.tet_count()]
    }
}

impl TetMesh {
    /// Checks the mesh, the Euler characteristic of a closed space with `vertex_count` real vertices, and
    /// that with the vertices at `coords`, by slot, the tetrahedra are right-handed and the hull convex.
    pub(super) fn check_embedding(
        &self,
        coords: &[DVec3],
        vertex_count: usize,
    ) -> Result<(), Violation3> {
        self.check()?;
        let [vertices, edges, facets, tets] = self.counts();
        require(
            vertices + facets == edges + tets && vertices == vertex_count + 1,
            Violation3::Euler {
                vertices,
                edges,
                facets,
                tets,
            },
        )?;
        let mut real = self.tets().filter(|&t| !self.is_ghost_tet(t));
        real.try_for_each(|t| self.check_orientation(t, coords))?;
        let mut ghosts = self.star(VertexId::GHOST);
        ghosts.try_for_each(|t| self.check_hull(t, coords))
    }

    fn check_orientation(&self, tet: TetId, coords: &[DVec3]) -> Result<(), Violation3> {
        let [a, b, c, d] = self.tet_vertices(tet).map(|v| coords[v.slot()]);
        require(
            orient3d(a, b, c, d) == Sign::Positive,
            Violation3::Orientation { tet },
        )
    }

    fn check_hull(&self, tet: TetId, coords: &[DVec3]) -> Result<(), Violation3> {
        let [a, b, c, _] = self.tet_vertices(tet).map(|v| coords[v.slot()]);
        for corner in 0..3 {
            let vertex = self.apex(self.twin(tet.facet(corner)));
            let outside = orient3d(a, b, c, coords[vertex.slot()]) == Sign::Positive;
            require(!outside, Violation3::HullNotConvex { tet, vertex })?;
        }
        Ok(())
    }
}

impl Delaunay3 {
    /// Checks every invariant: those of the [mesh](TetMesh::check), the Euler characteristic of a closed
    /// space, right-handed tetrahedra, a convex hull, and empty circumspheres with the tie rule.
    ///
    /// Together they say that this is *the* Delaunay triangulation of its vertices. Takes linear time.
    ///
    /// # Errors
    /// The first [`Violation3`], in the order above, then by id.
    pub fn check(&self) -> Result<(), Violation3> {
        self.mesh.check_embedding(&self.coords, self.vertex_count)?;
        let mut facets = self.tets().flat_map(TetId::facets);
        facets.try_for_each(|f| self.check_empty_sphere(f))
    }

    fn check_empty_sphere(&self, facet: FacetId) -> Result<(), Violation3> {
        let vertex = self.mesh.apex(self.mesh.twin(facet));
        if vertex.is_ghost() {
            return Ok(());
        }
        let sight = Sight3::new(self.coords.as_slice(), self.filter, self.point_of(vertex));
        require(
            !sight.in_real_conflict(self.mesh.tet_vertices(facet.tet())),
            Violation3::NotDelaunay { facet, vertex },
        )
    }
}

fn require(holds: bool, violation: Violation3) -> Result<(), Violation3> {
    if holds { Ok(()) } else { Err(violation) }
}
