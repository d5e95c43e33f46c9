//! Mass, mass centroid and cost of a Voronoi cell (§3.1).
//!
//! A cell is cut into the triangles between its generator and its edges. For density 1 the integrals over them
//! are closed formulas; for another density they are sums over the seven points of Radon's rule, which is
//! exact for polynomials up to degree 5, hence for the cost whenever the density is a polynomial of degree 3:
//!
//! ```text
//!       q ------ p
//!        \  · ·/         z: the generator; all is relative to it, where it rounds least
//!         \ · /
//!          \·/           ∫ |x|²  =  area (|p|² + q·p + |q|²) / 6     over the triangle z p q
//!           z
//! ```

use delaunay_core::ConvexPolygon;
use glam::DVec2;

use crate::error::DensityError;

/// Integrals of a density over a cell, about the cell's generator.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Moments {
    /// ∫ ρ dx, the mass.
    pub mass: f64,
    /// ∫ ρ (x - z) dx.
    pub first: DVec2,
    /// ∫ ρ |x - z|² dx, what the cell contributes to the cost F.
    pub second: f64,
}

impl Moments {
    /// Moments of `cell` about `generator` for density 1, exact up to rounding. O(corners).
    #[must_use]
    pub fn uniform(cell: &ConvexPolygon, generator: DVec2) -> Self {
        fan(cell, generator)
            .map(uniform_triangle)
            .fold(Self::default(), Self::plus)
    }

    /// Moments of `cell` about `generator` for a given density, by quadrature. O(corners); the density is
    /// asked for seven times per corner, always inside the cell.
    ///
    /// # Errors
    /// [`DensityError`] at the first point where the density is not finite or not positive.
    pub fn weighted(
        cell: &ConvexPolygon,
        generator: DVec2,
        density: impl Fn(DVec2) -> f64,
    ) -> Result<Self, DensityError> {
        fan(cell, generator).try_fold(Self::default(), |sum, triangle| {
            weighted_triangle(triangle, generator, &density).map(|moments| sum.plus(moments))
        })
    }

    /// The mass centroid of the cell, given its generator; `None` without mass. Source: §3.1.
    #[must_use]
    pub fn mass_center(&self, generator: DVec2) -> Option<DVec2> {
        (self.mass > 0.0).then(|| generator + self.first / self.mass)
    }

    fn plus(self, other: Self) -> Self {
        Self {
            mass: self.mass + other.mass,
            first: self.first + other.first,
            second: self.second + other.second,
        }
    }
}

/// The triangles between the generator and the edges of its cell: their two other corners, counterclockwise,
/// relative to the generator.
fn fan(cell: &ConvexPolygon, generator: DVec2) -> impl Iterator<Item = [DVec2; 2]> + '_ {
    let corners = cell.corners();
    let next = corners.iter().cycle().skip(1);
    corners
        .iter()
        .zip(next)
        .map(move |(&p, &q)| [p - generator, q - generator])
}

fn uniform_triangle([p, q]: [DVec2; 2]) -> Moments {
    let area = p.perp_dot(q) / 2.0;
    Moments {
        mass: area,
        first: area * (p + q) / 3.0,
        second: area * (p.length_squared() + p.dot(q) + q.length_squared()) / 6.0,
    }
}

fn weighted_triangle(
    [p, q]: [DVec2; 2],
    generator: DVec2,
    density: impl Fn(DVec2) -> f64,
) -> Result<Moments, DensityError> {
    let area = p.perp_dot(q) / 2.0;
    let mut moments = Moments::default();
    for ([along_p, along_q], weight) in radon_rule() {
        let x = along_p * p + along_q * q;
        let at = generator + x;
        let value = density(at);
        if !(value > 0.0 && value < f64::INFINITY) {
            return Err(DensityError { at, value });
        }
        let mass = area * weight * value;
        moments.mass += mass;
        moments.first += mass * x;
        moments.second += mass * x.length_squared();
    }
    Ok(moments)
}

/// Two of the three barycentric coordinates of each point, and its weight. Source: Radon 1948.
fn radon_rule() -> [([f64; 2], f64); 7] {
    let root = 15f64.sqrt();
    let (near, far) = ((6.0 - root) / 21.0, (6.0 + root) / 21.0);
    let (light, heavy) = ((155.0 - root) / 1200.0, (155.0 + root) / 1200.0);
    [
        ([1.0 / 3.0, 1.0 / 3.0], 0.225),
        ([near, near], light),
        ([near, 1.0 - 2.0 * near], light),
        ([1.0 - 2.0 * near, near], light),
        ([far, far], heavy),
        ([far, 1.0 - 2.0 * far], heavy),
        ([1.0 - 2.0 * far, far], heavy),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rectangle(low: [f64; 2], high: [f64; 2]) -> ConvexPolygon {
        ConvexPolygon::rectangle(DVec2::from(low), DVec2::from(high)).unwrap()
    }

    #[test]
    fn a_rectangle_has_its_school_moments() {
        let moments = Moments::uniform(&rectangle([0.0, 0.0], [3.0, 2.0]), DVec2::new(1.5, 1.0));
        assert_eq!(moments.mass, 6.0);
        assert_eq!(moments.first, DVec2::ZERO);
        // b h (b² + h²) / 12
        assert!((moments.second - 6.5).abs() < 1e-14);
    }

    #[test]
    fn the_generator_does_not_move_the_mass_center() {
        let cell = rectangle([0.0, 0.0], [3.0, 2.0]);
        let generator = DVec2::new(2.75, 0.25);
        let moments = Moments::uniform(&cell, generator);
        assert!(
            moments
                .mass_center(generator)
                .unwrap()
                .distance(DVec2::new(1.5, 1.0))
                < 1e-15
        );
        // Steiner: the second moment grows by the mass times the squared distance.
        assert!((moments.second - (6.5 + 6.0 * (1.25 * 1.25 + 0.75 * 0.75))).abs() < 1e-13);
    }

    #[test]
    fn density_one_gives_the_uniform_moments() {
        let (cell, generator) = (rectangle([0.0, 0.0], [3.0, 2.0]), DVec2::new(2.0, 0.5));
        let (exact, summed) = (
            Moments::uniform(&cell, generator),
            Moments::weighted(&cell, generator, |_| 1.0).unwrap(),
        );
        assert!((exact.mass - summed.mass).abs() < 1e-14);
        assert!((exact.first - summed.first).length() < 1e-14);
        assert!((exact.second - summed.second).abs() < 1e-13);
    }

    #[test]
    fn the_cost_of_a_cubic_density_is_exact() {
        // ∫ (x³ + 1) (x² + y²) over the unit square = 1/6 + 1/3·1/4 + 1/3 + 1/3.
        let moments = Moments::weighted(&rectangle([0.0; 2], [1.0; 2]), DVec2::ZERO, |p| {
            p.x.powi(3) + 1.0
        });
        assert!((moments.unwrap().second - (1.0 / 6.0 + 1.0 / 12.0 + 2.0 / 3.0)).abs() < 1e-15);
    }

    #[test]
    fn a_density_that_is_no_positive_number_is_refused_with_its_place() {
        let cell = rectangle([0.0; 2], [1.0; 2]);
        for value in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            let error = Moments::weighted(&cell, DVec2::splat(0.5), |_| value).unwrap_err();
            assert!(error.value == value || (error.value.is_nan() && value.is_nan()));
        }
        let error = Moments::weighted(&cell, DVec2::ZERO, |p| 0.1 - p.x).unwrap_err();
        assert!(error.at.x >= 0.1 && error.at.x <= 1.0);
    }

    #[test]
    fn an_empty_cell_has_no_mass_center() {
        let moments = Moments::uniform(&ConvexPolygon::default(), DVec2::ONE);
        assert_eq!(moments.mass_center(DVec2::ONE), None);
    }
}
