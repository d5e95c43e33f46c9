//! The paper's data sets as domains.

use glam::DVec2;
use medial_blocking::{Circle, Domain, DomainError};
use mesh_io::{CirclesDomain, Frame};

/// The domain that a data set describes.
pub(super) fn domain_of(circles: &CirclesDomain) -> Result<Domain, DomainError> {
    let circle = |center: [f64; 2], radius| Circle::new(DVec2::from(center), radius);
    let holes: Vec<Circle> = circles
        .holes
        .iter()
        .map(|hole| circle(hole.centre, hole.radius))
        .collect();
    match circles.frame {
        Frame::Circle { centre, radius } => Domain::in_circle(circle(centre, radius), &holes),
        Frame::Periodic { period } => Domain::periodic(DVec2::from(period), &holes),
    }
}
