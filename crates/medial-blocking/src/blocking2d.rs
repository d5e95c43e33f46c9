//! Algorithm 2, `Blocking2D`: the two curves of wall on either side of each medial arc (§3).
//!
//! Travelling along an arc, `C1` is the wall on the right and `C2` the wall on the left; in each
//! boundary triangle entered, the apex extends the curve whose wall holds the triangle's boundary
//! side. The third curve, `M`, is the arc itself.

use glam::DVec2;

use crate::corner::Corner;
use crate::medial_axis::{SampledAxis, TriangleSequence};
use crate::triangulation::Across;

/// A pair of blocks that share a medial arc, as three polygonal curves.
#[derive(Clone, Debug)]
pub struct BlockPair {
    /// The sequence of triangles that the pair covers.
    pub sequence: TriangleSequence,
    /// Samples of the wall on the right, in the direction of the arc.
    pub c1: Vec<Corner>,
    /// Circumcentres along the arc.
    pub m: Vec<DVec2>,
    /// Samples of the wall on the left, in the direction of the arc.
    pub c2: Vec<Corner>,
}

/// The pairs of blocks of a domain, one per medial arc, in the order of [`SampledAxis::arcs`].
///
/// Empty for a single hole in a circle, whose medial axis is a closed curve without a vertex.
/// O(number of triangles).
#[must_use]
pub fn block_pairs(axis: &SampledAxis<'_>) -> Vec<BlockPair> {
    axis.arcs()
        .into_iter()
        .map(|sequence| block_pair(axis, sequence))
        .collect()
}

fn block_pair(axis: &SampledAxis<'_>, sequence: TriangleSequence) -> BlockPair {
    let triangulation = axis.triangulation;
    let [a, b] = triangulation.ends(sequence.start);
    let (mut c1, mut c2) = (vec![a], vec![b]);
    for entry in &sequence.entries {
        let p = triangulation.apex(entry.side).moved(entry.shift);
        let (lambda1, lambda2) = (entry.side.next(), entry.side.next().next());
        if triangulation.across(lambda1) == Across::Wall {
            c1.push(p);
        }
        if triangulation.across(lambda2) == Across::Wall {
            c2.push(p);
        }
    }
    BlockPair {
        m: sequence.polyline(axis),
        sequence,
        c1,
        c2,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Blocking;
    use crate::corner::wall_image;
    use crate::example_domains::{three_holes, two_periodic_holes};
    use crate::wall::WallKind;

    fn each_pair(look: impl Fn(&SampledAxis<'_>, &BlockPair)) {
        for domain in [three_holes(), two_periodic_holes()] {
            let blocking = Blocking::of(&domain).unwrap();
            let axis = blocking.sampled_axis();
            for pair in block_pairs(&axis) {
                look(&axis, &pair);
            }
        }
    }

    #[test]
    fn c1_and_c2_stay_on_one_wall_each() {
        each_pair(|axis, pair| {
            for curve in [&pair.c1, &pair.c2] {
                let wall = wall_image(axis.samples, curve[0]);
                let stays = |&corner: &Corner| wall_image(axis.samples, corner) == wall;
                assert!(curve.iter().all(stays));
            }
        });
    }

    /// Line 9 adds to M in every triangle, lines 10 and 11 to one of C1 and C2 in every boundary
    /// triangle.
    #[test]
    fn m_has_as_many_points_as_c1_and_c2_together() {
        each_pair(|_, pair| assert_eq!(pair.m.len(), pair.c1.len() + pair.c2.len()));
    }

    #[test]
    fn the_curves_are_the_neighbouring_samples_of_their_walls_in_the_direction_of_the_arc() {
        each_pair(|axis, pair| {
            // Round a hole on the right the arc runs clockwise, inside a bounding circle counterclockwise.
            for (curve, clockwise_round_holes) in [(&pair.c1, true), (&pair.c2, false)] {
                let wall = axis.domain.wall(axis.samples.wall(curve[0].sample));
                let clockwise = clockwise_round_holes == (wall.kind == WallKind::Hole);
                for two in curve.windows(2) {
                    let following = if clockwise {
                        axis.samples.previous(two[0].sample)
                    } else {
                        axis.samples.next(two[0].sample)
                    };
                    assert_eq!(following, two[1].sample);
                }
            }
        });
    }
}
