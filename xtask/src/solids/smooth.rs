//! Smooth surfaces of many triangles, for timing: spheres, bumpy spheres, ellipsoids, tori.
//!
//! ```text
//!     .-"""-.        A sphere is an icosahedron whose triangles are divided in four, level by level: 20 · 4^level triangles.
//!    /       \       Moving its points along rays from the centre leaves it valid.
//!    \       /
//!     '-...-'
//! ```

use glam::{DVec3, dvec3};
use rand::RngExt;

use super::skin::Skin;
use super::tori::torus;
use super::{Size, Solid, random};

/// Spheres of levels 2 to 6, tori of up to 400 by 250 quads.
#[must_use]
pub fn draw(size: Size, seed: u64) -> Solid {
    let mut random = random(seed);
    let level = size.pick([random.random_range(2..=3), 4, 6]);
    match random.random_range(0..4) {
        0 => icosphere(level),
        1 => {
            let stretch = [0; 3].map(|_| random.random_range(0.2..3.0));
            let solid = icosphere(level).moved(|p| p * DVec3::from(stretch));
            Solid {
                name: format!("ellipsoid-{level}"),
                ..solid
            }
        }
        2 => bumpy(level, seed),
        _ => {
            let [around, across] = size.pick([[40, 20], [120, 60], [400, 250]]);
            torus(around, across, random.random_range(0.1..0.7), seed)
        }
    }
}

/// The unit sphere with 20 · 4^`level` triangles.
#[must_use]
pub fn icosphere(level: u32) -> Solid {
    let golden = (1.0 + 5.0_f64.sqrt()) / 2.0;
    let corner = |axis: usize, x: f64, y: f64| {
        let mut corner = [0.0; 3];
        corner[(axis + 1) % 3] = x;
        corner[(axis + 2) % 3] = y * golden;
        DVec3::from(corner).normalize()
    };
    let mut triangles: Vec<[DVec3; 3]> = Vec::new();
    // Eight triangles across the octants, and one on each side of twelve edges in coordinate planes.
    for x in [-1.0, 1.0] {
        for y in [-1.0, 1.0] {
            for axis in 0..3 {
                let edge = [corner(axis, x, y), corner(axis, -x, y)];
                let apex = corner((axis + 1) % 3, y, x);
                triangles.push([edge[0], edge[1], apex]);
            }
            for z in [-1.0, 1.0] {
                triangles.push([corner(0, y, z), corner(1, z, x), corner(2, x, y)]);
            }
        }
    }
    for _ in 0..level {
        triangles = triangles.into_iter().flat_map(divided).collect();
    }
    let mut skin = Skin::default();
    for [a, b, c] in triangles {
        let is_outwards = (b - a).cross(c - a).dot(a) > 0.0;
        skin.triangle(if is_outwards { [a, b, c] } else { [a, c, b] });
    }
    skin.into_solid(format!("sphere-{level}"))
}

/// In four, with the middles of the edges on the unit sphere.
fn divided([a, b, c]: [DVec3; 3]) -> [[DVec3; 3]; 4] {
    let middle = |p: DVec3, q: DVec3| (p + q).normalize();
    let [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
    [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
}

/// A sphere whose radius is a random polynomial of the direction, between 0.4 and 1.6.
#[must_use]
pub fn bumpy(level: u32, seed: u64) -> Solid {
    let mut random = random(seed);
    let bumps: Vec<(DVec3, i32)> = (0..8)
        .map(|_| {
            let mut draw = || random.random_range(-1.0..1.0);
            let axis = dvec3(draw(), draw(), draw()) / 3.0_f64.sqrt();
            (axis, random.random_range(2..=9))
        })
        .collect();
    let radius = |p: DVec3| {
        // A product, for the bits of `powi` may differ between machines.
        let bump = |(axis, power): &(DVec3, i32)| {
            (0..*power).fold(0.075, |product, _| product * p.dot(*axis))
        };
        1.0 + bumps.iter().map(bump).sum::<f64>()
    };
    let solid = icosphere(level).moved(|p| p * radius(p));
    Solid {
        name: format!("bumpy-{level}"),
        ..solid
    }
}

#[cfg(test)]
mod tests {
    use super::super::check::defect;
    use super::*;

    #[test]
    fn spheres_are_valid_and_have_as_many_triangles_as_they_say() {
        for level in 0..4 {
            let sphere = icosphere(level);
            assert_eq!(defect(&sphere), None);
            assert_eq!(sphere.triangles.len(), 20 << (2 * level));
            assert_eq!(sphere.points.len(), 2 + sphere.triangles.len() / 2);
        }
    }
}
