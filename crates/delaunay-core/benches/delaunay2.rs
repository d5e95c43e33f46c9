//! Bulk builds on uniform, clustered, cocircular and lattice points, beside `spade`.
//!
//! `cargo bench -p delaunay-core --bench delaunay2` prints points per second; the cost per point
//! should stay flat from 1e5 to 1e6. The time is that of the whole call, from a slice of points to the
//! finished mesh.

#[path = "../tests/clouds/mod.rs"]
mod clouds;

use criterion::{
    BatchSize, BenchmarkId, Criterion, SamplingMode, Throughput, criterion_group, criterion_main,
};
use delaunay_core::{Delaunay2, VertexId};
use glam::DVec2;
use spade::{DelaunayTriangulation, Point2, Triangulation};
use std::hint::black_box;
use std::time::Duration;

fn ring(count: usize) -> Vec<DVec2> {
    let step = std::f64::consts::TAU / count as f64;
    (0..count)
        .map(|i| DVec2::from_angle(i as f64 * step))
        .collect()
}

fn inputs() -> Vec<(&'static str, Vec<DVec2>)> {
    vec![
        ("uniform", clouds::uniform(100_000, 1)),
        ("uniform", clouds::uniform(1_000_000, 1)),
        ("grid", clouds::grid(1000, 1000)),
        ("clusters", clouds::gaussian_clusters(1_000_000, 2)),
        ("ring", ring(100_000)),
    ]
}

fn bulk(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("bulk");
    group
        .sample_size(10)
        .sampling_mode(SamplingMode::Flat)
        .warm_up_time(Duration::from_millis(500))
        .measurement_time(Duration::from_secs(3));
    for (name, points) in inputs() {
        group.throughput(Throughput::Elements(points.len() as u64));
        let ours = BenchmarkId::new(name, points.len());
        group.bench_with_input(ours, &points, |bencher, points| {
            bencher.iter(|| black_box(Delaunay2::build(points).map(|d| d.vertex_count())));
        });
        let theirs: Vec<Point2<f64>> = points.iter().map(|p| Point2::new(p.x, p.y)).collect();
        let peer = BenchmarkId::new(format!("{name}, spade"), points.len());
        group.bench_with_input(peer, &theirs, |bencher, points| {
            bencher.iter_batched(
                || points.clone(),
                |points| {
                    let built = DelaunayTriangulation::<Point2<f64>>::bulk_load(points);
                    black_box(built.map(|d| d.num_vertices()))
                },
                BatchSize::PerIteration,
            );
        });
    }
    group.finish();
}

fn single(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("single");
    let points = clouds::uniform(100_000, 1);
    let Ok(mut delaunay) = Delaunay2::build(&points) else {
        return;
    };
    let queries = clouds::uniform(1000, 5);
    group.throughput(Throughput::Elements(queries.len() as u64));
    group.bench_function("locate without hint", |bencher| {
        bencher.iter(|| {
            for &p in &queries {
                let _ = black_box(delaunay.locate(p));
            }
        });
    });
    group.bench_function("nearest vertex", |bencher| {
        bencher.iter(|| {
            for &p in &queries {
                let _ = black_box(delaunay.nearest_vertex(p));
            }
        });
    });
    group.bench_function("remove and insert", |bencher| {
        bencher.iter(|| {
            for v in (0..1000).map(VertexId::new) {
                let (p, near) = (delaunay.point(v), delaunay.mesh().neighbors(v).next());
                let _ = black_box(delaunay.remove(v));
                let _ = black_box(delaunay.insert_near(p, near.unwrap_or(v)));
            }
        });
    });
    group.finish();
}

criterion_group!(benches, bulk, single);
criterion_main!(benches);
