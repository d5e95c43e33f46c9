//! What an inserted vertex costs as meshes grow: the same for plates of one thickness, see `--example cost_per_vertex`, which
//! goes on to 10^6 tetrahedra and has cubes too.
//!
//! `cargo bench -p sink-refine --bench growth` prints inserted vertices per second.

use criterion::{
    BatchSize, BenchmarkId, Criterion, SamplingMode, Throughput, criterion_group, criterion_main,
};
use delaunay_core::progress::silent;
use delaunay_core::{Delaunay3, Subcomplex3};
use fixtures::boxes;
use sink_refine::{Candidate, Coarsening, Method, Params, RefineError, Schedule, refine3};
use std::hint::black_box;
use std::time::Duration;

/// Refines; tells how many vertices were inserted.
fn refined(solid: Subcomplex3, method: Method) -> Result<usize, RefineError> {
    let params = Params {
        method,
        ..Params::default()
    };
    Ok(refine3(solid, &params, &mut silent)?.counters.inserted)
}

fn growth(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("plate");
    group
        .sample_size(10)
        .sampling_mode(SamplingMode::Flat)
        .warm_up_time(Duration::from_millis(500))
        .measurement_time(Duration::from_secs(5));
    let candidate = Candidate::Sink;
    let paper = |schedule| Method::Paper {
        candidate,
        schedule,
    };
    for (name, method) in [
        ("Sink, Incremental", paper(Schedule::Incremental)),
        ("Sink, Parallel", paper(Schedule::Parallel)),
        ("Economical", Method::Economical(Coarsening::None)),
    ] {
        for cells in [30, 100] {
            let points = boxes::jittered([cells, cells, 6], 1);
            let hull = Delaunay3::build(&points).expect("points of a box");
            let solid = Subcomplex3::of(&hull, |_| true);
            let inserted = refined(solid.clone(), method).expect("the ratio is accepted");
            group.throughput(Throughput::Elements(inserted as u64));
            let id = BenchmarkId::new(name, solid.tets().count());
            group.bench_function(id, |bencher| {
                bencher.iter_batched(
                    || solid.clone(),
                    |solid| black_box(refined(solid, method)),
                    BatchSize::PerIteration,
                );
            });
        }
    }
    group.finish();
}

criterion_group!(benches, growth);
criterion_main!(benches);
