//! Volume, center of mass and moment of inertia of a convex polyhedron.
//!
//! From one corner the polyhedron falls into tetrahedra, one for each triangle of each face; so all terms
//! have one sign and nothing cancels, wherever the polyhedron is.

use super::polyhedron::ConvexPolyhedron;
use glam::DVec3;

/// Integrals over a polyhedron of constant density 1.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Moments {
    /// Cube of the unit of length; not negative beyond rounding.
    pub volume: f64,
    /// The integral of `x - origin`.
    pub first: DVec3,
    /// The integral of `|x - origin|^2`: the share of the cell in the energy of a centroidal
    /// tessellation.
    pub second: f64,
}

impl ConvexPolyhedron {
    /// The point from which [`moments`](Self::moments) and [`tetrahedra`](Self::tetrahedra) count: the vertex of
    /// a Voronoi cell, zero for a window.
    #[must_use]
    pub fn origin(&self) -> DVec3 {
        self.origin
    }

    /// The volume, not negative beyond rounding; 0 when empty.
    #[must_use]
    pub fn volume(&self) -> f64 {
        let mut sum = 0.0;
        self.for_each_tetrahedron(|[p, q, r]| sum += p.dot(q.cross(r)));
        sum / 6.0
    }

    /// The center of mass; `None` when the volume is 0.
    #[must_use]
    pub fn centroid(&self) -> Option<DVec3> {
        let Moments { volume, first, .. } = self.moments();
        (volume > 0.0).then(|| self.origin + first / volume)
    }

    /// Volume, first and second moment, relative to [`origin`](Self::origin). Linear in the number of
    /// corners.
    #[must_use]
    pub fn moments(&self) -> Moments {
        let (mut six, mut first, mut second) = (0.0, DVec3::ZERO, 0.0);
        self.for_each_tetrahedron(|[p, q, r]| {
            let weight = p.dot(q.cross(r));
            let sum = p + q + r;
            let squares = p.length_squared() + q.length_squared() + r.length_squared();
            six += weight;
            first += weight * sum;
            second += weight * (squares + sum.length_squared());
        });
        // A tetrahedron of volume V with the corners 0, p, q, r has the first moment V (p + q + r) / 4
        // and the second V (p² + q² + r² + (p + q + r)²) / 20.
        let (volume, first, second) = (six / 6.0, first / 24.0, second / 120.0);
        let apex = self.apex();
        Moments {
            volume,
            first: first + volume * apex,
            second: second + 2.0 * apex.dot(first) + volume * apex.length_squared(),
        }
    }

    /// Right-handed tetrahedra that fill the polyhedron, in coordinates relative to
    /// [`origin`](Self::origin): for integrals of other functions. Some may be flat.
    pub fn tetrahedra(&self) -> impl Iterator<Item = [DVec3; 4]> + '_ {
        let apex = self.apex();
        self.faces().flat_map(move |face| {
            let places = face.places();
            let first = places.clone().next().unwrap_or(apex);
            let edges = places.clone().skip(1).zip(places.skip(2));
            edges.map(move |(p, q)| [apex, first, p, q])
        })
    }

    /// The corner from which all is measured, relative to the origin.
    fn apex(&self) -> DVec3 {
        self.corners
            .first()
            .map_or(DVec3::ZERO, |corner| corner.place)
    }

    /// The corners of each of [`tetrahedra`](Self::tetrahedra) but the apex, relative to the apex.
    #[inline]
    fn for_each_tetrahedron(&self, mut visit: impl FnMut([DVec3; 3])) {
        let apex = self.apex();
        for face in self.faces() {
            let mut places = face.places().map(|place| place - apex);
            let (Some(first), Some(mut last)) = (places.next(), places.next()) else {
                continue;
            };
            for place in places {
                visit([first, last, place]);
                last = place;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_box_has_its_school_values() {
        let cuboid = ConvexPolyhedron::cuboid(DVec3::ZERO, DVec3::new(2.0, 3.0, 4.0)).unwrap();
        let moments = cuboid.moments();
        assert_eq!((cuboid.volume(), moments.volume), (24.0, 24.0));
        assert_eq!(cuboid.centroid(), Some(DVec3::new(1.0, 1.5, 2.0)));
        assert_eq!(moments.first, DVec3::new(24.0, 36.0, 48.0));
        // V (a² + b² + c²) / 3 about a corner.
        assert!((moments.second - 8.0 * 29.0).abs() < 1e-12);
    }

    #[test]
    fn a_box_far_from_the_origin_keeps_its_volume() {
        let low = DVec3::new(1e9, -3e9, 2e9);
        let cuboid = ConvexPolyhedron::cuboid(low, low + 2.0).unwrap();
        assert_eq!(cuboid.volume(), 8.0);
        assert_eq!(cuboid.centroid(), Some(low + 1.0));
    }

    #[test]
    fn the_tetrahedra_fill_the_box() {
        let cuboid = ConvexPolyhedron::cuboid(-DVec3::ONE, DVec3::ONE).unwrap();
        let six = |[a, b, c, d]: [DVec3; 4]| (b - a).cross(c - a).dot(d - a);
        let volumes: Vec<f64> = cuboid.tetrahedra().map(six).collect();
        assert!(volumes.iter().all(|&volume| volume >= 0.0));
        assert_eq!(volumes.iter().sum::<f64>(), 48.0);
    }

    #[test]
    fn nothing_has_no_centroid() {
        let nothing = ConvexPolyhedron::default();
        assert_eq!((nothing.volume(), nothing.centroid()), (0.0, None));
        assert_eq!(nothing.moments(), Moments::default());
    }
}
