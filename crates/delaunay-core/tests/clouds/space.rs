//! Points of space in which degeneracy is the common case.

use super::coordinate;
use glam::DVec3;
use proptest::prelude::*;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

pub fn rng(seed: u64) -> ChaCha8Rng {
    ChaCha8Rng::seed_from_u64(seed)
}

pub fn uniform(count: usize, seed: u64) -> Vec<DVec3> {
    let mut rng = rng(seed);
    (0..count)
        .map(|_| DVec3::new(rng.random(), rng.random(), rng.random()))
        .collect()
}

pub fn lattice(n: [u32; 3]) -> Vec<DVec3> {
    let [a, b, c] = n;
    let cells = (0..a).flat_map(move |i| (0..b).flat_map(move |j| (0..c).map(move |k| [i, j, k])));
    cells.map(|cell| DVec3::from(cell.map(f64::from))).collect()
}

pub fn sphere(count: usize, seed: u64) -> Vec<DVec3> {
    uniform(count, seed)
        .into_iter()
        .map(|p| (p * 2.0 - 1.0).normalize())
        .collect()
}

pub fn skew_lines(count: u32) -> Vec<DVec3> {
    let along = (0..count).map(f64::from);
    along
        .flat_map(|t| [DVec3::new(t, 0.0, 0.0), DVec3::new(0.5, t, 1.0)])
        .collect()
}

pub fn hard_sets() -> Vec<(&'static str, Vec<DVec3>)> {
    let snapped = uniform(300, 3).into_iter().map(|p| (p * 5.0).floor());
    let planes = uniform(200, 4).into_iter().enumerate().map(|(i, p)| {
        let height = [0.0, 1.0, 1.0 + 1e-15][i % 3];
        DVec3::new(p.x, p.y, height)
    });
    let cylinder = (0..200).map(|i| {
        let angle = std::f64::consts::TAU * f64::from(i % 20) / 20.0;
        DVec3::new(angle.cos(), angle.sin(), f64::from(i / 20))
    });
    let clusters = uniform(300, 5).into_iter().enumerate().map(|(i, p)| {
        let scale = [1e-5, 1e-9, 1e-13][i % 3];
        p * scale + DVec3::splat([0.1, 0.5, 0.9][i % 3])
    });
    let tenths = lattice([5, 5, 5]).into_iter().map(|p| p * 0.1);
    vec![
        ("uniform", uniform(400, 1)),
        ("lattice", lattice([6, 6, 6])),
        ("flat lattice", lattice([3, 3, 2])),
        ("sphere", sphere(200, 2)),
        ("skew lines", skew_lines(20)),
        ("snapped, with duplicates", snapped.collect()),
        ("planes", planes.collect()),
        ("cylinder", cylinder.collect()),
        ("clusters", clusters.collect()),
        ("tenths", tenths.collect()),
        (
            "tiny",
            uniform(100, 6)
                .iter()
                .map(|p| *p * 2f64.powi(-100))
                .collect(),
        ),
        (
            "huge",
            uniform(100, 7)
                .iter()
                .map(|p| *p * 2f64.powi(200))
                .collect(),
        ),
    ]
}

/// A place with coordinates that often coincide with others.
pub fn place() -> impl Strategy<Value = DVec3> {
    (coordinate(), coordinate(), coordinate()).prop_map(DVec3::from)
}

/// Few points, so that a vertex often holds up all others, with coordinates that often coincide.
pub fn cloud(max: usize) -> impl Strategy<Value = Vec<DVec3>> {
    prop::collection::vec(place(), 0..max)
}
