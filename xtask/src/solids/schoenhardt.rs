//! Schönhardt's prisms: two polygons, one turned against the other, with the diagonals that cave in. None of them is filled by
//! tetrahedra without a vertex inside.
//!
//! ```text
//!      ·─────────·       The turn goes up to 1/2 - 1/n of a whole one, where the diagonals meet on the axis: 1/6 for a triangle.
//!      │\ .'   '/│       Source: E. Schönhardt, Über die Zerlegung von Dreieckspolyedern in Tetraeder, 1928.
//!      │ X     / │
//!      │' \  ./  │
//!      ·─────────·
//! ```

use glam::DVec3;
use rand::RngExt;

use super::check::defect;
use super::skin::Skin;
use super::turn::turned;
use super::{Random, Size, Solid, random, ten_to};

/// One prism, a tower of them, or a block with prisms as cavities; half of them jittered.
#[must_use]
pub fn draw(size: Size, seed: u64) -> Solid {
    let mut random = random(seed);
    let sides = [3, 3, 3, 4, 5, 6, 8, 12][random.random_range(0..8)];
    let closeness = ten_to(-random.random_range(0..=9)) * 0.9;
    let solid = match (size, random.random_range(0..3)) {
        (Size::Small, 0) => prism(sides, closeness),
        (_, 1) => tower(
            sides,
            closeness,
            random.random_range(size.pick([2..=12, 40..=200, 800..=2000])),
        ),
        _ => block(
            sides,
            closeness,
            random.random_range(size.pick([2..=5, 6..=12, 15..=25])),
            seed,
        ),
    };
    if random.random_bool(0.5) {
        jittered(solid, &mut random)
    } else {
        solid
    }
}

/// A prism of height 1 over a regular polygon of radius 1 with at least three `sides`, turned by (1 - `closeness`) of the limit; `closeness` from 0, excluded, to 1.
#[must_use]
pub fn prism(sides: usize, closeness: f64) -> Solid {
    let name = format!("prism-{sides}-{closeness:.0e}");
    stacked(sides, closeness, 1).into_solid(name)
}

/// Prisms on each other, turned to and fro.
#[must_use]
pub fn tower(sides: usize, closeness: f64, floors: usize) -> Solid {
    let name = format!("tower-{sides}-{floors}-{closeness:.0e}");
    stacked(sides, closeness, floors).into_solid(name)
}

/// A flat block with `side` by `side` prisms as cavities.
#[must_use]
pub fn block(sides: usize, closeness: f64, side: usize, seed: u64) -> Solid {
    let mut random = random(seed);
    let mut skin = Skin::default();
    let high = DVec3::new(2.5 * side as f64, 2.5 * side as f64, 1.5);
    let corner = |index: usize| {
        let is_far = [0, 1, 2].map(|axis| index >> axis & 1 == 1);
        DVec3::select(glam::BVec3::from_array(is_far), high, DVec3::ZERO)
    };
    for quad in [
        [0, 2, 3, 1],
        [4, 5, 7, 6],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 4, 6, 2],
        [1, 3, 7, 5],
    ] {
        skin.quad(quad.map(corner), &mut random);
    }
    for index in 0..side * side {
        let [x, y] = [index / side, index % side].map(|count| 2.5 * count as f64 + 1.25);
        let prism = stacked(sides, closeness, 1).into_solid("prism");
        skin.add(&prism.moved(|p| p + DVec3::new(x, y, 0.25)), true);
    }
    skin.into_solid(format!("block-{sides}-{side}-{closeness:.0e}"))
}

fn stacked(sides: usize, closeness: f64, floors: usize) -> Skin {
    let limit = 0.5 - 1.0 / sides as f64;
    let twist = limit * (1.0 - closeness);
    let corner = |floor: usize, index: usize| {
        let turns = index as f64 / sides as f64 + if floor % 2 == 1 { twist } else { 0.0 };
        turned(turns).extend(floor as f64)
    };
    let mut skin = Skin::default();
    for index in 1..sides - 1 {
        skin.triangle([0, index + 1, index].map(|index| corner(0, index)));
        skin.triangle([0, index, index + 1].map(|index| corner(floors, index)));
    }
    for floor in 0..floors {
        for index in 0..sides {
            let next = (index + 1) % sides;
            let [a, b] = [corner(floor, index), corner(floor, next)];
            let [c, d] = [corner(floor + 1, next), corner(floor + 1, index)];
            // The longer diagonal: the polygon above is turned to the left, or, on odd floors, to the right.
            let halves = if floor % 2 == 0 {
                [[a, b, c], [a, c, d]]
            } else {
                [[a, b, d], [b, c, d]]
            };
            halves.into_iter().for_each(|half| skin.triangle(half));
        }
    }
    skin
}

/// Moved by up to a random power of ten; by less and less, and not at all in the end, where that makes it invalid.
pub(super) fn jittered(solid: Solid, random: &mut Random) -> Solid {
    let first = random.random_range(2..=10);
    for exponent in first..first + 8 {
        let mut moved = solid.clone().jittered(ten_to(-exponent), random);
        moved.name = format!("{}-jitter{exponent}", solid.name);
        if defect(&moved).is_none() {
            return moved;
        }
    }
    solid
}

#[cfg(test)]
mod tests {
    use super::*;
    use delaunay_core::{BuildOptions, Surface, VertexId, progress::silent};

    #[test]
    fn prisms_are_valid_up_to_the_limit_and_have_no_tetrahedra_of_their_own() {
        for closeness in [0.9, 0.5, 0.1, 1e-3, 1e-6, 1e-9] {
            for sides in [3, 4, 7] {
                let solid = prism(sides, closeness);
                assert_eq!(defect(&solid), None, "{}", solid.name);
                let corners = |t: &[u32; 3]| t.map(|v| VertexId::new(v as usize));
                let triangles = solid.triangles.iter().map(corners).collect();
                let surface = Surface::new(solid.points, triangles).unwrap();
                assert!(surface.solid(BuildOptions::default(), &mut silent).is_err());
            }
        }
    }
}
