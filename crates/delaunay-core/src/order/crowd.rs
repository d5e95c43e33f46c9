//! Points that share a cell of the grid in great number are sorted along a curve of their own.

use super::grid::Grid;
use super::key::KeyLayout;
use super::spatial::OnCurve;

/// Points in one cell of the grid that are worth a curve of their own.
const CROWD: usize = 32;

/// Sorts the points of every crowded cell along a curve through their own bounding box.
///
/// Ends because the bounding box of a crowd spreads over all cells along its longest side, so each
/// level splits it; equal points, which nothing splits, and points closer than accepted coordinates
/// can be are left alone.
pub(super) fn order_crowds<P: OnCurve>(points: &[P], keys: &mut [u64], layout: KeyLayout) {
    let crowds = keys.chunk_by_mut(|&a, &b| layout.cell(a) == layout.cell(b));
    for crowd in crowds.filter(|crowd| crowd.len() > CROWD) {
        let members = crowd.iter().map(|&key| points[layout.index(key)]);
        let grid = Grid::around(members, layout.grid_bits);
        if !grid.divides() {
            continue;
        }
        for key in crowd.iter_mut() {
            let index = layout.index(*key);
            let [place] = P::places(&[points[index]], &grid);
            *key = place << layout.index_bits | index as u64;
        }
        crowd.sort_unstable();
        order_crowds(points, crowd, layout);
    }
}
