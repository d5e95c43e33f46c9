//! What to mesh: circular holes in a bounding circle, or in a periodic rectangle (Guoy & Erickson,
//! Problem 1 and §5).
//!
//! A [`Domain`] cannot be wrong: its constructors look at every circle and every pair of circles
//! and either accept or answer a [`DomainError`] that lists all defects, not only the first. Code
//! behind this door never asks again.

use glam::DVec2;

use crate::error::{Defect, DomainError};
use crate::wall::{Circle, Shift, Wall, WallId, WallImage, WallKind, WallName, usable_length};

/// Farther than this many periods from the rectangle a centre has lost too many digits to be moved
/// into it.
const MAX_PERIODS: f64 = (1u32 << 20) as f64;

/// Circular holes in a bounding circle or in a periodic rectangle, checked.
///
/// The holes keep the order in which they were given.
#[derive(Clone, Debug, PartialEq)]
pub struct Domain {
    walls: Vec<Wall>,
    holes: usize,
    period: Option<DVec2>,
}

impl Domain {
    /// The domain inside `bounding` and outside every circle of `holes`.
    ///
    /// # Errors
    /// Every defect found: no hole, a coordinate or radius that is not a usable number, equal
    /// circles, pairs of circles that overlap or touch with their gap, holes that are not inside
    /// the bounding circle. O(n log n) for n holes that do not overlap.
    pub fn in_circle(bounding: Circle, holes: &[Circle]) -> Result<Self, DomainError> {
        let mut walls: Vec<Wall> = holes
            .iter()
            .map(|&circle| Wall {
                circle,
                kind: WallKind::Hole,
            })
            .collect();
        walls.push(Wall {
            circle: bounding,
            kind: WallKind::Bounding,
        });
        Self {
            walls,
            holes: holes.len(),
            period: None,
        }
        .validated()
    }

    /// The plane tiled by a rectangle of side lengths `period`, outside every circle of `holes` and
    /// its images.
    ///
    /// Centres are moved by whole periods into `[0, period)`. The period is rounded by at most
    /// 2^-48 of itself so that moving a node by whole periods is exact; [`Domain::period`] tells
    /// the rounded value.
    ///
    /// # Errors
    /// As for [`Domain::in_circle`]; a hole may also overlap its own image.
    pub fn periodic(period: DVec2, holes: &[Circle]) -> Result<Self, DomainError> {
        let defects: Vec<Defect> = (0..2)
            .filter(|&axis| !usable_length(period[axis]))
            .map(|axis| Defect::Period {
                axis: ['x', 'y'][axis],
                value: period[axis],
            })
            .collect();
        if !defects.is_empty() {
            return Err(DomainError::new(defects));
        }
        let period = DVec2::new(
            Lattice::of(period.x).snap(period.x),
            Lattice::of(period.y).snap(period.y),
        );
        let far = far_defects(holes, period);
        if !far.is_empty() {
            return Err(DomainError::new(far));
        }
        let walls = holes
            .iter()
            .map(|&circle| Wall {
                circle: wrapped(circle, period),
                kind: WallKind::Hole,
            })
            .collect();
        Self {
            walls,
            holes: holes.len(),
            period: Some(period),
        }
        .validated()
    }

    /// All walls: the holes in the order given, then the bounding circle if there is one.
    #[must_use]
    pub fn walls(&self) -> &[Wall] {
        &self.walls
    }

    /// The walls with their ids.
    pub fn wall_ids(&self) -> impl Iterator<Item = WallId> + use<> {
        (0..self.walls.len() as u32).map(WallId)
    }

    /// The wall with this id.
    #[must_use]
    pub fn wall(&self, id: WallId) -> &Wall {
        &self.walls[id.index()]
    }

    /// The wall moved by the image's periods.
    #[must_use]
    pub fn wall_image(&self, image: WallImage) -> Wall {
        self.wall(image.wall)
            .translated(self.translation(image.shift))
    }

    /// Number of holes, at least 1.
    #[must_use]
    pub const fn hole_count(&self) -> usize {
        self.holes
    }

    /// The id of the bounding circle; `None` in a periodic domain.
    #[must_use]
    pub fn bounding(&self) -> Option<WallId> {
        (self.walls.len() > self.holes).then_some(WallId(self.holes as u32))
    }

    /// The side lengths of the periodic rectangle; `None` in a bounded domain.
    #[must_use]
    pub const fn period(&self) -> Option<DVec2> {
        self.period
    }

    /// The vector by which `shift` moves: exact, see [`Domain::periodic`].
    #[must_use]
    pub fn translation(&self, shift: Shift) -> DVec2 {
        self.period
            .map_or(DVec2::ZERO, |period| shift.as_dvec2() * period)
    }

    /// `p` rounded so that moving it by a few periods is exact; `p` itself in a bounded domain.
    ///
    /// Rounds by at most 2^-49 of the period.
    #[must_use]
    pub fn snap(&self, p: DVec2) -> DVec2 {
        self.period.map_or(p, |period| {
            DVec2::new(
                Lattice::of(period.x).snap(p.x),
                Lattice::of(period.y).snap(p.y),
            )
        })
    }

    /// The same domain at a size of about 1, and the power of two by which to multiply to come back.
    ///
    /// At that size the coordinates of samples are in the range of the exact predicates, whatever the
    /// size of the domain; powers of two change no digit.
    pub(crate) fn at_unit_size(&self) -> (Self, f64) {
        let size = power_of_two_below(self.largest_number());
        let unit = |circle: Circle| Circle::new(circle.center / size, circle.radius / size);
        let walls = self.walls.iter().map(|wall| Wall {
            circle: unit(wall.circle),
            ..*wall
        });
        let domain = Self {
            walls: walls.collect(),
            holes: self.holes,
            period: self.period.map(|period| period / size),
        };
        (domain, size)
    }

    /// The largest absolute coordinate of a point of a wall, or the longer period.
    pub(crate) fn largest_number(&self) -> f64 {
        self.walls
            .iter()
            .map(|wall| wall.circle.center.abs().max_element() + wall.circle.radius)
            .chain(self.period.map(DVec2::max_element))
            .fold(0.0, f64::max)
    }

    /// The shifts under which an image of a hole can be the one nearest to a point in or next to
    /// the rectangle.
    pub(crate) fn near_shifts(&self) -> impl Iterator<Item = Shift> + use<> {
        let reach = i32::from(self.period.is_some());
        (-reach..=reach).flat_map(move |x| (-reach..=reach).map(move |y| Shift::new(x, y)))
    }

    fn validated(self) -> Result<Self, DomainError> {
        let mut defects = self.circle_defects();
        if defects.is_empty() {
            defects = self.pair_defects();
        }
        if defects.is_empty() {
            Ok(self)
        } else {
            Err(DomainError::new(defects))
        }
    }

    /// What errors and patches call a wall.
    #[must_use]
    pub fn name(&self, id: WallId) -> WallName {
        if Some(id) == self.bounding() {
            WallName::Bounding
        } else {
            WallName::Hole(id.index())
        }
    }
}

/// The multiples of a power of two near 2^-48 of a period: sums of a few of them are exact.
struct Lattice {
    per_unit: f64,
}

impl Lattice {
    fn of(period: f64) -> Self {
        Self {
            per_unit: (1u64 << 48) as f64 / power_of_two_below(period),
        }
    }

    fn snap(&self, x: f64) -> f64 {
        (x * self.per_unit).round() / self.per_unit
    }
}

/// The largest power of two that is not larger than `x`, a positive normal number.
fn power_of_two_below(x: f64) -> f64 {
    f64::from_bits(x.to_bits() & (0x7ff << 52))
}

/// Centres that are too many periods away to be moved into the rectangle.
fn far_defects(holes: &[Circle], period: DVec2) -> Vec<Defect> {
    let far = |(index, axis): (usize, usize)| {
        let value = holes[index].center[axis];
        (value.abs() > MAX_PERIODS * period[axis]).then_some(Defect::Center {
            wall: WallName::Hole(index),
            axis: ['x', 'y'][axis],
            value,
        })
    };
    (0..holes.len())
        .flat_map(|index| [(index, 0), (index, 1)])
        .filter_map(far)
        .collect()
}

fn wrapped(circle: Circle, period: DVec2) -> Circle {
    Circle::new(
        circle.center - (circle.center / period).floor() * period,
        circle.radius,
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn circle(x: f64, y: f64, radius: f64) -> Circle {
        Circle::new(DVec2::new(x, y), radius)
    }

    #[test]
    fn disjoint_holes_inside_are_accepted() {
        let domain = Domain::in_circle(
            circle(0.0, 0.0, 2.0),
            &[circle(-1.0, 0.0, 0.5), circle(1.0, 0.0, 0.5)],
        )
        .unwrap();
        assert_eq!(domain.hole_count(), 2);
        assert_eq!(domain.bounding(), Some(WallId(2)));
    }

    #[test]
    fn moving_a_snapped_point_by_periods_and_back_is_exact() {
        let domain = Domain::periodic(
            DVec2::new(0.1 + 0.2, std::f64::consts::TAU),
            &[circle(0.1, 0.1, 0.05)],
        )
        .unwrap();
        let p = domain.snap(DVec2::new(0.123_456_789, 4.2));
        for shift in domain.near_shifts() {
            let by = domain.translation(shift);
            assert_eq!((p + by) - by, p);
        }
    }

    #[test]
    fn a_domain_at_unit_size_has_the_same_digits() {
        let domain = Domain::in_circle(circle(12.5, -3.0, 40.0), &[circle(7.0, 0.1, 3.3)]).unwrap();
        let (unit, size) = domain.at_unit_size();
        assert_eq!(size, 32.0);
        assert!((1.0..2.0).contains(&unit.largest_number()));
        for (wall, original) in unit.walls().iter().zip(domain.walls()) {
            assert_eq!(wall.circle.center * size, original.circle.center);
            assert_eq!(wall.circle.radius * size, original.circle.radius);
        }
    }

    #[test]
    fn every_overlapping_pair_is_listed_with_its_gap() {
        let holes = [
            circle(0.0, 0.0, 1.0),
            circle(1.5, 0.0, 1.0),
            circle(3.0, 0.0, 1.0),
            circle(3.0, 0.0, 1.0),
        ];
        let error = Domain::in_circle(circle(0.0, 0.0, 5.0), &holes).unwrap_err();
        let gaps = error
            .defects()
            .iter()
            .filter(|defect| matches!(defect, Defect::Gap { .. }))
            .count();
        let duplicates = error
            .defects()
            .iter()
            .filter(|defect| matches!(defect, Defect::Duplicate { .. }))
            .count();
        assert_eq!((gaps, duplicates), (3, 1));
    }

    #[test]
    fn a_hole_may_not_overlap_its_own_image() {
        let error = Domain::periodic(DVec2::new(1.0, 4.0), &[circle(0.5, 0.5, 0.6)]).unwrap_err();
        assert!(matches!(error.defects()[0], Defect::Gap { gap, .. } if (gap + 0.2).abs() < 1e-12));
    }

    #[test]
    fn unusable_numbers_are_named() {
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e200, -1e200] {
            let holes = [circle(bad, 0.0, 0.1), circle(0.0, 0.0, bad)];
            let error = Domain::in_circle(circle(0.0, 0.0, 1.0), &holes).unwrap_err();
            assert_eq!(error.defects().len(), 2);
            assert!(Domain::periodic(DVec2::new(bad, 1.0), &holes).is_err());
        }
    }
}
