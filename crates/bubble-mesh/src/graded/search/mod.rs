//! Local search: the connectivity round the worst triangles is changed where that pays.
//!
//! Moves of nodes and flips that gain at once end where no single one does. Here changes are tried on a piece round a poor triangle, each
//! with the smoothing that it needs to show its worth: an edge flipped, a node removed, a node split in two, a node put into a
//! triangle. The best is kept if it lowers the cost, else the triangle is left alone until something changes nearby.
//!
//! | step | file |
//! |---|---|
//! | which changes are worth a trial | `proposals.rs`, `valence.rs` |
//! | a change on a piece, and what it gains | `trial.rs` |

mod proposals;
mod trial;
mod valence;

use delaunay_core::measure::triangle::radius_ratio;
use delaunay_core::progress::{Cancelled, Meter};
use delaunay_core::{Complex2, FaceId, VertexId};
use rayon::prelude::*;
use std::collections::BTreeSet;

use super::energy::FIRST;
use proposals::proposals;
use trial::{Trial, around};

/// Triangles above this ratio are left alone.
const GOOD_ENOUGH: f64 = 0.985;

/// A change has to gain so much.
const LEAST_GAIN: f64 = 1e-4;

/// How far the number of triangles may move freely, as a share of it, and how much more costs.
const FREE_COUNT: f64 = 0.003;
const STIFFNESS: f64 = 5.0;

/// Tries so many changes, the worst triangles first; none that adds a node where there are so many `nodes`. The same on any number of threads.
///
/// # Errors
/// When the meter stops it; the mesh is valid then too.
pub(super) fn search(
    complex: &mut Complex2,
    trials: usize,
    nodes: usize,
    meter: &mut Meter<'_>,
) -> Result<(), Cancelled> {
    let mut search = Search::of(complex);
    let mut left = trials;
    while left > 0
        && let Some(face) = search.worst(complex)
    {
        let mut proposals = proposals(complex, face);
        if complex.points().len() >= nodes {
            proposals.retain(|proposal| !proposal.adds_a_node());
        }
        proposals.truncate(left);
        if proposals.is_empty() {
            continue;
        }
        left -= proposals.len();
        for _ in &proposals {
            meter.advance()?;
        }
        let piece = complex.piece(&around(complex, face));
        let price = search.price(complex);
        let tried = proposals
            .par_iter()
            .map(|&proposal| Trial::of(&piece, proposal, price));
        let tried: Vec<Option<Trial>> = tried.collect();
        let best = tried
            .into_iter()
            .flatten()
            .min_by(|a, b| a.loss.total_cmp(&b.loss));
        match best.filter(|trial| trial.loss < -LEAST_GAIN) {
            Some(trial) => {
                complex.put_back(&piece, &trial.complex);
                search.note_change(complex, piece.vertices());
            }
            None => search.leave(complex, face),
        }
    }
    Ok(())
}

/// Which triangles are next.
struct Search {
    /// Triangles for which nothing has been found, by their corners.
    left_alone: BTreeSet<[VertexId; 3]>,
    /// The others, the worst last; no longer right after a change.
    queue: Vec<FaceId>,
    /// How many triangles there were.
    count: f64,
}

impl Search {
    fn of(complex: &Complex2) -> Self {
        let mut search = Self {
            left_alone: BTreeSet::new(),
            queue: Vec::new(),
            count: complex.faces().count() as f64,
        };
        search.rank(complex);
        search
    }

    fn rank(&mut self, complex: &Complex2) {
        let ratio = |f: FaceId| radius_ratio(complex.triangle(f));
        let ranked = complex.faces().map(|f| (ratio(f), f));
        let poor = ranked.filter(|&(ratio, f)| {
            ratio < GOOD_ENOUGH && !self.left_alone.contains(&corners(complex, f))
        });
        let mut poor: Vec<(f64, FaceId)> = poor.collect();
        poor.sort_by(|(q, f), (r, g)| r.total_cmp(q).then(g.cmp(f)));
        self.queue = poor.into_iter().map(|(_, f)| f).collect();
    }

    fn worst(&mut self, complex: &Complex2) -> Option<FaceId> {
        let next = self.queue.pop()?;
        debug_assert!(!complex.mesh().is_ghost_face(next));
        Some(next)
    }

    fn leave(&mut self, complex: &Complex2, face: FaceId) {
        self.left_alone.insert(corners(complex, face));
    }

    /// Triangles near a change may be tried again.
    fn note_change(&mut self, complex: &Complex2, near: &[VertexId]) {
        let near: BTreeSet<VertexId> = near.iter().copied().collect();
        self.left_alone
            .retain(|corners| !corners.iter().any(|v| near.contains(v)));
        self.rank(complex);
    }

    /// What one more triangle may cost: what they cost on average, and less the more there are already.
    fn price(&self, complex: &Complex2) -> f64 {
        let costs = complex.faces().map(|f| FIRST.of(complex.triangle(f)));
        let (sum, count) = costs.fold((0.0, 0.0), |(sum, count), cost| (sum + cost, count + 1.0));
        let excess = (count - self.count) / self.count;
        let beyond = excess - excess.clamp(-FREE_COUNT, FREE_COUNT);
        sum / count - STIFFNESS * beyond
    }
}

fn corners(complex: &Complex2, face: FaceId) -> [VertexId; 3] {
    let mut corners = complex.mesh().face_vertices(face);
    corners.sort_unstable();
    corners
}
