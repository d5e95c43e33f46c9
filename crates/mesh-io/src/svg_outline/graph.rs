//! Chords joined into a graph where their ends are at one place.

use std::collections::{HashMap, HashSet};

use kurbo::Point;

use super::{DrawingDefect, MOST_POINTS};
use crate::planar_graph::PlanarGraph;

/// The graph of the chords so far. The maps are only asked, never walked: the order is that of drawing.
#[derive(Default)]
pub(super) struct Joined {
    graph: PlanarGraph,
    /// The point at a place, by the bits of its coordinates.
    points: HashMap<[u64; 2], u32>,
    /// The segments, lesser point first.
    segments: HashSet<[u32; 2]>,
}

impl Joined {
    /// Adds a chord, unless it has no length or is there already.
    pub(super) fn push(&mut self, from: Point, to: Point) -> Result<(), DrawingDefect> {
        if from == to {
            return Ok(());
        }
        let (from, to) = (self.point_at(from)?, self.point_at(to)?);
        if self.segments.insert([from.min(to), from.max(to)]) {
            self.graph.segments.push([from, to]);
        }
        Ok(())
    }

    /// The point at a place, made if need be.
    fn point_at(&mut self, place: Point) -> Result<u32, DrawingDefect> {
        // Adding zero turns -0.0 into 0.0, so that equal numbers have equal bits.
        let place = [place.x + 0.0, place.y + 0.0];
        let next = self.graph.points.len();
        let point = *self
            .points
            .entry(place.map(f64::to_bits))
            .or_insert(next as u32);
        if point as usize == next {
            if next == MOST_POINTS {
                return Err(DrawingDefect::TooManyPoints { limit: MOST_POINTS });
            }
            self.graph.points.push(place);
        }
        Ok(point)
    }

    /// The graph of all chords.
    pub(super) fn graph(self) -> Result<PlanarGraph, DrawingDefect> {
        if self.graph.segments.is_empty() {
            return Err(DrawingDefect::NoOutline);
        }
        Ok(self.graph)
    }
}
