//! Prisms over outlines: words in block letters, alone, embossed and engraved; spirals, combs, and random simple polygons whose
//! ears are cut off.
//!
//! ```text
//!   ┌─────────────┐
//!   │ ┌─────────┐ │     embossed:   ┌┐ ┌┐            engraved:  ─┐┌─┐┌──
//!   │ │ ┌─────┐ │ │               ──┘└─┘└──                    └┘ └┘
//!   │ │ └───  │ │ │               ─────────                   ─────────
//!   │ └───────┘ │ │
//! ```

use delaunay_core::geo_predicates::{Sign, orient2d};
use delaunay_core::segments_cross;
use glam::{DVec2, dvec2};
use rand::RngExt;

use super::ears::clipped;
use super::extrude::straight;
use super::flat::{Cap, Drawing};
use super::letters::LETTERS;
use super::skin::Skin;
use super::{Random, Size, Solid, random};

/// One of the five kinds.
#[must_use]
pub fn draw(size: Size, seed: u64) -> Solid {
    let mut random = random(seed);
    let letters = random.random_range(size.pick([1..=12, 40..=150, 300..=900]));
    match (random.random_range(0..5), size) {
        (0, _) => word(letters, seed),
        (1, _) => relief(letters, random.random_bool(0.5), seed),
        (2, Size::Small) => prism("spiral", &spiral(random.random_range(2..=40)), seed),
        (3, Size::Small) => {
            let teeth = random.random_range(2..=60);
            prism("comb", &comb(teeth, &mut random), seed)
        }
        (4, Size::Small) => {
            let corners = random.random_range(5..=120);
            prism("polygon", &polygon(corners, &mut random), seed)
        }
        _ => relief(letters, true, seed),
    }
}

/// Random letters in a row, as bodies of their own.
#[must_use]
pub fn word(letters: usize, seed: u64) -> Solid {
    let mut random = random(seed);
    let (text, drawing) = text(letters, &mut random);
    let [bottom, top] = [0, 1].map(|_| drawing.inside(&mut random));
    let skin = straight(&bottom, &top, 2.0, random.random_range(1..=3), &mut random);
    skin.into_solid(format!("word-{text}"))
}

/// Random letters on a plate, raised or sunk by half of its height.
#[must_use]
pub fn relief(letters: usize, is_raised: bool, seed: u64) -> Solid {
    let mut random = random(seed);
    let (text, ink) = text(letters, &mut random);
    let width = 6.0 * letters as f64;
    let plate = [[-1.0, -1.0], [width, -1.0], [width, 8.0], [-1.0, 8.0]].map(DVec2::from);
    let mut base = Drawing::default();
    base.ring(&plate);
    let mut paper = ink.clone();
    paper.ring(&plate);
    let [base, ink, paper] = [base, ink, paper].map(|drawing| drawing.inside(&mut random));
    let mut skin = Skin::default();
    let [low, high] = [2.0, if is_raised { 3.0 } else { 1.0 }];
    for [a, b, c] in base.places() {
        skin.triangle([a, c, b].map(|p| p.extend(0.0)));
    }
    for (cap, height) in [(&paper, low), (&ink, high)] {
        for corners in cap.places() {
            skin.triangle(corners.map(|p| p.extend(height)));
        }
    }
    for (cap, [from, to]) in [(&base, [0.0, low]), (&ink, [low, high])] {
        walls(&mut skin, cap, [from, to], &mut random);
    }
    let kind = if is_raised { "embossed" } else { "engraved" };
    skin.into_solid(format!("{kind}-{text}"))
}

/// Quads on the rim, from one height to another, which may be below.
fn walls(skin: &mut Skin, cap: &Cap, [from, to]: [f64; 2], random: &mut Random) {
    for [a, b] in cap.rim() {
        skin.quad(
            [a.extend(from), b.extend(from), b.extend(to), a.extend(to)],
            random,
        );
    }
}

/// The letters that are drawn, up to eight of them as text in the name, and their outlines.
fn text(letters: usize, random: &mut Random) -> (String, Drawing) {
    let mut name = String::new();
    let mut drawing = Drawing::default();
    for column in 0..letters {
        let letter = &LETTERS[random.random_range(0..LETTERS.len())];
        if column < 8 {
            name.push(letter.name.to_ascii_lowercase());
        }
        letter.at(column).for_each(|ring| drawing.ring(&ring));
    }
    (name, drawing)
}

/// A prism over a simple polygon whose caps are triangulated by cutting off ears, from height 0 to 1, 10 or 1/100.
fn prism(kind: &str, polygon: &[DVec2], seed: u64) -> Solid {
    let mut random = random(seed);
    let [bottom, top] = [0, 1].map(|_| clipped(polygon, &mut random));
    let height = [1.0, 10.0, 0.01][random.random_range(0..3)];
    let skin = straight(&bottom, &top, height, 1, &mut random);
    skin.into_solid(format!("{kind}-{}", polygon.len()))
}

/// A band one wide that winds outwards to the left in right angles, with a gap of one between its turns: `arms` straight pieces.
#[must_use]
pub fn spiral(arms: usize) -> Vec<DVec2> {
    let mut at = DVec2::ZERO;
    let mut along = DVec2::X;
    let mut right = vec![at];
    let mut left = vec![at + along.perp()];
    for arm in 0..arms {
        at += along * (2 * (arm / 2) + 3) as f64;
        let beside = at + along.perp();
        right.push(at);
        left.push(if arm + 1 == arms {
            beside
        } else {
            beside - along
        });
        along = along.perp();
    }
    right.into_iter().chain(left.into_iter().rev()).collect()
}

/// Teeth of random length on a bar, some of no width but one thousandth.
fn comb(teeth: usize, random: &mut Random) -> Vec<DVec2> {
    let width = 2.0 * teeth as f64;
    let mut corners = vec![dvec2(0.0, -1.0), dvec2(width, -1.0)];
    for tooth in (0..teeth).rev() {
        let left = 2.0 * tooth as f64;
        let thickness = [1.0, 0.5, 0.001][random.random_range(0..3)];
        let length = f64::from(random.random_range(1..=50_i32));
        let right = left + 1.0 + thickness / 2.0;
        let far = left + 1.0 - thickness / 2.0;
        corners.extend([
            dvec2(right, 0.0),
            dvec2(right, length),
            dvec2(far, length),
            dvec2(far, 0.0),
        ]);
    }
    corners
}

/// A simple polygon with up to so many corners in whole numbers: an edge of a triangle gets a new corner again and again, wherever the
/// triangle between holds no corner and no edge.
fn polygon(corners: usize, random: &mut Random) -> Vec<DVec2> {
    const SIDE: i32 = 100;
    let mut polygon = vec![dvec2(40.0, 40.0), dvec2(60.0, 40.0), dvec2(50.0, 60.0)];
    for _ in 0..40 * corners {
        if polygon.len() >= corners {
            break;
        }
        let index = random.random_range(0..polygon.len());
        let [x, y] = [0; 2].map(|_| f64::from(random.random_range(0..=SIDE)));
        if may_grow(&polygon, index, dvec2(x, y)) {
            polygon.insert(index + 1, dvec2(x, y));
        }
    }
    // An edge led round all the rest turns the polygon over.
    let area = |corner: usize| polygon[corner].perp_dot(polygon[(corner + 1) % polygon.len()]);
    if (0..polygon.len()).map(area).sum::<f64>() < 0.0 {
        polygon.reverse();
    }
    polygon
}

/// Whether the edge after `index` can be led over `p` without touching any other.
fn may_grow(polygon: &[DVec2], index: usize, p: DVec2) -> bool {
    let count = polygon.len();
    let edge = |corner: usize| [corner, (corner + 1) % count].map(|corner| polygon[corner]);
    let [a, b] = edge(index);
    let is_free = |corner: usize| {
        corner == index
            || [[a, p], [p, b]]
                .into_iter()
                .all(|new| !segments_cross(new, edge(corner)))
    };
    orient2d(a, b, p) != Sign::Zero && !polygon.contains(&p) && (0..count).all(is_free)
}
