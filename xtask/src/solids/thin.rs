//! Thin plates, wedges and rods with needle triangles, and fans of many triangles at a vertex.
//!
//! ```text
//!   plate  ▔▔▔▔▔▔▔▔▔    wedge  __..--▔▔|     rod ─────────    fan  \|/     Angles go down to 1e-5 degrees.
//!          ▁▁▁▁▁▁▁▁▁         ‾‾‾‾‾‾‾‾‾‾‾                          ─·─
//! ```
//!
//! All are the space between two graphs over one region of the plane, one above the other: valid whatever the triangulations of
//! the two, for rounded heights move no point in the plane.

use glam::{DVec2, dvec2};
use rand::RngExt;

use super::extrude::between;
use super::flat::{Cap, Drawing};
use super::skin::Skin;
use super::turn::turned;
use super::{Random, Size, Solid, random, ten_to};

/// One of the four kinds.
#[must_use]
pub fn draw(size: Size, seed: u64) -> Solid {
    let mut random = random(seed);
    let points = random.random_range(size.pick([0..=100, 500..=3000, 10_000..=30_000]));
    let exponent = random.random_range(2..=23);
    match random.random_range(0..4) {
        0 => plate(points, exponent, seed),
        1 => wedge(points, exponent, seed),
        2 => rod(random.random_range(1..=40), exponent, seed),
        _ => {
            let corners = random.random_range(size.pick([20..=1000, 1000..=5000, 10_000..=50_000]));
            fan(corners, random.random_range(-6..=6), seed)
        }
    }
}

/// A square of side 1024 with up to `points` random points on each face and side, 1024 / 2^`exponent` thick; half of them are bumpy.
#[must_use]
pub fn plate(points: usize, exponent: i32, seed: u64) -> Solid {
    let mut random = random(seed);
    let [bottom, top] = caps(points, &mut random);
    let thickness = 1024.0 * 0.5_f64.powi(exponent);
    let is_bumpy = random.random_bool(0.5);
    let (below, above) = (random.random_range(0.1..1.0), random.random_range(0.1..1.0));
    let place = |p: DVec2, layer: usize| {
        // Between a quarter and three quarters of the thickness away from the middle.
        let wave = |of: DVec2| 0.5 + 0.25 * turned(of.dot(dvec2(0.013, 0.017))).x;
        let height = match (is_bumpy, layer) {
            (true, 0) => -thickness * wave(p * below),
            (true, _) => thickness * wave(p * above),
            (false, layer) => thickness * layer as f64,
        };
        p.extend(height)
    };
    let bumpy = if is_bumpy { "-bumpy" } else { "" };
    let name = format!("plate-{exponent}{bumpy}");
    between(&bottom, &top, 1, place, &mut random).into_solid(name)
}

/// A wedge over a square of side 1024 whose two faces meet in an edge, at the angle whose tangent is 1 / 2^`exponent`: 7e-6 degrees for 23.
/// All faces are flat exactly.
#[must_use]
pub fn wedge(points: usize, exponent: i32, seed: u64) -> Solid {
    let mut random = random(seed);
    let [bottom, top] = caps(points, &mut random);
    let slope = 0.5_f64.powi(exponent);
    // At y = 0 both layers are at one place.
    let place = |p: DVec2, layer: usize| p.extend(p.y * slope * layer as f64);
    between(&bottom, &top, 1, place, &mut random).into_solid(format!("wedge-{exponent}"))
}

/// A square rod of length 1024 and thickness 1024 / 2^`exponent`, in so many layers of random length.
#[must_use]
pub fn rod(layers: usize, exponent: i32, seed: u64) -> Solid {
    let mut random = random(seed);
    let side = 1024.0 * 0.5_f64.powi(exponent);
    let mut drawing = Drawing::default();
    drawing.ring(&[[0.0, 0.0], [side, 0.0], [side, side], [0.0, side]].map(DVec2::from));
    let [bottom, top] = [0, 1].map(|_| drawing.inside(&mut random));
    let mut heights: Vec<i32> = (1..layers).map(|_| random.random_range(1..1024)).collect();
    heights.extend([0, 1024]);
    heights.sort_unstable();
    heights.dedup();
    let place = |p: DVec2, layer: usize| p.extend(f64::from(heights[layer]));
    let layers = heights.len() - 1;
    between(&bottom, &top, layers, place, &mut random)
        .into_solid(format!("rod-{layers}-{exponent}"))
}

/// Two vertices on the axis joined to each of `corners` round it; gaps between these vary by up to 1e6. The height is
/// about 10^`exponent`, the radius 1. In half of the fans both vertices are above the ring, which makes a dent.
#[must_use]
pub fn fan(corners: usize, exponent: i32, seed: u64) -> Solid {
    let mut random = random(seed);
    let height = ten_to(exponent);
    let low = [-0.5, 0.5][random.random_range(0..2)] * height;
    let is_round = random.random_bool(0.5);
    let mut gaps: Vec<f64> = (0..corners.max(5))
        .map(|_| ten_to(random.random_range(-6..=0)))
        .collect();
    let whole: f64 = gaps.iter().sum();
    // Each gap must be below half a turn.
    if gaps.iter().any(|gap| *gap > 0.4 * whole) {
        gaps.fill(1.0);
    }
    let whole: f64 = gaps.iter().sum();
    let mut turns = 0.0;
    let ring: Vec<DVec2> = gaps
        .iter()
        .map(|gap| {
            turns += gap / whole;
            let radius = if is_round {
                1.0
            } else {
                random.random_range(0.3..1.0)
            };
            turned(turns) * radius
        })
        .collect();
    let mut skin = Skin::default();
    for (index, a) in ring.iter().enumerate() {
        let b = ring[(index + 1) % ring.len()];
        let [a, b] = [a.extend(0.0), b.extend(0.0)];
        skin.triangle([a, b, DVec2::ZERO.extend(height)]);
        skin.triangle([b, a, DVec2::ZERO.extend(low)]);
    }
    let dent = if low > 0.0 { "-dent" } else { "" };
    skin.into_solid(format!("fan-{}-{exponent}{dent}", ring.len()))
}

/// Two triangulations of a square of side 1024 with the same points on its rim and different ones inside, in whole numbers.
fn caps(points: usize, random: &mut Random) -> [Cap; 2] {
    const SIDE: i32 = 1024;
    let mut side = || {
        let count = random.random_range(0..=points / 8 + 1);
        let mut steps: Vec<i32> = (0..count).map(|_| random.random_range(1..SIDE)).collect();
        steps.push(0);
        steps.sort_unstable();
        steps.dedup();
        steps
    };
    let flat = |x: i32, y: i32| dvec2(f64::from(x), f64::from(y));
    let mut rim: Vec<DVec2> = side().into_iter().map(|step| flat(step, 0)).collect();
    rim.extend(side().into_iter().map(|step| flat(SIDE, step)));
    rim.extend(side().into_iter().map(|step| flat(SIDE - step, SIDE)));
    rim.extend(side().into_iter().map(|step| flat(0, SIDE - step)));
    [0, 1].map(|_| {
        let mut drawing = Drawing::default();
        drawing.ring(&rim);
        for _ in 0..random.random_range(0..=points) {
            drawing.point(flat(
                random.random_range(1..SIDE),
                random.random_range(1..SIDE),
            ));
        }
        drawing.inside(random)
    })
}
