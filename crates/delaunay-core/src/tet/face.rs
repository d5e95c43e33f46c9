//! The faces of a convex polyhedron.
//!
//! The direction of a face is that of its plane, not computed from its corners, which may all but coincide.

use super::polyhedron::{ConvexPolyhedron, Face, Side};
use glam::DVec3;

/// A face of a polyhedron, see [`ConvexPolyhedron::faces`].
#[derive(Clone, Copy, Debug)]
pub struct PolyhedronFace<'a> {
    pub(super) polyhedron: &'a ConvexPolyhedron,
    pub(super) number: u32,
    pub(super) face: &'a Face,
}

impl ConvexPolyhedron {
    /// The faces; rounding may leave some of no area among them.
    pub fn faces(&self) -> impl Iterator<Item = PolyhedronFace<'_>> + Clone + '_ {
        let left = self
            .faces
            .iter()
            .enumerate()
            .filter(|(_, face)| face.corner != Face::LOST);
        left.map(|(number, face)| PolyhedronFace {
            polyhedron: self,
            number: number as u32,
            face,
        })
    }
}

impl<'a> PolyhedronFace<'a> {
    /// What the face comes from.
    #[must_use]
    pub fn side(&self) -> Side {
        self.face.side
    }

    /// The normal of unit length that points outwards.
    #[must_use]
    pub fn normal(&self) -> DVec3 {
        self.face.plane.normal.normalize()
    }

    /// The corners, counterclockwise seen from outside, each place once: less than three when rounding
    /// has left no more.
    pub fn corners(&self) -> impl Iterator<Item = DVec3> + Clone + use<'a> {
        let origin = self.polyhedron.origin;
        let places = self.places().map(move |place| origin + place);
        let next = places.clone().skip(1).chain(places.clone().take(1));
        let pairs = places.zip(next).filter(|(place, next)| place != next);
        pairs.map(|(place, _)| place)
    }

    /// The area, not negative beyond rounding.
    #[must_use]
    pub fn area(&self) -> f64 {
        let normal = self.normal();
        self.fan()
            .map(|[_, p, q]| p.cross(q).dot(normal))
            .sum::<f64>()
            / 2.0
    }

    /// The center of mass; `None` when the area is 0.
    #[must_use]
    pub fn centroid(&self) -> Option<DVec3> {
        let normal = self.normal();
        let mut first = DVec3::ZERO;
        let (mut doubled, mut moment) = (0.0, DVec3::ZERO);
        for [corner, p, q] in self.fan() {
            let weight = p.cross(q).dot(normal);
            first = corner;
            doubled += weight;
            moment += weight * (p + q);
        }
        (doubled > 0.0).then(|| self.polyhedron.origin + first + moment / (3.0 * doubled))
    }

    /// The corners relative to the origin of the polyhedron.
    pub(super) fn places(&self) -> impl Iterator<Item = DVec3> + Clone + use<'a> {
        let polyhedron = self.polyhedron;
        let border = polyhedron.border(self.number);
        border.map(|end| polyhedron.corners[end.corner()].place)
    }

    /// The first corner, with each edge that it does not touch relative to it.
    fn fan(&self) -> impl Iterator<Item = [DVec3; 3]> + use<'a> {
        let places = self.places();
        let first = places.clone().next().unwrap_or_default();
        let edges = places.clone().skip(1).zip(places.skip(2));
        edges.map(move |(p, q)| [first, p - first, q - first])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::dvec3;

    #[test]
    fn the_faces_of_a_box_look_outwards_and_turn_counterclockwise() {
        let high = dvec3(1.0, 2.0, 3.0);
        let cuboid = ConvexPolyhedron::cuboid(DVec3::ZERO, high).unwrap();
        assert_eq!(cuboid.faces().count(), 6);
        for (number, face) in cuboid.faces().enumerate() {
            assert_eq!(face.side(), Side::Window(number as u32));
            assert_eq!(face.corners().count(), 4);
            let center = face.centroid().unwrap();
            assert_eq!(face.normal(), (center - high / 2.0).normalize());
            assert_eq!(face.area(), 6.0 / high[number / 2]);
        }
    }
}
