//! Regular triangulations of weighted points of the plane.
//!
//! | step | file |
//! |---|---|
//! | the triangulation and read access | `mod.rs` |
//! | all points, one after the other | `build.rs` |
//! | weighted vertices as seen from a point | `sight.rs` |
//! | cavity and star, where vertices may be swallowed | `cavity.rs` |
//! | invariants | `check.rs` |

mod build;
mod cavity;
mod check;
mod sight;

pub use check::RegularViolation2;

use super::duplicates::Duplicates;
use super::mesh::TriMesh;
use crate::ids::{FaceId, VertexId};
use glam::DVec2;

/// The regular triangulation of weighted points of the plane, not all on one line.
///
/// A point `p` of weight `w` is a circle of squared radius `w` round `p`; a weight may be negative. Lifted
/// to the height `|p|^2 - w`, the vertices are those of the lower hull of the points, and its facets
/// project to the triangles. With equal weights this is the Delaunay triangulation, bit for bit in
/// canonical form; greater weights make greater cells, and points with too small a weight for a cell
/// are [hidden](Self::hidden).
///
/// Input point `i` is vertex `i` for ever. The triangulation is unique: ties are broken as in
/// [`Delaunay2`](super::Delaunay2), and it is closed by ghosts in the same way.
///
/// ```
/// use delaunay_core::{Regular2, VertexId};
/// use glam::DVec2;
///
/// let points = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [1.0, 1.0]].map(DVec2::from);
/// let regular = Regular2::build(&points, &[0.0, 0.0, 0.0, 0.0, -3.0])?;
/// assert_eq!(regular.hidden(), [VertexId::new(4)]);
/// assert_eq!(regular.faces().count(), 2);
/// let regular = Regular2::build(&points, &[0.0; 5])?;
/// assert_eq!(regular.faces().count(), 4);
/// # Ok::<(), delaunay_core::RegularError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Regular2 {
    /// By vertex slot: the ghost in front, with coordinates and a weight that are not numbers.
    coords: Vec<DVec2>,
    weights: Vec<f64>,
    mesh: TriMesh,
    duplicates: Duplicates,
    /// Ascending.
    hidden: Vec<VertexId>,
}

impl Regular2 {
    /// The greatest number of points: with more, 32 bits would not number all half-edges.
    pub const MAX_POINTS: usize = FaceId::LIMIT / 2;

    /// The points by vertex index: all input points in input order. `-0.0` has become `0.0`.
    #[must_use]
    pub fn points(&self) -> &[DVec2] {
        &self.coords[1..]
    }

    /// The weights by vertex index, in squared units of length.
    #[must_use]
    pub fn weights(&self) -> &[f64] {
        &self.weights[1..]
    }

    /// Where `v` is.
    ///
    /// # Panics
    /// When `v` is the ghost or no input point.
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

    /// Gives the connectivity away and drops the rest.
    #[must_use]
    pub fn into_mesh(self) -> TriMesh {
        self.mesh
    }

    /// The triangles, by id: all faces that are not ghosts.
    pub fn faces(&self) -> impl Iterator<Item = FaceId> + Clone + '_ {
        self.mesh.faces().filter(|&f| !self.mesh.is_ghost_face(f))
    }

    /// The number of vertices in the triangulation: points neither hidden nor duplicates.
    #[must_use]
    pub fn vertex_count(&self) -> usize {
        self.points().len() - self.hidden.len() - self.duplicates.len()
    }

    /// The vertices in the triangulation, by id.
    pub fn vertices(&self) -> impl Iterator<Item = VertexId> + Clone + '_ {
        (0..self.points().len())
            .map(VertexId::new)
            .filter(|&v| self.contains_vertex(v))
    }

    /// Whether `v` is a vertex of the triangulation, neither the ghost nor hidden nor a duplicate.
    #[must_use]
    pub fn contains_vertex(&self, v: VertexId) -> bool {
        !v.is_ghost() && self.mesh.outgoing(v).is_some()
    }

    /// The points without a cell, ascending: their lifts are above the lower hull of the others. Points at
    /// the place of another one are not among them, but among the [`duplicates`](Self::duplicates).
    #[must_use]
    pub fn hidden(&self) -> &[VertexId] {
        &self.hidden
    }

    /// The points at the place of another one. The heaviest at a place stands for all, of equally heavy
    /// ones the smallest id; it may itself be hidden.
    #[must_use]
    pub fn duplicates(&self) -> &Duplicates {
        &self.duplicates
    }
}
