//! All points at once, in spatial order.
//!
//! The points are copied in the order of insertion (see [`crate::order`]) and numbered so while the
//! triangulation grows, which keeps what is used together near in memory; at the end the faces
//! take the caller's numbers. Between two insertions the walk starts at the side of the last star
//! that faces the next point.

use super::bulk::{Bulk, Finish, bring_triangle_to_front};
use super::cavity::Cavity;
use super::delaunay::Delaunay2;
use super::duplicates::Duplicates;
use super::flat::Flat;
use crate::error::BuildError;
use crate::guide::Guide;
use crate::memory::{vec_of, words_of};
use crate::options::BuildOptions;
use crate::order::Order;
use crate::progress::{Meter, Progress, silent};
use crate::threads;
use geo_predicates::check_points2;
use geo_predicates::filter::Filter2;
use glam::DVec2;
use std::ops::ControlFlow;

/// Points of a round that are worth a thread of their own.
const LEAST_SHARE: usize = 8192;

impl Delaunay2 {
    /// The Delaunay triangulation of `points`; point `i` is vertex `i`.
    ///
    /// Repeated points are vertices once, see [`duplicates`](Self::duplicates). Expected time
    /// n log n, memory about 64 bytes per point when done.
    ///
    /// # Errors
    /// - [`BuildError::Coordinate`] when a coordinate is not accepted: which point, axis and value;
    /// - [`BuildError::TooManyPoints`] beyond [`MAX_POINTS`](Self::MAX_POINTS);
    /// - [`BuildError::Flat`] when the points span no triangle: what they are instead.
    pub fn build(points: &[DVec2]) -> Result<Self, BuildError> {
        Self::build_with(points, &mut silent)
    }

    /// As [`build`](Self::build), reporting progress to `report`, which can stop the work.
    ///
    /// # Errors
    /// As [`build`](Self::build), and [`BuildError::Cancelled`] when `report` says so.
    ///
    /// ```
    /// # use delaunay_core::{BuildError, Delaunay2};
    /// # use glam::DVec2;
    /// # use std::ops::ControlFlow;
    /// let points: Vec<DVec2> = (0..100).map(|i| DVec2::new(f64::from(i % 10), f64::from(i / 10))).collect();
    /// let stopped = Delaunay2::build_with(&points, &mut |_| ControlFlow::Break(()));
    /// assert!(matches!(stopped, Err(BuildError::Cancelled(_))));
    /// ```
    pub fn build_with(
        points: &[DVec2],
        report: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Self, BuildError> {
        Self::build_on(points, BuildOptions::default(), report)
    }

    /// As [`build_with`](Self::build_with), on several threads or in pages of another size.
    ///
    /// # Errors
    /// As [`build_with`](Self::build_with).
    ///
    /// ```
    /// # use delaunay_core::{BuildError, BuildOptions, Delaunay2, progress::silent};
    /// # use glam::DVec2;
    /// let points: Vec<DVec2> = (0..100).map(|i| DVec2::new(f64::from(i % 10), f64::from(i / 10))).collect();
    /// let one = Delaunay2::build(&points)?;
    /// let two = Delaunay2::build_on(&points, BuildOptions::on_threads(2), &mut silent)?;
    /// assert_eq!(one.mesh().canonical(), two.mesh().canonical());
    /// # Ok::<(), BuildError>(())
    /// ```
    pub fn build_on(
        points: &[DVec2],
        options: BuildOptions,
        report: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Self, BuildError> {
        if points.len() > Self::MAX_POINTS {
            return Err(BuildError::TooManyPoints {
                count: points.len(),
                limit: Self::MAX_POINTS,
            });
        }
        let options = options.for_points(points.len());
        let threads = options.threads.get();
        threads::check(points, threads, check_points2)?;
        let mut meter = Meter::start(report, "triangulate", points.len())?;
        // Fresh memory is cleared first: the keys of the order and the names of the finish take the place of the points.
        let mut coords = vec_of(DVec2::NAN, points.len() + 1, options.huge_pages);
        let mut order = Order::in_memory(points, words_of(&mut coords), options);
        coords[0] = DVec2::NAN;
        // Adding zero makes `-0.0` to `0.0`.
        threads::fill(&mut coords[1..], &order.indices, threads, |&index| {
            points[index as usize] + DVec2::ZERO
        });
        if !bring_triangle_to_front(&mut coords, &mut order.indices) {
            return Err(BuildError::Flat(Box::new(Flat::sorted(points))));
        }
        let bulk = Bulk::of(&coords, &order, options, LEAST_SHARE, &mut meter)?;
        let Finish { mesh, duplicates } =
            bulk.finish(&order.indices, words_of(&mut coords), options);
        coords[0] = DVec2::NAN;
        threads::fill(&mut coords[1..], points, threads, |&p| p + DVec2::ZERO);
        Ok(Self {
            coords,
            mesh,
            filter: Filter2::GENERAL,
            duplicates: Duplicates::from_pairs(duplicates),
            vacant: Vec::new(),
            cavity: Cavity::default(),
            guide: Guide::default(),
        })
    }
}
