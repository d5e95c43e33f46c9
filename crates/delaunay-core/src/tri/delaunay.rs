//! The Delaunay triangulation of points in the plane: the data and read access to them.
//!
//! The algorithms add one `impl` block per file, see the [module map](super).

use super::cavity::Cavity;
use super::duplicates::Duplicates;
use super::mesh::TriMesh;
use super::sight::Sight;
use crate::guide::Guide;
use crate::ids::{FaceId, VertexId};
use geo_predicates::filter::Filter2;
use glam::DVec2;

/// The Delaunay triangulation of points in the plane, not all on one line.
///
/// Input point `i` is vertex `i` for ever. The triangulation is unique: where four points lie on
/// one circle, ties are broken by the coordinates alone (see [`geo_predicates::in_circle`]), so
/// neither the order of insertion nor the numbering of the points shows in the triangles.
///
/// The plane is closed by ghost faces, one on every hull edge, which share the vertex at infinity
/// [`VertexId::GHOST`]; so every half-edge has a twin. With `n` vertices there are `2 n - 2` faces,
/// ghosts included.
///
/// ```
/// use delaunay_core::Delaunay2;
/// use glam::DVec2;
///
/// let points = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [1.0, 1.0]];
/// let delaunay = Delaunay2::build(&points.map(DVec2::from))?;
/// assert_eq!(delaunay.vertex_count(), 5);
/// assert_eq!(delaunay.faces().count(), 4);
/// assert_eq!(delaunay.hull().count(), 4);
/// # Ok::<(), delaunay_core::BuildError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Delaunay2 {
    /// By vertex slot: the ghost in front, with coordinates that are not numbers.
    pub(super) coords: Vec<DVec2>,
    pub(super) mesh: TriMesh,
    /// Quick signs, valid for `coords` and for any point that is asked about.
    pub(super) filter: Filter2,
    pub(super) duplicates: Duplicates,
    /// Ids of removed vertices, the last removed on top.
    pub(super) vacant: Vec<VertexId>,
    /// Buffers of the last insertion, kept to be filled again.
    pub(super) cavity: Cavity,
    /// Where walks without a hint start.
    pub(super) guide: Guide,
}

impl Delaunay2 {
    /// The greatest number of points: with more, 32 bits would not number all half-edges.
    pub const MAX_POINTS: usize = FaceId::LIMIT / 2;

    /// The points by vertex index.
    ///
    /// Input points come first, in input order, duplicates included. The entry of a removed vertex
    /// keeps its last value until an insertion takes the id again. `-0.0` has become `0.0`.
    #[must_use]
    pub fn points(&self) -> &[DVec2] {
        &self.coords[1..]
    }

    /// Where `v` is.
    ///
    /// # Panics
    /// When `v` is the ghost or was never a vertex.
    #[must_use]
    pub fn point(&self, v: VertexId) -> DVec2 {
        self.points()[v.index()]
    }

    /// The corners of the real face `f`, counterclockwise.
    ///
    /// # Panics
    /// When there is no face `f` or it is a ghost.
    #[must_use]
    pub fn triangle(&self, f: FaceId) -> [DVec2; 3] {
        self.mesh.face_vertices(f).map(|v| self.point(v))
    }

    /// The connectivity, ghost faces included.
    #[must_use]
    pub fn mesh(&self) -> &TriMesh {
        &self.mesh
    }

    /// The triangles, by id: all faces that are not ghosts.
    pub fn faces(&self) -> impl Iterator<Item = FaceId> + Clone + '_ {
        self.mesh.faces().filter(|&f| !self.mesh.is_ghost_face(f))
    }

    /// Whether `f` is a ghost face: it stands on a hull edge and has no area.
    ///
    /// # Panics
    /// When there is no face `f`.
    #[must_use]
    pub fn is_ghost_face(&self, f: FaceId) -> bool {
        self.mesh.is_ghost_face(f)
    }

    /// The number of vertices in the triangulation: points that are neither duplicates nor removed.
    #[must_use]
    pub fn vertex_count(&self) -> usize {
        self.mesh.face_count() / 2 + 1
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
        !v.is_ghost() && self.mesh.outgoing(v).is_some()
    }

    /// The input points that repeat another one.
    #[must_use]
    pub fn duplicates(&self) -> &Duplicates {
        &self.duplicates
    }

    /// What `p` sees. It may be any accepted point, unless the filter is special: then one of those
    /// that the filter was made for.
    #[inline(always)]
    pub(super) fn sight(&self, p: DVec2) -> Sight<'_> {
        Sight::new(&self.coords, self.filter, p)
    }

    /// Coordinates of any vertex, not numbers for the ghost.
    pub(super) fn point_of(&self, v: VertexId) -> DVec2 {
        self.coords[v.slot()]
    }
}
