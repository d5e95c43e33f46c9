//! Quality of a tetrahedron: the smallest sine of its six dihedral angles.
//!
//! With `D` six times the volume and `N` the doubled area of a facet with its normal, the sine at an edge of length `l`
//! between facets `k` and `m` is `D l / (|N_k| |N_m|)`. It is small for angles near 0° and near 180° alike, and a smooth
//! function of the corners up to both.

use glam::DVec3;

/// Where products of sixteen lengths neither vanish nor overflow.
const SAFE: std::ops::Range<f64> = 1e-250..1e250;

/// The smallest sine of the dihedral angles of `[a, b, c, d]`: at most √8/3 ≈ 0.943, that of the regular tetrahedron, and
/// negative when the corners are left-handed; 0 for corners without a volume.
pub(crate) fn min_sine([a, b, c, d]: [DVec3; 4]) -> f64 {
    let [u, v, w] = [b - a, c - a, d - a];
    spanned_min_sine([u, v, w]).unwrap_or_else(|| scaled_min_sine([u, v, w]))
}

/// That of the tetrahedron spanned by three edges; `None` where doubles may run out.
#[inline]
fn spanned_min_sine([u, v, w]: [DVec3; 3]) -> Option<f64> {
    let normals = [(v - u).cross(w - u), v.cross(w), w.cross(u), u.cross(v)];
    let determinant = u.dot(normals[1]);
    let [na, nb, nc, nd] = normals.map(DVec3::length_squared);
    let [ab, ac, ad] = [u, v, w].map(DVec3::length_squared);
    let [bc, bd, cd] = [v - u, w - u, w - v].map(DVec3::length_squared);
    let [na_nb, nc_nd] = [na * nb, nc * nd];
    let all = na_nb * nc_nd;
    // Each squared sine without D², times the product of all four squared normals.
    let least = (ab * na_nb)
        .min(cd * nc_nd)
        .min((ac * (na * nc)).min(bd * (nb * nd)))
        .min((ad * (na * nd)).min(bc * (nb * nc)));
    SAFE.contains(&all)
        .then(|| determinant * (least / all).sqrt())
}

/// The same for edges of any size.
#[cold]
fn scaled_min_sine(edges: [DVec3; 3]) -> f64 {
    let longest = edges.iter().map(|e| e.abs().max_element());
    let unit = power_of_two(longest.fold(0.0, f64::max));
    spanned_min_sine(edges.map(|e| e / unit)).unwrap_or(0.0)
}

/// The greatest power of two that is not above a length: to divide by it costs no digits.
pub(crate) fn power_of_two(length: f64) -> f64 {
    const EXPONENT: u64 = 0x7FF0_0000_0000_0000;
    f64::from_bits(length.to_bits() & EXPONENT)
}

/// The sine of an angle up to 90 degrees: the same on all machines, which that of the standard library is not.
pub(crate) fn sine_of_degrees(angle: f64) -> f64 {
    let x = angle.to_radians();
    let (mut sum, mut term) = (0.0, x);
    for n in 1..16 {
        sum += term;
        let n = f64::from(2 * n);
        term *= -x * x / (n * (n + 1.0));
    }
    sum
}

/// The sine at one edge, and how it changes when corner `a` moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Sine {
    pub(crate) value: f64,
    pub(crate) gradient: DVec3,
}

/// The sines at the edges ab, ac, ad, bc, bd, cd of the right-handed `[a, b, c, d]`, whose size must be about 1.
pub(crate) fn sines([a, b, c, d]: [DVec3; 4]) -> [Sine; 6] {
    let [u, v, w] = [b - a, c - a, d - a];
    let [bc, bd, cd] = [v - u, w - u, w - v];
    let [na, nb, nc, nd] = [bc.cross(bd), v.cross(w), w.cross(u), u.cross(v)];
    let determinant = u.dot(nb);
    // Logarithmic derivatives: of D, of the areas of the three facets at `a`, of the edges at `a`.
    let volume = -na / determinant;
    let area = |normal: DVec3, edge: DVec3| normal.cross(edge) / normal.length_squared();
    let [area_b, area_c, area_d] = [area(nb, cd), area(nc, -bd), area(nd, bc)];
    let length = |edge: DVec3| -edge / edge.length_squared();
    let sine = |edge: DVec3, from: DVec3, to: DVec3, rate: DVec3| {
        let areas = (from.length_squared() * to.length_squared()).sqrt();
        let value = determinant * edge.length() / areas;
        Sine {
            value,
            gradient: value * rate,
        }
    };
    [
        sine(u, nc, nd, volume + length(u) - area_c - area_d),
        sine(v, nb, nd, volume + length(v) - area_b - area_d),
        sine(w, nb, nc, volume + length(w) - area_b - area_c),
        sine(bc, na, nd, volume - area_d),
        sine(bd, na, nc, volume - area_c),
        sine(cd, na, nb, volume - area_b),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use delaunay_core::measure::tetrahedron::dihedral_angles;
    use glam::dvec3;

    const SKEW: [DVec3; 4] = [
        dvec3(0.1, 0.2, -0.1),
        dvec3(1.0, 0.3, 0.2),
        dvec3(0.2, 0.9, 0.1),
        dvec3(0.4, 0.1, 0.7),
    ];

    #[test]
    fn sines_are_those_of_the_dihedral_angles() {
        let angles = dihedral_angles(SKEW);
        let expected = angles.map(|angle| angle.to_radians().sin());
        for (sine, expected) in sines(SKEW).into_iter().zip(expected) {
            assert!((sine.value - expected).abs() < 1e-14);
        }
        let least = expected.into_iter().fold(1.0, f64::min);
        assert!((min_sine(SKEW) - least).abs() < 1e-14);
        let [a, b, c, d] = SKEW;
        assert!((min_sine([b, a, c, d]) + least).abs() < 1e-14);
    }

    #[test]
    fn gradients_are_differences() {
        let step = 1e-6;
        let [a, b, c, d] = SKEW;
        for axis in DVec3::AXES {
            let [ahead, behind] = [1.0, -1.0].map(|s| sines([a + s * step * axis, b, c, d]));
            for (i, sine) in sines(SKEW).into_iter().enumerate() {
                let slope = (ahead[i].value - behind[i].value) / (2.0 * step);
                assert!((sine.gradient.dot(axis) - slope).abs() < 1e-8, "{i}");
            }
        }
    }

    #[test]
    fn the_sine_of_degrees_is_that_of_the_angle() {
        for angle in [0.0, 1e-9, 0.5, 20.0, 30.0, 70.0, 90.0_f64] {
            assert!((sine_of_degrees(angle) - angle.to_radians().sin()).abs() < 1e-15);
        }
    }

    #[test]
    fn size_has_no_influence_and_flat_corners_have_none() {
        let expected = min_sine(SKEW);
        for size in [2f64.powi(-140), 2f64.powi(200)] {
            assert_eq!(min_sine(SKEW.map(|p| p * size)), expected);
        }
        let [a, b, c, _] = SKEW;
        assert_eq!(min_sine([a, b, c, a]), 0.0);
        assert_eq!(min_sine([a; 4]), 0.0);
    }
}
