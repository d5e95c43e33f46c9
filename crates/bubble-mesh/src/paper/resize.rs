//! Size adjustment of interior node bubbles (§3.4): each becomes as large as those that it overlaps, the nearest foremost.

use rayon::prelude::*;

use super::bubbles::Bubbles;
use super::contacts::{BLOCK, Contacts};
use crate::bubble::Bubble;

/// The radius of the bubble `current` by interpolation between those of the nearby bubbles that overlap it: their mean, weighted
/// by the reciprocals of their distances.
///
/// Unit of length. The radius that it has when none overlaps it; one in the same place has no finite weight and
/// is left out. Source: eq. 9.
#[must_use]
#[inline]
pub fn resized(current: Bubble, nearby: impl IntoIterator<Item = Bubble>) -> f64 {
    let (mut radii, mut weights) = (0.0, 0.0);
    for other in nearby {
        let reach = current.radius + other.radius;
        let squared = current.center.distance_squared(other.center);
        // No branch, as in the forces.
        let overlaps = squared > 0.0 && squared < reach * reach;
        let weight = f64::from(overlaps) / squared.max(f64::MIN_POSITIVE).sqrt();
        radii += weight * other.radius;
        weights += weight;
    }
    if weights > 0.0 {
        radii / weights
    } else {
        current.radius
    }
}

/// Writes the interior bubbles with their new radii into `next`, all from the old radii; answers whether the contacts have to be
/// listed anew for them.
pub(super) fn adjust_sizes(bubbles: &Bubbles, contacts: &Contacts, next: &mut [Bubble]) -> bool {
    let blocks = contacts.blocks().par_iter().zip(next.par_chunks_mut(BLOCK));
    let adjusted = blocks.map(|(block, next)| {
        let mut slack_used = false;
        for (k, (current, nearby)) in block.neighborhoods(bubbles).enumerate() {
            next[k] = Bubble {
                center: current.center,
                radius: resized(current, nearby),
            };
            slack_used |= block.has_used_slack(k, next[k]);
        }
        slack_used
    });
    adjusted.reduce(|| false, |a, b| a | b)
}
