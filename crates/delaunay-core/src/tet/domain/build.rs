//! From points and triangles to a domain, or to all that is wrong with them.

use super::defects::DomainDefects;
use super::edges::Edges;
use super::error::{DomainError, MarkerCount};
use super::intersections::Boxed;
use super::options::Domain3Options;
use super::outwards::turn_outwards;
use super::patches::Patches;
use super::repairs::Repairs;
use super::soup::Soup;
use crate::ids::VertexId;
use crate::progress::{Meter, Progress, silent};
use crate::tet::delaunay::Delaunay3;
use glam::DVec3;
use std::ops::ControlFlow;

/// Triangles in space that bound bodies, or separate regions: exactly judged, without any of the [`DomainDefects`].
///
/// Points are all different and all corners; triangles have area, are all different, and have nothing in common but corners and
/// edges. Those of a patch, which hangs together across edges with two triangles, are turned to agree. Around closed bodies
/// normals point out of them.
///
/// ```
/// use delaunay_core::{Domain3, Domain3Options, VertexId, progress::silent};
/// use glam::DVec3;
///
/// let corners = vec![DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
/// let facets = [[1, 2, 3], [2, 0, 3], [1, 0, 3], [2, 1, 0]].map(|facet| facet.map(VertexId::new));
/// let options = Domain3Options::default();
/// let (domain, repairs) = Domain3::build(&corners, &facets, options, &mut silent)?;
/// assert_eq!(repairs.turned, [2]);
/// assert!((domain.shells()[0].volume - 1.0 / 6.0).abs() < 1e-15);
///
/// let error = Domain3::new(&corners, &facets[1..]).unwrap_err();
/// let defects = error.defects().unwrap();
/// assert_eq!((defects.open_edges.len(), defects.holes.len()), (3, 1));
/// # Ok::<(), delaunay_core::DomainError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Domain3 {
    points: Vec<DVec3>,
    triangles: Vec<[VertexId; 3]>,
    /// One per triangle, where known.
    markers: Option<Vec<i32>>,
    interfaces: bool,
}

impl Domain3 {
    /// Most triangles of a domain.
    pub const MAX_TRIANGLES: usize = u32::MAX as usize - 1;

    /// The closed bodies that the triangles bound, by the default [options](Domain3Options): nothing is repaired but the way
    /// triangles are turned, of which [`build`](Self::build) tells.
    ///
    /// # Errors
    /// As [`build`](Self::build).
    pub fn new(points: &[DVec3], triangles: &[[VertexId; 3]]) -> Result<Self, DomainError> {
        let options = Domain3Options::default();
        let built = Self::build(points, triangles, options, &mut silent);
        built.map(|(domain, _)| domain)
    }

    /// The bodies or regions that the triangles bound or separate, and what was repaired.
    ///
    /// Corners count the points from 0. Repaired is only what `options` say, and how triangles are turned. Normals point away from
    /// the inside where triangles bound bodies, of which one may be within a void of another; with
    /// [interfaces](Domain3Options::interfaces), where either side may be inside, the triangles of a patch agree and
    /// as few as possible are turned.
    ///
    /// Takes time n log n where each triangle is near to few others. Runs in the current pool of `rayon`; the result does not depend
    /// on the number of threads.
    ///
    /// # Errors
    /// No triangles; more points than [`Delaunay3::MAX_POINTS`] or more triangles than [`MAX_TRIANGLES`](Self::MAX_TRIANGLES);
    /// `report` stops the work; or all that is wrong: see [`DomainDefects`].
    pub fn build(
        points: &[DVec3],
        triangles: &[[VertexId; 3]],
        options: Domain3Options,
        report: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<(Self, Repairs), DomainError> {
        check_counts(points.len(), triangles.len())?;
        let mut defects = DomainDefects::default();
        let mut meter = Meter::start(report, "check triangles", triangles.len())?;
        let soup = Soup::examine(points, triangles, options, &mut defects, &mut meter)?;
        let counted = soup.joined.iter().copied().enumerate();
        let edges = Edges::of(counted.filter(|&(triangle, _)| soup.counts[triangle]));
        edges.judge(&soup, options, &mut defects);
        let mut patches = Patches::of(&edges, &soup.counts);
        patches.judge(&soup, &mut defects);
        let mut meter = Meter::start(report, "find intersections", triangles.len())?;
        let boxed = Boxed::of(&soup);
        boxed.judge(options.most_intersections, &mut defects, &mut meter)?;
        if !defects.is_empty() {
            return Err(DomainError::Defects(Box::new(defects)));
        }
        if !options.interfaces {
            let mut meter = Meter::start(report, "turn outwards", patches.members.len())?;
            turn_outwards(&boxed, &mut patches, &mut meter)?;
        }
        let repairs = Repairs::of(&soup, options, &patches);
        let domain = Self {
            points: repairs.points(&soup),
            triangles: repairs.triangles(&soup),
            markers: None,
            interfaces: options.interfaces,
        };
        Ok((domain, repairs))
    }

    /// The same domain with a marker for each triangle.
    ///
    /// # Errors
    /// Another number of markers than of triangles.
    pub fn with_markers(self, markers: Vec<i32>) -> Result<Self, MarkerCount> {
        let (markers_given, triangles) = (markers.len(), self.triangles.len());
        if markers_given != triangles {
            let markers = markers_given;
            return Err(MarkerCount { markers, triangles });
        }
        let markers = Some(markers);
        Ok(Self { markers, ..self })
    }

    /// The points, by vertex index.
    #[must_use]
    pub fn points(&self) -> &[DVec3] {
        &self.points
    }

    /// The corners of the triangles, counterclockwise seen from where their normals point.
    #[must_use]
    pub fn triangles(&self) -> &[[VertexId; 3]] {
        &self.triangles
    }

    /// A marker for each triangle, where they were given.
    #[must_use]
    pub fn markers(&self) -> Option<&[i32]> {
        self.markers.as_deref()
    }

    /// Whether the triangles may separate regions, so that normals need not point out of anything.
    #[must_use]
    pub fn has_interfaces(&self) -> bool {
        self.interfaces
    }
}

fn check_counts(points: usize, triangles: usize) -> Result<(), DomainError> {
    if points > Delaunay3::MAX_POINTS {
        let (count, limit) = (points, Delaunay3::MAX_POINTS);
        return Err(DomainError::TooManyPoints { count, limit });
    }
    if triangles > Domain3::MAX_TRIANGLES {
        let (count, limit) = (triangles, Domain3::MAX_TRIANGLES);
        return Err(DomainError::TooManyTriangles { count, limit });
    }
    if triangles == 0 {
        return Err(DomainError::Empty);
    }
    Ok(())
}
