//! Unions and differences of boxes on a small grid of integers.
//!
//! ```text
//!     ┌────┐
//!     │  ┌─┼──┐      Faces are coplanar exactly, merged into polygons with holes, and triangulated with needles.
//!   ┌─┼──┘ │  │      In some, bodies touch along an edge or at a vertex: "edge" and "vertex" in the name.
//!   └─┴────┴──┘
//! ```

use rand::RngExt;

use super::cells::{Cells, Place, whole};
use super::{Random, Size, Solid, random};

/// Boxes on grids of 3 to 40 cubes a side.
#[must_use]
pub fn draw(size: Size, seed: u64) -> Solid {
    let mut random = random(seed);
    let (side, boxes) = size.pick([(3..=8, 2..=10), (12..=20, 30..=80), (30..=40, 300..=600)]);
    let side = random.random_range(side);
    csg(
        side,
        random.random_range(boxes),
        random.random_bool(0.4),
        seed,
    )
}

/// The union and difference of `boxes` random boxes in a grid with `side` cubes a side; `is_touching` plants places where bodies touch.
#[must_use]
pub fn csg(side: i32, boxes: usize, is_touching: bool, seed: u64) -> Solid {
    let mut random = random(seed);
    let cells = cells(side, boxes, is_touching, &mut random);
    let touch = cells.touch();
    let edge = if touch.edges > 0 { "-edge" } else { "" };
    let vertex = if touch.vertices > 0 { "-vertex" } else { "" };
    let name = format!("{side}-{boxes}{edge}{vertex}");
    cells.polygons(whole, &mut random).into_solid(name)
}

/// At least one cube.
pub(super) fn cells(side: i32, boxes: usize, is_touching: bool, random: &mut Random) -> Cells {
    let side = side.max(2);
    let mut cells = Cells::new([side; 3]);
    for _ in 0..boxes {
        // Boxes of up to half a side, so that many see the light.
        let size = [0; 3].map(|_| random.random_range(1..=1 + side / 2));
        let low = size.map(|size| random.random_range(0..=(side - size).max(0)));
        let high = [0, 1, 2].map(|axis| low[axis] + size[axis]);
        cells.set_box(low, high, random.random_bool(0.65));
    }
    if is_touching {
        for _ in 0..=side / 4 {
            plant(&mut cells, random);
        }
    }
    if cells.is_empty() {
        cells.set_box([0; 3], [side, side, 1], true);
    }
    cells
}

/// Two cubes with an edge or only a vertex in common, and nothing beside them.
fn plant(cells: &mut Cells, random: &mut Random) {
    let side = cells.size()[0];
    let low: Place = [0; 3].map(|_| random.random_range(0..=side - 2));
    let high = low.map(|count| count + 2);
    let mut other = low.map(|count| count + 1);
    if random.random_bool(0.5) {
        let axis = random.random_range(0..3);
        other[axis] = low[axis];
    }
    // A body with two holes that touch, or two bodies that do.
    let is_body = random.random_bool(0.5);
    cells.set_box(low, high, !is_body);
    cells.set(low, is_body);
    cells.set(other, is_body);
}
