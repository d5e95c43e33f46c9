//! Algorithm 2, `Blocking2D`: the two curves of wall on either side of each medial arc (§3).
//!
//! Travelling along an arc, `C1` is the wall on the right and `C2` the wall on the left; in each boundary triangle entered, the apex
//! extends the curve whose wall holds the triangle's boundary side. The third curve, `M`, is the arc itself.

use glam::DVec2;

use crate::medial_axis::{SampledAxis, TriangleSequence};
use crate::triangulation::{Across, Corner};

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
/// Empty for a single hole in a circle, whose medial axis is a closed curve without a vertex. O(number of triangles).
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
