//! The constrained Delaunay triangulation: the data and read access to them.

use super::corridor::Corridor;
use super::paths::Paths;
use super::pocket::Pocket;
use crate::guide::Guide;
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::tri::cavity::Cavity;
use crate::tri::delaunay::Delaunay2;
use crate::tri::duplicates::Duplicates;
use crate::tri::mesh::TriMesh;
use crate::tri::sight::Sight;
use crate::tri::subcomplex::Subcomplex2;
use geo_predicates::filter::Filter2;
use glam::DVec2;

/// The constrained Delaunay triangulation of points and segments in the plane.
///
/// Every segment is an edge, or a chain of edges where vertices lie on it. Every other edge is Delaunay as far as can be
/// seen across the segments: no vertex that a triangle sees is inside its circle, ties broken as in a [`Delaunay2`]. So the
/// triangulation is unique whatever the order of points and segments.
///
/// Input point `i` is vertex `i`, and the plane is closed by ghost faces, as in a [`Delaunay2`].
///
/// ```
/// use delaunay_core::{Constrained2, Delaunay2, VertexId};
/// use glam::DVec2;
///
/// // A flat kite: its Delaunay edge is the short diagonal.
/// let corners = [[0.0, 0.0], [4.0, -1.0], [8.0, 0.0], [4.0, 1.0]].map(DVec2::from);
/// let mut kite = Constrained2::of(Delaunay2::build(&corners)?);
/// let [left, right] = [0, 2].map(VertexId::new);
/// assert_eq!(kite.mesh().find_half_edge(left, right), None);
///
/// kite.add_segment(0, [left, right])?;
/// let long = kite.mesh().find_half_edge(left, right).unwrap();
/// assert_eq!(kite.segment_of(long), Some(0));
/// assert_eq!(kite.check(), Ok(()));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Constrained2 {
    /// By vertex slot: the ghost in front, with coordinates that are not numbers.
    pub(super) coords: Vec<DVec2>,
    pub(super) mesh: TriMesh,
    /// Quick signs, valid for any accepted point.
    pub(super) filter: Filter2,
    pub(super) duplicates: Duplicates,
    /// By half-edge, one more than the least segment on it; 0 where there is none.
    pub(super) labels: Vec<u32>,
    pub(super) paths: Paths,
    /// Buffers, kept to be filled again.
    pub(super) corridor: Corridor,
    pub(super) pockets: [Pocket; 2],
}

impl Constrained2 {
    /// A triangulation without segments yet.
    #[must_use]
    pub fn of(delaunay: Delaunay2) -> Self {
        let Delaunay2 {
            coords,
            mesh,
            filter,
            duplicates,
            ..
        } = delaunay;
        let labels = vec![0; 4 * mesh.face_count()];
        Self {
            coords,
            mesh,
            filter,
            duplicates,
            labels,
            paths: Paths::default(),
            corridor: Corridor::default(),
            pockets: Default::default(),
        }
    }

    /// The same triangulation without its segments, when it is Delaunay all the same; takes linear time.
    #[must_use]
    pub fn as_delaunay(&self) -> Option<Delaunay2> {
        let mut half_edges = self.mesh.half_edges();
        if half_edges.any(|h| self.is_in_circle(h)) {
            return None;
        }
        Some(Delaunay2 {
            coords: self.coords.clone(),
            mesh: self.mesh.clone(),
            filter: self.filter,
            duplicates: self.duplicates.clone(),
            vacant: Vec::new(),
            cavity: Cavity::default(),
            guide: Guide::default(),
        })
    }

    /// The triangles that `keep` keeps, bounded by others and by segments: where a segment has triangles kept on both sides, they
    /// are cut apart along it, and it is two boundary edges.
    ///
    /// `keep` is asked about real triangles only, and should part them along segments alone: then all that is kept is
    /// Delaunay, as a [`Subcomplex2`] wants it. Takes linear time, and at a boundary vertex time proportional to its degree for
    /// each part of its star.
    #[must_use]
    pub fn subcomplex(&self, keep: impl FnMut(FaceId) -> bool) -> Subcomplex2 {
        let is_cut = |h: HalfEdgeId| self.is_constrained(h);
        Subcomplex2::cut_out(&self.coords, &self.mesh, self.filter, keep, is_cut)
    }

    /// The points by vertex index: those given, then those where segments were divided.
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

    /// The input points that repeat another one.
    #[must_use]
    pub fn duplicates(&self) -> &Duplicates {
        &self.duplicates
    }

    /// Whether a segment lies on the edge of `h`.
    ///
    /// # Panics
    /// When there is no half-edge `h`.
    #[must_use]
    #[inline]
    pub fn is_constrained(&self, h: HalfEdgeId) -> bool {
        self.labels[h.index()] != 0
    }

    /// The segment on the edge of `h`, the one with the least number if there are several.
    ///
    /// # Panics
    /// When there is no half-edge `h`.
    #[must_use]
    pub fn segment_of(&self, h: HalfEdgeId) -> Option<usize> {
        self.labels[h.index()]
            .checked_sub(1)
            .map(|segment| segment as usize)
    }

    /// The half-edges that segments lie on, one of the two of each edge, by id.
    pub fn constrained_edges(&self) -> impl Iterator<Item = HalfEdgeId> + Clone + '_ {
        let half_edges = self.mesh.half_edges();
        half_edges.filter(|&h| self.is_constrained(h) && h < self.mesh.twin(h))
    }

    /// The vertex at the place of input point `v`: itself, or the one that it repeats.
    #[must_use]
    pub fn vertex_at(&self, v: VertexId) -> VertexId {
        self.duplicates.representative(v).unwrap_or(v)
    }

    pub(super) fn sight(&self, from: VertexId) -> Sight<'_> {
        Sight::new(&self.coords, self.filter, self.coords[from.slot()])
    }
}
