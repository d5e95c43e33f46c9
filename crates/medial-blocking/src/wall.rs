//! Circles, and walls made of them: which side of a circle is domain, and how a wall is named and
//! moved.

use std::fmt;

use glam::{DVec2, IVec2};

/// A circle of the plane: centre and radius in the user's unit of length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Circle {
    /// The centre.
    pub center: DVec2,
    /// The radius, positive in every accepted domain.
    pub radius: f64,
}

impl Circle {
    /// The circle with this centre and radius, unchecked.
    #[must_use]
    pub const fn new(center: DVec2, radius: f64) -> Self {
        Self { center, radius }
    }
}

/// A wall of a [`crate::Domain`]: hole `i` is wall `i`, the bounding circle comes after the holes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct WallId(pub(crate) u32);

impl WallId {
    /// Position in [`crate::Domain::walls`].
    #[must_use]
    pub const fn index(self) -> usize {
        self.0 as usize
    }
}

impl fmt::Display for WallId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "w{}", self.0)
    }
}

/// On which side of its circle a wall has the domain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WallKind {
    /// A particle: the domain lies outside the circle.
    Hole,
    /// The bounding circle: the domain lies inside.
    Bounding,
}

/// A circle of the domain's boundary together with the side on which the domain lies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wall {
    /// The circle.
    pub circle: Circle,
    /// The side of the domain.
    pub kind: WallKind,
}

impl Wall {
    /// Distance from `p` to the wall, positive inside the domain, negative behind the wall.
    #[must_use]
    pub fn distance(&self, p: DVec2) -> f64 {
        let beyond = p.distance(self.circle.center) - self.circle.radius;
        match self.kind {
            WallKind::Hole => beyond,
            WallKind::Bounding => -beyond,
        }
    }

    /// The point of the wall in the unit direction `direction` from the circle's centre.
    #[must_use]
    pub fn point_towards(&self, direction: DVec2) -> DVec2 {
        self.circle.center + self.circle.radius * direction
    }

    /// The point of the wall at `angle` radians from the x-axis.
    #[must_use]
    pub fn point_at(&self, angle: f64) -> DVec2 {
        self.point_towards(DVec2::from_angle(angle))
    }

    /// +1 if the wall is traversed counterclockwise with the domain on its left, as the bounding
    /// circle is; −1 for holes.
    #[must_use]
    pub const fn turn(&self) -> f64 {
        match self.kind {
            WallKind::Hole => -1.0,
            WallKind::Bounding => 1.0,
        }
    }

    /// The wall moved by `by`.
    #[must_use]
    pub fn translated(&self, by: DVec2) -> Self {
        Self {
            circle: Circle::new(self.circle.center + by, self.circle.radius),
            kind: self.kind,
        }
    }
}

/// A whole number of periods in x and y; always zero in a bounded domain.
pub type Shift = IVec2;

/// A wall together with the periods by which it is moved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WallImage {
    /// The wall.
    pub wall: WallId,
    /// The periods by which it is moved.
    pub shift: Shift,
}

/// How errors and patches call a wall: `hole 3` or `bounding circle`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WallName {
    /// The hole with this index in the user's list, from 0.
    Hole(usize),
    /// The bounding circle.
    Bounding,
}

impl fmt::Display for WallName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Hole(index) => write!(f, "hole {index}"),
            Self::Bounding => write!(f, "bounding circle"),
        }
    }
}

/// Whether `x` is finite and at most 2^201.
pub(crate) fn usable_coordinate(x: f64) -> bool {
    x.abs() <= 2f64.powi(201)
}

/// Whether `x` is positive and of a size that squares survive: 2^-142 to 2^201.
pub(crate) fn usable_length(x: f64) -> bool {
    (2f64.powi(-142)..=2f64.powi(201)).contains(&x)
}
