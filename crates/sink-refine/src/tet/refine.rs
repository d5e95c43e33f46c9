//! Refinement of a solid: the driver, and what it answers.

use super::boundary;
use super::economical;
use super::low::{Low3, left_over};
use super::records::Records;
use super::refiner::Refiner;
use super::schedule;
use super::separation::{Separation3, shortest_edge, vertex_bound};
use super::sizes::Sizes;
use crate::error::RefineError;
use crate::history::{Counters, Round};
use crate::params::{Method, Params};
use crate::sizing::Sizing3;
use crate::stop::Stop;
use delaunay_core::Subcomplex3;
use delaunay_core::progress::{Meter, Progress};
use std::ops::ControlFlow;

/// A refined solid, and how it came about.
#[derive(Clone, Debug)]
pub struct Outcome3 {
    /// The mesh. Its boundary is the one given, divided where that was allowed. Vertices given keep their ids and places.
    pub solid: Subcomplex3,
    /// Why no more points were inserted.
    pub stop: Stop,
    /// Counts of work done.
    pub counters: Counters,
    /// The mesh before each round, and what the round did; of the incremental schedules, before each pass. The last entry
    /// is the mesh that comes out.
    pub rounds: Vec<Round>,
    /// The tetrahedra of low quality that are left, worst first.
    pub low: Vec<Low3>,
    /// How near vertices are to each other, and how many there can be.
    pub separation: Separation3,
}

/// Improves the tetrahedra of `solid` by inserting points. The boundary stays as it is, unless
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
/// use delaunay_core::{Delaunay3, Subcomplex3, progress::silent};
/// use glam::DVec3;
/// use sink_refine::{Params, Stop, refine3};
///
/// // The corners of an octahedron and the middles of its edges, all on one sphere: tetrahedra between them are poor.
/// let axes = [DVec3::X, DVec3::Y, DVec3::Z, -DVec3::X, -DVec3::Y, -DVec3::Z];
/// let mut points = axes.to_vec();
/// for (i, a) in axes.into_iter().enumerate() {
///     points.extend(axes[i + 1..].iter().filter(|b| a.dot(**b) == 0.0).map(|b| (a + b).normalize()));
/// }
/// let solid = Subcomplex3::of(&Delaunay3::build(&points)?, |_| true);
/// let params = Params { ratio: 1.2, ..Params::default() };
/// let outcome = refine3(solid, &params, &mut silent)?;
/// assert_eq!(outcome.stop, Stop::AllGood);
/// assert_eq!(outcome.low, []);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn refine3(
    solid: Subcomplex3,
    params: &Params,
    report: &mut dyn FnMut(Progress) -> ControlFlow<()>,
) -> Result<Outcome3, RefineError> {
    refine3_sized(solid, params, &Sizing3::default(), report)
}

/// Improves the tetrahedra of `solid` as [`refine3`] does, and makes them small enough for `sizing`.
///
/// What is too large is of low quality in all that the outcome says: [`Stop::AllGood`] means that nothing too large is left, and
/// [`Low3::size`] tells how much too large what is left is. Where the field gives no size, it ends with [`Stop::UnusableSize`].
///
/// # Errors
/// Those of [`refine3`]; [`RefineError::RegionSize`] and [`RefineError::RegionOutside`] for regions that are none.
pub fn refine3_sized(
    solid: Subcomplex3,
    params: &Params,
    sizing: &Sizing3<'_>,
    report: &mut dyn FnMut(Progress) -> ControlFlow<()>,
) -> Result<Outcome3, RefineError> {
    params.check()?;
    let sizes = Sizes::of(&solid, sizing)?;
    let meter = Meter::start(report, "refine", 0)?;
    let given = shortest_edge(&solid);
    let mut bound = vertex_bound(&solid, params.boundary.least_separation(given));
    let records = Records::of(&solid, params.ratio, sizes);
    let mut refiner = Refiner::new(solid, records, params.max_new_vertices, meter);
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
    let low = left_over(&refiner.solid, &refiner.records);
    let stop = match ended {
        Err(stop) => stop,
        Ok(()) if low.is_empty() => Stop::AllGood,
        Ok(()) => Stop::NothingToInsert,
    };
    let Refiner {
        solid,
        counters,
        rounds,
        ..
    } = refiner;
    let reached = shortest_edge(&solid);
    if reached < given && !sizing.is_empty() {
        bound = vertex_bound(&solid, reached);
    }
    let separation = Separation3 {
        given,
        reached,
        vertex_bound: bound,
    };
    Ok(Outcome3 {
        solid,
        stop,
        counters,
        rounds,
        low,
        separation,
    })
}
