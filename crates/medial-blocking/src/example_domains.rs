//! Small domains and single walls for the unit tests.

use glam::DVec2;

use crate::domain::Domain;
use crate::wall::{Circle, Wall, WallKind};

/// Three holes of unequal size in a circle: 4 medial vertices, 6 arcs, 12 blocks.
pub(crate) fn three_holes() -> Domain {
    let holes = [
        Circle::new(DVec2::new(-0.5, 0.0), 0.25),
        Circle::new(DVec2::new(0.5, 0.125), 0.3),
        Circle::new(DVec2::new(0.0, 0.75), 0.125),
    ];
    Domain::in_circle(Circle::new(DVec2::new(0.0, 0.25), 1.5), &holes)
        .expect("the holes are disjoint")
}

/// One hole off the middle of a circle: a closed medial axis.
pub(crate) fn one_hole() -> Domain {
    let hole = Circle::new(DVec2::new(0.25, 0.0), 0.5);
    Domain::in_circle(Circle::new(DVec2::ZERO, 1.0), &[hole]).expect("the hole is inside")
}

/// Two holes in a periodic rectangle, one of them across its border: 4 medial vertices, 6 arcs, 12
/// blocks.
pub(crate) fn two_periodic_holes() -> Domain {
    let holes = [
        Circle::new(DVec2::new(0.3, 0.3), 0.2),
        Circle::new(DVec2::new(0.95, 0.6), 0.15),
    ];
    Domain::periodic(DVec2::new(1.0, 0.75), &holes).expect("the holes are disjoint")
}

/// Four equal holes round a common empty circle: one arc has no length.
pub(crate) fn four_co_circular_holes() -> Domain {
    let holes = [DVec2::X, DVec2::Y, -DVec2::X, -DVec2::Y].map(|p| Circle::new(p, 0.25));
    Domain::in_circle(Circle::new(DVec2::ZERO, 2.0), &holes).expect("the holes are disjoint")
}

/// A wall of no domain in particular.
pub(crate) fn wall(x: f64, y: f64, radius: f64, kind: WallKind) -> Wall {
    Wall {
        circle: Circle::new(DVec2::new(x, y), radius),
        kind,
    }
}
