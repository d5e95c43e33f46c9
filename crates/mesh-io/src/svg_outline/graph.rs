//! Chords joined into a graph where their ends are at one place.

use kurbo::Point;

use super::{DrawingDefect, MOST_POINTS};
use crate::outline::Outline;
use crate::planar_graph::PlanarGraph;

/// The graph of the chords so far.
#[derive(Default)]
pub(super) struct Joined {
    outline: Outline,
}

impl Joined {
    /// Adds a chord, unless it has no length or is there already.
    pub(super) fn push(&mut self, from: Point, to: Point) -> Result<(), DrawingDefect> {
        if from == to {
            return Ok(());
        }
        let too_many = |_| DrawingDefect::TooManyPoints { limit: MOST_POINTS };
        let mut point = |at: Point| self.outline.point([at.x, at.y]).map_err(too_many);
        let ends = [point(from)?, point(to)?];
        if self.outline.point_count() > MOST_POINTS {
            return Err(DrawingDefect::TooManyPoints { limit: MOST_POINTS });
        }
        self.outline.segment(ends, None);
        Ok(())
    }

    /// The graph of all chords.
    pub(super) fn graph(self) -> Result<PlanarGraph, DrawingDefect> {
        let graph = self.outline.into_graph();
        match graph.segments.is_empty() {
            true => Err(DrawingDefect::NoOutline),
            false => Ok(graph),
        }
    }
}
