//! Single operations on triangulations of evenly spread points of space.
//!
//! `cargo bench -p delaunay-core --bench delaunay3` prints the time of a thousand operations as
//! operations per second. Places are drawn anew and in random order; with hints, from the nearest vertex.

#[path = "../tests/clouds/mod.rs"]
mod clouds;

use clouds::space::uniform;
use criterion::{BenchmarkGroup, Criterion, Throughput, criterion_group, criterion_main};
use criterion::{SamplingMode, measurement::WallTime};
use delaunay_core::{Delaunay3, VertexId};
use glam::DVec3;
use std::hint::black_box;
use std::time::{Duration, Instant};

type Group<'a> = BenchmarkGroup<'a, WallTime>;

const OPERATIONS: usize = 1000;

/// Places never seen before, a thousand at a time.
struct Places(u64);

impl Places {
    fn next(&mut self) -> Vec<DVec3> {
        self.0 += 1;
        uniform(OPERATIONS, self.0)
    }
}

/// Times `work` on fresh places, without the preparation and clearing away around it.
fn measure<T>(
    group: &mut Group<'_>,
    name: &str,
    delaunay: &mut Delaunay3,
    prepare: impl Fn(&Delaunay3, &[DVec3]) -> T,
    work: impl Fn(&mut Delaunay3, &T),
    clear: impl Fn(&mut Delaunay3),
) {
    let size = delaunay.vertex_count();
    let mut places = Places(1000);
    group.throughput(Throughput::Elements(OPERATIONS as u64));
    group.bench_function(format!("{name}/{size}"), |bencher| {
        bencher.iter_custom(|rounds| {
            let mut spent = Duration::ZERO;
            for _ in 0..rounds {
                let prepared = prepare(delaunay, &places.next());
                let start = Instant::now();
                work(delaunay, &prepared);
                spent += start.elapsed();
                clear(delaunay);
            }
            spent
        });
    });
}

fn hinted(delaunay: &Delaunay3, places: &[DVec3]) -> Vec<(DVec3, VertexId)> {
    let hint = |&p: &DVec3| Some((p, delaunay.nearest_vertex(p).ok()?));
    places.iter().filter_map(hint).collect()
}

fn vertices(delaunay: &Delaunay3, places: &[DVec3]) -> Vec<VertexId> {
    let found = hinted(delaunay, places).into_iter();
    found.map(|(_, v)| v).collect()
}

fn remove_from(delaunay: &mut Delaunay3, count: usize) {
    for index in count..delaunay.points().len() {
        let _ = delaunay.remove(VertexId::new(index));
    }
}

fn single(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("single");
    group
        .sample_size(20)
        .sampling_mode(SamplingMode::Flat)
        .warm_up_time(Duration::from_millis(300))
        .measurement_time(Duration::from_secs(2));
    for count in [100_000, 1_000_000] {
        let Ok(mut delaunay) = Delaunay3::build(&uniform(count, 1)) else {
            return;
        };
        operations(&mut group, &mut delaunay, count);
    }
    group.finish();
}

fn operations(group: &mut Group<'_>, delaunay: &mut Delaunay3, count: usize) {
    let given = |_: &Delaunay3, places: &[DVec3]| places.to_vec();
    let locate = |delaunay: &mut Delaunay3, places: &Vec<DVec3>| {
        for &p in places {
            let _ = black_box(delaunay.locate(p));
        }
    };
    measure(
        group,
        "locate without hint",
        delaunay,
        given,
        locate,
        |_| {},
    );
    let nearest = |delaunay: &mut Delaunay3, places: &Vec<DVec3>| {
        for &p in places {
            let _ = black_box(delaunay.nearest_vertex(p));
        }
    };
    measure(group, "nearest vertex", delaunay, given, nearest, |_| {});
    let insert = |delaunay: &mut Delaunay3, hinted: &Vec<(DVec3, VertexId)>| {
        for &(p, hint) in hinted {
            let _ = black_box(delaunay.insert_near(p, hint));
        }
    };
    let clear = |delaunay: &mut Delaunay3| remove_from(delaunay, count);
    measure(group, "insert with hint", delaunay, hinted, insert, clear);
    let cycle = |delaunay: &mut Delaunay3, vertices: &Vec<VertexId>| {
        for &v in vertices {
            let (p, near) = (delaunay.point(v), delaunay.mesh().neighbors(v).next());
            let _ = black_box(delaunay.remove(v));
            let _ = black_box(delaunay.insert_near(p, near.unwrap_or(v)));
        }
    };
    measure(
        group,
        "remove and insert",
        delaunay,
        vertices,
        cycle,
        |_| {},
    );
}

criterion_group!(benches, single);
criterion_main!(benches);
