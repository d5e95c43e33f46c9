//! Twisted extrusions: a section that turns and shrinks as it rises, whose sides are no longer flat.
//!
//! ```text
//!    ┌──┐   /‾‾/   ◇    The four corners between two layers and two edges are not coplanar; each quad is folded along either
//!    │  │  /  /   / \   diagonal at random.
//!    └──┘ /__/    \_/
//! ```
//!
//! Folded quads may meet when the twist of a layer is large, so each surface is checked, with twice the layers if need be.

use glam::{DVec2, dvec2};
use rand::RngExt;

use super::check::defect;
use super::extrude::between;
use super::flat::Drawing;
use super::gears::{circle, teeth_outline};
use super::turn::{nth, turned};
use super::{Random, Size, Solid, random};

/// Twists of up to three turns.
#[must_use]
pub fn draw(size: Size, seed: u64) -> Solid {
    let mut random = random(seed);
    let layers = random.random_range(size.pick([1..=20, 40..=80, 200..=400]));
    screw(layers, random.random_range(-3.0..3.0), seed)
}

/// A random section that turns so often on its way up, in so many layers or a small multiple.
#[must_use]
pub fn screw(layers: usize, turns: f64, seed: u64) -> Solid {
    let mut random = random(seed);
    let (kind, outline) = section(&mut random);
    let mut drawing = Drawing::default();
    drawing.ring(&outline);
    let is_hollow = random.random_bool(0.3);
    if is_hollow {
        drawing.ring(&circle(DVec2::ZERO, 0.25, random.random_range(6..=24)));
    }
    let [bottom, top] = [0, 1].map(|_| drawing.inside(&mut random));
    let height = random.random_range(0.5..6.0);
    let taper = random.random_range(0.0..0.9);
    let hollow = if is_hollow { "-hollow" } else { "" };
    let mut twisted = |layers: usize, turns: f64| {
        let place = |p: DVec2, layer: usize| {
            let part = layer as f64 / layers as f64;
            let p = turned(turns * part).rotate(p) * (1.0 - taper * part);
            p.extend(height * part)
        };
        let name = format!("{kind}{hollow}-{layers}");
        between(&bottom, &top, layers, place, &mut random).into_solid(name)
    };
    // At first a sixth of a turn for each layer at most.
    let most = layers as f64 / 6.0;
    [(1, turns.clamp(-most, most)), (2, turns), (4, turns / 2.0)]
        .into_iter()
        .map(|(factor, turns)| twisted(layers * factor, turns))
        .find(|solid| defect(solid).is_none())
        .unwrap_or_else(|| twisted(layers, 0.0))
}

/// A section of radius about 1 that holds the circle of radius 0.3.
fn section(random: &mut Random) -> (&'static str, Vec<DVec2>) {
    let cross = [
        [1, 3],
        [-1, 3],
        [-1, 1],
        [-3, 1],
        [-3, -1],
        [-1, -1],
        [-1, -3],
        [1, -3],
    ];
    match random.random_range(0..5) {
        0 => ("square", circle(DVec2::ZERO, 1.0, 4)),
        1 => {
            let cross = cross.into_iter().chain([[1, -1], [3, -1], [3, 1], [1, 1]]);
            let corner = |[x, y]: [i32; 2]| dvec2(f64::from(x), f64::from(y)) / 3.0;
            ("cross", cross.map(corner).collect())
        }
        2 => {
            let spikes = random.random_range(4..=9);
            let radius = |index: usize| if index.is_multiple_of(2) { 1.0 } else { 0.45 };
            let corner = |index| nth(index, 2 * spikes) * radius(index);
            ("star", (0..2 * spikes).map(corner).collect())
        }
        3 => {
            // A thin ellipse: its sides come close to the axis.
            let corner = |p: DVec2| p * dvec2(1.0, 0.32);
            (
                "blade",
                circle(DVec2::ZERO, 1.0, 16)
                    .into_iter()
                    .map(corner)
                    .collect(),
            )
        }
        _ => {
            let teeth = random.random_range(5..=16);
            (
                "gear",
                teeth_outline(teeth, random.random_bool(0.5), random),
            )
        }
    }
}
