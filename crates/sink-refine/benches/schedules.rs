//! Every way to choose points, on solids of the sink paper.
//!
//! `cargo bench -p sink-refine --bench schedules` prints inserted vertices per second, so methods that insert more have an easier
//! time; divide by it what `--example refine_solid` says that they insert. The star is refined as in the paper, in
//! parallel by sinks, and economically.

use criterion::{
    BatchSize, BenchmarkId, Criterion, SamplingMode, Throughput, criterion_group, criterion_main,
};
use delaunay_core::progress::silent;
use delaunay_core::{BuildOptions, Subcomplex3, Surface, VertexId};
use fixtures::surfaces::{self, Triangles};
use sink_refine::{Candidate, Coarsening, Method, Params, RefineError, Schedule, refine3};
use std::hint::black_box;
use std::time::Duration;

/// The tetrahedra inside a surface.
fn solid(set: Triangles) -> Subcomplex3 {
    let triangles = set.triangles.iter().map(|t| t.map(VertexId::new)).collect();
    let surface = Surface::new(set.points, triangles).expect("a fixture");
    let solid = surface.solid(BuildOptions::default(), &mut silent);
    let solid = solid.expect("a fixture");
    Subcomplex3::of(solid.delaunay(), |t| solid.is_inside(t))
}

/// The methods of the paper.
fn paper() -> impl Iterator<Item = (String, Method)> {
    let candidates = [Candidate::Sink, Candidate::Circumcenter];
    candidates.into_iter().flat_map(|candidate| {
        [Schedule::Incremental, Schedule::Block, Schedule::Parallel].map(|schedule| {
            let method = Method::Paper {
                candidate,
                schedule,
            };
            (format!("{candidate:?}, {schedule:?}"), method)
        })
    })
}

fn economical() -> impl Iterator<Item = (String, Method)> {
    let coarsenings = [Coarsening::None, Coarsening::Removal];
    coarsenings
        .map(|coarsening| {
            (
                format!("Economical, {coarsening:?}"),
                Method::Economical(coarsening),
            )
        })
        .into_iter()
}

/// Refines; tells how many vertices were inserted.
fn refined(solid: Subcomplex3, method: Method) -> Result<usize, RefineError> {
    let params = Params {
        method,
        ..Params::default()
    };
    Ok(refine3(solid, &params, &mut silent)?.counters.inserted)
}

fn schedules(criterion: &mut Criterion) {
    let sink_in_parallel = paper().filter(|(name, _)| name == "Sink, Parallel");
    let merging = Method::Economical(Coarsening::Merging);
    let merging = [("Economical, Merging".to_owned(), merging)];
    for (name, set, methods) in [
        (
            "cuboctahedron",
            surfaces::cuboctahedron(),
            paper()
                .chain(economical())
                .chain(merging)
                .collect::<Vec<_>>(),
        ),
        (
            "paraboloid",
            surfaces::paraboloid(),
            paper().chain(economical()).collect(),
        ),
        (
            "star",
            surfaces::star(),
            sink_in_parallel.chain(economical()).collect(),
        ),
    ] {
        let mut group = criterion.benchmark_group(name);
        group
            .sample_size(10)
            .sampling_mode(SamplingMode::Flat)
            .warm_up_time(Duration::from_millis(500))
            .measurement_time(Duration::from_secs(5));
        let solid = solid(set);
        for (method_name, method) in methods {
            let inserted = refined(solid.clone(), method).expect("the ratio is accepted");
            group.throughput(Throughput::Elements(inserted as u64));
            group.bench_function(BenchmarkId::from_parameter(method_name), |bencher| {
                bencher.iter_batched(
                    || solid.clone(),
                    |solid| black_box(refined(solid, method)),
                    BatchSize::PerIteration,
                );
            });
        }
        group.finish();
    }
}

criterion_group!(benches, schedules);
criterion_main!(benches);
