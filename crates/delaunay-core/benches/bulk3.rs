//! Bulk builds of space on uniform, cospherical and lattice points, on one thread and on two.
//!
//! `cargo bench -p delaunay-core --bench bulk3` prints points per second. The time is that of the whole
//! call, from a slice of points to the finished mesh. `docs/performance.md` has larger sets, beside peers.

#[path = "../tests/clouds/mod.rs"]
mod clouds;

use clouds::space::{lattice, rng, sphere, uniform};
use criterion::{
    BenchmarkId, Criterion, SamplingMode, Throughput, criterion_group, criterion_main,
};
use delaunay_core::progress::silent;
use delaunay_core::{BuildOptions, Delaunay3};
use glam::DVec3;
use rand::seq::SliceRandom;
use std::hint::black_box;
use std::time::Duration;

fn inputs() -> Vec<(&'static str, Vec<DVec3>)> {
    let mut scattered = lattice([46, 46, 46]);
    scattered.shuffle(&mut rng(1));
    vec![
        ("uniform", uniform(100_000, 1)),
        ("uniform", uniform(1_000_000, 1)),
        ("lattice", scattered),
        ("sphere", sphere(50_000, 1)),
    ]
}

fn bulk(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("bulk in space");
    group
        .sample_size(10)
        .sampling_mode(SamplingMode::Flat)
        .warm_up_time(Duration::from_millis(500))
        .measurement_time(Duration::from_secs(5));
    for (name, points) in inputs() {
        group.throughput(Throughput::Elements(points.len() as u64));
        for threads in [1, 2] {
            let id = BenchmarkId::new(format!("{name}, {threads} threads"), points.len());
            let options = BuildOptions::on_threads(threads);
            group.bench_with_input(id, &points, |bencher, points| {
                bencher.iter(|| {
                    let built = Delaunay3::build_on(points, options, &mut silent);
                    black_box(built.map(|delaunay| delaunay.vertex_count()))
                });
            });
        }
    }
    group.finish();
}

criterion_group!(benches, bulk);
criterion_main!(benches);
