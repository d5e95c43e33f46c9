//! Which of the nearby bubbles can overlap for the time being.
//!
//! Of some 36 nearby bubbles half a dozen overlap. They are listed with some slack: two bubbles are in the list when they
//! overlap or would, if both grew and moved together by a share of their radii. As long as no bubble has used up
//! its share, a bubble that is not listed does not overlap, so the lists change no force and no radius, to the
//! last bit: sums run through the bubbles that overlap in the order of their ids, with lists or without.

use rayon::prelude::*;

use super::bubbles::Bubbles;
use super::nearby::Nearby;
use crate::bubble::Bubble;

/// How many interior nodes are worked on together.
pub(super) const BLOCK: usize = 1024;

/// The share of its radius by which a bubble may move and grow.
const SLACK: f64 = 0.25;

/// What rounding may hide of it.
const ROUNDING: f64 = 1e-9;

/// For each interior node the nearby nodes whose bubbles can overlap its own.
#[derive(Clone, Debug)]
pub(super) struct Contacts {
    nearby: Nearby,
    blocks: Vec<Block>,
}

/// The lists of consecutive interior nodes.
#[derive(Clone, Debug, Default)]
pub(super) struct Block {
    /// The number of the first node among the interior nodes.
    first: usize,
    /// Where the list of each node ends.
    ends: Vec<u32>,
    nodes: Vec<u32>,
    /// The bubbles of the block when they were listed.
    listed: Vec<Bubble>,
}

impl Contacts {
    /// The lists for the nodes that have lists in `nearby`, which are the last of `bubbles`.
    pub(super) fn of(nearby: Nearby, bubbles: &Bubbles) -> Self {
        let starts = (0..bubbles.interior_count()).step_by(BLOCK);
        let block = |first| Block {
            first,
            ..Block::default()
        };
        let blocks = starts.map(block).collect();
        let mut contacts = Self { nearby, blocks };
        contacts.renew(bubbles);
        contacts
    }

    /// Lists anew.
    pub(super) fn renew(&mut self, bubbles: &Bubbles) {
        let Self { nearby, blocks } = self;
        blocks
            .par_iter_mut()
            .for_each(|block| block.renew(nearby, bubbles));
    }

    /// The lists of [`BLOCK`] nodes each, but the last.
    pub(super) fn blocks(&self) -> &[Block] {
        &self.blocks
    }
}

impl Block {
    /// The bubble of each node of the block, and the bubbles listed for it.
    pub(super) fn neighborhoods<'a>(
        &'a self,
        bubbles: &'a Bubbles,
    ) -> impl Iterator<Item = (Bubble, impl Iterator<Item = Bubble> + 'a)> {
        let starts = std::iter::once(&0).chain(&self.ends);
        let ranges = starts.zip(&self.ends).enumerate();
        ranges.map(move |(k, (&start, &end))| {
            let list = &self.nodes[start as usize..end as usize];
            let nearby = list.iter().map(|&node| bubbles.get(node as usize));
            (bubbles.interior(self.first + k), nearby)
        })
    }

    /// Whether the list of the node with this number in the block may not be good for the bubble that it has now.
    pub(super) fn has_used_slack(&self, number: usize, bubble: Bubble) -> bool {
        let listed = self.listed[number];
        let left = SLACK * (1.0 - ROUNDING) * listed.radius - (bubble.radius - listed.radius);
        let is_in_slack = left > 0.0 && bubble.center.distance_squared(listed.center) < left * left;
        !is_in_slack
    }

    fn renew(&mut self, nearby: &Nearby, bubbles: &Bubbles) {
        self.ends.clear();
        self.nodes.clear();
        self.listed.clear();
        let last = (self.first + BLOCK).min(bubbles.interior_count());
        for interior in self.first..last {
            let bubble = bubbles.interior(interior);
            let can_overlap = |&&node: &&u32| {
                let other = bubbles.get(node as usize);
                let reach = (bubble.radius + other.radius) * (1.0 + SLACK) * (1.0 + ROUNDING);
                bubble.center.distance_squared(other.center) <= reach * reach
            };
            let listed = nearby.list(interior).iter().filter(can_overlap);
            self.nodes.extend(listed);
            self.ends.push(self.nodes.len() as u32);
            self.listed.push(bubble);
        }
    }
}
