//! Iterations of the optimization (§3.6) on one thread.
//!
//! `cargo bench -p bubble-mesh --bench optimize` prints interior nodes times iterations per second; the triangulation
//! at the end and the search for nearby nodes at the start count too, once in 200 iterations.

#[path = "../tests/regions/mod.rs"]
mod regions;

use std::hint::black_box;
use std::time::Duration;

use bubble_mesh::paper::{Params, generate, optimize};
use criterion::{
    BenchmarkId, Criterion, SamplingMode, Throughput, criterion_group, criterion_main,
};
use delaunay_core::progress::silent;

fn square(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("optimize");
    group
        .sample_size(10)
        .sampling_mode(SamplingMode::Flat)
        .warm_up_time(Duration::from_millis(500))
        .measurement_time(Duration::from_secs(3));
    let params = Params::paper();
    let Ok(pool) = rayon::ThreadPoolBuilder::new().num_threads(1).build() else {
        return;
    };
    for edges in [93, 294] {
        let domain = regions::domain(&[regions::square(edges, 0.0)]);
        let mesh = generate(&domain, &params, &mut silent);
        let moved = mesh.bubbles().len() - mesh.boundary_nodes();
        group.throughput(Throughput::Elements((moved * params.iterations) as u64));
        let id = BenchmarkId::new("square, one thread", moved);
        group.bench_with_input(id, &mesh, |bencher, mesh| {
            bencher.iter(|| pool.install(|| black_box(optimize(mesh, &params, &mut silent))));
        });
    }
    group.finish();
}

criterion_group!(benches, square);
criterion_main!(benches);
