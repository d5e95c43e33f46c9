//! The summit of a large polyhedron over a plane, found by climbing along edges.
//!
//! On a convex surface the way up ends at the highest corner. The climb starts from the best of about the cube
//! root of n corners, so it takes about as many steps; looking at all n corners for each of n planes
//! would take quadratic time. It goes by rounded heights, so its end need not be the summit; but from there a way up by
//! exact heights leads to it over corners that are lower by no more than rounding. All of those are
//! looked at, and judged exactly, before the plane counts as above the polyhedron.

use super::face_plane::FacePlane;
use super::polyhedron::{ConvexPolyhedron, End};
use geo_predicates::Sign;
use rustc_hash::FxHashSet;

/// Where the highest corner over a plane is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Summit {
    /// This corner is above the plane; it need not be the highest.
    Above(usize),
    /// No corner is above.
    NotAbove,
}

impl Summit {
    /// Exactly so.
    pub(super) fn climb(polyhedron: &ConvexPolyhedron, plane: &FacePlane) -> Self {
        let slope = Slope { polyhedron, plane };
        let Some(mut here) = slope.start() else {
            return Self::NotAbove;
        };
        loop {
            if slope.is_above(here) {
                return Self::Above(here);
            }
            match slope.up(here).or_else(|| slope.out_of_hollow(here)) {
                Some(next) => here = next,
                None => return Self::NotAbove,
            }
        }
    }
}

/// The surface of a polyhedron as seen from a plane.
struct Slope<'a> {
    polyhedron: &'a ConvexPolyhedron,
    plane: &'a FacePlane,
}

impl Slope<'_> {
    fn is_above(&self, slot: usize) -> bool {
        let corner = &self.polyhedron.corners[slot];
        self.polyhedron.side_of_corner(corner, self.plane) == Sign::Positive
    }

    fn height(&self, slot: usize) -> f64 {
        self.plane.height(self.polyhedron.corners[slot].place)
    }

    /// Bound on the error of a height.
    fn blur(&self, slot: usize) -> f64 {
        self.plane.blur_of_height(&self.polyhedron.corners[slot])
    }

    /// The highest of some corners.
    fn start(&self) -> Option<usize> {
        let count = self.polyhedron.corners.len();
        let stride = (count as f64 / (count as f64).cbrt()) as usize;
        self.highest((0..count).step_by(stride.max(1)))
    }

    /// The highest neighbour, if it is higher.
    fn up(&self, slot: usize) -> Option<usize> {
        let highest = self.highest(self.neighbors(slot).into_iter());
        highest.filter(|&next| self.height(next) > self.height(slot))
    }

    /// A corner that is higher, or above the plane, beyond others that are lower by no more than rounding.
    fn out_of_hollow(&self, slot: usize) -> Option<usize> {
        let floor = self.height(slot) - self.blur(slot);
        let mut seen = FxHashSet::from_iter([slot]);
        let mut pending = vec![slot];
        while let Some(near) = pending.pop() {
            for next in self.neighbors(near) {
                // False when a number is beyond the range of doubles.
                let is_lower = self.height(next) + self.blur(next) < floor;
                if !is_lower && seen.insert(next) {
                    if self.height(next) > self.height(slot) || self.is_above(next) {
                        return Some(next);
                    }
                    pending.push(next);
                }
            }
        }
        None
    }

    fn neighbors(&self, slot: usize) -> [usize; 3] {
        self.polyhedron.corners[slot].twins.map(End::corner)
    }

    fn highest(&self, slots: impl Iterator<Item = usize>) -> Option<usize> {
        slots.max_by(|&i, &j| self.height(i).total_cmp(&self.height(j)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tet::half_space::HalfSpace;
    use crate::tet::polyhedron::Side;
    use glam::{DVec3, dvec3};

    /// A prism over a polygon of `count` edges, each cut of which meets the others in the plane z = 0 of
    /// corners of three edges and more.
    fn prism(count: u32) -> ConvexPolyhedron {
        let mut prism = ConvexPolyhedron::cuboid(-DVec3::ONE, DVec3::ONE).unwrap();
        for i in 0..count {
            let angle = std::f64::consts::TAU * f64::from(i) / f64::from(count);
            let normal = dvec3(angle.cos(), angle.sin(), 0.0);
            prism.clip(&HalfSpace::new(normal, 0.5).unwrap(), Side::Window(6 + i));
        }
        prism
    }

    fn agrees(polyhedron: &ConvexPolyhedron, half_space: &HalfSpace) -> bool {
        let plane = FacePlane::of(half_space, polyhedron.origin);
        let side = |slot: usize| polyhedron.side_of_corner(&polyhedron.corners[slot], &plane);
        let some_above = (0..polyhedron.corners.len()).any(|slot| side(slot) == Sign::Positive);
        match Summit::climb(polyhedron, &plane) {
            Summit::Above(slot) => side(slot) == Sign::Positive,
            Summit::NotAbove => !some_above,
        }
    }

    #[test]
    fn the_climb_finds_what_looking_at_all_corners_finds() {
        let prism = prism(500);
        for i in 0..1000 {
            let angle = f64::from(i) * 0.37;
            let normal = dvec3(angle.cos(), angle.sin(), f64::from(i % 7 - 3));
            let limit = 0.5 + f64::from(i % 7 - 3).abs() + f64::from(i % 5 - 2) * 1e-6;
            assert!(
                agrees(&prism, &HalfSpace::new(normal, limit).unwrap()),
                "{i}"
            );
        }
    }

    /// A cone whose apex is shared by hundreds of corners, joined by edges without length.
    #[test]
    fn the_way_up_leads_over_corners_at_one_place() {
        let mut cone = ConvexPolyhedron::cuboid(-DVec3::ONE, DVec3::ONE).unwrap();
        let mut cuts = (-40_i32..=40).flat_map(|x| (-40_i32..=40).map(move |y| (x, y)));
        let on_circle = cuts.by_ref().filter(|(x, y)| x * x + y * y == 25 * 25);
        let on_circles = on_circle.map(|(x, y)| dvec3(f64::from(x), f64::from(y), 25.0));
        for (number, normal) in on_circles.enumerate() {
            cone.clip(
                &HalfSpace::new(normal, 0.0).unwrap(),
                Side::Window(6 + number as u32),
            );
        }
        let at_apex = cone
            .corners
            .iter()
            .filter(|corner| corner.place == DVec3::ZERO);
        assert!(at_apex.count() > 10);
        for i in 0..1000 {
            let (x, y) = (f64::from(i % 31 - 15), f64::from(i / 31 - 15));
            for limit in [-1e-3, 0.0, 1e-3, 1.0, 5.0] {
                let plane = HalfSpace::new(dvec3(x, y, 16.0), limit).unwrap();
                assert!(agrees(&cone, &plane), "{x} {y} {limit}");
                let plane = HalfSpace::new(dvec3(x, y, -16.0), limit + 16.0).unwrap();
                assert!(agrees(&cone, &plane), "{x} {y} {limit}");
            }
        }
    }
}
