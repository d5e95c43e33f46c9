//! Point clouds in which degeneracy is the common case.
// Each test file uses its part of the module.
#![allow(dead_code, unreachable_pub)]

pub mod space;

use glam::DVec2;
use proptest::prelude::*;
use rand::{Rng, RngExt, SeedableRng, seq::SliceRandom};
use rand_chacha::ChaCha8Rng;

pub fn rng(seed: u64) -> ChaCha8Rng {
    ChaCha8Rng::seed_from_u64(seed)
}

pub fn uniform(count: usize, seed: u64) -> Vec<DVec2> {
    let mut rng = rng(seed);
    (0..count)
        .map(|_| DVec2::new(rng.random(), rng.random()))
        .collect()
}

pub fn grid(columns: usize, rows: usize) -> Vec<DVec2> {
    (0..columns * rows)
        .map(|i| DVec2::new((i % columns) as f64, (i / columns) as f64))
        .collect()
}

/// The integer points of the circle of radius 65: 36 points exactly on one circle.
pub fn circle() -> Vec<DVec2> {
    let side = -65_i32..=65;
    side.clone()
        .flat_map(|x| side.clone().map(move |y| (x, y)))
        .filter(|(x, y)| x * x + y * y == 65 * 65)
        .map(|(x, y)| DVec2::new(f64::from(x), f64::from(y)))
        .collect()
}

/// Concentric exact circles with their center.
pub fn rings() -> Vec<DVec2> {
    let mut points = vec![DVec2::ZERO];
    for scale in [1.0, 2.0, 4.0] {
        points.extend(circle().into_iter().map(|p| p * scale));
    }
    points
}

pub fn line_and_one(count: usize) -> Vec<DVec2> {
    let mut points: Vec<DVec2> = (0..count)
        .map(|i| DVec2::new(i as f64, 3.0 * i as f64))
        .collect();
    points.push(DVec2::new(1.0, -2.0));
    points
}

/// Points a few units in the last place off a line.
pub fn nearly_a_line(count: usize, seed: u64) -> Vec<DVec2> {
    let mut rng = rng(seed);
    (0..count)
        .map(|_| {
            let x: f64 = rng.random_range(0.5..1.0);
            let ulps = f64::from(rng.random_range(-3..=3));
            DVec2::new(x, x * (1.0 + ulps * f64::EPSILON))
        })
        .collect()
}

pub fn clusters(count: usize, seed: u64) -> Vec<DVec2> {
    let centers = uniform(5, seed);
    let offsets = uniform(count, seed + 1);
    offsets
        .iter()
        .zip(centers.iter().cycle())
        .map(|(offset, center)| *center + *offset * 1e-9)
        .collect()
}

/// Fifty clusters of width 0.01 in the unit square, thick in the middle.
pub fn gaussian_clusters(count: usize, seed: u64) -> Vec<DVec2> {
    let mut rng = rng(seed);
    let centers = uniform(50, seed + 1);
    let mut offset = move || -> f64 { (0..6).map(|_| rng.random_range(-0.005..0.005)).sum() };
    (0..count)
        .map(|i| centers[i % 50] + DVec2::new(offset(), offset()))
        .collect()
}

pub fn with_duplicates(points: &[DVec2], seed: u64) -> Vec<DVec2> {
    let mut doubled = [points, points].concat();
    doubled.shuffle(&mut rng(seed));
    doubled
}

pub fn scaled(points: &[DVec2], exponent: i32) -> Vec<DVec2> {
    let factor = 2.0_f64.powi(exponent);
    points.iter().map(|&p| p * factor).collect()
}

pub fn shuffled(points: &[DVec2], rng: &mut impl Rng) -> Vec<DVec2> {
    let mut points = points.to_vec();
    points.shuffle(rng);
    points
}

/// Every hard case of moderate size, by name.
pub fn hard_cases() -> Vec<(&'static str, Vec<DVec2>)> {
    let small = grid(6, 5);
    vec![
        ("uniform", uniform(120, 1)),
        ("grid", grid(9, 9)),
        ("circle", circle()),
        ("rings", rings()),
        ("line and one", line_and_one(40)),
        ("nearly a line", nearly_a_line(60, 2)),
        ("clusters", clusters(100, 3)),
        ("duplicates", with_duplicates(&small, 4)),
        ("tiny grid", scaled(&grid(7, 7), -140)),
        ("huge rings", scaled(&rings(), 190)),
        (
            "mixed scales",
            [scaled(&grid(4, 4), -140), scaled(&grid(4, 4), 196)].concat(),
        ),
        ("tiny uniform", scaled(&uniform(60, 5), -100)),
        ("three", grid(2, 2)[..3].to_vec()),
    ]
}

/// Coordinates that often coincide, line up or differ in the last bits.
pub fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => (-4_i32..=4).prop_map(f64::from),
        1 => -4.0..4.0,
        2 => (-4_i32..=4, -2_i32..=2)
            .prop_map(|(base, ulps)| f64::from(base) * (1.0 + f64::from(ulps) * f64::EPSILON)),
    ]
}

pub fn cloud(max: usize) -> impl Strategy<Value = Vec<DVec2>> {
    prop::collection::vec((coordinate(), coordinate()).prop_map(DVec2::from), 0..max)
}
