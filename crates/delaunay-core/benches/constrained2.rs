//! Constrained triangulations: many short segments beside `spade`, and one segment across very many triangles.
//!
//! `cargo bench -p delaunay-core --bench constrained2`. The time is that of the whole call, from slices of points and
//! segments to the finished mesh; for the one long segment that of the segment alone.

#[path = "../tests/clouds/mod.rs"]
mod clouds;

use criterion::{
    BatchSize, BenchmarkId, Criterion, SamplingMode, Throughput, criterion_group, criterion_main,
};
use delaunay_core::progress::silent;
use delaunay_core::{BuildOptions, Constrained2, Crossings, Delaunay2, VertexId};
use glam::DVec2;
use spade::{ConstrainedDelaunayTriangulation, Point2, Triangulation};
use std::hint::black_box;
use std::time::Duration;

/// A tenth of the points joined by the edges of their own triangulation, as many as points in that tenth.
fn segments(points: &[DVec2]) -> Vec<[VertexId; 2]> {
    let some = points.len() / 10;
    let Ok(coarse) = Delaunay2::build(&points[..some]) else {
        return Vec::new();
    };
    let mesh = coarse.mesh();
    let edges = mesh.half_edges().filter(|&h| h < mesh.twin(h));
    let ends = edges.map(|h| [mesh.origin(h), mesh.target(h)]);
    let real = ends.filter(|ends| !ends.iter().any(|v| v.is_ghost()));
    // Every third edge, from all over the plane.
    real.step_by(3).take(some).collect()
}

fn many_segments(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("constrained");
    group
        .sample_size(10)
        .sampling_mode(SamplingMode::Flat)
        .warm_up_time(Duration::from_millis(500))
        .measurement_time(Duration::from_secs(3));
    for count in [100_000, 1_000_000] {
        let points = clouds::uniform(count, 1);
        let segments = segments(&points);
        group.throughput(Throughput::Elements(count as u64));
        let build = || {
            let options = BuildOptions::default();
            Constrained2::build(&points, &segments, Crossings::Refuse, options, &mut silent)
        };
        group.bench_function(
            BenchmarkId::new("points and a tenth as many segments", count),
            |bencher| {
                bencher.iter(|| black_box(build().map(|built| built.mesh().face_count())));
            },
        );
        let places: Vec<Point2<f64>> = points.iter().map(|p| Point2::new(p.x, p.y)).collect();
        let ends: Vec<[usize; 2]> = segments
            .iter()
            .map(|ends| ends.map(VertexId::index))
            .collect();
        group.bench_function(BenchmarkId::new("the same, spade", count), |bencher| {
            bencher.iter_batched(
                || (places.clone(), ends.clone()),
                |(places, ends)| {
                    let built = ConstrainedDelaunayTriangulation::<Point2<f64>>::bulk_load_cdt(
                        places, ends,
                    );
                    black_box(built.map(|built| built.num_vertices()))
                },
                BatchSize::PerIteration,
            );
        });
    }
    group.finish();
}

fn one_segment(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("one segment");
    group.sample_size(10);
    // A strip so thin that a way along it crosses a hundred thousand triangles.
    let mut points = clouds::uniform(400_000, 1);
    points.iter_mut().for_each(|p| p.y *= 2e-4);
    let ends = [points.len(), points.len() + 1].map(VertexId::new);
    points.extend([DVec2::new(-0.1, 0.5e-4), DVec2::new(1.1, 1.5e-4)]);
    let Ok(delaunay) = Delaunay2::build(&points) else {
        return;
    };
    let strip = Constrained2::of(delaunay);
    group.bench_function("along a strip", |bencher| {
        bencher.iter_batched_ref(
            || strip.clone(),
            |strip| black_box(strip.add_segment(0, ends)),
            BatchSize::PerIteration,
        );
    });
    group.finish();
}

criterion_group!(benches, many_segments, one_segment);
criterion_main!(benches);
