//! How large triangles should be where: sizes of boundary nodes, carried into the region.
//!
//! The size at a place is the mean of the sizes of all boundary nodes, weighted by size over squared distance (Shepard 1968). It is smooth
//! wherever there are nodes to come, equals the boundary's sizes on it, and of the fields tried it leaves the fewest
//! poor triangles. Nodes far away count together, as in the method of Barnes and Hut, so a value takes log n time.
//!
//! It is limited by what the nodes permit, the size of each and a share of the distance from it: a few short edges far from long ones,
//! round a small hole for instance, would else count for too little a short way off. Where that share is small, the shortest edges tell
//! the size even beside the longest; there sizes fall from those of the boundary by a share of the distance too.

use glam::DVec2;

use super::params::GradedError;
use crate::envelope::{Cone, Envelope};

/// A box of nodes counts as one when it is this many times as far away as it is wide.
const FAR: f64 = 2.5;

/// Boxes with so many nodes are not divided.
const LEAF: usize = 8;

/// Sizes fall from a boundary node inwards by at most this share of the distance: more would make poor triangles.
const FALL: f64 = 0.5;

/// A size for every place, of the caller's.
pub type Sizing<'a> = &'a (dyn Fn(DVec2) -> f64 + Sync);

/// Sizes in the plane: from those of nodes, and at most the caller's.
#[derive(Clone)]
pub(super) struct SizeField<'a> {
    nodes: Vec<Cone>,
    boxes: Vec<Group>,
    /// What the nodes permit, when sizes grow with the distance as they may.
    permitted: Envelope,
    /// What the nodes ask for, as sizes below zero, when sizes fall as fast as they may; none where they grow as fast.
    asked: Option<Envelope>,
    scale: f64,
    sizing: Option<Sizing<'a>>,
}

/// Consecutive nodes, as one.
#[derive(Clone, Copy, Debug)]
struct Group {
    first: u32,
    end: u32,
    /// The box that follows when this one is far enough, or else the next in the list.
    skip: u32,
    low: DVec2,
    high: DVec2,
    /// The mean place, weighted by size.
    center: DVec2,
    sizes: f64,
    squares: f64,
}

impl<'a> SizeField<'a> {
    /// The field of nodes with these places and sizes, all above zero, at least one; sizes are multiplied by `scale`.
    pub(super) fn new(
        nodes: impl Iterator<Item = (DVec2, f64)>,
        scale: f64,
        grade: f64,
        sizing: Option<Sizing<'a>>,
    ) -> Self {
        let nodes: Vec<Cone> = nodes.map(|(place, size)| Cone { place, size }).collect();
        let mut field = Self {
            permitted: Envelope::of(nodes.clone(), grade),
            asked: (grade < FALL).then(|| {
                let below = |node: &Cone| Cone {
                    place: node.place,
                    size: -node.size,
                };
                Envelope::of(nodes.iter().map(below).collect(), FALL)
            }),
            nodes,
            boxes: Vec::new(),
            scale,
            sizing,
        };
        field.divide(0, field.nodes.len());
        field
    }

    /// The size at a place.
    ///
    /// # Errors
    /// The caller's size when it is not a finite number above zero.
    pub(super) fn at(&self, place: DVec2) -> Result<f64, GradedError> {
        let of_boundary = self.scale * self.limited(place, self.of_boundary(place));
        let Some(sizing) = self.sizing else {
            return Ok(of_boundary);
        };
        let size = sizing(place);
        match size > 0.0 && size < f64::INFINITY {
            true => Ok(size.min(of_boundary)),
            false => Err(GradedError::Size { place, size }),
        }
    }

    /// A size, limited by what the nodes permit but where they ask for more.
    fn limited(&self, place: DVec2, size: f64) -> f64 {
        let permitted = self.permitted.at(place, size);
        match &self.asked {
            Some(asked) => permitted.max(size.min(-asked.at(place, f64::INFINITY))),
            None => permitted,
        }
    }

    /// Whether the caller has a say.
    pub(super) fn is_sized(&self) -> bool {
        self.sizing.is_some()
    }

    /// The mean of what the nodes say.
    fn of_boundary(&self, place: DVec2) -> f64 {
        let (mut sizes, mut weights) = (0.0, 0.0);
        let mut next = 0;
        while let Some(group) = self.boxes.get(next) {
            let width = (group.high - group.low).max_element();
            let apart = group.center.distance_squared(place);
            if apart > FAR * FAR * width * width {
                sizes += group.squares / apart;
                weights += group.sizes / apart;
                next = group.skip as usize;
                continue;
            }
            next += 1;
            if next == group.skip as usize {
                for node in &self.nodes[group.first as usize..group.end as usize] {
                    let apart = node.place.distance_squared(place);
                    if apart == 0.0 {
                        return node.size;
                    }
                    sizes += node.size * node.size / apart;
                    weights += node.size / apart;
                }
            }
        }
        sizes / weights
    }

    /// Lists the box of some nodes and those that it is divided into, half of its nodes each.
    fn divide(&mut self, first: usize, end: usize) {
        let nodes = &mut self.nodes[first..end];
        let sum = |part: fn(&Cone) -> f64| nodes.iter().map(part).sum::<f64>();
        let low = nodes
            .iter()
            .fold(DVec2::INFINITY, |low, node| low.min(node.place));
        let high = nodes
            .iter()
            .fold(-DVec2::INFINITY, |high, node| high.max(node.place));
        let sizes = sum(|node| node.size);
        let moment: DVec2 = nodes.iter().map(|node| node.size * node.place).sum();
        let this = self.boxes.len();
        self.boxes.push(Group {
            first: first as u32,
            end: end as u32,
            skip: 0,
            low,
            high,
            center: moment / sizes,
            sizes,
            squares: sum(|node| node.size * node.size),
        });
        let (half, wide) = (nodes.len() / 2, high - low);
        if nodes.len() > LEAF {
            let along = |node: &Cone| {
                if wide.x >= wide.y {
                    node.place.x
                } else {
                    node.place.y
                }
            };
            nodes.select_nth_unstable_by(half, |a, b| along(a).total_cmp(&along(b)));
            self.divide(first, first + half);
            self.divide(first + half, end);
        }
        self.boxes[this].skip = self.boxes.len() as u32;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ring(count: u32) -> Vec<(DVec2, f64)> {
        let node = |i: u32| {
            let turn = f64::from(i) * std::f64::consts::TAU / f64::from(count);
            (DVec2::from_angle(turn), 0.1 + 0.05 * turn.sin())
        };
        (0..count).map(node).collect()
    }

    fn plainly(nodes: &[(DVec2, f64)], at: DVec2) -> f64 {
        let weight = |place: DVec2, size: f64| size / place.distance_squared(at);
        let sizes: f64 = nodes.iter().map(|&(p, h)| weight(p, h) * h).sum();
        sizes / nodes.iter().map(|&(p, h)| weight(p, h)).sum::<f64>()
    }

    #[test]
    fn far_nodes_together_are_as_good_as_one_by_one() {
        let nodes = ring(1000);
        let field = SizeField::new(nodes.iter().copied(), 1.0, 0.5, None);
        for i in 0..200 {
            let at = DVec2::from_angle(f64::from(i)) * (f64::from(i) / 201.0);
            let (found, expected) = (field.of_boundary(at), plainly(&nodes, at));
            assert!(
                (found / expected - 1.0).abs() < 0.01,
                "{at}: {found} {expected}"
            );
        }
    }

    #[test]
    fn nodes_have_their_own_sizes_and_all_are_scaled() {
        let nodes = ring(100);
        let field = SizeField::new(nodes.iter().copied(), 0.5, 0.5, None);
        assert!(
            nodes
                .iter()
                .all(|&(place, size)| field.at(place) == Ok(0.5 * size))
        );
    }

    #[test]
    fn no_node_permits_less() {
        let nodes = ring(300);
        let field = SizeField::new(nodes.iter().copied(), 1.0, 0.1, None);
        for i in 0..200 {
            let at = DVec2::from_angle(f64::from(i)) * (f64::from(i) / 100.0);
            let permitted = nodes.iter().map(|(p, h)| h + 0.1 * p.distance(at));
            let asked = field.of_boundary(at);
            assert_eq!(field.at(at), Ok(permitted.fold(asked, f64::min)));
        }
    }
}
