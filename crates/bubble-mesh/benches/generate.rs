//! Generation (§2.4) of a square with equal edges: the cost per node from 10^4 to 10^6 nodes should be flat.
//!
//! `cargo bench -p bubble-mesh --bench generate` prints nodes per second.

#[path = "../tests/regions/mod.rs"]
mod regions;

use std::hint::black_box;
use std::time::Duration;

use bubble_mesh::paper::{Params, generate};
use criterion::{
    BenchmarkId, Criterion, SamplingMode, Throughput, criterion_group, criterion_main,
};
use delaunay_core::progress::silent;

fn square(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("generate");
    group
        .sample_size(10)
        .sampling_mode(SamplingMode::Flat)
        .warm_up_time(Duration::from_millis(500))
        .measurement_time(Duration::from_secs(3));
    let params = Params {
        nodes: usize::MAX,
        ..Params::paper()
    };
    for edges in [93, 294, 930] {
        let domain = regions::domain(&[regions::square(edges, 0.0)]);
        let nodes = generate(&domain, &params, &mut silent).bubbles().len();
        group.throughput(Throughput::Elements(nodes as u64));
        let id = BenchmarkId::new("square", nodes);
        group.bench_with_input(id, &domain, |bencher, domain| {
            bencher.iter(|| black_box(generate(domain, &params, &mut silent)));
        });
    }
    group.finish();
}

criterion_group!(benches, square);
criterion_main!(benches);
