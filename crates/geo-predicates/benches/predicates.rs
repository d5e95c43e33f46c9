//! Each predicate that `robust` has, against calling `robust` directly, per kind of input.
#![allow(missing_docs)]

mod inputs;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use geo_predicates::{Sign, in_circle, in_sphere, orient2d, orient3d};
use inputs::{Kind, QUERIES, flat, solid};

fn predicates(criterion: &mut Criterion) {
    for kind in inputs::KINDS {
        let queries = inputs::planar(kind);
        pair(
            criterion,
            "orient2d",
            kind,
            &queries,
            |&[a, b, c]| robust::orient2d(flat(a), flat(b), flat(c)),
            |&[a, b, c]| orient2d(a, b, c),
        );
        let queries = inputs::planar(kind);
        pair(
            criterion,
            "in_circle",
            kind,
            &queries,
            |&[a, b, c, d]| robust::incircle(flat(a), flat(b), flat(c), flat(d)),
            |&[a, b, c, d]| in_circle(a, b, c, d),
        );
        let queries = inputs::spatial(kind);
        pair(
            criterion,
            "orient3d",
            kind,
            &queries,
            |&[a, b, c, d]| -robust::orient3d(solid(a), solid(b), solid(c), solid(d)),
            |&[a, b, c, d]| orient3d(a, b, c, d),
        );
        let queries = inputs::spatial(kind);
        pair(
            criterion,
            "in_sphere",
            kind,
            &queries,
            |&[a, b, c, d, e]| -robust::insphere(solid(a), solid(b), solid(c), solid(d), solid(e)),
            |&[a, b, c, d, e]| in_sphere(a, b, c, d, e),
        );
    }
}

fn pair<Q>(
    criterion: &mut Criterion,
    name: &str,
    kind: Kind,
    queries: &[Q],
    theirs: impl Fn(&Q) -> f64,
    ours: impl Fn(&Q) -> Sign,
) {
    let mut group = criterion.benchmark_group(format!("{name}/{kind:?}"));
    group.throughput(Throughput::Elements(QUERIES as u64));
    group.bench_function(BenchmarkId::from_parameter("robust"), |bencher| {
        bencher.iter(|| queries.iter().filter(|query| theirs(query) > 0.0).count());
    });
    group.bench_function(BenchmarkId::from_parameter("ours"), |bencher| {
        bencher.iter(|| {
            queries
                .iter()
                .filter(|query| ours(query) == Sign::Positive)
                .count()
        });
    });
    group.finish();
}

criterion_group!(benches, predicates);
criterion_main!(benches);
