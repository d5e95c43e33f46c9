//! Times of `robust`, called directly, over times of this crate, in one table: rounds of the two
//! interleaved, medians of the rounds.

mod inputs;

use geo_predicates::Sign;
use inputs::{Kind, QUERIES, flat, solid};
use std::hint::black_box;
use std::time::Instant;

const ROUNDS: usize = 41;

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
    let repeats = if kind == Kind::Generic { 40 } else { 4 };
    let count = |positive: usize| black_box(positive);
    let rounds = (0..ROUNDS).map(|_| {
        let theirs = seconds(repeats, || {
            count(queries.iter().filter(|query| theirs(query) > 0.0).count())
        });
        let ours = seconds(repeats, || {
            count(
                queries
                    .iter()
                    .filter(|query| ours(query) == Sign::Positive)
                    .count(),
            )
        });
        (theirs, ours)
    });
    let (theirs, ours): (Vec<f64>, Vec<f64>) = rounds.unzip();
    let [theirs, ours] =
        [theirs, ours].map(|times| median(times) * 1e9 / (repeats * QUERIES) as f64);
    let kind = format!("{kind:?}");
    println!(
        "{name:<12} {kind:<8} {theirs:>9.2} {ours:>9.2} {:>6.2}",
        theirs / ours
    );
}

fn seconds(repeats: usize, work: impl Fn() -> usize) -> f64 {
    let start = Instant::now();
    for _ in 0..repeats {
        work();
    }
    start.elapsed().as_secs_f64()
}

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_by(f64::total_cmp);
    times[ROUNDS / 2]
}
