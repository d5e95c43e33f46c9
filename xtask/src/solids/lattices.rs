//! Struts of square section between the nodes of a grid, some of them missing.
//!
//! ```text
//!   ▪──▪──▪
//!   │  │  │     Struts are thin as their node, or much longer: thickness 0.001 to 1 of the gap. Faces are merged into long
//!   ▪──▪  ▪     polygons, or squares stay.
//!   │     │
//!   ▪──▪──▪
//! ```

use glam::DVec3;
use rand::RngExt;

use super::cells::{Cells, Place};
use super::{Size, Solid, random};

/// Grids of 2 to 16 nodes a side.
#[must_use]
pub fn draw(size: Size, seed: u64) -> Solid {
    let mut random = random(seed);
    let most = size.pick([3, 7, 16]);
    let least = size.pick([2, 4, 9]);
    let mut count = || random.random_range(least..=most);
    let nodes = [count(), count(), count()];
    let thickness = [1.0, 0.25, 0.1, 0.01, 0.001][random.random_range(0..5)];
    lattice(nodes, thickness, random.random_bool(0.5), seed)
}

/// A lattice with so many nodes along each axis, at distance 1 + `thickness`; one strut in eight is missing. `is_merged` merges
/// coplanar faces.
#[must_use]
pub fn lattice(nodes: Place, thickness: f64, is_merged: bool, seed: u64) -> Solid {
    const MISSING: f64 = 0.125;
    let mut random = random(seed);
    // Even places are nodes, odd ones struts, or nothing.
    let size = nodes.map(|count| 2 * count.max(1) - 1);
    let mut cells = Cells::new(size);
    for x in 0..size[0] {
        for y in 0..size[1] {
            for z in 0..size[2] {
                let odd = x % 2 + y % 2 + z % 2;
                let is_filled = odd == 0 || odd == 1 && !random.random_bool(MISSING);
                cells.set([x, y, z], is_filled);
            }
        }
    }
    let along = |step: i32| f64::from(step / 2) + f64::from((step + 1) / 2) * thickness;
    let place = |vertex: Place| DVec3::from(vertex.map(along));
    let [nx, ny, nz] = nodes;
    let merged = if is_merged { "merged" } else { "squares" };
    let name = format!("{nx}x{ny}x{nz}-{merged}");
    let skin = if is_merged {
        cells.polygons(place, &mut random)
    } else {
        cells.squares(place, &mut random)
    };
    skin.into_solid(name)
}
