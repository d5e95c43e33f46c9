//! Times of `robust`, called directly, over times of this crate: interleaved rounds, medians.
#![allow(missing_docs)]

mod inputs;

use geo_predicates::{DVec2, DVec3, Sign};
use inputs::{KINDS, planar, spatial};
use robust::{Coord, Coord3D};
use std::hint::black_box;
use std::time::Instant;

const ROUNDS: usize = 41;

fn main() {
    println!(
        "{:<10} {:<8} {:>10} {:>10} {:>7}",
        "predicate", "input", "robust ns", "ours ns", "ratio"
    );
    for kind in KINDS {
        let queries = planar::<3>(kind);
        row(
            "orient2d",
            kind,
            &queries,
            |&[a, b, c]| robust::orient2d(flat(a), flat(b), flat(c)),
            |&[a, b, c]| geo_predicates::orient2d(a, b, c),
        );
        let queries = planar::<4>(kind);
        row(
            "in_circle",
            kind,
            &queries,
            |&[a, b, c, d]| robust::incircle(flat(a), flat(b), flat(c), flat(d)),
            |&[a, b, c, d]| geo_predicates::in_circle(a, b, c, d),
        );
        let queries = spatial::<4>(kind);
        row(
            "orient3d",
            kind,
            &queries,
            |&[a, b, c, d]| -robust::orient3d(solid(a), solid(b), solid(c), solid(d)),
            |&[a, b, c, d]| geo_predicates::orient3d(a, b, c, d),
        );
        let queries = spatial::<5>(kind);
        row(
            "in_sphere",
            kind,
            &queries,
            |&[a, b, c, d, e]| -robust::insphere(solid(a), solid(b), solid(c), solid(d), solid(e)),
            |&[a, b, c, d, e]| geo_predicates::in_sphere(a, b, c, d, e),
        );
    }
}

fn row<Q>(
    name: &str,
    kind: inputs::Kind,
    queries: &[Q],
    theirs: impl Fn(&Q) -> f64,
    ours: impl Fn(&Q) -> Sign,
) {
    for query in queries {
        assert_eq!(Sign::of(theirs(query)), ours(query), "{name}, {kind:?}");
    }
    let repeats = if kind == inputs::Kind::Generic { 40 } else { 4 };
    let mut times = [Vec::new(), Vec::new()];
    for _ in 0..ROUNDS {
        times[0].push(seconds(repeats, || {
            queries
                .iter()
                .map(|q| {
                    i64::from({
                        let d = theirs(q);
                        d > 0.0
                    }) - 0
                })
                .sum()
        }));
        times[1].push(seconds(repeats, || {
            queries.iter().map(|q| ours(q) as i64).sum()
        }));
    }
    let each = 1e9 / (repeats * queries.len()) as f64;
    let [theirs, ours] = times.map(|mut times| {
        times.sort_by(f64::total_cmp);
        times[ROUNDS / 2] * each
    });
    println!(
        "{name:<10} {:<8} {theirs:>10.2} {ours:>10.2} {:>7.2}",
        format!("{kind:?}"),
        theirs / ours
    );
}

fn seconds(repeats: usize, work: impl Fn() -> i64) -> f64 {
    let start = Instant::now();
    for _ in 0..repeats {
        black_box(work());
    }
    start.elapsed().as_secs_f64()
}

fn flat(p: DVec2) -> Coord<f64> {
    Coord { x: p.x, y: p.y }
}

fn solid(p: DVec3) -> Coord3D<f64> {
    Coord3D {
        x: p.x,
        y: p.y,
        z: p.z,
    }
}
