//! Minimum separation, and how many vertices fit (§4.4).

use delaunay_core::Subcomplex2;
use delaunay_core::measure::triangle::{area, shortest_edge as shortest_of};
use std::f64::consts::PI;

/// How near vertices are to each other, and how many there can be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Separation2 {
    /// Length of the shortest edge before: δ. The paper's method never makes a shorter one, unless the boundary may be divided,
    /// when δ is an eighth of it, or a smaller size is asked for: then none is shorter than 1/√3 times the least size, or an
    /// eighth of that with both.
    pub given: f64,
    /// Length of the shortest edge after.
    pub reached: f64,
    /// A bound on the number of vertices that are δ apart: 4/(πδ²) times the area grown by δ/2. Infinite where doubles
    /// run out. With sizes asked for, of those that are as far apart as `reached`, if that is less.
    ///
    /// The paper prints 6/(πδ³) and the volume, for space. It is the same packing: disks of radius δ/2 round the vertices
    /// are disjoint, each takes the area πδ²/4, and all are inside the region grown by δ/2.
    pub vertex_bound: f64,
}

/// Length of the shortest edge; infinite when there is none.
pub(crate) fn shortest_edge(region: &Subcomplex2) -> f64 {
    let edges = region.faces().map(|f| shortest_of(region.triangle(f)));
    edges.fold(f64::INFINITY, f64::min)
}

/// How many vertices `separation` apart fit into the region (§4.4).
///
/// The region grown by δ/2 on all sides is at most its area, a strip along each boundary edge and a disk round each
/// boundary vertex.
pub(crate) fn vertex_bound(region: &Subcomplex2, separation: f64) -> f64 {
    let margin = separation / 2.0;
    let mut grown: f64 = region.faces().map(|f| area(region.triangle(f))).sum();
    for h in region.boundary() {
        let [a, b] = region.segment(h);
        // A boundary has no more vertices than edges.
        grown += a.distance(b) * margin + PI * margin * margin;
    }
    grown * 4.0 / (PI * separation * separation)
}
