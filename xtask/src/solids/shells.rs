//! Surfaces within each other with gaps down to 1e-12 of their size: bodies, cavities in them, bodies in these.
//!
//! ```text
//!   ┌──────────┐
//!   │┌────────┐│     Spheres in spheres, boxes in boxes with other vertices and triangles, octahedra whose corners nearly touch the
//!   ││ ◇  ◇  ◇││     faces of a box, and many small cavities, some with bodies in them.
//!   │└────────┘│
//!   └──────────┘
//! ```

use glam::{DVec3, dvec3};
use rand::RngExt;

use super::cells::Cells;
use super::skin::Skin;
use super::smooth::icosphere;
use super::{Random, Size, Solid, random, ten_to};

/// 2 to 12 shells, or up to 1,000 cavities.
#[must_use]
pub fn draw(size: Size, seed: u64) -> Solid {
    let mut random = random(seed);
    let shells = random.random_range(2..=8);
    let gap = ten_to(-random.random_range(1..=12));
    match random.random_range(0..4) {
        0 => spheres(
            random.random_range(size.pick([0..=2, 3..=3, 5..=5])),
            shells,
            gap,
        ),
        1 => boxes(size.pick([4, 16, 50]), shells, gap, seed),
        2 => diamonds(shells, gap, seed),
        _ => cavities(
            random.random_range(size.pick([2..=3, 4..=5, 8..=10])),
            gap,
            seed,
        ),
    }
}

/// Spheres with the same triangles, each smaller by a factor of 1 - `gap`.
#[must_use]
pub fn spheres(level: u32, shells: usize, gap: f64) -> Solid {
    let sphere = icosphere(level);
    let mut skin = Skin::default();
    for shell in 0..shells {
        // The difference is rounded once, not with every shell again.
        let factor = 1.0 - gap * 0.5 * shell as f64;
        skin.add(&sphere.clone().moved(|p| p * factor), shell % 2 == 1);
    }
    skin.into_solid(format!("spheres-{level}-{shells}-{gap:e}"))
}

/// Boxes in the unit cube, each divided anew into up to `most` pieces along each axis, `gap` inside of the one before.
#[must_use]
pub fn boxes(most: i32, shells: usize, gap: f64, seed: u64) -> Solid {
    let mut random = random(seed);
    let mut skin = Skin::default();
    let gap = gap * 0.9 / shells as f64;
    for shell in 0..shells {
        let inset = gap * shell as f64;
        skin.add(&gridded_box(most, inset, &mut random), shell % 2 == 1);
    }
    skin.into_solid(format!("boxes-{shells}-{gap:.0e}"))
}

/// The unit cube, smaller by `inset` on every side, with squares between random planes.
fn gridded_box(most: i32, inset: f64, random: &mut Random) -> Solid {
    let mut along = || {
        let count = random.random_range(1..=most);
        let inner = (1..count).map(|_| f64::from(random.random_range(1..64_i32)) / 64.0);
        let inner = inner.filter(|place| (inset..1.0 - inset).contains(place));
        let mut places: Vec<f64> = inner.chain([inset, 1.0 - inset]).collect();
        places.sort_by(f64::total_cmp);
        places.dedup();
        places
    };
    let places = [along(), along(), along()];
    let size = [0, 1, 2].map(|axis| places[axis].len() as i32 - 1);
    let mut cells = Cells::new(size);
    cells.set_box([0; 3], size, true);
    let place = |vertex: [i32; 3]| {
        DVec3::from([0, 1, 2].map(|axis: usize| places[axis][vertex[axis] as usize]))
    };
    cells.squares(place, random).into_solid("box")
}

/// A cube, an octahedron in it with corners `gap` from the faces, a cube in that with corners `gap` from its faces, and so on.
#[must_use]
pub fn diamonds(shells: usize, gap: f64, seed: u64) -> Solid {
    let mut random = random(seed);
    let mut skin = Skin::default();
    let mut half = 1.0;
    for shell in 0..shells {
        let solid = if shell % 2 == 0 {
            centred_box(DVec3::ZERO, half, &mut random)
        } else {
            octahedron(DVec3::ZERO, half)
        };
        skin.add(&solid, shell % 2 == 1);
        // An octahedron of this half width holds a cube of a third.
        half = if shell % 2 == 0 {
            half * (1.0 - gap)
        } else {
            half / 3.0 * (1.0 - gap)
        };
    }
    skin.into_solid(format!("diamonds-{shells}-{gap:e}"))
}

/// A cube with a grid of cavities, `gap` apart: octahedra, boxes and small spheres, every other one with a body inside.
#[must_use]
pub fn cavities(side: i32, gap: f64, seed: u64) -> Solid {
    let mut random = random(seed);
    let mut skin = Skin::default();
    let outer = 2.0 * f64::from(side);
    skin.add(&boxed(DVec3::ZERO, DVec3::splat(outer), &mut random), false);
    for index in 0..side * side * side {
        let centre = [index / side / side, index / side % side, index % side];
        let centre = DVec3::from(centre.map(|count| 2.0 * f64::from(count) + 1.0));
        let half = 1.0 - gap / 2.0;
        let mut bubble = |half: f64| match random.random_range(0..3) {
            0 => octahedron(centre, half),
            1 => centred_box(centre, half, &mut random),
            _ => icosphere(0).moved(|p| centre + p * half),
        };
        let cavity = bubble(half);
        skin.add(&cavity, true);
        if index % 2 == 0 {
            // Every cavity holds a ball of more than half its half width, and every body is in the ball of √3 its own.
            skin.add(&bubble(half * 0.3), false);
        }
    }
    skin.into_solid(format!("cavities-{side}-{gap:e}"))
}

fn centred_box(centre: DVec3, half: f64, random: &mut Random) -> Solid {
    boxed(centre - half, centre + half, random)
}

fn boxed(low: DVec3, high: DVec3, random: &mut Random) -> Solid {
    let mut cells = Cells::new([1; 3]);
    cells.set([0; 3], true);
    let corner = |vertex: [i32; 3]| {
        DVec3::select(
            glam::BVec3::from_array(vertex.map(|end| end > 0)),
            high,
            low,
        )
    };
    cells.squares(corner, random).into_solid("box")
}

fn octahedron(centre: DVec3, half: f64) -> Solid {
    let mut skin = Skin::default();
    for [x, y, z] in [
        [1.0, 1.0, 1.0],
        [1.0, -1.0, -1.0],
        [-1.0, 1.0, -1.0],
        [-1.0, -1.0, 1.0],
    ] {
        let corners = |x: f64, y: f64, z: f64| {
            [dvec3(x, 0.0, 0.0), dvec3(0.0, y, 0.0), dvec3(0.0, 0.0, z)].map(|p| centre + p * half)
        };
        skin.triangle(corners(x, y, z));
        // The opposite octant has the other sense.
        let [a, b, c] = corners(-x, -y, -z);
        skin.triangle([a, c, b]);
    }
    skin.into_solid("octahedron")
}
