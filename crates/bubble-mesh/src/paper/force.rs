//! Position adjustment of interior nodes (§3.2): bubbles that overlap push each other apart.

use delaunay_core::Subcomplex2;
use glam::DVec2;
use rayon::prelude::*;

use super::bubbles::Bubbles;
use super::confine::Tether;
use super::contacts::{BLOCK, Contacts};
use crate::bubble::Bubble;

/// The force of the bubble `nearby` on the bubble `current`: as long as the two overlap, away from `nearby`.
///
/// Unit of length. None where they do not overlap, and where they are in one place and there is no direction.
///
/// Departs from Luo eq. 8: there the unit vector points to the nearby bubble, which would make the force attract.
/// Source: eq. 8.
#[must_use]
#[inline]
pub fn repulsion(current: Bubble, nearby: Bubble) -> DVec2 {
    let way = current.center - nearby.center;
    let reach = current.radius + nearby.radius;
    // No branch: which bubbles overlap can not be foretold. In one place the way is zero, whatever the factor.
    let distance = way.length_squared().max(f64::MIN_POSITIVE).sqrt();
    way * (reach / distance - 1.0).max(0.0)
}

/// Where the forces of nearby bubbles move a node with the factor `step`, α in the paper. Source: eq. 7.
#[must_use]
#[inline]
pub fn moved(current: Bubble, nearby: impl IntoIterator<Item = Bubble>, step: f64) -> DVec2 {
    let forces = nearby.into_iter().map(|other| repulsion(current, other));
    current.center + step * forces.fold(DVec2::ZERO, |sum, force| sum + force)
}

/// Writes the interior bubbles at their new places into `next`, all from the old places; answers whether the contacts have to be
/// listed anew for them.
pub(super) fn adjust_positions(
    bubbles: &Bubbles,
    contacts: &Contacts,
    step: f64,
    region: &Subcomplex2,
    tethers: &mut [Tether],
    next: &mut [Bubble],
) -> bool {
    let outcomes = next
        .par_chunks_mut(BLOCK)
        .zip(tethers.par_chunks_mut(BLOCK));
    let blocks = contacts.blocks().par_iter().zip(outcomes);
    let adjusted = blocks.map(|(block, (next, tethers))| {
        let mut slack_used = false;
        for (k, (current, nearby)) in block.neighborhoods(bubbles).enumerate() {
            let place = moved(current, nearby, step);
            next[k] = Bubble {
                center: tethers[k].held(region, current.center, place),
                radius: current.radius,
            };
            slack_used |= block.has_used_slack(k, next[k]);
        }
        slack_used
    });
    adjusted.reduce(|| false, |a, b| a | b)
}
