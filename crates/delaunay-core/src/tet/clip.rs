//! Clipping of a convex polyhedron by a half-space.
//!
//! Corners above the plane go, all others stay, and the surface is closed along the [rim](super::rim) between the two
//! kinds. Sides of corners are exact, so the surface is that of the exact polyhedron, with three edges per corner;
//! where more edges meet, several corners share a place.
//!
//! A new corner is the common point of its three planes, so errors do not add up, however large the polyhedron was at
//! the start.

use super::face_plane::FacePlane;
use super::half_space::HalfSpace;
use super::polyhedron::{ConvexPolyhedron, Corner, End, Face, Side};
use super::rim::{Clipper, Verdict};

impl ConvexPolyhedron {
    /// Keeps what lies in `half_space`, and calls the new face `side`. Tells whether anything was cut off.
    ///
    /// Corners in the plane stay as long as one is below it; else nothing is left. Takes time linear in the
    /// number of corners, or in what is removed when there are many. Corners that are as near to the plane as rounding may
    /// put them cost some microseconds each, for exact arithmetic.
    pub fn clip(&mut self, half_space: &HalfSpace, side: Side) -> bool {
        self.clip_in(half_space, side, &mut Clipper::default())
    }

    /// As [`clip`](Self::clip), in the room of `clipper`: nothing is allocated after a few times.
    pub fn clip_in(&mut self, half_space: &HalfSpace, side: Side, clipper: &mut Clipper) -> bool {
        let plane = FacePlane::of(half_space, self.origin);
        self.cut(&plane, side, clipper)
    }

    /// Clips by a plane seen from the origin of the polyhedron.
    pub(super) fn cut(&mut self, plane: &FacePlane, side: Side, clipper: &mut Clipper) -> bool {
        match clipper.judge(self, plane) {
            Verdict::KeepAll => return false,
            Verdict::RemoveAll => self.clear(),
            Verdict::Divide => {
                clipper.trace_rim(self);
                self.close(plane, side, clipper);
            }
        }
        true
    }

    /// Replaces the removed corners by those of the new face.
    fn close(&mut self, plane: &FacePlane, side: Side, clipper: &mut Clipper) {
        let number = self.faces.len() as u32;
        let corner = Face::LOST;
        self.faces.push(Face {
            plane: *plane,
            side,
            corner,
        });
        clipper.fresh.clear();
        for &end in &clipper.rim {
            clipper.fresh.push(self.corner_on(end, number));
        }
        for &slot in &clipper.removed {
            for face in self.corners[slot as usize].faces {
                self.faces[face as usize].corner = Face::LOST;
            }
        }
        while let Some(&corner) = clipper.fresh.get(clipper.removed.len()) {
            clipper.removed.push(self.corners.len() as u32);
            self.corners.push(corner);
        }
        self.settle(&clipper.fresh, &clipper.removed);
        for &slot in clipper.removed.iter().skip(clipper.fresh.len()).rev() {
            self.vacate(slot as usize);
        }
    }

    /// The corner on the edge of `end`, between the new face `number` and the two faces of the edge.
    fn corner_on(&self, end: End, number: u32) -> Corner {
        let removed = &self.corners[end.corner()];
        let twin = self.twin(end);
        let kept = &self.corners[twin.corner()];
        let faces = [
            number,
            removed.faces[end.next().edge()],
            removed.faces[end.prev().edge()],
        ];
        let planes = faces.map(|face| &self.faces[face as usize].plane);
        let reach = kept.place.abs().max(removed.place.abs()).max_element();
        let (place, blur) = FacePlane::meet(planes, self.origin, reach);
        Corner {
            place,
            blur,
            faces,
            twins: [twin; 3],
        }
    }

    /// Stores the corners round the new face in the first of `slots`, joined in a ring.
    fn settle(&mut self, fresh: &[Corner], slots: &[u32]) {
        let count = fresh.len();
        let slot = |i: usize| slots[i % count] as usize;
        for (i, &corner) in fresh.iter().enumerate() {
            let twins = [
                corner.twins[0],
                End::new(slot(i + 1), 2),
                End::new(slot(i + count - 1), 1),
            ];
            self.put(slot(i), Corner { twins, ..corner });
        }
    }

    /// Stores a corner and tells its neighbours and faces.
    fn put(&mut self, slot: usize, corner: Corner) {
        self.corners[slot] = corner;
        for edge in 0..3 {
            let twin = corner.twins[edge];
            self.corners[twin.corner()].twins[twin.edge()] = End::new(slot, edge);
            self.faces[corner.faces[edge] as usize].corner = slot as u32;
        }
    }

    /// Drops the corner in `slot`, to which no edge leads any more; the last one takes the slot.
    fn vacate(&mut self, slot: usize) {
        if let Some(last) = self.corners.pop()
            && slot < self.corners.len()
        {
            self.put(slot, last);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tet::polyhedron::PolyhedronError;
    use glam::DVec3;

    fn cube() -> ConvexPolyhedron {
        ConvexPolyhedron::cuboid(-DVec3::ONE, DVec3::ONE).unwrap()
    }

    fn clipped(cuts: &[([f64; 3], f64)]) -> ConvexPolyhedron {
        let mut polyhedron = cube();
        for (number, &(normal, limit)) in cuts.iter().enumerate() {
            let half_space = HalfSpace::new(normal.into(), limit).unwrap();
            polyhedron.clip(&half_space, Side::Window(6 + number as u32));
            assert_sound(&polyhedron);
        }
        polyhedron
    }

    /// Twins are mutual and share their two faces, borders close, and the surface is a sphere.
    fn assert_sound(polyhedron: &ConvexPolyhedron) {
        let mut edges = 0;
        for slot in 0..polyhedron.corners.len() {
            for edge in 0..3 {
                let end = End::new(slot, edge);
                let twin = polyhedron.twin(end);
                assert_eq!(polyhedron.twin(twin), end);
                let sides = |end: End| {
                    let faces = polyhedron.corners[end.corner()].faces;
                    [faces[end.next().edge()], faces[end.prev().edge()]]
                };
                let [left, right] = sides(twin);
                assert_eq!(sides(end), [right, left]);
                edges += 1;
            }
        }
        let faces: Vec<_> = polyhedron.faces().collect();
        let around: usize = faces.iter().map(|face| face.places().count()).sum();
        assert_eq!(around, edges);
        if !polyhedron.is_empty() {
            assert_eq!(polyhedron.corners.len() + faces.len(), edges / 2 + 2);
        }
    }

    #[test]
    fn a_box_is_sound() {
        assert_sound(&cube());
        let refused = ConvexPolyhedron::cuboid(DVec3::ZERO, DVec3::new(1.0, 0.0, 1.0));
        assert!(matches!(refused, Err(PolyhedronError::NotBelow { .. })));
        insta::assert_snapshot!(refused.unwrap_err(), @"the low corner is not below the high one along y: 0e0 and 0e0");
    }

    #[test]
    fn a_cut_keeps_the_near_side() {
        assert_eq!(clipped(&[([1.0, 0.0, 0.0], 0.0)]).volume(), 4.0);
        assert_eq!(clipped(&[([1.0, 1.0, 0.0], 0.0)]).volume(), 4.0);
        assert_eq!(clipped(&[([1.0, 1.0, 1.0], 0.0)]).volume(), 4.0);
        let without_corner = clipped(&[([1.0, 1.0, 1.0], 2.0)]);
        assert!((without_corner.volume() - (8.0 - 1.0 / 6.0)).abs() < 1e-14);
        assert_eq!(without_corner.faces().count(), 7);
    }

    #[test]
    fn a_plane_that_touches_takes_nothing() {
        for cut in [
            ([1.0, 0.0, 0.0], 1.0),
            ([1.0, 1.0, 0.0], 2.0),
            ([1.0, 1.0, 1.0], 3.0),
        ] {
            assert_eq!(clipped(&[cut]), cube());
        }
    }

    #[test]
    fn cuts_that_leave_nothing_leave_no_corners() {
        assert!(clipped(&[([1.0, 1.0, 1.0], -4.0)]).is_empty());
        assert!(clipped(&[([1.0, 0.0, 0.0], -0.5), ([-1.0, 0.0, 0.0], 0.25)]).is_empty());
        assert!(clipped(&[([1.0, 0.0, 0.0], -4.0), ([1.0, 0.0, 0.0], 0.0)]).is_empty());
    }

    #[test]
    fn a_touch_from_outside_leaves_nothing() {
        for cut in [
            ([1.0, 0.0, 0.0], -1.0),
            ([1.0, 1.0, 0.0], -2.0),
            ([1.0, 1.0, 1.0], -3.0),
        ] {
            assert!(clipped(&[cut]).is_empty());
        }
    }

    #[test]
    fn a_face_that_is_cut_off_is_gone() {
        let half = clipped(&[([1.0, 0.0, 0.0], 0.5)]);
        let sides: Vec<Side> = half.faces().map(|face| face.side()).collect();
        assert_eq!(sides, [0, 2, 3, 4, 5, 6].map(Side::Window));
    }

    /// Limits that are the smallest numbers there are lose their digits in every product.
    #[test]
    fn limits_without_digits_leave_a_sound_surface() {
        let limit = |smallest: u64| f64::from_bits(smallest);
        clipped(&[
            ([3.0, -8.0, -5.0], limit(25)),
            ([-6.0, 3.0, -1.0], limit(4)),
            ([2.0, -8.0, -1.0], limit(20)),
            ([1.0, -5.0, 4.0], limit(4)),
            ([-3.0, 7.0, -6.0], limit(12)),
        ]);
    }

    /// Planes through one point that all but coincide: sides of corners by rounded numbers would contradict each
    /// other.
    #[test]
    fn planes_that_all_but_coincide_leave_a_sound_surface() {
        let tilt = |i: i32| f64::from(i * 7 % 11 - 5) * f64::EPSILON;
        let cut = |i| {
            (
                [1.0 + tilt(i), 1.0 + tilt(i + 1), 1.0 + tilt(i + 2)],
                1.0 + tilt(i + 3),
            )
        };
        let cuts: Vec<_> = (0..40).map(cut).collect();
        let volume = clipped(&cuts).volume();
        assert!((volume - clipped(&cuts[..1]).volume()).abs() < 1e-14);
    }
}
