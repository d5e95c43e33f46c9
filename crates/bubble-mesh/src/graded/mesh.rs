//! The whole, step by step.

use std::ops::ControlFlow;

use delaunay_core::Complex2;
use delaunay_core::measure::triangle::radius_ratio;
use delaunay_core::progress::{Meter, Progress};

use super::energy::{FIRST, LAST};
use super::optimize::{Sweeps, optimize};
use super::params::{GradedError, GradedParams, Stop};
use super::place::{Order, Placed, place};
use super::relax::relax;
use super::size::SizeField;
use crate::domain::Domain;

/// A graded mesh.
#[derive(Clone, Debug)]
pub struct GradedMesh {
    /// The triangles; the boundary nodes are those of the domain, with the same ids.
    pub complex: Complex2,
    /// The size asked for at each node, by vertex.
    pub sizes: Vec<f64>,
    /// Why it ended.
    pub stop: Stop,
}

/// The mesh of a region whose boundary edges say how large its triangles should be.
///
/// The boundary stays as it is. Takes n log n time; `report` cancels the work by [`ControlFlow::Break`]. The same domain gives
/// the same mesh, bit for bit, on any number of threads.
///
/// # Errors
/// [`GradedError`] when the parameters are none to work with.
pub fn mesh(
    domain: &Domain,
    params: &GradedParams,
    report: &mut dyn FnMut(Progress) -> ControlFlow<()>,
) -> Result<GradedMesh, GradedError> {
    params.check()?;
    // The bubble of a node with two edges of length l has radius 0.3713 l.
    let per_radius = (4.0 * std::f64::consts::PI / 3.0_f64.sqrt()).sqrt();
    let sizes: Vec<f64> = domain
        .bubbles()
        .iter()
        .map(|bubble| per_radius * bubble.radius)
        .collect();
    let places = domain.region().points().iter().copied();
    let field = SizeField::new(places.zip(sizes.iter().copied()), params.scale);
    let Ok(mut meter) = Meter::start(report, "place nodes", 0) else {
        return Ok(unmeshed(domain, sizes));
    };
    let placed = place(
        domain.region(),
        &sizes,
        &field,
        if std::env::var("LF").is_ok() { Order::LargestFirst } else { Order::LayersFirst },
        params.nodes,
        &mut meter,
    );
    let Placed {
        region,
        sizes,
        stop,
    } = placed;
    let mut mesh = GradedMesh {
        complex: Complex2::of(region),
        sizes,
        stop,
    };
    if mesh.stop != Stop::Cancelled
        && let Err(stop) = mesh.improve(params, report)
    {
        mesh.stop = stop;
    }
    Ok(mesh)
}

fn unmeshed(domain: &Domain, sizes: Vec<f64>) -> GradedMesh {
    GradedMesh {
        complex: Complex2::of(domain.region().clone()),
        sizes,
        stop: Stop::Cancelled,
    }
}

impl GradedMesh {
    /// Moves nodes and flips edges for better shapes.
    fn improve(
        &mut self,
        params: &GradedParams,
        report: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<(), Stop> {
        let mut meter = Meter::start(report, "relax", 0)?;
        relax(
            &mut self.complex,
            &self.sizes,
            params.relaxation,
            &mut meter,
        )?;
        let mut meter = Meter::start(report, "optimize", 0)?;
        let first = Sweeps {
            energy: FIRST,
            tolerance: 1e-2,
            limit: params.sweeps,
            below: 2.0,
        };
        optimize(&mut self.complex, first, &mut meter)?;
        let mut polished = self.complex.clone();
        let last = Sweeps {
            energy: LAST,
            tolerance: 3e-3,
            below: 0.94,
            ..first
        };
        optimize(&mut polished, last, &mut meter)?;
        let [before, after] = [&self.complex, &polished].map(quality);
        if after.0 - before.0 > 0.5 * (before.1 - after.1) {
            self.complex = polished;
        }
        Ok(())
    }
}

/// The least radius ratio and the mean.
fn quality(complex: &Complex2) -> (f64, f64) {
    let (mut least, mut sum, mut count) = (f64::INFINITY, 0.0, 0.0_f64);
    for f in complex.faces() {
        let ratio = radius_ratio(complex.triangle(f));
        least = least.min(ratio);
        sum += ratio;
        count += 1.0;
    }
    (least, sum / count.max(1.0))
}
