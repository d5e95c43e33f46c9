//! Patches: triangles that hang together across edges with two triangles, and how each is turned.
//!
//! ```text
//!        ·                 Across the edge the corners of two triangles that agree
//!       / \                go opposite ways. Where they go the same way, one of the
//!      / → \   agree       two has to be turned; a patch in which this cannot be done
//!     ·-----·              for all edges has one side, as a Möbius strip.
//!      \ ← /
//!       \ /                At an edge with four triangles or more nothing tells which
//!        ·                 two belong together, so patches end there.
//! ```

use super::defect::OneSided;
use super::defects::DomainDefects;
use super::edges::{Edges, Side};
use super::soup::Soup;
use crate::ids::VertexId;

/// No patch, for triangles that do not count.
const NONE: u32 = u32::MAX;

/// The patches of triangles, and which triangles have to be turned so that those of each patch agree.
pub(super) struct Patches {
    /// By triangle, its patch.
    of: Vec<u32>,
    /// By triangle, whether it is to be turned. In each patch these are no more than half, and if they are half, the first triangle
    /// stays.
    pub(super) turned: Vec<bool>,
    /// By patch, its triangles, the first in front.
    pub(super) members: Vec<Vec<usize>>,
    one_sided: Vec<(usize, [VertexId; 2])>,
}

/// The triangles across the sides of each, and whether the corners of the two agree there.
struct Across {
    /// Pairs of triangle and neighbour, in order.
    pairs: Vec<(usize, usize, bool)>,
    /// By triangle, where its pairs begin; one number more at the end.
    begin: Vec<usize>,
}

impl Patches {
    /// Finds the patches of the triangles that count, in time n log n.
    pub(super) fn of(edges: &Edges, counts: &[bool]) -> Self {
        let across = Across::of(edges, counts.len());
        let mut patches = Self {
            of: vec![NONE; counts.len()],
            turned: vec![false; counts.len()],
            members: Vec::new(),
            one_sided: Vec::new(),
        };
        for triangle in (0..counts.len()).filter(|&triangle| counts[triangle]) {
            if patches.of[triangle] == NONE {
                patches.grow(triangle, &across);
            }
        }
        patches.find_one_sided(edges);
        patches
    }

    /// The patch of a triangle, and those that hang together with it.
    fn grow(&mut self, first: usize, across: &Across) {
        let patch = self.members.len();
        let mut members = vec![first];
        self.of[first] = patch as u32;
        let mut next = 0;
        while let Some(&here) = members.get(next) {
            next += 1;
            for &(_, there, agree) in across.from(here) {
                if self.of[there] == NONE {
                    self.of[there] = patch as u32;
                    self.turned[there] = self.turned[here] ^ !agree;
                    members.push(there);
                }
            }
        }
        let turned = members.iter().filter(|&&member| self.turned[member]);
        if 2 * turned.count() > members.len() {
            self.turn(&members);
        }
        self.members.push(members);
    }

    /// Turns triangles the other way.
    fn turn(&mut self, triangles: &[usize]) {
        for &triangle in triangles {
            self.turned[triangle] ^= true;
        }
    }

    /// Turns all triangles of a patch the other way.
    pub(super) fn turn_patch(&mut self, patch: usize) {
        let members = std::mem::take(&mut self.members[patch]);
        self.turn(&members);
        self.members[patch] = members;
    }

    /// Patches in which triangles disagree when turned, each with the first edge where they do.
    fn find_one_sided(&mut self, edges: &Edges) {
        let mut known = vec![false; self.members.len()];
        for [side, other] in pairs(edges) {
            let [one, two] = [side, other].map(|side| side.forward ^ self.turned[side.triangle()]);
            let patch = self.of[side.triangle()] as usize;
            if one == two && !known[patch] {
                known[patch] = true;
                self.one_sided.push((patch, side.ends));
            }
        }
        self.one_sided.sort_unstable();
    }

    /// Patches that have one side.
    pub(super) fn judge(&self, soup: &Soup<'_>, defects: &mut DomainDefects) {
        let defect = |&(patch, ends): &(usize, [VertexId; 2])| OneSided {
            first: self.members[patch][0],
            triangles: self.members[patch].len(),
            ends: ends.map(|v| soup.placed(v)),
        };
        defects.one_sided = self.one_sided.iter().map(defect).collect();
    }
}

impl Across {
    fn of(edges: &Edges, triangles: usize) -> Self {
        let both = pairs(edges).flat_map(|[side, other]| {
            let [one, two] = [side.triangle(), other.triangle()];
            let agree = side.forward != other.forward;
            [(one, two, agree), (two, one, agree)]
        });
        let mut pairs: Vec<_> = both.collect();
        pairs.sort_unstable();
        let mut begin = vec![0; triangles + 1];
        for &(triangle, ..) in &pairs {
            begin[triangle + 1] += 1;
        }
        for triangle in 0..triangles {
            begin[triangle + 1] += begin[triangle];
        }
        Self { pairs, begin }
    }

    fn from(&self, triangle: usize) -> &[(usize, usize, bool)] {
        &self.pairs[self.begin[triangle]..self.begin[triangle + 1]]
    }
}

/// The edges with two triangles.
fn pairs(edges: &Edges) -> impl Iterator<Item = [Side; 2]> + '_ {
    edges.iter().filter_map(|on_edge| match *on_edge {
        [side, other] => Some([side, other]),
        _ => None,
    })
}
