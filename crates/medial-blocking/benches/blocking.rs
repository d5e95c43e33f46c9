//! Cost of blocking and meshing: time per hole stays flat as the number of holes grows.

use std::hint::black_box;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use glam::DVec2;
use medial_blocking::{Blocking, Circle, Domain, Params, mesh};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// `count` holes of radius 0.1 to 0.35 in the cells of a square grid, inside a circle.
fn random_holes(count: usize) -> (Circle, Vec<Circle>) {
    let mut rng = ChaCha8Rng::seed_from_u64(17);
    let side = (count as f64).sqrt().ceil() as usize;
    let holes = (0..count)
        .map(|k| {
            let radius = rng.random_range(0.1..0.35);
            let reach = 0.49 - radius;
            let offset = DVec2::new(
                rng.random_range(-reach..reach),
                rng.random_range(-reach..reach),
            );
            Circle::new(
                DVec2::new((k % side) as f64, (k / side) as f64) + offset,
                radius,
            )
        })
        .collect();
    let half = side as f64 / 2.0;
    (
        Circle::new(DVec2::splat(half - 0.5), 1.5 * half + 0.5),
        holes,
    )
}

fn blocking(c: &mut Criterion) {
    let mut group = c.benchmark_group("blocking");
    group.sample_size(10);
    for count in [10, 100, 1_000, 10_000] {
        let (bounding, holes) = random_holes(count);
        let domain = Domain::in_circle(bounding, &holes).expect("the holes are disjoint");
        group.throughput(Throughput::Elements(count as u64));
        group.bench_with_input(BenchmarkId::from_parameter(count), &domain, |b, domain| {
            b.iter(|| Blocking::of(black_box(domain)));
        });
    }
    group.finish();
}

fn meshing(c: &mut Criterion) {
    let mut group = c.benchmark_group("mesh 16x16");
    group.sample_size(10);
    for count in [100, 1_000] {
        let (bounding, holes) = random_holes(count);
        group.throughput(Throughput::Elements(count as u64));
        group.bench_function(BenchmarkId::from_parameter(count), |b| {
            b.iter(|| {
                let domain =
                    Domain::in_circle(bounding, black_box(&holes)).expect("the holes are disjoint");
                mesh(&domain, &Params::default())
            });
        });
    }
    group.finish();
}

criterion_group!(benches, blocking, meshing);
criterion_main!(benches);
