//! The paraboloid of the sink paper, refined with few points and improved to 20° and to 30°.
//!
//! `cargo bench -p tet-improve` prints tetrahedra of the refined mesh per second.

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use delaunay_core::progress::silent;
use delaunay_core::{BuildOptions, Complex3, Subcomplex3, Surface, VertexId};
use fixtures::surfaces;
use std::error::Error;
use std::time::Duration;
use tet_improve::{Params, improve};

fn refined() -> Result<Complex3, Box<dyn Error>> {
    let set = surfaces::paraboloid();
    let triangles = set.triangles.iter().map(|t| t.map(VertexId::new));
    let surface = Surface::new(set.points, triangles.collect())?;
    let solid = surface.solid(BuildOptions::default(), &mut silent)?;
    let solid = Subcomplex3::of(solid.delaunay(), |t| solid.is_inside(t));
    let refined = sink_refine::refine3(solid, &sink_refine::Params::default(), &mut silent)?;
    Ok(Complex3::from(refined.solid))
}

fn paraboloid(criterion: &mut Criterion) {
    let Ok(solid) = refined() else { return };
    let mut group = criterion.benchmark_group("paraboloid");
    group
        .sample_size(10)
        .warm_up_time(Duration::from_millis(500))
        .measurement_time(Duration::from_secs(5))
        .throughput(Throughput::Elements(solid.tets().count() as u64));
    for angle in [20.0, 30.0] {
        let params = Params {
            goal: angle,
            vertices_below: angle,
            ..Params::default()
        };
        group.bench_function(BenchmarkId::new("improved to", angle), |bencher| {
            bencher.iter(|| improve(solid.clone(), &params, &mut silent));
        });
    }
    group.finish();
}

criterion_group!(benches, paraboloid);
criterion_main!(benches);
