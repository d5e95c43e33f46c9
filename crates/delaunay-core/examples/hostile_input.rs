//! Times bulk builds of hostile sets of points beside evenly spread ones, per point.
//!
//! ```text
//! cargo run --release -p delaunay-core --example hostile_input
//! ```
//!
//! Each line gives nanoseconds per point, how many times those of evenly spread points that is, and what came of the
//! build: simplices and duplicates, or the error. The last line gives the greatest ratio. No set has
//! a triangulation of more than linear size; two skew lines of n points, for one, have n²/4 tetrahedra.

#![allow(clippy::print_stdout)]

use delaunay_core::{BuildError, Delaunay2, Delaunay3};
use glam::{DMat3, DVec2, DVec3, EulerRot};
use std::time::Instant;

/// Points in most sets.
const COUNT: usize = 200_000;

/// Points along each side of a lattice in space, and in the plane.
const SIDE3: usize = 58;
const SIDE2: usize = 447;

fn main() {
    let mut greatest: f64 = 0.0;
    let clouds3 = hostile_in_space();
    let uniform3 = nanoseconds_per_point(&cloud3(COUNT, 7), Delaunay3::build).0;
    println!("space: evenly spread points take {uniform3:.0} ns each");
    for (name, points) in clouds3 {
        let (spent, built) = nanoseconds_per_point(&points, Delaunay3::build);
        let outcome = built.map(|d| (d.tets().count(), d.duplicates().len()));
        greatest = greatest.max(report(&name, spent, uniform3, outcome));
    }
    let uniform2 = nanoseconds_per_point(&cloud2(COUNT, 7), Delaunay2::build).0;
    println!("plane: evenly spread points take {uniform2:.0} ns each");
    for (name, points) in hostile_in_plane() {
        let (spent, built) = nanoseconds_per_point(&points, Delaunay2::build);
        let outcome = built.map(|d| (d.faces().count(), d.duplicates().len()));
        greatest = greatest.max(report(&name, spent, uniform2, outcome));
    }
    println!("the slowest takes {greatest:.1} times as long as evenly spread points");
}

/// The better of two builds.
fn nanoseconds_per_point<P, T>(
    points: &[P],
    build: impl Fn(&[P]) -> Result<T, BuildError>,
) -> (f64, Result<T, BuildError>) {
    let once = || {
        let start = Instant::now();
        let built = build(points);
        (
            start.elapsed().as_secs_f64() * 1e9 / points.len() as f64,
            built,
        )
    };
    let (first, _) = once();
    let (second, built) = once();
    (first.min(second), built)
}

/// Prints a line and gives the ratio.
fn report(
    name: &str,
    spent: f64,
    uniform: f64,
    outcome: Result<(usize, usize), BuildError>,
) -> f64 {
    let ratio = spent / uniform;
    let outcome = match outcome {
        Ok((simplices, 0)) => format!("{simplices} simplices"),
        Ok((simplices, duplicates)) => format!("{simplices} simplices, {duplicates} duplicates"),
        Err(error) => error.to_string(),
    };
    println!("{spent:>9.0} ns  {ratio:>6.2}  {name}: {outcome}");
    ratio
}

/// Evenly spread numbers in 0..1, the same in every run.
fn numbers(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1;
    move || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1_u64 << 53) as f64
    }
}

fn cloud3(count: usize, seed: u64) -> Vec<DVec3> {
    let mut number = numbers(seed);
    let mut point = || DVec3::new(number(), number(), number());
    (0..count).map(|_| point()).collect()
}

fn cloud2(count: usize, seed: u64) -> Vec<DVec2> {
    cloud3(count, seed)
        .into_iter()
        .map(DVec3::truncate)
        .collect()
}

fn lattice3() -> impl Iterator<Item = DVec3> {
    let point = |i: usize| [i % SIDE3, i / SIDE3 % SIDE3, i / (SIDE3 * SIDE3)];
    (0..SIDE3 * SIDE3 * SIDE3).map(move |i| DVec3::from_array(point(i).map(|x| x as f64)))
}

fn lattice2() -> impl Iterator<Item = DVec2> {
    (0..SIDE2 * SIDE2).map(|i| DVec2::new((i % SIDE2) as f64, (i / SIDE2) as f64))
}

/// Moves 1 by so many units of its last place.
fn ulps(x: f64, count: f64) -> f64 {
    1.0 + (x * count).floor() * f64::EPSILON
}

/// A factor between 2^-100 and 2^100.
fn any_scale(x: f64) -> f64 {
    2_f64.powf((200.0 * x - 100.0).floor())
}

fn hostile_in_space() -> Vec<(String, Vec<DVec3>)> {
    let cloud = cloud3(COUNT, 1);
    let turned = DMat3::from_euler(EulerRot::XYZ, 0.3, 0.7, 1.1);
    let of = |map: &dyn Fn(DVec3) -> DVec3| cloud.iter().map(|&p| map(p)).collect::<Vec<_>>();
    let repeated = |distinct: usize| (0..1_000_000).map(|i| cloud[i % distinct]).collect();
    let mut broken = cloud.clone();
    broken[COUNT / 2].y = f64::NAN;
    let line = |p: DVec3| DVec3::new(1.0, 2.0, 3.0) * (p.x * 1e6).floor();
    let mut sets = vec![
        ("all equal".to_owned(), vec![DVec3::ONE; 1_000_000]),
        ("10^6 points, 1000 distinct".to_owned(), repeated(1000)),
        ("10^6 points, each ten times".to_owned(), repeated(100_000)),
        ("on a line".to_owned(), of(&line)),
        (
            "on a line, rounded".to_owned(),
            of(&|p| DVec3::new(0.1, 0.7, 0.3) * p.x),
        ),
        ("on a plane".to_owned(), of(&|p| p.with_z(0.25))),
        (
            "on a slanted plane, rounded".to_owned(),
            of(&|p| p.with_z(0.3 * p.x + 0.7 * p.y)),
        ),
        ("lattice".to_owned(), lattice3().collect()),
        (
            "lattice, turned".to_owned(),
            lattice3().map(|p| turned * p).collect(),
        ),
        (
            "lattice with steps of 0.1".to_owned(),
            lattice3().map(|p| p * 0.1).collect(),
        ),
        ("lattice far from the origin".to_owned(), {
            lattice3()
                .map(|p| p * DVec3::new(1.0, 1.5, 0.7) + 1e6)
                .collect()
        }),
        (
            "on a sphere, rounded".to_owned(),
            of(&|p| (p - 0.5).normalize()),
        ),
        (
            "some ulps apart".to_owned(),
            of(&|p| p.map(|x| ulps(x, 40.0))),
        ),
        (
            "many ulps apart".to_owned(),
            of(&|p| p.map(|x| ulps(x, 1e4))),
        ),
        (
            "all scales at once".to_owned(),
            of(&|p| (p - 0.5) * any_scale((p.x * 1e6).fract())),
        ),
        (
            "a thin rod".to_owned(),
            of(&|p| p * DVec3::new(1.0, 1e-9, 1e-9)),
        ),
        ("a NaN".to_owned(), broken),
    ];
    for power in [-300, -140, 140, 300] {
        let scale = 2_f64.powi(power);
        sets.push((format!("2^{power} in size"), of(&|p| (p + 1.0) * scale)));
    }
    sets
}

fn hostile_in_plane() -> Vec<(String, Vec<DVec2>)> {
    let cloud = cloud2(COUNT, 1);
    let of = |map: &dyn Fn(DVec2) -> DVec2| cloud.iter().map(|&p| map(p)).collect::<Vec<_>>();
    let turn = DVec2::from_angle(0.7);
    let line = |p: DVec2| DVec2::new(1.0, 2.0) * (p.x * 1e6).floor();
    let mut broken = cloud.clone();
    broken[COUNT / 2].y = f64::NAN;
    let repeated = |distinct: usize| (0..1_000_000).map(|i| cloud[i % distinct]).collect();
    let parabola = |i: usize| DVec2::new(i as f64, (i * i) as f64);
    let mut sets = vec![
        ("all equal".to_owned(), vec![DVec2::ONE; 1_000_000]),
        ("10^6 points, 1000 distinct".to_owned(), repeated(1000)),
        ("on a line".to_owned(), of(&line)),
        (
            "on a line, rounded".to_owned(),
            of(&|p| DVec2::new(0.1, 0.7) * p.x),
        ),
        (
            "on a parabola".to_owned(),
            (0..COUNT).map(parabola).collect(),
        ),
        ("lattice".to_owned(), lattice2().collect()),
        (
            "lattice, turned".to_owned(),
            lattice2().map(|p| turn.rotate(p)).collect(),
        ),
        (
            "lattice with steps of 0.1".to_owned(),
            lattice2().map(|p| p * 0.1).collect(),
        ),
        (
            "on a circle, rounded".to_owned(),
            of(&|p| (p - 0.5).normalize()),
        ),
        (
            "some ulps apart".to_owned(),
            of(&|p| p.map(|x| ulps(x, 400.0))),
        ),
        (
            "all scales at once".to_owned(),
            of(&|p| (p - 0.5) * any_scale((p.x * 1e6).fract())),
        ),
        ("a NaN".to_owned(), broken),
    ];
    for power in [-300, -140, 140, 300] {
        let scale = 2_f64.powi(power);
        sets.push((format!("2^{power} in size"), of(&|p| (p + 1.0) * scale)));
    }
    sets
}
