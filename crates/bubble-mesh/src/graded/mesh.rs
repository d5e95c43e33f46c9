//! The whole, step by step.

use std::ops::ControlFlow;
use std::sync::Mutex;

use delaunay_core::Complex2;
use delaunay_core::measure::triangle::radius_ratio;
use delaunay_core::progress::{Cancelled, Meter, Progress};

use super::energy::{FIRST, LAST};
use super::optimize::{Sweeps, optimize, optimize_on};
use super::params::{GradedError, GradedParams, Stop};
use super::place::{Order, place};
use super::relax::relax;
use super::search::search;
use super::size::{SizeField, Sizing};
use crate::boundary::{Rails, is_boundary_simple};
use crate::domain::Domain;

/// A graded mesh.
#[derive(Clone, Debug)]
pub struct GradedMesh {
    /// The triangles; the boundary nodes are those of the domain, with the same ids, in the same places unless they slide.
    pub complex: Complex2,
    /// Why it ended.
    pub stop: Stop,
}

/// The mesh of a region whose boundary edges say how large its triangles should be.
///
/// The boundary stays as it is. Two meshes are started, one from the largest gaps and one layer by layer, and the one with the
/// better shapes is kept. Takes n log n time; `report` cancels the work by [`ControlFlow::Break`]. The same domain gives the
/// same mesh, bit for bit, on any number of threads.
///
/// ```
/// use bubble_mesh::graded::{GradedParams, mesh};
/// use bubble_mesh::{Domain, radius_ratio};
/// use delaunay_core::{BuildOptions, Outline, VertexId, progress::silent};
/// use glam::DVec2;
///
/// // A circle with 60 nodes.
/// let node = |i: usize| DVec2::from_angle(i as f64 * std::f64::consts::TAU / 60.0);
/// let edges = (0..60).map(|i| [i, (i + 1) % 60].map(VertexId::new));
/// let circle = Outline::new((0..60).map(node).collect(), edges.collect())?;
/// let domain = Domain::new(&circle, BuildOptions::default(), &mut silent)?;
/// let mesh = mesh(&domain, &GradedParams::default(), &mut silent)?.complex;
/// assert!(mesh.faces().all(|f| radius_ratio(mesh.triangle(f)) > 0.9));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`GradedError`] when the parameters are none to work with.
pub fn mesh(
    domain: &Domain,
    params: &GradedParams,
    report: &mut (dyn FnMut(Progress) -> ControlFlow<()> + Send),
) -> Result<GradedMesh, GradedError> {
    mesh_sized(domain, params, None, report)
}

/// As [`mesh`], with triangles inside that are no larger than `sizing` says: it gives the length of edges at a place.
///
/// It is asked on several threads, at places inside and a little beyond the boundary. The boundary stays as it is, so what is smaller than
/// the boundary asks for grows from it as fast as it must.
///
/// # Errors
/// [`GradedError`] when the parameters are none to work with, or a size is not a finite number above zero.
pub fn mesh_sized(
    domain: &Domain,
    params: &GradedParams,
    sizing: Option<Sizing<'_>>,
    report: &mut (dyn FnMut(Progress) -> ControlFlow<()> + Send),
) -> Result<GradedMesh, GradedError> {
    params.check()?;
    let sizes = boundary_sizes(domain);
    let places = domain.region().points().iter().copied();
    let nodes = places.zip(sizes.iter().copied());
    let field = SizeField::new(nodes, params.scale, params.grade, sizing);
    let report = Mutex::new(Some(report));
    let start = |order: Order| start(domain, &sizes, &field, order, params, &mut told(&report));
    let (layers, gaps) = rayon::join(|| start(Order::LayersFirst), || start(Order::LargestFirst));
    let (layers, gaps) = (layers?, gaps?);
    let mut mesh = if gaps.is_better_than(&layers) {
        gaps
    } else {
        layers
    };
    if mesh.stop != Stop::Cancelled
        && let Err(cancelled) = mesh.finish(domain, params, &mut told(&report))
    {
        mesh.stop = cancelled.into();
    }
    Ok(mesh)
}

/// The closure of the caller, which all threads report through; none once it has stopped one of them, so that it stops all.
type Told<'a> = Mutex<Option<&'a mut (dyn FnMut(Progress) -> ControlFlow<()> + Send)>>;

/// A closure for one thread that reports through that of all.
fn told<'a>(report: &'a Told<'_>) -> impl FnMut(Progress) -> ControlFlow<()> + 'a {
    move |progress| {
        // Without a lock another thread has panicked in the closure.
        let Ok(mut report) = report.lock() else {
            return ControlFlow::Break(());
        };
        let flow = report
            .as_mut()
            .map_or(ControlFlow::Break(()), |report| report(progress));
        if flow.is_break() {
            *report = None;
        }
        flow
    }
}

/// The sizes of the boundary nodes, by vertex: the root of the mean square of their edges.
fn boundary_sizes(domain: &Domain) -> Vec<f64> {
    // The bubble of a node has the area of the regular triangle of its size.
    let per_radius = (4.0 * std::f64::consts::PI / 3.0_f64.sqrt()).sqrt();
    let bubbles = domain.bubbles().iter();
    bubbles.map(|bubble| per_radius * bubble.radius).collect()
}

/// More nodes than this are numbered anew after they are placed, as the order in which they came is that of no place.
const OUT_OF_CACHE: usize = 8192;

/// Places nodes in one order, evens them out and makes their triangles better.
fn start(
    domain: &Domain,
    sizes: &[f64],
    field: &SizeField<'_>,
    order: Order,
    params: &GradedParams,
    report: &mut dyn FnMut(Progress) -> ControlFlow<()>,
) -> Result<GradedMesh, GradedError> {
    let Ok(mut meter) = Meter::start(report, "place nodes", 0) else {
        return Ok(GradedMesh {
            complex: Complex2::of(domain.region().clone()),
            stop: Stop::Cancelled,
        });
    };
    let nodes = params.nodes;
    let placed = place(domain.region(), sizes, field, order, nodes, &mut meter)?;
    let (mut complex, mut sizes) = (Complex2::of(placed.region), placed.sizes);
    if sizes.len() > OUT_OF_CACHE {
        let (renumbered, before) = complex.renumbered();
        sizes = before.iter().map(|v| sizes[v.index()]).collect();
        complex = renumbered;
    }
    let stop = placed.stop;
    let mut mesh = GradedMesh { complex, stop };
    if mesh.stop != Stop::Cancelled
        && let Err(cancelled) = mesh.improve(&sizes, params, report)
    {
        mesh.stop = cancelled.into();
    }
    Ok(mesh)
}

/// Sweeps of all nodes, for the mean.
fn first_sweeps(params: &GradedParams) -> Sweeps {
    Sweeps {
        energy: FIRST,
        tolerance: 1e-2,
        limit: params.sweeps,
        below: f64::INFINITY,
    }
}

impl GradedMesh {
    /// Evens out the places of the nodes, then makes the shapes better.
    fn improve(
        &mut self,
        sizes: &[f64],
        params: &GradedParams,
        report: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<(), Cancelled> {
        let mut meter = Meter::start(report, "relax", 0)?;
        relax(&mut self.complex, sizes, params.relaxation, &mut meter)?;
        let mut meter = Meter::start(report, "optimize", 0)?;
        optimize(&mut self.complex, first_sweeps(params), &mut meter)
    }

    /// Changes the connectivity where that pays, and makes the worst triangles better.
    fn finish(
        &mut self,
        domain: &Domain,
        params: &GradedParams,
        report: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<(), Cancelled> {
        if params.trials > 0 {
            let mut meter = Meter::start(report, "search", params.trials)?;
            search(&mut self.complex, params.trials, params.nodes, &mut meter)?;
            optimize(&mut self.complex, first_sweeps(params), &mut meter)?;
        }
        if let Some(crease) = params.sliding {
            let mut meter = Meter::start(report, "slide", 0)?;
            self.slide(domain, crease, first_sweeps(params), &mut meter)?;
        }
        self.polish(params, report)
    }

    /// Makes the shapes better with boundary nodes that slide, unless parts of the boundary would meet then.
    fn slide(
        &mut self,
        domain: &Domain,
        crease: f64,
        sweeps: Sweeps,
        meter: &mut Meter<'_>,
    ) -> Result<(), Cancelled> {
        // Nodes that no curve goes through, far out for instance, stay.
        let Ok(mut rails) = Rails::of(domain, crease) else {
            return Ok(());
        };
        let mut slid = self.complex.clone();
        optimize_on(&mut slid, Some(&mut rails), sweeps, meter)?;
        if is_boundary_simple(&slid) {
            self.complex = slid;
        }
        Ok(())
    }

    /// Makes the worst triangles better at the cost of others, unless the mean loses more than the worst gain.
    fn polish(
        &mut self,
        params: &GradedParams,
        report: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<(), Cancelled> {
        let mut meter = Meter::start(report, "polish", 0)?;
        let mut polished = self.complex.clone();
        let sweeps = Sweeps {
            energy: LAST,
            tolerance: 3e-3,
            limit: params.sweeps,
            below: 0.94,
        };
        optimize(&mut polished, sweeps, &mut meter)?;
        let [before, after] = [&self.complex, &polished].map(Quality::of);
        if after.least - before.least > 0.5 * (before.mean - after.mean) {
            self.complex = polished;
        }
        Ok(())
    }

    /// Whether it is complete and its triangles cost less on average than those of another mesh, or the other is not complete.
    fn is_better_than(&self, other: &Self) -> bool {
        let cost = |mesh: &Self| {
            let costs = mesh
                .complex
                .faces()
                .map(|f| FIRST.of(mesh.complex.triangle(f)));
            let (sum, count) =
                costs.fold((0.0, 0.0), |(sum, count), cost| (sum + cost, count + 1.0));
            sum / f64::max(count, 1.0)
        };
        match (self.stop, other.stop) {
            (Stop::Cancelled, _) => false,
            (_, Stop::Cancelled) => true,
            _ => cost(self) < cost(other),
        }
    }
}

/// Radius ratios of triangles.
struct Quality {
    least: f64,
    mean: f64,
}

impl Quality {
    fn of(complex: &Complex2) -> Self {
        let ratios = complex.faces().map(|f| radius_ratio(complex.triangle(f)));
        let (mut least, mut sum, mut count) = (1.0, 0.0, 0.0);
        for ratio in ratios {
            least = f64::min(least, ratio);
            sum += ratio;
            count += 1.0;
        }
        Self {
            least,
            mean: sum / f64::max(count, 1.0),
        }
    }
}
