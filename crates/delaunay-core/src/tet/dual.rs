//! The Voronoi diagram, dual of the Delaunay triangulation: vertices, edges, facets, clipped cells.
//!
//! Cells are carved out of a window by the bisectors between a vertex and its Delaunay neighbours. No Voronoi
//! vertex is needed for that, so slivers and flat tetrahedra on the hull, whose centers are far away,
//! do no harm.

use super::carve::CellCarver;
use super::delaunay::Delaunay3;
use super::polyhedron::ConvexPolyhedron;
use crate::ids::VertexId;

/// The Voronoi diagram of the vertices, see [`Delaunay3::voronoi`].
#[derive(Clone, Copy, Debug)]
pub struct Voronoi3<'a> {
    delaunay: &'a Delaunay3,
}

impl Delaunay3 {
    /// The Voronoi diagram of the vertices. Nothing is computed before it is asked for.
    ///
    /// ```
    /// # use delaunay_core::{ConvexPolyhedron, Delaunay3, VertexId};
    /// # use glam::DVec3;
    /// let mut points: Vec<DVec3> = (0..8)
    ///     .map(|i| DVec3::new((i & 1) as f64, (i >> 1 & 1) as f64, (i >> 2) as f64))
    ///     .collect();
    /// points.push(DVec3::splat(0.5));
    /// let delaunay = Delaunay3::build(&points)?;
    /// let window = ConvexPolyhedron::cuboid(DVec3::ZERO, DVec3::ONE)?;
    /// let cell = delaunay.voronoi().cell(VertexId::new(8), &window);
    /// assert_eq!(cell.volume(), 0.5);
    /// assert_eq!(cell.centroid(), Some(DVec3::splat(0.5)));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn voronoi(&self) -> Voronoi3<'_> {
        Voronoi3 { delaunay: self }
    }
}

impl<'a> Voronoi3<'a> {
    /// The cell of `v`: the part of `window` that is nearer to `v` than to any other vertex.
    ///
    /// Empty when `v` is not a vertex or its cell lies outside the window. The cells of all vertices tile
    /// the window up to rounding. For many cells take a [`carver`](Self::carver).
    #[must_use]
    pub fn cell(&self, v: VertexId, window: &ConvexPolyhedron) -> ConvexPolyhedron {
        let mut carver = CellCarver::new(self.delaunay, window);
        carver.cell(v);
        carver.into_cell()
    }

    /// What makes one cell after the other.
    #[must_use]
    pub fn carver(&self, window: &'a ConvexPolyhedron) -> CellCarver<'a> {
        CellCarver::new(self.delaunay, window)
    }
}
