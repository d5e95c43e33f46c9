//! Points of the plane and of space, as the order sees them.

use super::grid::Grid;
use crate::hilbert::{PLANE, SPACE};
use glam::{DVec2, DVec3};

/// A point that can be put in spatial order: [`DVec2`] or [`DVec3`].
pub trait Spatial: OnCurve {}

impl Spatial for DVec2 {}
impl Spatial for DVec3 {}

/// What the order asks of a point; sealed, because the module is private.
pub trait OnCurve: Copy + Send + Sync {
    /// Coordinates of a point.
    const AXES: u32;
    /// Levels of the curve that one table look-up answers; grids have a multiple of this many.
    const LEVELS: u32;
    /// About the size of the first round.
    const FIRST_ROUND: usize;
    /// The bounding box of nothing: its low and its high corner.
    const NOWHERE: [Self; 2];

    /// The bounding box of two boxes.
    fn hull(a: [Self; 2], b: [Self; 2]) -> [Self; 2];

    /// The longest side of a box.
    fn longest_side(bounds: [Self; 2]) -> f64;

    /// The place on the curve of the cell that the point is in.
    fn place(self, grid: &Grid<Self>) -> u64;
}

impl OnCurve for DVec2 {
    const AXES: u32 = 2;
    const LEVELS: u32 = PLANE.levels();
    const FIRST_ROUND: usize = 1000;
    const NOWHERE: [Self; 2] = [Self::INFINITY, Self::NEG_INFINITY];

    #[inline(always)]
    fn hull([low, high]: [Self; 2], [l, h]: [Self; 2]) -> [Self; 2] {
        [low.min(l), high.max(h)]
    }

    fn longest_side([low, high]: [Self; 2]) -> f64 {
        (high - low).max_element()
    }

    #[inline(always)]
    fn place(self, grid: &Grid<Self>) -> u64 {
        let cell = (self - grid.corner) * grid.scale;
        PLANE.place(cell.to_array().map(|c| grid.column(c)), grid.bits)
    }
}

impl OnCurve for DVec3 {
    const AXES: u32 = 3;
    const LEVELS: u32 = SPACE.levels();
    const FIRST_ROUND: usize = 2000;
    const NOWHERE: [Self; 2] = [Self::INFINITY, Self::NEG_INFINITY];

    #[inline(always)]
    fn hull([low, high]: [Self; 2], [l, h]: [Self; 2]) -> [Self; 2] {
        [low.min(l), high.max(h)]
    }

    fn longest_side([low, high]: [Self; 2]) -> f64 {
        (high - low).max_element()
    }

    #[inline(always)]
    fn place(self, grid: &Grid<Self>) -> u64 {
        let cell = (self - grid.corner) * grid.scale;
        SPACE.place(cell.to_array().map(|c| grid.column(c)), grid.bits)
    }
}
