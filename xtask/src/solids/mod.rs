//! Closed surfaces that are hard to fill with tetrahedra, made from nothing but a seed.
//!
//! Every surface is closed (an even number of triangles on each edge), has no two points at one place and no triangle without
//! area, and no two of its triangles have more in common than corners and edges that they share. What a family does not ensure by
//! its construction it asks [`defect`](check::defect), which is exact.
//!
//! | family | file | what is hard |
//! |---|---|---|
//! | `csg` | `csg.rs` | unions and differences of boxes: coplanar faces, large polygons with holes, bodies that touch |
//! | `rotated` | `rotated.rs` | the same turned and scaled: faces that are coplanar but for rounding |
//! | `gears` | `gears.rs` | gears and ratchets with bores: many vertical faces, caps with holes |
//! | `screws` | `screws.rs` | twisted extrusions: folded quads, thin helical teeth |
//! | `lattices` | `lattices.rs` | struts on a grid: little volume between much surface |
//! | `thin` | `thin.rs` | plates, wedges, rods, fans: needles down to 1e-5 degrees, 1000 triangles at a vertex |
//! | `shells` | `shells.rs` | surfaces in each other with gaps down to 1e-12, cavities in bodies in cavities |
//! | `schoenhardt` | `schoenhardt.rs` | twisted prisms, which need a vertex inside |
//! | `chazelle` | `chazelle.rs` | notches along a saddle, which need very many vertices inside |
//! | `stars` | `stars.rs` | spikes of random length, corners on coarse grids |
//! | `outlines` | `outlines.rs` | letters, spirals, combs, random polygons as prisms, embossed and engraved |
//! | `tori` | `tori.rs` | tori, knotted tubes, chains of rings |
//! | `drilled` | `drilled.rs` | high genus: plates with many holes, sponges |
//! | `smooth` | `smooth.rs` | many triangles, for timing |
//! | `touching` | `touching.rs` | bodies that share a vertex or an edge and nothing else |
//!
//! What the families share: [`skin`] gathers triangles, [`flat`] and [`ears`] triangulate polygons badly, [`cells`] finds the
//! surface of a set of cubes, [`extrude`] makes prisms, [`places`] numbers
//! places, [`turn`] is the circle, the same on every machine.

use glam::DVec3;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

pub mod cells;
pub mod chazelle;
pub mod check;
pub mod csg;
pub mod drilled;
pub mod ears;
pub mod extrude;
pub mod flat;
pub mod gears;
pub mod lattices;
pub mod letters;
pub mod outlines;
pub mod places;
pub mod rotated;
pub mod schoenhardt;
pub mod screws;
pub mod shells;
pub mod skin;
pub mod smooth;
pub mod stars;
pub mod thin;
pub mod tori;
pub mod touching;
pub mod turn;
mod write;

pub use write::{SolidsArgs, solids};

/// A closed surface of triangles.
#[derive(Clone, Debug, PartialEq)]
pub struct Solid {
    /// What it is, fit for the name of a file: small letters, digits, `-` and `_`.
    pub name: String,
    /// The vertices; every one is a corner.
    pub points: Vec<DVec3>,
    /// Corners of each triangle as indices of points, counterclockwise seen from outside the body.
    pub triangles: Vec<[u32; 3]>,
}

/// How many triangles a solid is to have, roughly.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Size {
    /// 4 to 2,000, in rare cases 4,000.
    Small,
    /// Up to 20,000.
    Medium,
    /// 3,000 to 300,000, as many as suit the family.
    Large,
}

impl Size {
    /// The size of the solid with this number in its family: of 40 solids 36 are small, three medium, one large.
    #[must_use]
    pub fn of(number: usize) -> Self {
        match number % 40 {
            39 => Self::Large,
            9 | 19 | 29 => Self::Medium,
            _ => Self::Small,
        }
    }

    /// The one of three values that is meant for this size.
    fn pick<T>(self, [small, medium, large]: [T; 3]) -> T {
        match self {
            Self::Small => small,
            Self::Medium => medium,
            Self::Large => large,
        }
    }
}

/// Solids of one kind.
#[derive(Clone, Copy, Debug)]
pub struct Family {
    /// The name, one word.
    pub name: &'static str,
    /// A solid with parameters drawn from the seed: the same for the same size and seed.
    pub draw: fn(Size, u64) -> Solid,
}

/// Every family.
pub const FAMILIES: [Family; 15] = [
    family("csg", csg::draw),
    family("rotated", rotated::draw),
    family("gears", gears::draw),
    family("screws", screws::draw),
    family("lattices", lattices::draw),
    family("thin", thin::draw),
    family("shells", shells::draw),
    family("schoenhardt", schoenhardt::draw),
    family("chazelle", chazelle::draw),
    family("stars", stars::draw),
    family("outlines", outlines::draw),
    family("tori", tori::draw),
    family("drilled", drilled::draw),
    family("smooth", smooth::draw),
    family("touching", touching::draw),
];

const fn family(name: &'static str, draw: fn(Size, u64) -> Solid) -> Family {
    Family { name, draw }
}

impl Family {
    /// The solid with this number: the same for the same number and seed, however many others are made. Its name begins with that
    /// of the family and the number.
    #[must_use]
    pub fn solid(&self, number: usize, seed: u64) -> Solid {
        // Names differ in their first letters, so families draw different numbers; the multiplier spreads seeds and numbers apart.
        let word = self.name.bytes().fold(0, |word: u64, letter| {
            word.wrapping_mul(257).wrapping_add(letter.into())
        });
        let mixed = (seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ word)
            .wrapping_mul(0xd134_2543_de82_ef95)
            .wrapping_add(number as u64);
        let mut solid = (self.draw)(Size::of(number), mixed);
        solid.name = format!("{}-{number:05}-{}", self.name, solid.name);
        solid
    }
}

/// Where all that is random comes from.
type Random = ChaCha8Rng;

/// The random numbers of this seed.
fn random(seed: u64) -> Random {
    ChaCha8Rng::seed_from_u64(seed)
}

/// A power of ten, the same on every machine, which `powi` does not promise.
fn ten_to(exponent: i32) -> f64 {
    let power = (0..exponent.unsigned_abs()).fold(1.0, |product, _| product * 10.0);
    if exponent < 0 { 1.0 / power } else { power }
}
