//! What to mesh, judged once: the region that an outline bounds.

use std::ops::ControlFlow;

use delaunay_core::measure::{Sum, triangle};
use delaunay_core::progress::Progress;
use delaunay_core::{BuildOptions, Outline, Subcomplex2, VertexId};

use crate::bubble::{Bubble, boundary_bubbles};
use crate::error::DomainError;

/// A region of any form, with holes, parts that touch and parts that lie apart: its boundary nodes, their bubbles
/// and the triangles between them, the initial boundary mesh (§2.1).
///
/// ```
/// use bubble_mesh::Domain;
/// use delaunay_core::{BuildOptions, Outline, VertexId, progress::silent};
/// use glam::DVec2;
///
/// // A square frame: one loop in another.
/// let square = |s: f64| [[-s, -s], [s, -s], [s, s], [-s, s]].map(DVec2::from);
/// let points = [square(2.0), square(1.0)].concat();
/// let segments = (0..8).map(|i| [i, i / 4 * 4 + (i + 1) % 4].map(VertexId::new));
/// let outline = Outline::new(points, segments.collect())?;
/// let domain = Domain::new(&outline, BuildOptions::default(), &mut silent)?;
/// assert_eq!(domain.region().faces().count(), 8);
/// assert_eq!(domain.area(), 12.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Domain {
    region: Subcomplex2,
    bubbles: Vec<Bubble>,
}

impl Domain {
    /// The region that the outline bounds; point i of the outline is boundary node i.
    ///
    /// `options` and `report` are those of [`Outline::region`], whose time it takes.
    ///
    /// # Errors
    /// [`DomainError`] when the outline comes with points inside, or bounds no region, with the element in question.
    pub fn new(
        outline: &Outline,
        options: BuildOptions,
        report: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Self, DomainError> {
        Self::of(outline.region(options, report)?.subcomplex())
    }

    /// The domain of a region that has been triangulated, regions side by side for instance; all its vertices are boundary nodes.
    ///
    /// # Errors
    /// [`DomainError::InteriorPoint`] when a vertex is not on the boundary.
    pub fn of(region: Subcomplex2) -> Result<Self, DomainError> {
        let bubbles = boundary_bubbles(&region);
        match bubbles.iter().position(|bubble| bubble.radius == 0.0) {
            Some(index) => Err(DomainError::InteriorPoint {
                vertex: VertexId::new(index),
            }),
            None => Ok(Self { region, bubbles }),
        }
    }

    /// The initial boundary mesh: triangles between the boundary nodes, which fill the region.
    #[must_use]
    pub fn region(&self) -> &Subcomplex2 {
        &self.region
    }

    /// The edges of the boundary as pairs of nodes, with the region on the left; those with the region on both sides come twice.
    pub fn segments(&self) -> impl Iterator<Item = [VertexId; 2]> + '_ {
        let mesh = self.region.mesh();
        let half_edges = self.region.boundary();
        half_edges.map(|h| [mesh.origin(h), mesh.target(h)])
    }

    /// The bubbles of the boundary nodes, by vertex. Source: eq. 1 and 2.
    #[must_use]
    pub fn bubbles(&self) -> &[Bubble] {
        &self.bubbles
    }

    /// The area of the region, `A_geo` of eq. 6; square of the unit of length.
    #[must_use]
    pub fn area(&self) -> f64 {
        let mut sum = Sum::default();
        for f in self.region.faces() {
            sum.add(triangle::area(self.region.triangle(f)));
        }
        sum.total()
    }
}
