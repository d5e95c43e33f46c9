//! Random and regular domains for the tests.

use glam::DVec2;
use medial_blocking::{Circle, Domain};
use proptest::prelude::*;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// Strategies for domains.
pub(crate) struct Domains;

impl Domains {
    /// Up to 24 holes of very different sizes in a circle or a periodic rectangle.
    pub(crate) fn any() -> impl Strategy<Value = Domain> {
        (
            any::<u64>(),
            1usize..24,
            -3.0..-1.0f64,
            any::<bool>(),
            0.3..1.0f64,
        )
            .prop_map(|(seed, count, log_gap, periodic, aspect)| {
                let gap = 10f64.powf(log_gap);
                if periodic {
                    random_periodic(seed, count, gap, aspect)
                } else {
                    random_in_circle(seed, count, gap)
                }
            })
    }
}

/// Six holes round a seventh, as in the paper's Hexagon.
#[allow(dead_code)]
pub(crate) fn hexagon() -> Domain {
    let ring = (0..6).map(|k| DVec2::from_angle(f64::from(k) * std::f64::consts::FRAC_PI_3));
    let holes: Vec<Circle> = std::iter::once(DVec2::ZERO)
        .chain(ring)
        .map(|center| Circle::new(center, 0.3))
        .collect();
    Domain::in_circle(Circle::new(DVec2::ZERO, 1.74), &holes).expect("the holes are disjoint")
}

/// Holes added one by one where they fit, gaps at least `gap`, in the unit circle.
pub(crate) fn random_in_circle(seed: u64, count: usize, gap: f64) -> Domain {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let mut holes: Vec<Circle> = Vec::new();
    for _ in 0..50 * count {
        let p = DVec2::new(rng.random_range(-1.0..1.0), rng.random_range(-1.0..1.0));
        let circle = Circle::new(p, 10f64.powf(rng.random_range(-2.0..-0.6)));
        let fits = |other: &Circle| other.center.distance(p) - other.radius - circle.radius > gap;
        if holes.len() < count && p.length() + circle.radius + gap < 1.0 && holes.iter().all(fits) {
            holes.push(circle);
        }
    }
    if holes.is_empty() {
        holes.push(Circle::new(DVec2::new(0.1, 0.2), 0.3));
    }
    Domain::in_circle(Circle::new(DVec2::ZERO, 1.0), &holes).expect("the holes are disjoint")
}

/// The same in a periodic rectangle of width 1 and height `aspect`.
pub(crate) fn random_periodic(seed: u64, count: usize, gap: f64, aspect: f64) -> Domain {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let period = DVec2::new(1.0, aspect);
    let mut holes: Vec<Circle> = Vec::new();
    for _ in 0..50 * count {
        let p = DVec2::new(rng.random_range(0.0..1.0), rng.random_range(0.0..aspect));
        let circle = Circle::new(p, aspect * 10f64.powf(rng.random_range(-2.0..-0.7)));
        let fits = |other: &Circle| {
            let mut offset = other.center - p;
            offset -= (offset / period).round() * period;
            offset.length() - other.radius - circle.radius > gap
        };
        if holes.len() < count && holes.iter().all(fits) {
            holes.push(circle);
        }
    }
    Domain::periodic(period, &holes).expect("the holes are disjoint")
}
