//! Refinement of a solid on several threads.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use delaunay_core::progress::silent;
use delaunay_core::{Delaunay3, Subcomplex3};
use glam::DVec3;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use sink_refine::{Boundary, Candidate, Method, Params, Schedule, refine3};

#[test]
fn the_mesh_of_a_solid_does_not_depend_on_the_number_of_threads() {
    let mut rng = ChaCha8Rng::seed_from_u64(7);
    // Points near a sphere: poor tetrahedra across it.
    let points: Vec<DVec3> = (0..400)
        .map(|_| {
            let p = DVec3::from(std::array::from_fn(|_| rng.random_range(-1.0..1.0)));
            p.normalize_or(DVec3::X) * rng.random_range(0.9..1.0)
        })
        .collect();
    let solid = Subcomplex3::of(&Delaunay3::build(&points).unwrap(), |_| true);
    for candidate in [Candidate::Sink, Candidate::Circumcenter] {
        let params = Params {
            boundary: Boundary::Keep,
            ratio: 1.5,
            method: Method::Paper {
                candidate,
                schedule: Schedule::Parallel,
            },
            max_new_vertices: 2000,
        };
        let on = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new()
                .num_threads(threads)
                .build()
                .unwrap();
            let outcome = pool.install(|| refine3(solid.clone(), &params, &mut silent).unwrap());
            let mesh = outcome.solid.mesh();
            assert_eq!(mesh.check(), Ok(()));
            (
                outcome.solid.points().to_vec(),
                mesh.canonical(),
                outcome.rounds,
            )
        };
        let one = on(1);
        assert!(one.2.len() > 2);
        for threads in [2, 3, 8] {
            assert!(on(threads) == one, "{threads} threads");
        }
    }
}
