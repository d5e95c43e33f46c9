//! Tetrahedra: corners `[a, b, c, d]` in either orientation; only [`signed_volume`] tells them apart.

use glam::DVec3;

use super::angle::degrees;
use super::double_double::DoubleDVec3;
use super::scale::{length, scale, scaled};

/// The six edges, as pairs of corners, each followed by the two corners of the opposite edge.
///
/// This is the order of [`dihedral_angles`].
pub const EDGES: [[usize; 4]; 6] = [
    [0, 1, 2, 3],
    [0, 2, 1, 3],
    [0, 3, 1, 2],
    [1, 2, 0, 3],
    [1, 3, 0, 2],
    [2, 3, 0, 1],
];

/// Volume, positive when `abcd` is right-handed; cube of the unit of length.
///
/// Rounded: use `orient3d` for the sign.
#[must_use]
pub fn signed_volume(corners: [DVec3; 4]) -> f64 {
    let spanned = spanned(corners);
    let unit = spanned.unit;
    spanned.determinant() / 6.0 * unit * unit * unit
}

/// The point at equal distance from the corners; [`DVec3::INFINITY`] when the volume is zero.
///
/// Relative to the circumradius the error is of the order of 1e-15, for slivers too: where doubles would
/// cancel, twice the digits are used. Only the center of a tetrahedron whose volume is below about 1e-30 of
/// the cube of its longest edge may be anywhere along its axis, even at infinity.
#[must_use]
pub fn circumcenter(corners: [DVec3; 4]) -> DVec3 {
    let spanned = spanned(corners);
    let center = match spanned.circumcenter() {
        Some(offset) => corners[0] + spanned.unit * offset,
        None => corners[0] + spanned.unit * accurate_circumcenter(corners, spanned.unit),
    };
    if center.is_finite() {
        center
    } else {
        DVec3::INFINITY
    }
}

/// The circumcenter relative to the first corner, in units of `unit`, with twice the digits.
#[cold]
fn accurate_circumcenter([a, b, c, d]: [DVec3; 4], unit: f64) -> DVec3 {
    let [u, v, w] = [b, c, d].map(|corner| DoubleDVec3::difference(corner, a, unit));
    let (vw, wu, uv) = (v.cross(w), w.cross(u), u.cross(v));
    let offset = u.dot(u) * vw + v.dot(v) * wu + w.dot(w) * uv;
    offset.rounded() / (2.0 * u.dot(vw).rounded())
}

/// Radius of the sphere through the corners, unit of length; infinite when the volume is zero.
#[must_use]
pub fn circumradius(corners: [DVec3; 4]) -> f64 {
    let spanned = spanned(corners);
    let radius = spanned.circumradius();
    if radius.is_infinite() {
        radius
    } else {
        spanned.unit * radius
    }
}

/// Radius of the inscribed sphere, unit of length; 0 when the volume is zero.
#[must_use]
pub fn inradius(corners: [DVec3; 4]) -> f64 {
    let spanned = spanned(corners);
    spanned.unit * spanned.inradius()
}

/// Length of the shortest edge.
#[must_use]
pub fn shortest_edge(corners: [DVec3; 4]) -> f64 {
    let spanned = spanned(corners);
    spanned.unit * spanned.shortest_edge()
}

/// Length of the longest edge.
#[must_use]
pub fn longest_edge(corners: [DVec3; 4]) -> f64 {
    let spanned = spanned(corners);
    spanned.unit * spanned.longest_edge()
}

/// Circumradius over shortest edge, r/l: dimensionless, at least √6/4 (regular), infinite when the volume is
/// zero.
///
/// Slivers may have a good value, and rounding may spoil it: four corners that are nearly on one circle have
/// hardly a volume to divide by. Source: sink paper §4.3.
#[must_use]
pub fn radius_edge_ratio(corners: [DVec3; 4]) -> f64 {
    let spanned = spanned(corners);
    let radius = spanned.circumradius();
    if radius.is_infinite() {
        radius
    } else {
        (radius / spanned.shortest_edge()).max(6f64.sqrt() / 4.0)
    }
}

/// Q = 2√6 times the inradius over the longest edge: dimensionless, in [0, 1], 1 for the regular tetrahedron,
/// 0 when the volume is zero.
///
/// Source: CVT paper §2.2.
#[must_use]
pub fn inradius_quality(corners: [DVec3; 4]) -> f64 {
    let spanned = spanned(corners);
    match spanned.inradius() {
        0.0 => 0.0,
        inradius => (24f64.sqrt() * inradius / spanned.longest_edge()).min(1.0),
    }
}

/// Three times the inradius over the circumradius: dimensionless, in [0, 1], 1 for the regular tetrahedron, 0
/// when the volume is zero.
#[must_use]
pub fn radius_ratio(corners: [DVec3; 4]) -> f64 {
    let spanned = spanned(corners);
    (3.0 * spanned.inradius() / spanned.circumradius()).min(1.0)
}

/// Angles between the two facets at each edge of [`EDGES`], in degrees, in [0, 180].
///
/// A flat tetrahedron has angles 0 and 180; the angle at a facet without area is 0.
#[must_use]
pub fn dihedral_angles(corners: [DVec3; 4]) -> [f64; 6] {
    let Spanned {
        edges: [u, v, w], ..
    } = spanned(corners);
    EDGES.map(|indices| dihedral_angle(indices.map(|corner| [DVec3::ZERO, u, v, w][corner])))
}

/// The angle at edge `pq` between the facets that lead to `r` and to `s`.
fn dihedral_angle([p, q, r, s]: [DVec3; 4]) -> f64 {
    let [edge, r, s] = [q - p, r - p, s - p].map(|arm| scaled(arm).1);
    let (toward_r, toward_s) = (edge.cross(r), edge.cross(s));
    // |m × n| = |edge| |det|: no second cross product, which would cancel in thin elements.
    degrees(
        edge.length() * toward_r.dot(s).abs(),
        toward_r.dot(toward_s),
    )
}

/// The three edges that leave the first corner, in units of a power of two near the longest edge.
#[derive(Clone, Copy, Default)]
struct Spanned {
    unit: f64,
    edges: [DVec3; 3],
}

/// All zero for a point.
fn spanned([a, b, c, d]: [DVec3; 4]) -> Spanned {
    let edges = [b - a, c - a, d - a];
    let Some(unit) = scale(edges.map(|edge| edge.abs().max_element())) else {
        return Spanned::default();
    };
    Spanned {
        unit,
        edges: edges.map(|edge| edge / unit),
    }
}

impl Spanned {
    /// In units of `unit`, as all below.
    fn circumradius(&self) -> f64 {
        let determinant = self.determinant().abs();
        if determinant == 0.0 {
            return f64::INFINITY;
        }
        // Whatever rounds: no sphere through both ends of an edge of length one is smaller.
        (length(self.toward_center()) / (2.0 * determinant)).max(0.5)
    }

    /// The circumcenter relative to the first corner; `None` when the determinant has lost digits.
    fn circumcenter(&self) -> Option<DVec3> {
        const SLIVER: f64 = 0.125;
        let determinant = self.determinant();
        let is_thick = determinant.abs() > SLIVER;
        is_thick.then(|| self.toward_center() / (2.0 * determinant))
    }

    /// The vector from the first corner to the circumcenter, times twice the determinant.
    fn toward_center(&self) -> DVec3 {
        let [u, v, w] = self.edges;
        let [vw, wu, uv] = [v.cross(w), w.cross(u), u.cross(v)];
        u.length_squared() * vw + v.length_squared() * wu + w.length_squared() * uv
    }

    /// r = 3 V / S, with 6 V the determinant and 2 S the sum of the lengths of the four normals.
    fn inradius(&self) -> f64 {
        let [u, v, w] = self.edges;
        let normals = [v.cross(w), w.cross(u), u.cross(v), (v - u).cross(w - u)];
        match self.determinant().abs() {
            0.0 => 0.0,
            determinant => determinant / normals.map(length).into_iter().sum::<f64>(),
        }
    }

    /// Six times the signed volume; exactly 0 when two corners coincide.
    fn determinant(&self) -> f64 {
        let [u, v, w] = self.edges;
        if u == v || v == w || w == u {
            0.0
        } else {
            u.dot(v.cross(w))
        }
    }

    fn shortest_edge(&self) -> f64 {
        self.lengths().into_iter().fold(f64::INFINITY, f64::min)
    }

    fn longest_edge(&self) -> f64 {
        self.lengths().into_iter().fold(0.0, f64::max)
    }

    fn lengths(&self) -> [f64; 6] {
        let [u, v, w] = self.edges;
        [u, v, w, v - u, w - u, w - v].map(length)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const REGULAR: [[f64; 3]; 4] = [
        [1.0, 1.0, 1.0],
        [1.0, -1.0, -1.0],
        [-1.0, 1.0, -1.0],
        [-1.0, -1.0, 1.0],
    ];
    const UNIT_CORNER: [[f64; 3]; 4] =
        [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

    fn corners(points: [[f64; 3]; 4]) -> [DVec3; 4] {
        points.map(DVec3::from)
    }

    #[test]
    fn the_regular_tetrahedron_is_best() {
        let t = corners(REGULAR);
        assert!((radius_ratio(t) - 1.0).abs() < 1e-15);
        assert!((inradius_quality(t) - 1.0).abs() < 1e-15);
        assert!((radius_edge_ratio(t) - 6f64.sqrt() / 4.0).abs() < 1e-15);
        let dihedral = (1.0f64 / 3.0).acos().to_degrees();
        assert!(
            dihedral_angles(t)
                .iter()
                .all(|angle| (angle - dihedral).abs() < 1e-13)
        );
    }

    #[test]
    fn the_corner_of_a_cube_has_its_school_values() {
        let t = corners(UNIT_CORNER);
        assert_eq!(signed_volume(t), 1.0 / 6.0);
        assert_eq!(signed_volume([t[1], t[0], t[2], t[3]]), -1.0 / 6.0);
        assert_eq!((shortest_edge(t), longest_edge(t)), (1.0, 2f64.sqrt()));
        assert!((circumradius(t) - 0.75f64.sqrt()).abs() < 1e-15);
        assert!((inradius(t) - 1.0 / (3.0 + 3f64.sqrt())).abs() < 1e-15);
        let [ab, ac, ad, bc, bd, cd] = dihedral_angles(t);
        let slanted = (1.0 / 3f64.sqrt()).acos().to_degrees();
        assert_eq!([ab, ac, ad], [90.0; 3]);
        assert!(
            [bc, bd, cd]
                .iter()
                .all(|angle| (angle - slanted).abs() < 1e-13)
        );
    }

    #[test]
    fn the_circumcenter_of_slivers_keeps_its_digits() {
        // Integer points on a sphere of radius 27 round a center far away, at their exact places.
        let side = -27_i32..=27;
        let cube = side.clone().flat_map(|x| side.clone().map(move |y| (x, y)));
        let cube = cube.flat_map(|(x, y)| side.clone().map(move |z| [x, y, z]));
        let shell = cube.filter(|p| p.iter().map(|x| x * x).sum::<i32>() == 27 * 27);
        let center = DVec3::new(1e6, -2e6, 3e6);
        let shell: Vec<DVec3> = shell
            .map(|p| center + DVec3::from(p.map(f64::from)))
            .collect();
        let mut slivers = 0;
        for i in 0..shell.len() {
            for step in 1..40 {
                let t = [0, 1, step, 7 * step].map(|j| shell[(i + j) % shell.len()]);
                let volume = signed_volume(t).abs();
                if volume > 0.0 {
                    assert_eq!(circumcenter(t), center, "{t:?}");
                    slivers += usize::from(volume < 20.0);
                }
            }
        }
        assert!(slivers > 50, "{slivers}");
        let nearly_flat = [
            [0.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            [0.0, 1.0, 0.0],
            [1.0, 1.0, 1e-17],
        ];
        // z = t / 2: the sphere meets the plane in the circle round the square, and the fourth corner.
        assert_eq!(
            circumcenter(corners(nearly_flat)),
            DVec3::new(0.5, 0.5, 0.5e-17)
        );
    }

    #[test]
    fn the_circumcenter_without_volume_is_at_infinity() {
        let flat = [[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
        for t in [
            corners(flat),
            [DVec3::ONE; 4],
            [DVec3::MAX, DVec3::MIN, DVec3::X, DVec3::Y],
        ] {
            assert_eq!(circumcenter(t), DVec3::INFINITY);
        }
    }

    #[test]
    fn a_flat_square_has_the_worst_values() {
        let t = corners([[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]]);
        assert_eq!(signed_volume(t), 0.0);
        assert_eq!(
            [inradius(t), radius_ratio(t), inradius_quality(t)],
            [0.0; 3]
        );
        assert_eq!([circumradius(t), radius_edge_ratio(t)], [f64::INFINITY; 2]);
        // The diagonals ac and bd see the square opened flat, the sides see it folded.
        assert_eq!(dihedral_angles(t), [0.0, 180.0, 0.0, 0.0, 180.0, 0.0]);
    }

    #[test]
    fn the_ratio_of_a_sliver_is_not_better_than_that_of_the_regular_one() {
        // A rectangle but for one corner; the vector toward its center rounds to nothing.
        let t = corners([
            [0.0; 3],
            [-1.0; 3],
            [0.0, 2f64.powi(-142), -1.0],
            [-1.0, -1.0, 0.0],
        ]);
        assert!(radius_edge_ratio(t) >= 6f64.sqrt() / 4.0);
    }

    #[test]
    fn a_point_has_the_worst_values() {
        let t = [DVec3::splat(0.1); 4];
        assert_eq!(
            [inradius(t), radius_ratio(t), inradius_quality(t)],
            [0.0; 3]
        );
        assert_eq!([circumradius(t), radius_edge_ratio(t)], [f64::INFINITY; 2]);
        assert_eq!((signed_volume(t), longest_edge(t)), (0.0, 0.0));
        assert_eq!(dihedral_angles(t), [0.0; 6]);
    }

    #[test]
    fn two_equal_corners_have_the_worst_values() {
        let [a, b, c] = [[0.1, 0.7, 0.3], [0.2, 0.9, 0.6], [0.4, 0.15, 0.35]].map(DVec3::from);
        for t in [[a, a, b, c], [b, a, a, c], [a, b, c, a], [b, a, c, a]] {
            assert_eq!([circumradius(t), radius_edge_ratio(t)], [f64::INFINITY; 2]);
            assert_eq!(
                (signed_volume(t), radius_ratio(t), inradius_quality(t)),
                (0.0, 0.0, 0.0)
            );
        }
    }

    #[test]
    fn a_spire_as_slender_as_coordinates_allow_keeps_its_values() {
        let tiny = 2f64.powi(-142);
        let t = corners([
            [0.0; 3],
            [tiny, 0.0, 0.0],
            [0.0, tiny, 0.0],
            [0.0, 0.0, 2f64.powi(201)],
        ]);
        assert_eq!(circumradius(t), 2f64.powi(200));
        assert_eq!(radius_edge_ratio(t), 2f64.powi(342));
        assert_eq!(dihedral_angles(t)[..3], [90.0; 3]);
    }

    #[test]
    fn size_has_no_influence_up_to_the_ends_of_the_accepted_range() {
        let unit = corners(UNIT_CORNER);
        for size in [2f64.powi(-142), 2f64.powi(201)] {
            let scaled = unit.map(|p| p * size);
            assert_eq!(circumcenter(scaled), size * circumcenter(unit));
            assert_eq!(circumradius(scaled), size * circumradius(unit));
            assert_eq!(radius_edge_ratio(scaled), radius_edge_ratio(unit));
            assert_eq!(radius_ratio(scaled), radius_ratio(unit));
            assert_eq!(inradius_quality(scaled), inradius_quality(unit));
            assert_eq!(dihedral_angles(scaled), dihedral_angles(unit));
        }
    }
}
