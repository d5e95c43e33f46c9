//! A change made on a piece, smoothed, and weighed.

use delaunay_core::{Complex2, FaceId, HalfEdgeId, Piece2, VertexId};
use glam::DVec2;
use std::collections::BTreeSet;

use super::super::energy::FIRST;
use super::super::optimize::flip_all;
use super::super::smooth::Smoother;
use super::proposals::Proposal;

/// How many edges away from a triangle its piece reaches: as far as smoothing does, and one more.
const REACH: usize = 4;

/// Below this loss a change is smoothed further.
const PROMISING: f64 = 0.4;

/// Smoothing ends when nodes move by less than this share of an edge.
const SETTLED: f64 = 2e-3;

/// Where a new node of a split is put, as a share of the shortest edge.
const SPLIT_SHARE: f64 = 0.25;

/// What came of a change.
pub(super) struct Trial {
    /// The piece with the change.
    pub(super) complex: Complex2,
    /// How much more it costs, less what its triangles may cost.
    pub(super) loss: f64,
}

impl Trial {
    /// Makes a change on a piece, when one more triangle may cost `price`. `None` when it can not be made.
    pub(super) fn of(piece: &Piece2, proposal: Proposal, price: f64) -> Option<Self> {
        let mut patch = Patch {
            complex: piece.complex().clone(),
            smoother: Smoother::default(),
        };
        let nodes = patch.change(piece, proposal)?;
        let before = weigh(piece.complex(), price);
        patch.settle(&nodes, 1, 2);
        if weigh(&patch.complex, price) - before < PROMISING {
            patch.settle(&nodes, 2, 4);
        }
        Some(Self {
            loss: weigh(&patch.complex, price) - before,
            complex: patch.complex,
        })
    }
}

/// The triangles that a change for a triangle may touch.
pub(super) fn around(complex: &Complex2, face: FaceId) -> Vec<FaceId> {
    let nodes = rings(complex, &complex.mesh().face_vertices(face), REACH);
    star_of(complex, &nodes)
}

/// What the triangles cost, less what as many may cost.
fn weigh(complex: &Complex2, price: f64) -> f64 {
    complex
        .faces()
        .map(|f| FIRST.of(complex.triangle(f)) - price)
        .sum()
}

/// Some nodes and those so many edges away.
fn rings(complex: &Complex2, nodes: &[VertexId], count: usize) -> Vec<VertexId> {
    let mut found: BTreeSet<VertexId> = nodes.iter().copied().collect();
    let mut last: Vec<VertexId> = nodes.to_vec();
    for _ in 0..count {
        let beside = last.iter().flat_map(|&v| complex.mesh().neighbors(v));
        let mut next: Vec<VertexId> = beside.filter(|v| !v.is_ghost()).collect();
        next.retain(|&v| found.insert(v));
        last = next;
    }
    found.into_iter().collect()
}

/// The triangles at some nodes, by id.
fn star_of(complex: &Complex2, nodes: &[VertexId]) -> Vec<FaceId> {
    let mesh = complex.mesh();
    let faces = nodes.iter().flat_map(|&v| mesh.star(v));
    let mut faces: Vec<FaceId> = faces.filter(|&f| !mesh.is_ghost_face(f)).collect();
    faces.sort_unstable();
    faces.dedup();
    faces
}

/// A piece that is worked on.
struct Patch {
    complex: Complex2,
    smoother: Smoother,
}

impl Patch {
    /// Makes the change; gives the nodes that have to settle.
    fn change(&mut self, piece: &Piece2, proposal: Proposal) -> Option<Vec<VertexId>> {
        let local = |v: VertexId| piece.local(v);
        match proposal {
            Proposal::Flip([a, b]) => {
                let h = self.complex.mesh().find_half_edge(local(a)?, local(b)?)?;
                let sides = self.complex.flip(h)?;
                let nodes = sides.map(|h| self.complex.mesh().origin(h)).to_vec();
                // They have to move first, or the edge would be flipped back at once.
                self.sweep(&nodes);
                self.sweep(&nodes);
                Some(nodes)
            }
            Proposal::Remove(v) => {
                let v = local(v)?;
                let nodes: Vec<VertexId> = self.complex.mesh().neighbors(v).collect();
                self.complex.remove(v)?;
                self.sweep(&nodes);
                Some(nodes)
            }
            Proposal::Split { node, from, to } => {
                self.split(local(node)?, [local(from)?, local(to)?])
            }
            Proposal::Insert([a, b, c]) => {
                let mut nodes = [local(a)?, local(b)?, local(c)?].to_vec();
                let h = self.complex.mesh().find_half_edge(nodes[0], nodes[1])?;
                let center = self.complex.triangle(h.face()).into_iter().sum::<DVec2>() / 3.0;
                nodes.push(self.complex.insert(center, h.face())?);
                Some(nodes)
            }
        }
    }

    /// Makes two nodes of one; the new one gets the neighbours between two of them.
    fn split(&mut self, node: VertexId, [from, to]: [VertexId; 2]) -> Option<Vec<VertexId>> {
        let mesh = self.complex.mesh();
        let mut ring: Vec<VertexId> = mesh.neighbors(node).collect();
        let start = ring.iter().position(|&v| v == from)?;
        ring.rotate_left(start);
        let end = ring.iter().position(|&v| v == to)?;
        let here = self.complex.point(node);
        let arms = ring[..=end].iter().map(|&v| self.complex.point(v) - here);
        let shortest = arms
            .clone()
            .map(DVec2::length)
            .fold(f64::INFINITY, f64::min);
        let toward: DVec2 = arms.map(DVec2::normalize_or_zero).sum();
        let place = here + SPLIT_SHARE * shortest * toward.normalize_or_zero();
        let faces = ring[..end]
            .iter()
            .filter_map(|&v| self.complex.mesh().find_half_edge(node, v));
        let faces: Vec<FaceId> = faces.map(HalfEdgeId::face).collect();
        let new = faces
            .into_iter()
            .find_map(|f| self.complex.insert(place, f))?;
        self.take_over(node, new, &ring[1..end])?;
        let mut nodes = ring;
        nodes.extend([node, new]);
        for _ in 0..3 {
            self.sweep(&[node, new]);
        }
        self.sweep(&nodes);
        Some(nodes)
    }

    /// Flips the edges between a node and some neighbours so that they lead to the new node.
    fn take_over(&mut self, node: VertexId, new: VertexId, neighbors: &[VertexId]) -> Option<()> {
        let mut left: Vec<VertexId> = neighbors.to_vec();
        while !left.is_empty() {
            let before = left.len();
            left.retain(|&v| {
                let mesh = self.complex.mesh();
                let Some(h) = mesh.find_half_edge(node, v) else {
                    return false;
                };
                let borders = [mesh.apex(h), mesh.apex(mesh.twin(h))].contains(&new);
                !(borders && self.complex.flip(h).is_some())
            });
            if left.len() == before {
                return None;
            }
        }
        Some(())
    }

    /// Moves some nodes once; gives the longest step over an edge.
    fn sweep(&mut self, nodes: &[VertexId]) -> f64 {
        let mut longest = 0.0;
        for &v in nodes {
            if self.complex.is_inner(v) {
                longest = f64::max(longest, self.smoother.smooth(&mut self.complex, v, FIRST));
            }
        }
        longest
    }

    /// Moves the nodes within some rings of those given and flips edges there, a few times.
    fn settle(&mut self, nodes: &[VertexId], reach: usize, sweeps: usize) {
        let nodes = rings(&self.complex, nodes, reach);
        let mut faces = star_of(&self.complex, &nodes);
        flip_all(&mut self.complex, FIRST, &mut faces);
        for _ in 0..sweeps {
            let moved = self.sweep(&nodes);
            let mut faces = star_of(&self.complex, &nodes);
            let flipped = flip_all(&mut self.complex, FIRST, &mut faces);
            if moved < SETTLED && flipped.is_empty() {
                break;
            }
        }
    }
}
