//! Refinement of a region: the driver, and what it answers.

use super::boundary;
use super::economical;
use super::low::{Low2, left_over};
use super::records::Records;
use super::refiner::Refiner;
use super::schedule;
use super::separation::{Separation2, shortest_edge, vertex_bound};
use super::sizes::Sizes;
use crate::error::RefineError;
use crate::history::{Counters, Round};
use crate::params::{Method, Params};
use crate::sizing::Sizing2;
use crate::stop::Stop;
use delaunay_core::Subcomplex2;
use delaunay_core::progress::{Meter, Progress};
use std::ops::ControlFlow;

/// A refined region, and how it came about.
#[derive(Clone, Debug)]
pub struct Outcome2 {
    /// The mesh. Its boundary is the one given, divided where that was allowed. Vertices given keep their ids and places.
    pub region: Subcomplex2,
    /// Why no more points were inserted.
    pub stop: Stop,
    /// Counts of work done.
    pub counters: Counters,
    /// The mesh before each round, and what the round did; of the incremental schedules, before each pass. The last entry
    /// is the mesh that comes out.
    pub rounds: Vec<Round>,
    /// The triangles of low quality that are left, worst first.
    pub low: Vec<Low2>,
    /// How near vertices are to each other, and how many there can be.
    pub separation: Separation2,
}

/// Improves the triangles of `region` by inserting points. The boundary stays as it is, unless
/// [`Boundary::Split`](crate::Boundary::Split) is asked for.
///
/// The same input gives the same mesh, bit for bit, for any number of threads; the parallel schedule uses those of the
/// current rayon pool. Inserted vertices have ids from the number of given points on. Every point of the paper's method
/// keeps the minimum separation, so it ends; the phases beyond it end as said in the module. Whatever the
/// reason to stop, the mesh is valid.
///
/// # Errors
/// [`RefineError::Ratio`] when the ratio is below 1 or no number, [`RefineError::Crease`] when the crease angle is none;
/// [`RefineError::Cancelled`] when `report` stops the work
/// before it has begun. Later it ends with [`Stop::Cancelled`].
///
/// ```
/// use delaunay_core::{Delaunay2, Subcomplex2, progress::silent};
/// use glam::DVec2;
/// use sink_refine::{Params, Stop, refine2};
///
/// // A square with ten edges on each side: triangles between the sides are poor.
/// let sides = (0..10).map(f64::from).flat_map(|t| [[t, 0.0], [10.0, t], [10.0 - t, 10.0], [0.0, 10.0 - t]]);
/// let points: Vec<DVec2> = sides.map(DVec2::from).collect();
/// let region = Subcomplex2::of(&Delaunay2::build(&points)?, |_| true);
/// let params = Params { ratio: 1.0, ..Params::default() };
/// let outcome = refine2(region, &params, &mut silent)?;
/// assert_eq!(outcome.stop, Stop::AllGood);
/// assert_eq!(outcome.low, []);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn refine2(
    region: Subcomplex2,
    params: &Params,
    report: &mut dyn FnMut(Progress) -> ControlFlow<()>,
) -> Result<Outcome2, RefineError> {
    refine2_sized(region, params, &Sizing2::default(), report)
}

/// Improves the triangles of `region` as [`refine2`] does, and makes them small enough for `sizing`.
///
/// What is too large is of low quality in all that the outcome says: [`Stop::AllGood`] means that nothing too large is left, and
/// [`Low2::size`] tells how much too large what is left is. Where the field gives no size, it ends with [`Stop::UnusableSize`].
///
/// # Errors
/// Those of [`refine2`]; [`RefineError::RegionSize`] and [`RefineError::RegionOutside`] for regions that are none.
pub fn refine2_sized(
    region: Subcomplex2,
    params: &Params,
    sizing: &Sizing2<'_>,
    report: &mut dyn FnMut(Progress) -> ControlFlow<()>,
) -> Result<Outcome2, RefineError> {
    params.check()?;
    let sizes = Sizes::of(&region, sizing)?;
    let meter = Meter::start(report, "refine", 0)?;
    let given = shortest_edge(&region);
    let mut bound = vertex_bound(&region, params.boundary.least_separation(given));
    let records = Records::of(&region, params.ratio, sizes);
    let mut refiner = Refiner::new(region, records, params.max_new_vertices, meter);
    let usable = refiner.records.check_sizes();
    let ended = usable.and_then(|()| match params.method {
        Method::Paper {
            candidate,
            schedule,
        } => schedule::run(&mut refiner, candidate, schedule)
            .and_then(|()| boundary::run(&mut refiner, params.boundary)),
        Method::Economical(coarsening) => {
            economical::run(&mut refiner, coarsening, params.boundary)
        }
    });
    refiner.begin_round();
    let low = left_over(&refiner.region, &refiner.records);
    let stop = match ended {
        Err(stop) => stop,
        Ok(()) if low.is_empty() => Stop::AllGood,
        Ok(()) => Stop::NothingToInsert,
    };
    let Refiner {
        region,
        counters,
        rounds,
        ..
    } = refiner;
    let reached = shortest_edge(&region);
    if reached < given && !sizing.is_empty() {
        bound = vertex_bound(&region, reached);
    }
    let separation = Separation2 {
        given,
        reached,
        vertex_bound: bound,
    };
    Ok(Outcome2 {
        region,
        stop,
        counters,
        rounds,
        low,
        separation,
    })
}
