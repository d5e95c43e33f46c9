//! The grid through which the curve runs.

use super::spatial::OnCurve;
use crate::threads;

/// A square or cubic grid over a bounding box, 2^bits cells along the longest side.
pub struct Grid<P> {
    pub(super) corner: P,
    /// Cells to a unit of length.
    pub(super) scale: f64,
    pub(super) bits: u32,
    last: f64,
}

impl<P: OnCurve> Grid<P> {
    /// The grid around `points`.
    pub(super) fn around(points: impl Iterator<Item = P>, bits: u32) -> Self {
        Self::over(bounds(points), bits)
    }

    /// The grid around `points`, which `threads` threads look at.
    pub(super) fn around_all(points: &[P], bits: u32, threads: usize) -> Self {
        let shares = points.chunks(threads::share(points.len(), threads));
        let boxes = threads::map(shares.collect(), |share| bounds(share.iter().copied()));
        Self::over(boxes.into_iter().fold(P::NOWHERE, P::hull), bits)
    }

    fn over(bounds: [P; 2], bits: u32) -> Self {
        let side = P::longest_side(bounds);
        let cells = f64::from(1_u32 << bits);
        let scale = cells / side;
        // A box without a size, or too small for its cells to be counted per unit of length, has one cell.
        let divisible = side > 0.0 && scale.is_finite();
        Self {
            corner: bounds[0],
            scale: if divisible { scale } else { 0.0 },
            bits,
            last: cells - 1.0,
        }
    }

    /// Whether the box has a size, so that places differ.
    pub(super) fn divides(&self) -> bool {
        self.scale > 0.0
    }

    /// The number of the column at a distance from the corner, given in cells.
    #[inline(always)]
    pub(super) fn column(&self, distance: f64) -> u32 {
        // In this sum the integer next to the distance is in the lowest bits; a conversion that saturates takes longer.
        (distance.min(self.last) + 4_503_599_627_370_496.0).to_bits() as u32 & self.last as u32
    }
}

fn bounds<P: OnCurve>(points: impl Iterator<Item = P>) -> [P; 2] {
    points.fold(P::NOWHERE, |bounds, p| P::hull(bounds, [p, p]))
}
