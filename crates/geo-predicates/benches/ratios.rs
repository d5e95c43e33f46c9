//! Times of `robust`, called directly, over times of this crate, in one table: rounds of the two
//! interleaved, medians of the rounds.

// The table is what this program is for.
#![allow(clippy::print_stdout)]

mod inputs;

use geo_predicates::filter::{
    Filter2, Filter3, Relative2, Relative3, StaticFilter2, StaticFilter3,
};
use geo_predicates::{DVec2, DVec3, Sign};
use inputs::{Kind, QUERIES, flat, solid};
use std::hint::black_box;
use std::time::Instant;

const ROUNDS: usize = 201;
const REPEATS: usize = 2;

fn main() {
    println!("predicate    input    robust ns   ours ns  ratio");
    for kind in inputs::KINDS {
        let queries = inputs::planar(kind);
        row(
            "orient2d",
            kind,
            &queries,
            |&[a, b, c]| robust::orient2d(flat(a), flat(b), flat(c)),
            |&[a, b, c]| geo_predicates::orient2d(a, b, c),
        );
        let queries = inputs::planar(kind);
        row(
            "in_circle",
            kind,
            &queries,
            |&[a, b, c, d]| robust::incircle(flat(a), flat(b), flat(c), flat(d)),
            |&[a, b, c, d]| geo_predicates::in_circle(a, b, c, d),
        );
        let queries = inputs::spatial(kind);
        row(
            "orient3d",
            kind,
            &queries,
            |&[a, b, c, d]| -robust::orient3d(solid(a), solid(b), solid(c), solid(d)),
            |&[a, b, c, d]| geo_predicates::orient3d(a, b, c, d),
        );
        let queries = inputs::spatial(kind);
        row(
            "in_sphere",
            kind,
            &queries,
            |&[a, b, c, d, e]| -robust::insphere(solid(a), solid(b), solid(c), solid(d), solid(e)),
            |&[a, b, c, d, e]| geo_predicates::in_sphere(a, b, c, d, e),
        );
    }
    fixed();
    strips();
    strips_in_space();
}

fn row<Q>(
    name: &str,
    kind: Kind,
    queries: &[Q],
    theirs: impl Fn(&Q) -> f64,
    ours: impl Fn(&Q) -> Sign,
) {
    for query in queries {
        assert_eq!(Sign::of(theirs(query)), ours(query), "{name}, {kind:?}");
    }
    // Rounds must fit into a scheduler's time slice, or waiting is measured on a busy machine.
    let queries = if kind == Kind::Generic {
        queries
    } else {
        &queries[..128]
    };
    race(
        &format!("{name:<12} {kind:?}"),
        queries.len(),
        || queries.iter().filter(|query| theirs(query) > 0.0).count(),
        || {
            queries
                .iter()
                .filter(|query| ours(query) == Sign::Positive)
                .count()
        },
    );
}

/// Static filters for the box of the generic points.
fn fixed() {
    let filter = StaticFilter2::of_box(DVec2::ZERO, DVec2::splat(60.0));
    let queries = inputs::planar(Kind::Generic);
    race(
        "orient2d     static",
        QUERIES,
        || {
            let positive =
                |&&[a, b, c]: &&[DVec2; 3]| robust::orient2d(flat(a), flat(b), flat(c)) > 0.0;
            queries.iter().filter(positive).count()
        },
        || {
            let sign = |&[a, b, c]: &[DVec2; 3]| {
                filter
                    .orient2d(a, b, c)
                    .unwrap_or_else(|| geo_predicates::orient2d(a, b, c))
            };
            queries
                .iter()
                .filter(|query| sign(query) == Sign::Positive)
                .count()
        },
    );
    let queries = inputs::planar(Kind::Generic);
    race(
        "in_circle    static",
        QUERIES,
        || {
            let queries = queries.iter().map(|corners: &[DVec2; 4]| corners.map(flat));
            queries
                .filter(|&[a, b, c, d]| robust::incircle(a, b, c, d) > 0.0)
                .count()
        },
        || {
            let sign = |&[a, b, c, d]: &[DVec2; 4]| {
                let sign = filter.in_circle(a, b, c, d);
                sign.unwrap_or_else(|| geo_predicates::in_circle(a, b, c, d))
            };
            queries
                .iter()
                .filter(|query| sign(query) == Sign::Positive)
                .count()
        },
    );
    let filter = StaticFilter3::of_box(DVec3::ZERO, DVec3::splat(60.0));
    let queries = inputs::spatial(Kind::Generic);
    race(
        "orient3d     static",
        QUERIES,
        || {
            let queries = queries
                .iter()
                .map(|corners: &[DVec3; 4]| corners.map(solid));
            queries
                .filter(|&[a, b, c, d]| robust::orient3d(a, b, c, d) < 0.0)
                .count()
        },
        || {
            let sign = |&[a, b, c, d]: &[DVec3; 4]| {
                let sign = filter.orient3d(a, b, c, d);
                sign.unwrap_or_else(|| geo_predicates::orient3d(a, b, c, d))
            };
            queries
                .iter()
                .filter(|query| sign(query) == Sign::Positive)
                .count()
        },
    );
    let queries = inputs::spatial(Kind::Generic);
    race(
        "in_sphere    static",
        QUERIES,
        || {
            let queries = queries
                .iter()
                .map(|corners: &[DVec3; 5]| corners.map(solid));
            queries
                .filter(|&[a, b, c, d, e]| robust::insphere(a, b, c, d, e) < 0.0)
                .count()
        },
        || {
            let sign = |&[a, b, c, d, e]: &[DVec3; 5]| {
                let sign = filter.in_sphere(a, b, c, d, e);
                sign.unwrap_or_else(|| geo_predicates::in_sphere(a, b, c, d, e))
            };
            queries
                .iter()
                .filter(|query| sign(query) == Sign::Positive)
                .count()
        },
    );
}

/// The kernel's form: one query point, vertices met one after the other and kept relative to it.
fn strips() {
    let filter = Filter2::GENERAL;
    let p = DVec2::new(30.1, 29.3);
    let points = inputs::planar::<1>(Kind::Generic).concat();
    let seen = |&point: &DVec2| Relative2::new(point, p);
    race(
        "orient2d     strip",
        QUERIES,
        || {
            let edges = points.windows(2);
            edges
                .filter(|v| robust::orient2d(flat(v[0]), flat(v[1]), flat(p)) > 0.0)
                .count()
        },
        || {
            let mut a = seen(&points[0]);
            let left = |b: &DVec2| {
                let b = seen(b);
                let sign = filter.orient_relative(&a, &b);
                a = b;
                sign == Some(Sign::Positive)
            };
            points[1..].iter().map(left).filter(|&left| left).count()
        },
    );
    race(
        "in_circle    strip",
        QUERIES,
        || {
            let [b, mut c] = [points[0], points[1]];
            let inside = |&a: &DVec2| {
                let sign = robust::incircle(flat(a), flat(b), flat(c), flat(p));
                c = a;
                sign > 0.0
            };
            points[2..]
                .iter()
                .map(inside)
                .filter(|&inside| inside)
                .count()
        },
        || {
            let [b, mut c] = [seen(&points[0]), seen(&points[1])];
            let mut bc = b.cross(&c);
            let inside = |a: &DVec2| {
                let a = seen(a);
                let crosses = [bc, c.cross(&a), a.cross(&b)];
                let sign = filter.in_circle_crossed([&a, &b, &c], crosses);
                (bc, c) = (b.cross(&a), a);
                sign == Some(Sign::Positive)
            };
            points[2..]
                .iter()
                .map(inside)
                .filter(|&inside| inside)
                .count()
        },
    );
}

fn strips_in_space() {
    let filter = Filter3::GENERAL;
    let p = DVec3::new(30.1, 29.3, 31.7);
    let points = inputs::spatial::<1>(Kind::Generic).concat();
    let seen = |&point: &DVec3| Relative3::new(point, p);
    race(
        "orient3d     strip",
        QUERIES,
        || {
            let facets = points.windows(3).map(|v| [v[0], v[1], v[2], p].map(solid));
            facets
                .filter(|&[a, b, c, p]| robust::orient3d(a, b, c, p) < 0.0)
                .count()
        },
        || {
            let [mut a, mut b] = [seen(&points[0]), seen(&points[1])];
            let above = |c: &DVec3| {
                let c = seen(c);
                let sign = filter.orient_relative(&a, &b, &c);
                (a, b) = (b, c);
                sign == Some(Sign::Positive)
            };
            points[2..].iter().map(above).filter(|&above| above).count()
        },
    );
    race(
        "in_sphere    strip",
        QUERIES,
        || {
            let tetrahedra = points
                .windows(4)
                .map(|v| [v[0], v[1], v[2], v[3], p].map(solid));
            tetrahedra
                .filter(|&[a, b, c, d, p]| robust::insphere(a, b, c, d, p) < 0.0)
                .count()
        },
        || {
            let [mut a, mut b, mut c] = [seen(&points[0]), seen(&points[1]), seen(&points[2])];
            let inside = |d: &DVec3| {
                let d = seen(d);
                let sign = filter.in_sphere_relative(&a, &b, &c, &d);
                (a, b, c) = (b, c, d);
                sign == Some(Sign::Positive)
            };
            points[3..]
                .iter()
                .map(inside)
                .filter(|&inside| inside)
                .count()
        },
    );
}

/// Median times per query of two ways to the same count, in interleaved rounds.
fn race(name: &str, queries: usize, theirs: impl Fn() -> usize, ours: impl Fn() -> usize) {
    assert_eq!(theirs(), ours(), "{name}");
    let rounds = (0..ROUNDS).map(|_| (seconds(&theirs), seconds(&ours)));
    let (theirs, ours): (Vec<f64>, Vec<f64>) = rounds.unzip();
    let each = 1e9 / (REPEATS * queries) as f64;
    let [theirs, ours] = [theirs, ours].map(|times| median(times) * each);
    println!(
        "{name:<21} {theirs:>9.2} {ours:>9.2} {:>6.2}",
        theirs / ours
    );
}

fn seconds(work: impl Fn() -> usize) -> f64 {
    let start = Instant::now();
    for _ in 0..REPEATS {
        black_box(work());
    }
    start.elapsed().as_secs_f64()
}

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_by(f64::total_cmp);
    times[ROUNDS / 2]
}
