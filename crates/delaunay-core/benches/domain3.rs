//! A closed surface judged: a bumpy sphere of 10^5 triangles, and the same with some points moved.
//!
//! `cargo bench -p delaunay-core --bench domain3` prints triangles per second. The time is that of the whole call, from points and
//! triangles to the domain or its defects, on one thread and on two; most of it is the search for intersections.

#[path = "../tests/clouds/mod.rs"]
mod clouds;

use clouds::space::{rng, sphere};
use criterion::{
    BenchmarkId, Criterion, SamplingMode, Throughput, criterion_group, criterion_main,
};
use delaunay_core::progress::silent;
use delaunay_core::{BuildError, Delaunay3, Domain3, Domain3Options, VertexId};
use glam::DVec3;
use rand::RngExt;
use rayon::ThreadPoolBuilder;
use std::hint::black_box;
use std::time::Duration;

/// The hull of directions, each pulled out by waves.
fn bumpy_sphere(triangles: usize) -> Result<(Vec<DVec3>, Vec<[VertexId; 3]>), BuildError> {
    let directions = sphere(triangles / 2 + 2, 1);
    let hull = Delaunay3::build(&directions)?;
    let facets = hull.hull().map(|f| hull.mesh().facet_vertices(f));
    let bumps = |p: &DVec3| p * (1.0 + 0.1 * (9.0 * p.x).sin() * (8.0 * p.y).sin());
    Ok((directions.iter().map(bumps).collect(), facets.collect()))
}

/// Some points moved by about the length of an edge.
fn shaken(mut points: Vec<DVec3>, count: usize) -> Vec<DVec3> {
    let mut random = rng(2);
    for _ in 0..count {
        let moved = random.random_range(0..points.len());
        let step = DVec3::from([(); 3].map(|()| random.random_range(-0.01..0.01)));
        points[moved] += step;
    }
    points
}

fn judge(criterion: &mut Criterion) {
    let Ok((points, triangles)) = bumpy_sphere(100_000) else {
        return;
    };
    let mut group = criterion.benchmark_group("domain");
    group
        .sample_size(10)
        .sampling_mode(SamplingMode::Flat)
        .warm_up_time(Duration::from_millis(500))
        .measurement_time(Duration::from_secs(5))
        .throughput(Throughput::Elements(triangles.len() as u64));
    for threads in [1, 2] {
        let Ok(pool) = ThreadPoolBuilder::new().num_threads(threads).build() else {
            return;
        };
        for (name, points) in [
            ("valid", points.clone()),
            ("shaken", shaken(points.clone(), 2000)),
        ] {
            let id = BenchmarkId::new(format!("{name}, {threads} threads"), triangles.len());
            group.bench_with_input(id, &points, |bencher, points| {
                let options = Domain3Options {
                    drop_unused: true,
                    ..Domain3Options::default()
                };
                let build = || Domain3::build(points, &triangles, options, &mut silent);
                bencher.iter(|| pool.install(|| black_box(build().is_ok())));
            });
        }
    }
    group.finish();
}

criterion_group!(benches, judge);
criterion_main!(benches);
