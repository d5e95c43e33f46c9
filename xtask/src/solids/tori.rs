//! Tori, tubes along torus knots with coarse sections, and chains of rings.
//!
//! ```text
//!     .-"""""-.         A knot (p, q) goes p times round the axis and q times through the hole. The frame of the torus
//!   /   .---.   \       carries the section round it and comes back to where it began.
//!   \   '---'   /
//!     '-.....-'
//! ```
//!
//! Thick tubes meet themselves, so knots are checked, and made thinner until they are valid.

use glam::{DVec2, DVec3};
use rand::RngExt;

use super::check::defect;
use super::skin::Skin;
use super::turn::{nth, turned};
use super::{Random, Size, Solid, random};

/// Turns round the axis and through the hole.
const KNOTS: [[usize; 2]; 7] = [[2, 3], [3, 2], [2, 5], [3, 4], [3, 5], [5, 2], [4, 7]];

/// One of the three kinds.
#[must_use]
pub fn draw(size: Size, seed: u64) -> Solid {
    let mut random = random(seed);
    match random.random_range(0..3) {
        0 => {
            let around = random.random_range(size.pick([3..=40, 60..=120, 200..=500]));
            torus(
                around,
                random.random_range(3..=around.min(200)),
                random.random_range(0.05..0.9),
                seed,
            )
        }
        1 => {
            let steps = random.random_range(size.pick([30..=120, 200..=600, 2000..=4000]));
            knot(
                KNOTS[random.random_range(0..KNOTS.len())],
                steps,
                random.random_range(3..=8),
                seed,
            )
        }
        _ => chain(
            random.random_range(size.pick([2..=5, 10..=30, 100..=300])),
            seed,
        ),
    }
}

/// A torus of radius 1 whose tube has the radius `tube`, below 1, in `around` by `across` quads folded at random.
#[must_use]
pub fn torus(around: usize, across: usize, tube: f64, seed: u64) -> Solid {
    let mut random = random(seed);
    let frame = |index: usize| {
        let out = nth(index, around).extend(0.0);
        (out, [out, DVec3::Z])
    };
    let mut skin = Skin::default();
    tubed(&mut skin, around, across, tube, frame, &mut random);
    skin.into_solid(format!("torus-{around}x{across}"))
}

/// A tube along a torus knot, with `steps` sections of so many `corners`, or a small multiple where so few let the strands meet.
#[must_use]
pub fn knot([p, q]: [usize; 2], steps: usize, corners: usize, seed: u64) -> Solid {
    const HOLE: f64 = 0.4;
    let mut random = random(seed);
    let frame = |index: usize, steps: usize| {
        let out = nth(index * p, steps);
        let section = nth(index * q, steps);
        let radius = 1.0 + HOLE * section.x;
        let centre = (out * radius).extend(HOLE * section.y);
        // Off the torus, and along it across the knot, but for what is in the direction of the knot.
        let normal = (out * section.x).extend(section.y);
        let along = (out.perp() * radius * p as f64).extend(0.0)
            + (out * -section.y).extend(section.x) * HOLE * q as f64;
        (centre, [normal, normal.cross(along).normalize()])
    };
    let widest: f64 = random.random_range(0.05..0.25);
    let mut tube = |radius: f64, steps: usize| {
        let mut skin = Skin::default();
        tubed(
            &mut skin,
            steps,
            corners,
            radius,
            |index| frame(index, steps),
            &mut random,
        );
        skin.into_solid(format!("knot-{p}-{q}-{steps}x{corners}"))
    };
    [(1.0, 1), (0.6, 1), (0.3, 1), (0.2, 2), (0.1, 4)]
        .into_iter()
        .map(|(part, factor)| tube(widest * part, steps * factor))
        .find(|solid| defect(solid).is_none())
        .unwrap_or_else(|| tube(1e-3, steps * 8))
}

/// Rings, each through the next.
#[must_use]
pub fn chain(rings: usize, seed: u64) -> Solid {
    let mut random = random(seed);
    let mut skin = Skin::default();
    for ring in 0..rings {
        let around = random.random_range(8..=24);
        let across = random.random_range(3..=8);
        let centre = DVec3::X * 1.3 * ring as f64;
        let upright = [DVec3::Y, DVec3::Z][ring % 2];
        let frame = |index: usize| {
            let turn = nth(index, around);
            let out = DVec3::X * turn.x + upright * turn.y;
            (centre + out, [out, DVec3::X.cross(upright)])
        };
        tubed(&mut skin, around, across, 0.2, frame, &mut random);
    }
    skin.into_solid(format!("chain-{rings}"))
}

/// A closed tube: the section at each step is a polygon round a centre, in the plane of two axes.
fn tubed(
    skin: &mut Skin,
    steps: usize,
    corners: usize,
    radius: f64,
    frame: impl Fn(usize) -> (DVec3, [DVec3; 2]),
    random: &mut Random,
) {
    let start = random.random_range(0.0..1.0);
    let section =
        |corner: usize| -> DVec2 { turned(start + (corner % corners) as f64 / corners as f64) };
    let place = |step: usize, corner: usize| {
        let (centre, [right, up]) = frame(step % steps);
        let at = section(corner) * radius;
        centre + right * at.x + up * at.y
    };
    for step in 0..steps {
        for corner in 0..corners {
            let quad = [[0, 0], [1, 0], [1, 1], [0, 1]];
            let quad = quad.map(|[s, c]| place(step + s, corner + c));
            skin.quad(quad, random);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn knots_of_few_steps_are_clear_of_themselves() {
        for kind in KNOTS {
            for steps in [30, 31, 43, 60] {
                for seed in 0..3 {
                    let solid = knot(kind, steps, 3, seed);
                    assert_eq!(defect(&solid), None, "{}", solid.name);
                }
            }
        }
    }
}
