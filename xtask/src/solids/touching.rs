//! Bodies that share a vertex or an edge and nothing else: tetrahedra in chains, rings round an edge, bunches at a vertex, and
//! cavities that reach the outside at a point.
//!
//! ```text
//!   /\  /\  /\          \ | /        ┌───────┐
//!  /__\/__\/__\        --\|/--       │   /\  │
//!    chain             --/|\--       │  /__\ │     a cavity at a corner of its body
//!                       fan          └───────┘
//! ```

use glam::{DVec3, dvec3};
use rand::RngExt;

use super::skin::Skin;
use super::turn::nth;
use super::{Random, Size, Solid, random};

/// One of the five kinds.
#[must_use]
pub fn draw(size: Size, seed: u64) -> Solid {
    let mut random = random(seed);
    let count = random.random_range(size.pick([2..=40, 300..=2000, 4000..=20_000]));
    match random.random_range(0..5) {
        0 => chain(count, seed),
        1 => fan(count.max(3)),
        2 => bunch(count, seed),
        3 => cavity(random.random_bool(0.5), seed),
        _ => grid(count.min(20_000).isqrt().max(2), seed),
    }
}

/// Tetrahedra in a row, each at the next with a vertex or with an edge, at random.
#[must_use]
pub fn chain(count: usize, seed: u64) -> Solid {
    let mut random = random(seed);
    let mut skin = Skin::default();
    // Each runs from an edge or a vertex in the plane x = i to one in the plane x = i + 1.
    let mut is_edge = random.random_bool(0.5);
    for link in 0..count {
        let is_edge_next = random.random_bool(0.5);
        let at = |dx: f64, y: f64, z: f64| dvec3(2.0 * (link as f64 + dx), y, z);
        let corners = match (is_edge, is_edge_next) {
            (true, true) => [
                at(0.0, 0.0, 0.0),
                at(0.0, 1.0, 0.0),
                at(1.0, 0.0, 0.0),
                at(1.0, 1.0, 0.0),
            ],
            (true, false) => [
                at(0.0, 0.0, 0.0),
                at(0.0, 1.0, 0.0),
                at(0.5, 0.0, 1.0),
                at(1.0, 0.0, 0.0),
            ],
            (false, true) => [
                at(0.0, 0.0, 0.0),
                at(0.5, 0.0, 1.0),
                at(1.0, 0.0, 0.0),
                at(1.0, 1.0, 0.0),
            ],
            (false, false) => [
                at(0.0, 0.0, 0.0),
                at(0.5, 1.0, 0.0),
                at(0.5, 0.0, 1.0),
                at(1.0, 0.0, 0.0),
            ],
        };
        if is_edge && is_edge_next {
            // Four corners of a rectangle: two tetrahedra over it, with a ridge between.
            let [a, b, c, d] = corners;
            let [low, high] = [at(0.5, 0.5, -1.0), at(0.5, 0.5, 1.0)];
            for [p, q] in [[a, b], [b, d], [d, c], [c, a]] {
                skin.triangle([q, p, high]);
                skin.triangle([p, q, low]);
            }
        } else {
            tetrahedron(&mut skin, corners);
        }
        is_edge = is_edge_next;
    }
    skin.into_solid(format!("chain-{count}"))
}

/// Wedges round a common edge, with as much room between them as they take: an edge with twice as many triangles.
#[must_use]
pub fn fan(count: usize) -> Solid {
    let mut skin = Skin::default();
    for blade in 0..count {
        let [a, b] = [2 * blade, 2 * blade + 1].map(|turn| nth(turn, 2 * count));
        tetrahedron(
            &mut skin,
            [DVec3::ZERO, DVec3::Z, a.extend(0.0), b.extend(0.5)],
        );
    }
    skin.into_solid(format!("fan-{count}"))
}

/// Tetrahedra with a common vertex, in cones that a grid of squares on the faces of a cube keeps apart.
#[must_use]
pub fn bunch(count: usize, seed: u64) -> Solid {
    let mut random = random(seed);
    let side = (count / 6).isqrt() + 1;
    let mut skin = Skin::default();
    for square in 0..count.min(6 * side * side) {
        let (face, i, j) = (square % 6, square / 6 / side, square / 6 % side);
        let mut corner = || {
            // Inside of the square, off its sides.
            let mut along = |index: usize| {
                let part = f64::from(random.random_range(1..16_i32)) / 16.0;
                2.0 * (index as f64 + part) / side as f64 - 1.0
            };
            let [x, y] = [along(i), along(j)];
            let flat = dvec3(x, y, 1.0);
            let turned = [
                flat,
                dvec3(flat.z, flat.x, flat.y),
                dvec3(flat.y, flat.z, flat.x),
            ][face % 3];
            (if face < 3 { turned } else { -turned }) * f64::from(random.random_range(1..=3_i32))
        };
        let corners = [DVec3::ZERO, corner(), corner(), corner()];
        let [_, a, b, c] = corners;
        // Corners that are drawn in one plane with the centre have no body, or one that rounding might spoil.
        if a.cross(b).dot(c).abs() > 1e-9 {
            tetrahedron(&mut skin, corners);
        }
    }
    if skin.is_empty() {
        tetrahedron(&mut skin, [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z]);
    }
    skin.into_solid(format!("bunch-{count}"))
}

/// A tetrahedron with a cavity that has a vertex, or an edge, in common with it.
#[must_use]
pub fn cavity(is_edge: bool, seed: u64) -> Solid {
    let mut random = random(seed);
    let mut inside = || {
        let mut draw = || f64::from(random.random_range(1..=5_i32));
        dvec3(draw(), draw(), draw())
    };
    let mut skin = Skin::default();
    let corners = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z].map(|p| p * 16.0);
    tetrahedron(&mut skin, corners);
    let mut ends = [
        if is_edge { corners[3] } else { inside() },
        inside(),
        inside(),
    ];
    if ends[1].cross(ends[2]).dot(ends[0]) == 0.0 {
        // In one plane with the corner.
        ends = [corners[3], dvec3(2.0, 1.0, 1.0), dvec3(1.0, 2.0, 1.0)];
    }
    let [a, b, c] = ends;
    let mut hole = Skin::default();
    tetrahedron(&mut hole, [DVec3::ZERO, a, b, c]);
    skin.add(&hole.into_solid("hole"), true);
    let kind = if ends[0] == corners[3] {
        "edge"
    } else {
        "vertex"
    };
    skin.into_solid(format!("cavity-{kind}"))
}

/// Octahedra on the squares of a chessboard, which touch at the middles of the sides; a third of them are missing.
#[must_use]
pub fn grid(side: usize, seed: u64) -> Solid {
    let mut random = random(seed);
    let mut skin = Skin::default();
    for index in 0..side * side {
        if index > 0 && random.random_range(0..3) == 0 {
            continue;
        }
        let centre = dvec3((index / side) as f64, (index % side) as f64, 0.0) * 2.0;
        octahedron(&mut skin, centre, &mut random);
    }
    skin.into_solid(format!("grid-{side}"))
}

/// Four corners in the plane at distance 1 of the centre, joined to one above and one below.
fn octahedron(skin: &mut Skin, centre: DVec3, random: &mut Random) {
    let mut height = || f64::from(random.random_range(1..=9_i32));
    let [low, high] = [centre - DVec3::Z * height(), centre + DVec3::Z * height()];
    for step in 0..4 {
        let [a, b] = [step, step + 1].map(|step| centre + nth(step, 4).extend(0.0));
        skin.triangle([a, b, high]);
        skin.triangle([b, a, low]);
    }
}

/// Turned so that its triangles face outwards.
fn tetrahedron(skin: &mut Skin, [a, b, c, d]: [DVec3; 4]) {
    let is_right_handed = (b - a).cross(c - a).dot(d - a) > 0.0;
    let [b, c] = if is_right_handed { [b, c] } else { [c, b] };
    for corners in [[a, c, b], [a, b, d], [b, c, d], [c, a, d]] {
        skin.triangle(corners);
    }
}
