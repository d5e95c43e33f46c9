//! Seeded inputs of the benchmarks: generic, exactly degenerate, and a few ulps from degenerate.

use geo_predicates::{DVec2, DVec3};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use robust::{Coord, Coord3D};

/// Number of queries of one kind: enough to defeat the branch predictor, small enough for the cache.
pub(crate) const QUERIES: usize = 2048;

/// How near to degenerate the queries are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// Uniform in the unit square or cube.
    Generic,
    /// On a small lattice, degenerate.
    Zero,
    /// On a lattice of tenths, which doubles cannot represent, degenerate but for roundoff.
    Tenths,
    /// Degenerate up to a few units in the last place.
    Ulps,
}

/// All kinds, in the order of the tables.
pub(crate) const KINDS: [Kind; 4] = [Kind::Generic, Kind::Zero, Kind::Tenths, Kind::Ulps];

/// `N` points of the plane per query: on a line (`N` = 3) or circle (`N` = 4) unless generic.
pub(crate) fn planar<const N: usize>(kind: Kind) -> Vec<[DVec2; N]> {
    let mut rng = ChaCha8Rng::seed_from_u64(2);
    let query = |_| {
        let center = DVec2::new(
            rng.random_range(20..40) as f64,
            rng.random_range(20..40) as f64,
        );
        let points = std::array::from_fn(|_| match (kind, N) {
            (Kind::Generic, _) => DVec2::new(rng.random(), rng.random()) * 60.0,
            (_, 3) => center + DVec2::new(2.0, 3.0) * rng.random_range(-5..=5) as f64,
            _ => center + pythagorean2(&mut rng),
        });
        points.map(|p| DVec2::from_array(p.to_array().map(|x| disturb(kind, x, &mut rng))))
    };
    (0..QUERIES).map(query).collect()
}

/// `N` points of space per query: on a plane (`N` = 4) or sphere (`N` = 5) unless generic.
pub(crate) fn spatial<const N: usize>(kind: Kind) -> Vec<[DVec3; N]> {
    let mut rng = ChaCha8Rng::seed_from_u64(3);
    let query = |_| {
        let center = DVec3::from_array(std::array::from_fn(|_| rng.random_range(20..40) as f64));
        let points = std::array::from_fn(|_| match (kind, N) {
            (Kind::Generic, _) => DVec3::new(rng.random(), rng.random(), rng.random()) * 60.0,
            (_, 4) => {
                let (s, t) = (
                    rng.random_range(-5..=5) as f64,
                    rng.random_range(-5..=5) as f64,
                );
                center + DVec3::new(1.0, 2.0, -1.0) * s + DVec3::new(0.0, 1.0, 2.0) * t
            }
            _ => center + pythagorean3(&mut rng),
        });
        points.map(|p| DVec3::from_array(p.to_array().map(|x| disturb(kind, x, &mut rng))))
    };
    (0..QUERIES).map(query).collect()
}

/// A lattice point at distance 5 from the origin.
fn pythagorean2(rng: &mut ChaCha8Rng) -> DVec2 {
    let (x, y) = [(3.0, 4.0), (4.0, 3.0), (5.0, 0.0), (0.0, 5.0)][rng.random_range(0..4)];
    DVec2::new(sign(rng) * x, sign(rng) * y)
}

/// A lattice point at distance 3 from the origin.
fn pythagorean3(rng: &mut ChaCha8Rng) -> DVec3 {
    let corners = [
        [1.0, 2.0, 2.0],
        [2.0, 1.0, 2.0],
        [2.0, 2.0, 1.0],
        [3.0, 0.0, 0.0],
    ];
    DVec3::from_array(corners[rng.random_range(0..4)].map(|x| sign(rng) * x))
}

fn sign(rng: &mut ChaCha8Rng) -> f64 {
    if rng.random() { 1.0 } else { -1.0 }
}

fn disturb(kind: Kind, x: f64, rng: &mut ChaCha8Rng) -> f64 {
    match kind {
        Kind::Generic | Kind::Zero => x,
        Kind::Tenths => x * 0.1,
        Kind::Ulps => x * 0.1 * (1.0 + rng.random_range(-2..=2) as f64 * f64::EPSILON),
    }
}

/// A point as `robust` wants it.
pub(crate) fn flat(p: DVec2) -> Coord<f64> {
    Coord { x: p.x, y: p.y }
}

/// A point as `robust` wants it.
pub(crate) fn solid(p: DVec3) -> Coord3D<f64> {
    Coord3D {
        x: p.x,
        y: p.y,
        z: p.z,
    }
}
