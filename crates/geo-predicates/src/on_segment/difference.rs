//! Vectors between points in doubles, with a size that tells how wrong they can be.
//!
//! With `u = 2^-53`, a component is computed from the difference of the rounded places and what that loses, and from the
//! difference of the rests: at most `3 u` times the magnitudes of these three, and what the rests do not tell. The size of
//! a component is so much that its error is at most `3 u` times the size; a determinant of such vectors is wrong by no more than
//! its roundings and three of these for each factor, times the permanent of the sizes.
//!
//! - orientation: 3 factors with `3 u` each and 5 roundings of products and sums, `14 u`; taken as `20 u`;
//! - in-sphere: 5 factors and 13 roundings, `28 u`; taken as `40 u`.

use glam::DVec3;

use super::doubled::sum;
use super::point::ExactPoint3;
use crate::sign::Sign;

const UNIT: f64 = f64::EPSILON / 2.0;
const ORIENT: f64 = 20.0 * UNIT;
const IN_SPHERE: f64 = 40.0 * UNIT;

/// The vector from one point to another.
#[derive(Clone, Copy)]
pub(super) struct Difference {
    vector: DVec3,
    size: DVec3,
}

impl Difference {
    #[inline]
    pub(super) fn new(to: &ExactPoint3<'_>, from: &ExactPoint3<'_>) -> Self {
        let (near_to, near_from) = (to.rounded(), from.rounded());
        let ((rest_to, lost_to), (rest_from, lost_from)) = (to.rest(), from.rest());
        let (mut vector, mut size) = (DVec3::ZERO, DVec3::ZERO);
        let lost = (lost_to + lost_from) / UNIT;
        for axis in 0..3 {
            let (near, lost_near) = sum(near_to[axis], -near_from[axis]);
            let rest = rest_to[axis] - rest_from[axis];
            let small = lost_near + rest;
            vector[axis] = near + small;
            size[axis] = vector[axis].abs() + lost_near.abs() + rest.abs() + lost[axis];
        }
        Self { vector, size }
    }

    /// The squared length, and its size.
    fn lift(&self) -> (f64, f64) {
        (self.vector.length_squared(), self.size.length_squared())
    }
}

/// A determinant and its permanent.
#[derive(Clone, Copy)]
struct Sized {
    value: f64,
    size: f64,
}

fn minor(a: &Difference, b: &Difference, i: usize, j: usize) -> Sized {
    Sized {
        value: a.vector[i] * b.vector[j] - a.vector[j] * b.vector[i],
        size: a.size[i] * b.size[j] + a.size[j] * b.size[i],
    }
}

fn volume(a: &Difference, b: &Difference, c: &Difference) -> Sized {
    let minors = [minor(b, c, 1, 2), minor(b, c, 2, 0), minor(b, c, 0, 1)];
    let mut volume = Sized {
        value: 0.0,
        size: 0.0,
    };
    for (axis, minor) in minors.into_iter().enumerate() {
        volume.value += a.vector[axis] * minor.value;
        volume.size += a.size[axis] * minor.size;
    }
    volume
}

fn certain(determinant: Sized, factor: f64) -> Option<Sign> {
    let Sized { value, size } = determinant;
    let bound = factor * size;
    if value > bound {
        Some(Sign::Positive)
    } else if value < -bound {
        Some(Sign::Negative)
    } else {
        // Without size there is nothing to be wrong.
        (size == 0.0).then_some(Sign::Zero)
    }
}

/// `orient3d` of three points and the origin.
pub(super) fn orient3d(corners: [&Difference; 3]) -> Option<Sign> {
    let [a, b, c] = corners;
    let Sized { value, size } = volume(a, b, c);
    certain(
        Sized {
            value: -value,
            size,
        },
        ORIENT,
    )
}

/// `in_sphere` of four points and the origin.
pub(super) fn in_sphere(corners: [&Difference; 4]) -> Option<Sign> {
    let [a, b, c, d] = corners;
    let volumes = [
        (a, volume(b, c, d)),
        (b, volume(c, d, a)),
        (c, volume(d, a, b)),
        (d, volume(a, b, c)),
    ];
    let mut sphere = Sized {
        value: 0.0,
        size: 0.0,
    };
    for (index, (corner, volume)) in volumes.into_iter().enumerate() {
        let (lift, lift_size) = corner.lift();
        let term = lift * volume.value;
        sphere.value += if index % 2 == 0 { term } else { -term };
        sphere.size += lift_size * volume.size;
    }
    certain(sphere, IN_SPHERE)
}
