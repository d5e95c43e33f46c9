//! Voronoi cells of uniform points, clipped to the unit cube, with their moments.
//!
//! `cargo bench -p delaunay-core --bench voronoi3` prints cells per second on one thread; the reciprocal is
//! the time per cell. The cells of 1000 vertices in a row are made, those of the first in the cube.

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use delaunay_core::{ConvexPolyhedron, Delaunay3, VertexId};
use glam::DVec3;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::hint::black_box;
use std::time::Duration;

fn uniform(count: usize, seed: u64) -> Vec<DVec3> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    (0..count)
        .map(|_| DVec3::new(rng.random(), rng.random(), rng.random()))
        .collect()
}

fn cells(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("cells");
    group
        .sample_size(10)
        .warm_up_time(Duration::from_millis(500))
        .measurement_time(Duration::from_secs(3));
    let Ok(window) = ConvexPolyhedron::cuboid(DVec3::ZERO, DVec3::ONE) else {
        return;
    };
    for count in [10_000, 100_000] {
        let Ok(delaunay) = Delaunay3::build(&uniform(count, 1)) else {
            continue;
        };
        let voronoi = delaunay.voronoi();
        group.throughput(Throughput::Elements(1000));
        group.bench_function(BenchmarkId::new("carved", count), |bencher| {
            let mut carver = voronoi.carver(&window);
            bencher.iter(|| {
                for v in (0..1000).map(VertexId::new) {
                    black_box(carver.cell(v));
                }
            });
        });
        group.bench_function(BenchmarkId::new("carved and measured", count), |bencher| {
            let mut carver = voronoi.carver(&window);
            bencher.iter(|| {
                for v in (0..1000).map(VertexId::new) {
                    black_box(carver.cell(v).moments());
                }
            });
        });
    }
    group.finish();
}

criterion_group!(benches, cells);
criterion_main!(benches);
