//! Chazelle's polyhedron: a block with notches from below up to lines of the saddle z = x y, and notches from above, across them,
//! down to lines of the same saddle a little higher. It takes a number of tetrahedra quadratic in the number of notches.
//!
//! ```text
//!    ______________________
//!    |  |/  |/  |/  |/    /|      from above: ridges at x = 1, 2, ..., n, at heights x y + gap
//!    |__________________ / |
//!    |/\__/\__/\__/\____|/ |      from below: ridges at y = 1, 2, ..., n, at heights x y
//! ```
//!
//! Both are graphs over the square from 0 to n + 1, made of strips between lines; the walls are polygons in upright planes.
//! Source: B. Chazelle, Convex partitions of polyhedra, SIAM J. Comput. 13, 1984.

use glam::{DVec2, DVec3, dvec2, dvec3};
use rand::RngExt;

use super::flat::Drawing;
use super::schoenhardt::jittered;
use super::skin::Skin;
use super::{Size, Solid, random, ten_to};

/// 1 to 24 notches each way, 25 to 60, 200 to 400; many of the small ones jittered.
#[must_use]
pub fn draw(size: Size, seed: u64) -> Solid {
    let mut random = random(seed);
    let notches = random.random_range(size.pick([1..=24, 25..=60, 200..=400]));
    let exponent = random.random_range(0..=9);
    // A binary gap leaves the ends of the ridges on lines exactly; another one leaves them on lines but for rounding.
    let gap = if random.random_bool(0.75) {
        0.125_f64.powi(exponent)
    } else {
        ten_to(-exponent)
    };
    let width = [0.25, 0.1, 0.01, 1.0 / 1024.0][random.random_range(0..4)];
    let solid = chazelle(notches, gap, width, seed);
    if size == Size::Small && random.random_bool(0.4) {
        jittered(solid, &mut random)
    } else {
        solid
    }
}

/// Straight lines along a strip of the square: a place across, and heights at both ends.
#[derive(Clone, Copy)]
struct Line {
    at: f64,
    heights: [f64; 2],
}

/// The polyhedron with so many notches each way, `gap` between the two saddles, notches `width` wide on either side, at most 1/4.
///
/// The sides of notches are steeper than the saddle anywhere, which keeps the two graphs apart.
#[must_use]
pub fn chazelle(notches: usize, gap: f64, width: f64, seed: u64) -> Solid {
    let name = format!("{notches}-gap{gap:.0e}-width{width:.0e}");
    skin(notches, gap, width, seed).into_solid(name)
}

fn skin(notches: usize, gap: f64, width: f64, seed: u64) -> Skin {
    let mut random = random(seed);
    let side = notches as f64 + 1.0;
    // As deep as the saddle is high, so that the slope of a notch is at least that of the saddle.
    let [floor, roof] = [-side, side * side + side];
    let below = lines(notches, width, floor, 0.0);
    let above = lines(notches, width, roof, gap);
    let mut skin = Skin::default();
    let bottom = |line: &Line, end: usize| dvec3(side * end as f64, line.at, line.heights[end]);
    let top = |line: &Line, end: usize| dvec3(line.at, side * end as f64, line.heights[end]);
    for pair in below.windows(2) {
        let [a, b] = [&pair[0], &pair[1]];
        skin.quad(
            [bottom(a, 0), bottom(b, 0), bottom(b, 1), bottom(a, 1)],
            &mut random,
        );
    }
    for pair in above.windows(2) {
        let [a, b] = [&pair[0], &pair[1]];
        skin.quad([top(a, 0), top(b, 0), top(b, 1), top(a, 1)], &mut random);
    }
    for end in [0, 1] {
        let far = side * end as f64;
        let profile = |lines: &[Line]| -> Vec<DVec2> {
            lines
                .iter()
                .map(|line| dvec2(line.at, line.heights[end]))
                .collect()
        };
        let straight = |height: f64| [dvec2(side, height), dvec2(0.0, height)];
        // Seen from outside, y runs to the left at x = 0, and x to the left at y = side.
        wall(
            &mut skin,
            profile(&below),
            straight(roof),
            |p| dvec3(far, p.x, p.y),
            end == 1,
            seed,
        );
        wall(
            &mut skin,
            profile(&above),
            straight(floor),
            |p| dvec3(p.x, far, p.y),
            end == 0,
            seed,
        );
    }
    skin
}

/// Strips at the height `base` between notches, and notches from there to the saddle.
fn lines(notches: usize, width: f64, base: f64, gap: f64) -> Vec<Line> {
    let side = notches as f64 + 1.0;
    let flat = |at: f64| Line {
        at,
        heights: [base; 2],
    };
    let notch = |index: usize| {
        let at = index as f64;
        let ridge = Line {
            at,
            heights: [gap, at * side + gap],
        };
        [flat(at - width), ridge, flat(at + width)]
    };
    let inner = (1..=notches).flat_map(notch);
    [flat(0.0)]
        .into_iter()
        .chain(inner)
        .chain([flat(side)])
        .collect()
}

/// A polygon in an upright plane between a profile and a straight side.
fn wall(
    skin: &mut Skin,
    profile: Vec<DVec2>,
    straight: [DVec2; 2],
    place: impl Fn(DVec2) -> DVec3,
    is_kept: bool,
    seed: u64,
) {
    let mut drawing = Drawing::default();
    let corners: Vec<DVec2> = profile.into_iter().chain(straight).collect();
    drawing.ring(&corners);
    for corners in drawing.inside(&mut random(seed)).places() {
        let [a, b, c] = corners.map(&place);
        skin.triangle(if is_kept { [a, b, c] } else { [a, c, b] });
    }
}

#[cfg(test)]
mod tests {
    use super::super::check::defect;
    use super::*;

    #[test]
    fn notches_of_any_width_and_gap_are_apart() {
        for notches in [1, 2, 5, 13, 40] {
            for gap in [1.0, 0.01, 1e-9] {
                for width in [0.25, 0.1, 1.0 / 1024.0] {
                    for seed in 0..3 {
                        let solid = chazelle(notches, gap, width, seed);
                        assert_eq!(defect(&solid), None, "{}", solid.name);
                    }
                }
            }
        }
    }
}
