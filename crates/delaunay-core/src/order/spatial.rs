//! Points of the plane and of space, as the order sees them.

use super::grid::Grid;
use crate::hilbert::{MAX_BITS_IN_PLANE, SPACE, places_in_plane};
use glam::{DVec2, DVec3};
use std::ops::Index;

/// A point that can be put in spatial order: [`DVec2`] or [`DVec3`].
pub trait Spatial: OnCurve {}

impl Spatial for DVec2 {}
impl Spatial for DVec3 {}

/// What the order asks of a point; sealed, because the module is private.
pub trait OnCurve: Copy + Send + Sync + Index<usize, Output = f64> {
    /// Coordinates of a point.
    const AXES: u32;
    /// The most bits per axis that a grid has.
    const MAX_GRID_BITS: u32;
    /// Levels of the curve that are found in one step; the bits of a grid are a multiple of this.
    const LEVELS: u32;
    /// About the size of the first round.
    const FIRST_ROUND: usize;
    /// The bounding box of nothing: its low and its high corner.
    const NOWHERE: [Self; 2];

    /// The bounding box of two boxes.
    fn hull(a: [Self; 2], b: [Self; 2]) -> [Self; 2];

    /// The longest side of a box.
    fn longest_side(bounds: [Self; 2]) -> f64;

    /// The axis along which a box is longest.
    fn longest_axis(bounds: [Self; 2]) -> usize;

    /// The places on the curve of the cells that points are in.
    fn places<const COUNT: usize>(points: &[Self; COUNT], grid: &Grid<Self>) -> [u64; COUNT];
}

impl OnCurve for DVec2 {
    const AXES: u32 = 2;
    const MAX_GRID_BITS: u32 = MAX_BITS_IN_PLANE;
    const LEVELS: u32 = 1;
    const FIRST_ROUND: usize = 1000;
    const NOWHERE: [Self; 2] = [Self::INFINITY, Self::NEG_INFINITY];

    #[inline(always)]
    fn hull([low, high]: [Self; 2], [l, h]: [Self; 2]) -> [Self; 2] {
        [low.min(l), high.max(h)]
    }

    fn longest_side([low, high]: [Self; 2]) -> f64 {
        (high - low).max_element()
    }

    fn longest_axis([low, high]: [Self; 2]) -> usize {
        (high - low).max_position()
    }

    #[inline(always)]
    fn places<const COUNT: usize>(points: &[Self; COUNT], grid: &Grid<Self>) -> [u64; COUNT] {
        let cells = points.map(|p| (p - grid.corner) * grid.scale);
        let x = cells.map(|cell| grid.column(cell.x));
        let y = cells.map(|cell| grid.column(cell.y));
        places_in_plane(x, y, grid.bits).map(u64::from)
    }
}

impl OnCurve for DVec3 {
    const AXES: u32 = 3;
    const MAX_GRID_BITS: u32 = 20;
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

    fn longest_axis([low, high]: [Self; 2]) -> usize {
        (high - low).max_position()
    }

    #[inline(always)]
    fn places<const COUNT: usize>(points: &[Self; COUNT], grid: &Grid<Self>) -> [u64; COUNT] {
        points.map(|p| {
            let cell = (p - grid.corner) * grid.scale;
            SPACE.place(cell.to_array().map(|c| grid.column(c)), grid.bits)
        })
    }
}
