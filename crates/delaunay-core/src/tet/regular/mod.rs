//! Regular triangulations of weighted points of space.
//!
//! | step | file |
//! |---|---|
//! | the triangulation and read access | `mod.rs` |
//! | all points, one after the other | `build.rs` |
//! | weighted vertices as seen from a point | `sight.rs` |
//! | invariants | `check.rs` |

mod build;
mod check;
mod sight;

pub use check::RegularViolation3;

use super::mesh::TetMesh;
use crate::ids::{TetId, VertexId};
use crate::tri::Duplicates;
use glam::DVec3;

/// The regular triangulation of weighted points of space, not all on one plane.
///
/// A point `p` of weight `w` is a ball of squared radius `w` round `p`; a weight may be negative. Lifted
/// to the height `|p|^2 - w`, the vertices are those of the lower hull of the points, and its facets
/// project to the tetrahedra. With equal weights this is the Delaunay triangulation, bit for bit in
/// canonical form; greater weights make greater cells, and points with too small a weight for a cell
/// are [hidden](Self::hidden).
///
/// Input point `i` is vertex `i` for ever. The triangulation is unique: ties are broken as in
/// [`Delaunay3`](super::Delaunay3), and it is closed by ghosts in the same way.
///
/// ```
/// use delaunay_core::{Regular3, VertexId};
/// use glam::DVec3;
///
/// let points = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z, DVec3::splat(0.2)];
/// let regular = Regular3::build(&points, &[0.0, 0.0, 0.0, 0.0, -1.0])?;
/// assert_eq!(regular.hidden(), [VertexId::new(4)]);
/// assert_eq!(regular.tets().count(), 1);
/// let regular = Regular3::build(&points, &[0.0; 5])?;
/// assert_eq!(regular.tets().count(), 4);
/// # Ok::<(), delaunay_core::RegularError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Regular3 {
    /// By vertex slot: the ghost in front, with coordinates and a weight that are not numbers.
    coords: Vec<DVec3>,
    weights: Vec<f64>,
    mesh: TetMesh,
    duplicates: Duplicates,
    /// Ascending.
    hidden: Vec<VertexId>,
}

impl Regular3 {
    /// The greatest number of points.
    pub const MAX_POINTS: usize = VertexId::LIMIT - 1;

    /// The points by vertex index: all input points in input order. `-0.0` has become `0.0`.
    #[must_use]
    pub fn points(&self) -> &[DVec3] {
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
        !v.is_ghost() && self.mesh.home(v).is_some()
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
