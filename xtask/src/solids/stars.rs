//! Star polyhedra: a triangulated sphere with each vertex at a random distance from the centre, on a coarse grid or not.
//!
//! ```text
//!      /\  /|
//!   __/  \/ |_      Rounding to a grid moves points onto lines, planes and each other, so those are checked, and the grid is
//!   \__  o  __|     refined until one is valid.
//!     /_/\_/
//! ```

use delaunay_core::Delaunay3;
use glam::{DVec3, dvec3};
use rand::RngExt;

use super::check::defect;
use super::skin::Skin;
use super::smooth::icosphere;
use super::{Random, Size, Solid, random};

/// Stars of 10 to 20,000 vertices.
#[must_use]
pub fn draw(size: Size, seed: u64) -> Solid {
    let mut random = random(seed);
    let base = if random.random_bool(0.4) {
        icosphere(random.random_range(size.pick([0..=3, 4..=4, 5..=5])))
    } else {
        hull(
            random.random_range(size.pick([6..=500, 1000..=5000, 8000..=20_000])),
            &mut random,
        )
    };
    // On a grid, large ones are hopeless.
    let is_snapped = size != Size::Large && random.random_bool(0.6);
    star(&base, random.random_range(0.05..0.95), is_snapped, seed)
}

/// The triangulated unit sphere with radii from `least` to 1; `is_snapped` puts the points on a grid of whole numbers.
#[must_use]
pub fn star(base: &Solid, least: f64, is_snapped: bool, seed: u64) -> Solid {
    let mut random = random(seed);
    let radii: Vec<f64> = base
        .points
        .iter()
        .map(|_| random.random_range(least..1.0))
        .collect();
    let mut radius = radii.iter();
    let star = base
        .clone()
        .moved(|p| p * radius.next().copied().unwrap_or(1.0));
    let count = base.points.len();
    if is_snapped {
        for bits in 2..16 {
            let grid = f64::from(1 << bits);
            let mut solid = star.clone().moved(|p| (p * grid).round() + 0.0);
            solid.name = format!("{count}-grid{bits}");
            if defect(&solid).is_none() {
                return solid;
            }
        }
    }
    Solid {
        name: format!("{count}-free"),
        ..star
    }
}

/// The convex hull of random points of the unit sphere, at least four, with the origin inside.
pub(super) fn hull(count: usize, random: &mut Random) -> Solid {
    // Corners of an octahedron, so that the origin is inside; they are exactly on the sphere.
    let corners = DVec3::AXES.into_iter().flat_map(|axis| [axis, -axis]);
    let points: Vec<DVec3> = corners
        .chain((6..count).map(|_| direction(random)))
        .collect();
    let mut skin = Skin::default();
    if let Ok(delaunay) = Delaunay3::build(&points) {
        for facet in delaunay.hull() {
            let corners = delaunay.mesh().facet_vertices(facet);
            skin.triangle(corners.map(|v| delaunay.point(v)));
        }
    }
    skin.into_solid("hull")
}

/// Uniform on the unit sphere but for rounding: a point of the cube that is in the ball, pushed out.
pub(super) fn direction(random: &mut Random) -> DVec3 {
    let mut in_cube = || {
        let mut draw = || random.random_range(-1.0..1.0);
        dvec3(draw(), draw(), draw())
    };
    // More than half of all draws are in the ball: of a hundred in a row none is, with a chance below 1e-30.
    (0..100)
        .map(|_| in_cube())
        .find(|p| (0.01..=1.0).contains(&p.length_squared()))
        .map_or(DVec3::X, DVec3::normalize)
}
