//! Small domains that explain the method.

use glam::DVec2;
use medial_blocking::{Blocking, Circle, Domain};

/// Three particles of different size.
pub(super) fn three_particles() -> Result<Blocking, Box<dyn std::error::Error>> {
    let circle = |x, y, radius| Circle::new(DVec2::new(x, y), radius);
    let holes = [
        circle(-0.85, -0.35, 0.5),
        circle(0.85, -0.6, 0.4),
        circle(0.2, 0.9, 0.52),
    ];
    Ok(Blocking::of(&Domain::in_circle(
        circle(0.0, 0.0, 2.0),
        &holes,
    )?)?)
}

/// Two particles with wide gaps, where few samples are enough.
pub(super) fn two_particles() -> Result<Blocking, Box<dyn std::error::Error>> {
    let circle = |x, y, radius| Circle::new(DVec2::new(x, y), radius);
    let holes = [circle(-0.8, -0.1, 0.45), circle(0.75, 0.15, 0.35)];
    Ok(Blocking::of(&Domain::in_circle(
        circle(0.0, 0.0, 2.0),
        &holes,
    )?)?)
}
