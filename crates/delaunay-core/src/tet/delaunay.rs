//! The Delaunay triangulation of points in space: the data and read access to them.
//!
//! The algorithms add one `impl` block per file, see the [module map](super).

use super::cavity::Cavity3;
use super::mesh::TetMesh;
use crate::guide::Guide;
use crate::ids::{TetId, VertexId};
use crate::tri::Duplicates;
use geo_predicates::filter::Filter3;
use glam::DVec3;

/// The Delaunay triangulation of points in space, not all on one plane.
///
/// Input point `i` is vertex `i` for ever. The triangulation is unique: where five points lie on
/// one sphere, ties are broken by the coordinates alone (see [`geo_predicates::in_sphere`]), so
/// neither the order of insertion nor the numbering of the points shows in the tetrahedra. None of
/// them is flat.
///
/// Space is closed by ghost tetrahedra, one on every hull facet, which share the vertex at infinity
/// [`VertexId::GHOST`]; so every facet has a twin.
///
/// ```
/// use delaunay_core::Delaunay3;
/// use glam::DVec3;
///
/// let cube: Vec<DVec3> = (0..8).map(|i| DVec3::new((i & 1) as f64, (i >> 1 & 1) as f64, (i >> 2) as f64)).collect();
/// let delaunay = Delaunay3::build(&cube)?;
/// assert_eq!(delaunay.vertex_count(), 8);
/// assert_eq!(delaunay.tets().count(), 6);
/// assert_eq!(delaunay.hull().count(), 12);
/// # Ok::<(), delaunay_core::BuildError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Delaunay3 {
    /// By vertex slot: the ghost in front, with coordinates that are not numbers.
    pub(super) coords: Vec<DVec3>,
    pub(super) mesh: TetMesh,
    /// Quick signs, valid for `coords` and for any point that is asked about.
    pub(super) filter: Filter3,
    pub(super) duplicates: Duplicates,
    /// Ids of removed vertices, the last removed on top.
    pub(super) vacant: Vec<VertexId>,
    pub(super) vertex_count: usize,
    /// Buffers of the last insertion, kept to be filled again.
    pub(super) cavity: Cavity3,
    /// Where walks without a hint start.
    pub(super) guide: Guide,
}

impl Delaunay3 {
    /// The greatest number of points.
    pub const MAX_POINTS: usize = VertexId::LIMIT - 1;

    /// The points by vertex index.
    ///
    /// Input points come first, in input order, duplicates included. The entry of a removed vertex
    /// keeps its last value until an insertion takes the id again. `-0.0` has become `0.0`.
    #[must_use]
    pub fn points(&self) -> &[DVec3] {
        &self.coords[1..]
    }

    /// Where `v` is.
    ///
    /// # Panics
    /// When `v` is the ghost or was never a vertex.
    #[must_use]
    pub fn point(&self, v: VertexId) -> DVec3 {
        self.points()[v.index()]
    }

    /// The corners of the real tetrahedron `t`, right-handed.
    ///
    /// # Panics
    /// When there is no tetrahedron `t` or it is a ghost.
    #[must_use]
    pub fn tetrahedron(&self, t: TetId) -> [DVec3; 4] {
        self.mesh.tet_vertices(t).map(|v| self.point(v))
    }

    /// The connectivity, ghost tetrahedra included.
    #[must_use]
    pub fn mesh(&self) -> &TetMesh {
        &self.mesh
    }

    /// Gives the connectivity away and drops the rest.
    #[must_use]
    pub fn into_mesh(self) -> TetMesh {
        self.mesh
    }

    /// The tetrahedra, by id: all that are not ghosts.
    #[must_use]
    pub fn tets(&self) -> impl DoubleEndedIterator<Item = TetId> + Clone + '_ {
        self.mesh.tets().filter(|&t| !self.mesh.is_ghost_tet(t))
    }

    /// Whether `t` is a ghost: it stands on a hull facet and has no volume.
    ///
    /// # Panics
    /// When there is no tetrahedron `t`.
    #[must_use]
    pub fn is_ghost_tet(&self, t: TetId) -> bool {
        self.mesh.is_ghost_tet(t)
    }

    /// The number of vertices in the triangulation: points that are neither duplicates nor removed.
    #[must_use]
    pub fn vertex_count(&self) -> usize {
        self.vertex_count
    }

    /// The vertices in the triangulation, by id.
    pub fn vertices(&self) -> impl Iterator<Item = VertexId> + Clone + '_ {
        (0..self.points().len())
            .map(VertexId::new)
            .filter(|&v| self.contains_vertex(v))
    }

    /// Whether `v` is a vertex of the triangulation, neither the ghost nor a duplicate nor removed.
    #[must_use]
    pub fn contains_vertex(&self, v: VertexId) -> bool {
        !v.is_ghost() && self.mesh.home(v).is_some()
    }

    /// The input points that repeat another one.
    #[must_use]
    pub fn duplicates(&self) -> &Duplicates {
        &self.duplicates
    }

    /// Gives the tetrahedra dense ids, `0..tet_count`, in the order of their old ids.
    ///
    /// Returns, by old id, the new one; `None` for vacant ids. Linear.
    pub fn compact(&mut self) -> Vec<Option<TetId>> {
        self.mesh.compact()
    }

    /// Coordinates of any vertex, not numbers for the ghost.
    pub(super) fn point_of(&self, v: VertexId) -> DVec3 {
        self.coords[v.slot()]
    }
}
