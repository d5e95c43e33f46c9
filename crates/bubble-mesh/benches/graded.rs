//! Graded meshes: the paper's regions, and squares with up to a million nodes, whose cost per node should stay flat.
//!
//! `cargo bench -p bubble-mesh --bench graded`

#[path = "../tests/regions/mod.rs"]
mod regions;

use bubble_mesh::graded::{GradedParams, mesh};
use criterion::{
    BenchmarkId, Criterion, SamplingMode, Throughput, criterion_group, criterion_main,
};
use delaunay_core::progress::silent;
use regions::{domain, of_the_paper, square};
use std::hint::black_box;
use std::time::Duration;

fn regions_of_the_paper(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("graded");
    group
        .sample_size(10)
        .measurement_time(Duration::from_secs(3));
    for (name, domain) in of_the_paper() {
        for trials in [0, 1000] {
            let params = GradedParams {
                trials,
                ..GradedParams::default()
            };
            group.bench_function(BenchmarkId::new(name, trials), |bencher| {
                bencher.iter(|| black_box(mesh(&domain, &params, &mut silent)));
            });
        }
    }
    group.finish();
}

fn growth(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("graded square");
    group.sample_size(10).sampling_mode(SamplingMode::Flat);
    for edges in [80, 250, 800] {
        let domain = domain(&[square(edges, 0.0)]);
        let params = GradedParams {
            nodes: usize::MAX,
            ..GradedParams::default()
        };
        let nodes =
            mesh(&domain, &params, &mut silent).map_or(0, |mesh| mesh.complex.points().len());
        group.throughput(Throughput::Elements(nodes as u64));
        group.bench_function(BenchmarkId::from_parameter(nodes), |bencher| {
            bencher.iter(|| black_box(mesh(&domain, &params, &mut silent)));
        });
    }
    group.finish();
}

criterion_group!(benches, regions_of_the_paper, growth);
criterion_main!(benches);
