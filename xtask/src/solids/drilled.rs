//! High genus: plates with a grid of square holes, and sponges drilled along all three axes.
//!
//! ```text
//!    ____________
//!   / □ □ □ □ □ /|     A plate with n by m holes has genus n m. A sponge of level k is drilled with squares of a third, a ninth, ...
//!  /_□_□_□_□_□_/ |     of its side.
//!  |___________|/
//! ```

use rand::RngExt;

use super::cells::{Cells, Place, whole};
use super::{Size, Solid, random};

/// Plates of 1 to 100 holes a side, sponges of levels 1 to 3, blocks drilled at random.
#[must_use]
pub fn draw(size: Size, seed: u64) -> Solid {
    let mut random = random(seed);
    match random.random_range(0..4) {
        0 | 1 => {
            let least = size.pick([1, 6, 30]);
            let most = size.pick([8, 24, 60]);
            let mut holes = || random.random_range(least..=most);
            plate([holes(), holes()], random.random_bool(0.6), seed)
        }
        2 => {
            let side = size.pick([5, 12, 30]);
            block(side, random.random_range(1..=side as usize * 2), seed)
        }
        _ => sponge(size.pick([1, 2, 3]), random.random_bool(0.5), seed),
    }
}

/// A plate with so many square holes, one cube high. `is_merged` merges coplanar faces.
#[must_use]
pub fn plate(holes: [i32; 2], is_merged: bool, seed: u64) -> Solid {
    let [width, depth] = holes.map(|count| 2 * count.max(0) + 1);
    let mut cells = Cells::new([width, depth, 1]);
    for x in 0..width {
        for y in 0..depth {
            cells.set([x, y, 0], x % 2 == 0 || y % 2 == 0);
        }
    }
    surface(
        &cells,
        is_merged,
        &format!("plate-{}x{}", holes[0], holes[1]),
        seed,
    )
}

/// A sponge: in every cube of three by three by three, the middle cube and those beside it are missing.
#[must_use]
pub fn sponge(level: u32, is_merged: bool, seed: u64) -> Solid {
    let side = 3_i32.pow(level);
    let mut cells = Cells::new([side; 3]);
    let is_hole = |place: Place| {
        (0..level).any(|digit| {
            let ones = place
                .iter()
                .filter(|&&count| count / 3_i32.pow(digit) % 3 == 1);
            ones.count() >= 2
        })
    };
    for x in 0..side {
        for y in 0..side {
            for z in 0..side {
                cells.set([x, y, z], !is_hole([x, y, z]));
            }
        }
    }
    surface(&cells, is_merged, &format!("sponge-{level}"), seed)
}

/// A block with square bores along random axes, through and through; bores may meet, and touch.
#[must_use]
pub fn block(side: i32, bores: usize, seed: u64) -> Solid {
    let mut random = random(seed);
    let mut cells = Cells::new([side; 3]);
    cells.set_box([0; 3], [side; 3], true);
    for _ in 0..bores {
        let axis = random.random_range(0..3);
        let mut low = [0; 3].map(|_| random.random_range(1..(side - 1).max(2)));
        let mut high = low.map(|count| count + 1);
        low[axis] = 0;
        high[axis] = side;
        cells.set_box(low, high, false);
    }
    surface(
        &cells,
        random.random_bool(0.7),
        &format!("block-{side}-{bores}"),
        seed,
    )
}

fn surface(cells: &Cells, is_merged: bool, name: &str, seed: u64) -> Solid {
    let mut random = random(seed);
    let skin = if is_merged {
        cells.polygons(whole, &mut random)
    } else {
        cells.squares(whole, &mut random)
    };
    let merged = if is_merged { "merged" } else { "squares" };
    skin.into_solid(format!("{name}-{merged}"))
}
