//! The cost functional F and the movement D (§3.1, §4 step 3), which one pass over all cells gives.

use std::convert::Infallible;

use delaunay_core::ConvexPolygon;
use delaunay_core::progress::Meter;
use glam::DVec2;

use crate::error::DensityError;
use crate::generators::Generators;
use crate::moments::Moments;

/// The cost F of the Voronoi tessellation for density 1: the sum over the cells of ∫ |x - z|² dx.
///
/// Fourth power of the unit of length. Exact up to rounding; O(n). Source: §3.1.
#[must_use]
pub fn cost(generators: &Generators) -> f64 {
    let Ok(costs) = moments_of_cells(generators, |cell, z| {
        Ok::<_, Infallible>(Moments::uniform(cell, z))
    });
    costs.iter().map(|moments| moments.second).sum()
}

/// The cost F of the Voronoi tessellation for a given density ρ: the sum over the cells of ∫ ρ |x - z|² dx.
///
/// By quadrature, see [`Moments`]; O(n). Source: §3.1.
///
/// # Errors
/// [`DensityError`] where the density is not finite or not positive.
pub fn cost_with(
    generators: &Generators,
    density: impl Fn(DVec2) -> f64,
) -> Result<f64, DensityError> {
    let costs = moments_of_cells(generators, |cell, z| Moments::weighted(cell, z, &density))?;
    Ok(costs.iter().map(|moments| moments.second).sum())
}

/// The moments of every cell about its generator, by point.
fn moments_of_cells<E>(
    generators: &Generators,
    moments: impl Fn(&ConvexPolygon, DVec2) -> Result<Moments, E>,
) -> Result<Vec<Moments>, E> {
    let points = generators.points().iter().enumerate();
    points
        .map(|(i, &point)| moments(&generators.cell(i), point))
        .collect()
}

/// What one pass over all cells finds.
pub(crate) struct Survey {
    /// The cost F.
    pub(crate) cost: f64,
    /// The movement D: sum of the squared distances between points and targets.
    pub(crate) movement: f64,
    /// Where each point should go: the mass centroid of its cell, or what is nearest to that in the place to
    /// which the point is bound; the point itself where the cell is empty.
    pub(crate) targets: Vec<DVec2>,
}

/// One pass over all cells, a step of `meter` each; `None` when the meter says stop.
pub(crate) fn survey<E>(
    generators: &Generators,
    moments: impl Fn(&ConvexPolygon, DVec2) -> Result<Moments, E>,
    meter: &mut Meter<'_>,
) -> Result<Option<Survey>, E> {
    let points = generators.points();
    let mut survey = Survey {
        cost: 0.0,
        movement: 0.0,
        targets: Vec::with_capacity(points.len()),
    };
    for (i, (&point, place)) in points.iter().zip(generators.places()).enumerate() {
        let moments = moments(&generators.cell(i), point)?;
        let target = match moments.mass_center(point) {
            Some(center) => place.nearest(generators.region(), center),
            None => point,
        };
        survey.cost += moments.second;
        survey.movement += target.distance_squared(point);
        survey.targets.push(target);
        if meter.advance().is_err() {
            return Ok(None);
        }
    }
    Ok(Some(survey))
}
