//! Which changes round a triangle are worth a trial: those that do not make valences much worse.

use delaunay_core::{Complex2, FaceId, HalfEdgeId, VertexId};

use super::valence::defect;

/// By how much the squares of the defects may grow.
const WORSE: f64 = 2.0;

/// A node with more triangles is not removed.
const LARGEST_REMOVED: usize = 6;

/// A node with fewer triangles is not split, and so many ways to split one are tried.
const SMALLEST_SPLIT: usize = 6;
const SPLITS: usize = 3;

/// A change, by vertices of the whole.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Proposal {
    /// The edge between two nodes is flipped.
    Flip([VertexId; 2]),
    /// A node is removed.
    Remove(VertexId),
    /// A node becomes two; the new one gets the neighbours from the first to the second, counterclockwise, those included.
    Split {
        node: VertexId,
        from: VertexId,
        to: VertexId,
    },
    /// A node is put into the triangle.
    Insert([VertexId; 3]),
}

impl Proposal {
    /// Whether there is one node more then.
    pub(super) fn adds_a_node(&self) -> bool {
        matches!(self, Self::Split { .. } | Self::Insert(_))
    }
}

/// The changes to be tried for a triangle.
pub(super) fn proposals(complex: &Complex2, face: FaceId) -> Vec<Proposal> {
    let mesh = complex.mesh();
    let mut found = Vec::new();
    for h in face.half_edges() {
        let twin = mesh.twin(h);
        if mesh.is_ghost_face(twin.face()) {
            continue;
        }
        for edge in [h, twin.next(), twin.prev()] {
            propose_flip(complex, edge, &mut found);
        }
        propose_removal(complex, mesh.apex(twin), &mut found);
    }
    let corners = mesh.face_vertices(face);
    for v in corners {
        propose_removal(complex, v, &mut found);
        propose_splits(complex, v, &mut found);
    }
    found.push(Proposal::Insert(corners));
    found
}

fn propose_flip(complex: &Complex2, h: HalfEdgeId, found: &mut Vec<Proposal>) {
    if complex.is_boundary(h) {
        return;
    }
    let mesh = complex.mesh();
    let (ends, tips) = (
        [mesh.origin(h), mesh.target(h)],
        [mesh.apex(h), mesh.apex(mesh.twin(h))],
    );
    let sum = |nodes: [VertexId; 2]| nodes.map(|v| defect(complex, v)).iter().sum::<f64>();
    // Each tip gains an edge and each end loses one.
    if 2.0 * (sum(tips) - sum(ends)) + 4.0 <= WORSE {
        found.push(Proposal::Flip(ends));
    }
}

fn propose_removal(complex: &Complex2, v: VertexId, found: &mut Vec<Proposal>) {
    if complex.is_inner(v) && complex.mesh().around(v).count() <= LARGEST_REMOVED {
        found.push(Proposal::Remove(v));
    }
}

fn propose_splits(complex: &Complex2, node: VertexId, found: &mut Vec<Proposal>) {
    let ring: Vec<VertexId> = complex.mesh().neighbors(node).collect();
    let degree = ring.len();
    if !complex.is_inner(node) || degree < SMALLEST_SPLIT {
        return;
    }
    let defects: Vec<f64> = ring.iter().map(|&v| defect(complex, v)).collect();
    let grown = |defect: f64| 2.0 * defect + 1.0;
    let square = |triangles: usize| (triangles as f64 - 6.0).powi(2);
    let mut ways = Vec::new();
    for first in 0..degree {
        for width in 2..=degree / 2 {
            let last = (first + width) % degree;
            let worse = square(width + 2) + square(degree + 2 - width) - square(degree)
                + grown(defects[first])
                + grown(defects[last]);
            if worse <= WORSE {
                ways.push((worse, first, last));
            }
        }
    }
    ways.sort_by(|a, b| a.0.total_cmp(&b.0));
    let splits = ways
        .into_iter()
        .take(SPLITS)
        .map(|(_, first, last)| Proposal::Split {
            node,
            from: ring[first],
            to: ring[last],
        });
    found.extend(splits);
}
