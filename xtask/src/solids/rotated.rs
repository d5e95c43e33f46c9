//! Boxes, sponges and lattices, scaled by factors that are not binary and turned by rational rotations.
//!
//! ```text
//!   1  ⎡ a²+b²-c²-d²   2(bc-ad)      2(bd+ac)    ⎤    The rotation of the quaternion a + bi + cj + dk with small integers:
//!  ─── ⎢ 2(bc+ad)      a²-b²+c²-d²   2(cd-ab)    ⎥    what was coplanar is so only but for rounding, and a triangulation of it
//!  |q|²⎣ 2(bd-ac)      2(cd+ab)      a²-b²-c²+d² ⎦    is a little bent.
//! ```
//!
//! Rounding may make such a surface intersect itself, so each is checked, and other rotations are tried.

use glam::{DMat3, DVec3, dvec3};
use rand::RngExt;

use super::check::defect;
use super::{Random, Size, Solid, csg, drilled, lattices, random};

/// Rotations tried before the surface is only scaled.
const TRIED: usize = 6;

/// Turned boxes, plates with holes or lattices.
#[must_use]
pub fn draw(size: Size, seed: u64) -> Solid {
    let mut random = random(seed);
    let base_seed = random.random();
    let base = match random.random_range(0..5) {
        0 => lattices::lattice([size.pick([3, 5, 9]); 3], 0.2, true, base_seed),
        1 => drilled::plate(
            size.pick([[4, 3], [12, 9], [40, 30]]),
            random.random_bool(0.5),
            base_seed,
        ),
        _ => {
            let (side, boxes) =
                size.pick([(3..=7, 2..=9), (12..=16, 30..=60), (30..=30, 300..=400)]);
            let [side, boxes] = [random.random_range(side), random.random_range(boxes)];
            csg::csg(side, boxes as usize, random.random_bool(0.3), base_seed)
        }
    };
    rotated(&base, seed)
}

/// The solid, scaled and turned at random, or only scaled when no rotation leaves it valid.
#[must_use]
pub fn rotated(base: &Solid, seed: u64) -> Solid {
    const FACTORS: [f64; 7] = [0.1, 1.0 / 3.0, 0.7, 1.1, 1e-3, 1234.567, 1e5 / 7.0];
    let mut random = random(seed);
    let factor = FACTORS[random.random_range(0..FACTORS.len())];
    for _ in 0..TRIED {
        let rotation = rotation(&mut random);
        let offset = offset(&mut random) * factor;
        let mut solid = base.clone().moved(|p| rotation * (p * factor) + offset);
        solid.name = format!("{}-turned", base.name);
        if defect(&solid).is_none() {
            return solid;
        }
    }
    // Each coordinate is scaled by itself, so that equal ones stay equal.
    let mut solid = base
        .clone()
        .moved(|p| p * dvec3(factor, factor * 1.7, factor / 3.0));
    solid.name = format!("{}-scaled", base.name);
    solid
}

/// About an axis of the grid in a third of the cases.
fn rotation(random: &mut Random) -> DMat3 {
    let mut draw = || f64::from(random.random_range(-5..=5_i32));
    let [a, b, c, d] = [draw(), draw(), draw(), draw()];
    let [b, c] = if random.random_range(0..3) == 0 {
        [0.0; 2]
    } else {
        [b, c]
    };
    let square = a * a + b * b + c * c + d * d;
    if square == 0.0 {
        return DMat3::IDENTITY;
    }
    let rows = [
        [
            a * a + b * b - c * c - d * d,
            2.0 * (b * c - a * d),
            2.0 * (b * d + a * c),
        ],
        [
            2.0 * (b * c + a * d),
            a * a - b * b + c * c - d * d,
            2.0 * (c * d - a * b),
        ],
        [
            2.0 * (b * d - a * c),
            2.0 * (c * d + a * b),
            a * a - b * b - c * c + d * d,
        ],
    ];
    DMat3::from_cols_array_2d(&rows.map(|row| row.map(|entry| entry / square))).transpose()
}

/// Nothing, or far enough to lose digits.
fn offset(random: &mut Random) -> DVec3 {
    let far = [0.0, 0.0, 1.0, 1e3, 1e6][random.random_range(0..5)];
    DVec3::new(random.random(), random.random(), random.random()) * far
}
