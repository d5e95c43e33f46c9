//! Lloyd's iteration (§3.2): every point moves to the mass centroid of its Voronoi cell, again and again. A
//! point bound to the boundary moves to what is nearest to the centroid there.
//!
//! Neither half of a step can raise the cost: for fixed points the Voronoi cells are the cheapest tessellation,
//! for fixed cells the mass centroids are the cheapest points. So the cost falls, down to where the points are
//! the mass centroids of their cells (beyond the error of the quadrature, for a given density).

use std::convert::Infallible;
use std::ops::ControlFlow;

use delaunay_core::ConvexPolygon;
use delaunay_core::progress::{Meter, Progress};
use glam::DVec2;

use crate::cost::survey;
use crate::error::DensityError;
use crate::generators::Generators;
use crate::moments::Moments;

/// When to stop.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Params {
    /// At most this many times the points move.
    pub iterations: usize,
    /// Stop when the movement D (§4 step 3) is not above this part of the region's area, that is when the mean
    /// squared move is not above this part of the mean area of a cell. Negative or NaN never stops.
    pub tolerance: f64,
}

impl Default for Params {
    /// 200 iterations; a tolerance of 1e-6, moves of a thousandth of a cell's size.
    fn default() -> Self {
        Self {
            iterations: 200,
            tolerance: 1e-6,
        }
    }
}

/// Why the iteration stopped. The points are valid in every case.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stop {
    /// The points are the mass centroids of their cells, up to the tolerance.
    Converged,
    /// The budget of iterations is used up.
    OutOfIterations,
    /// The next step would put all points on one line, where they have no triangulation. That happens to few
    /// points in a long region.
    OnOneLine,
    /// The report closure stopped it.
    Cancelled,
}

/// What has come out.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// The generators after the last move.
    pub generators: Generators,
    /// The cost F of the start and after each move; without the last when the iteration was cancelled.
    pub costs: Vec<f64>,
    /// Why it stopped.
    pub stop: Stop,
}

/// Generators of a centroidal Voronoi tessellation for density 1, near the given ones.
///
/// An iteration takes the time of a Delaunay triangulation and of all Voronoi cells, n log n. `report` is told
/// of every 4096th cell and cancels the work by [`ControlFlow::Break`]. Source: §3.2, steps 0–3.
#[must_use]
pub fn lloyd(
    generators: Generators,
    params: &Params,
    report: &mut dyn FnMut(Progress) -> ControlFlow<()>,
) -> Outcome {
    let uniform = |cell: &ConvexPolygon, z| Ok::<_, Infallible>(Moments::uniform(cell, z));
    let Ok(outcome) = iterate(generators, params, uniform, report);
    outcome
}

/// Generators of a centroidal Voronoi tessellation for a given density, near the given ones.
///
/// Where the density is greater, the cells are smaller: their size goes with the density to the power -1/4.
/// For the rest like [`lloyd`]. Source: §3.2, steps 0–3.
///
/// # Errors
/// [`DensityError`] where the density is asked for, always in the region, and is not finite or not positive.
pub fn lloyd_with(
    generators: Generators,
    density: impl Fn(DVec2) -> f64,
    params: &Params,
    report: &mut dyn FnMut(Progress) -> ControlFlow<()>,
) -> Result<Outcome, DensityError> {
    iterate(
        generators,
        params,
        |cell, z| Moments::weighted(cell, z, &density),
        report,
    )
}

fn iterate<E>(
    mut generators: Generators,
    params: &Params,
    moments: impl Fn(&ConvexPolygon, DVec2) -> Result<Moments, E>,
    report: &mut dyn FnMut(Progress) -> ControlFlow<()>,
) -> Result<Outcome, E> {
    let cells = generators.points().len();
    let steps = cells.saturating_mul(params.iterations.saturating_add(1));
    let enough = params.tolerance * generators.region().area();
    let mut costs = Vec::new();
    let Ok(mut meter) = Meter::start(report, "lloyd", steps) else {
        return Ok(Outcome {
            generators,
            costs,
            stop: Stop::Cancelled,
        });
    };
    let stop = loop {
        let Some(survey) = survey(&generators, &moments, &mut meter)? else {
            break Stop::Cancelled;
        };
        costs.push(survey.cost);
        if survey.movement <= enough {
            break Stop::Converged;
        }
        if costs.len() > params.iterations {
            break Stop::OutOfIterations;
        }
        match generators.moved(survey.targets, generators.places().to_vec()) {
            Some(moved) => generators = moved,
            None => break Stop::OnOneLine,
        }
    };
    Ok(Outcome {
        generators,
        costs,
        stop,
    })
}
