//! The circle that touches three walls: a vertex of the medial axis.
//!
//! The paper takes the circumcentre of an interior triangle, which is off by the square of the
//! sample spacing. Departs from Guoy & Erickson §2: the circumcentre is only the start of Newton's
//! method on the three equations *distance to wall = radius*, so that vertices, touching points and
//! with them the right angles at the walls and the Angle Lemma hold to rounding and not just to
//! sampling error.

use glam::{DMat2, DVec2};

use crate::wall::{Circle, Wall};

/// Steps allowed: from a circumcentre four or five suffice.
const MAX_STEPS: usize = 60;

/// Largest accepted difference between the three distances, relative to the largest coordinate or
/// radius.
const TOLERANCE: f64 = 1e-13;

/// The circle near `start` that touches all three walls from inside the domain; `None` if Newton's
/// method does not settle.
pub(crate) fn tangent_circle(walls: &[Wall; 3], start: DVec2) -> Option<Circle> {
    let scale = walls
        .iter()
        .map(|wall| wall.circle.center.abs().max_element() + wall.circle.radius)
        .fold(0.0, f64::max);
    let mut center = start;
    let mut best = spread(walls, center);
    for _ in 0..MAX_STEPS {
        let step = newton_step(walls, center)?;
        let next = center + step;
        let after = spread(walls, next);
        if after >= best {
            break;
        }
        (center, best) = (next, after);
    }
    let radius = walls.iter().map(|wall| wall.distance(center)).sum::<f64>() / 3.0;
    (best <= TOLERANCE * scale && radius > 0.0).then_some(Circle::new(center, radius))
}

/// The step that makes the three distances equal to first order.
fn newton_step(walls: &[Wall; 3], center: DVec2) -> Option<DVec2> {
    let [n0, n1, n2] = walls.map(|wall| -inward(&wall, center));
    let [d0, d1, d2] = walls.map(|wall| wall.distance(center));
    let rows = DMat2::from_cols(n1 - n0, n2 - n0).transpose();
    let step = rows.inverse() * DVec2::new(d0 - d1, d0 - d2);
    step.is_finite().then_some(step)
}

/// Unit vector from `center` towards the nearest point of the wall.
pub(crate) fn inward(wall: &Wall, center: DVec2) -> DVec2 {
    (wall.circle.center - center).normalize_or_zero() * -wall.turn()
}

/// Largest difference between the distances to the three walls.
fn spread(walls: &[Wall; 3], center: DVec2) -> f64 {
    let distances = walls.map(|wall| wall.distance(center));
    distances.iter().copied().fold(f64::MIN, f64::max)
        - distances.iter().copied().fold(f64::MAX, f64::min)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::example_domains::wall;
    use crate::wall::WallKind;

    #[test]
    fn the_circle_touches_holes_and_bounding_circle() {
        let walls = [
            wall(-1.0, 0.1, 0.3, WallKind::Hole),
            wall(1.0, 0.0, 0.5, WallKind::Hole),
            wall(0.0, 0.0, 2.0, WallKind::Bounding),
        ];
        let circle = tangent_circle(&walls, DVec2::new(0.0, 1.0)).unwrap();
        for wall in &walls {
            assert!((wall.distance(circle.center) - circle.radius).abs() < 1e-14);
        }
        assert!(circle.center.y > 0.0);
    }

    #[test]
    fn three_circles_in_a_row_have_no_circle_between_them() {
        let walls = [-1.0, 0.0, 1.0].map(|x| wall(3.0 * x, 0.0, 1.0, WallKind::Hole));
        assert_eq!(tangent_circle(&walls, DVec2::new(0.0, 1.0)), None);
    }
}
