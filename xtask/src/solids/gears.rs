//! Gears and ratchets with a bore, a keyway and holes to save weight, extruded straight, tapered or helically.
//!
//! ```text
//!        _/‾\_
//!     /‾   _   ‾\       ratchet:  /|  /|
//!    <   o(_)o   >               / |_/ |_
//!     \_   ‾   _/
//!        ‾\_/‾
//! ```

use glam::{DVec2, dvec2};
use rand::RngExt;

use super::check::defect;
use super::extrude::{between, straight};
use super::flat::Drawing;
use super::turn::{nth, turned};
use super::{Random, Size, Solid, random};

/// Wheels of 5 to 2,000 teeth.
#[must_use]
pub fn draw(size: Size, seed: u64) -> Solid {
    let mut random = random(seed);
    let teeth = random.random_range(size.pick([5..=40, 60..=300, 800..=2000]));
    let layers = random.random_range(size.pick([1..=4, 1..=8, 4..=12]));
    gear(
        teeth,
        random.random_range(0..=8),
        layers,
        random.random_bool(0.4),
        seed,
    )
}

/// A wheel of radius 1 with so many teeth, holes and layers; `is_ratchet` makes the teeth lean.
///
/// Half of them are helical, checked, and straight where that fails.
#[must_use]
pub fn gear(teeth: usize, holes: usize, layers: usize, is_ratchet: bool, seed: u64) -> Solid {
    let mut random = random(seed);
    let mut drawing = Drawing::default();
    drawing.ring(&teeth_outline(teeth, is_ratchet, &mut random));
    drawing.ring(&bore(&mut random));
    for hole in 0..holes {
        let radius = (0.9 / holes as f64).min(0.12);
        let corners = random.random_range(3..=16);
        drawing.ring(&circle(nth(hole, holes) * 0.5, radius, corners));
    }
    let [bottom, top] = [0, 1].map(|_| drawing.inside(&mut random));
    let kind = if is_ratchet { "ratchet" } else { "gear" };
    let height = random.random_range(0.05..0.8);
    if random.random_bool(0.5) {
        // Less than a tooth, and at most a twelfth of a turn a layer.
        let twist = (1.0 / teeth as f64).min(layers as f64 / 12.0) * random.random_range(0.1..0.9);
        let taper = random.random_range(0.0..0.3);
        let place = |p: DVec2, layer: usize| {
            let part = layer as f64 / layers as f64;
            let p = turned(twist * part).rotate(p) * (1.0 - taper * part);
            p.extend(height * part)
        };
        let name = format!("{kind}-{teeth}-{holes}-helical");
        let solid = between(&bottom, &top, layers, place, &mut random).into_solid(name);
        if defect(&solid).is_none() {
            return solid;
        }
    }
    let name = format!("{kind}-{teeth}-{holes}-straight");
    straight(&bottom, &top, height, layers, &mut random).into_solid(name)
}

/// Counterclockwise; radii grow and turns never go back, so it is simple.
pub(super) fn teeth_outline(teeth: usize, is_ratchet: bool, random: &mut Random) -> Vec<DVec2> {
    let root = random.random_range(0.75..0.95);
    let [rise, tip, fall] = if is_ratchet {
        [0.9, 0.9, 0.95]
    } else {
        [0.3, 0.5, 0.8]
    };
    let tooth = |index: usize| {
        let at = |part: f64, radius: f64| turned((index as f64 + part) / teeth as f64) * radius;
        let tip = (tip > rise).then(|| at(tip, 1.0));
        [
            Some(at(0.0, root)),
            Some(at(rise, 1.0)),
            tip,
            Some(at(fall, root)),
        ]
    };
    (0..teeth).flat_map(tooth).flatten().collect()
}

/// A round hole of radius 0.2, with a keyway in half of the cases.
fn bore(random: &mut Random) -> Vec<DVec2> {
    const RADIUS: f64 = 0.2;
    let corners = 4 * random.random_range(2..=10);
    let mut hole = circle(DVec2::ZERO, RADIUS, corners);
    if random.random_bool(0.5) {
        let width = hole[1].y.min(0.05);
        let key = [[0.0, -width], [0.06, -width], [0.06, width], [0.0, width]];
        hole[0] = dvec2(RADIUS, 0.0);
        hole.splice(0..1, key.map(|[x, y]| dvec2(RADIUS * 0.99 + x, y)));
    }
    hole
}

/// Counterclockwise.
pub(super) fn circle(centre: DVec2, radius: f64, corners: usize) -> Vec<DVec2> {
    (0..corners)
        .map(|index| centre + nth(index, corners) * radius)
        .collect()
}
