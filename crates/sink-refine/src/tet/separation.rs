//! Minimum separation, and how many vertices fit (§4.4).

use delaunay_core::measure::facet::area;
use delaunay_core::measure::tetrahedron::{EDGES, signed_volume};
use delaunay_core::{Subcomplex3, TetId};
use rayon::prelude::*;
use std::f64::consts::PI;

/// How near vertices are to each other, and how many there can be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Separation3 {
    /// Length of the shortest edge before: δ. The paper's method never makes a shorter one, unless the boundary may be divided,
    /// when δ is an eighth of it, or a smaller size is asked for: then none is shorter than √6/4 times the least size, or an
    /// eighth of that with both.
    pub given: f64,
    /// Length of the shortest edge after.
    pub reached: f64,
    /// A bound on the number of vertices that are δ apart: 6/(πδ³) times the volume grown by δ/2. Infinite where doubles
    /// run out. With sizes asked for, of those that are as far apart as `reached`, if that is less.
    pub vertex_bound: f64,
}

/// Length of the shortest edge; infinite when there is none.
pub(crate) fn shortest_edge(solid: &Subcomplex3) -> f64 {
    let of_tet = |t| {
        let corners = solid.tetrahedron(t);
        let squares = EDGES.map(|[a, b, ..]| corners[a].distance_squared(corners[b]));
        squares.into_iter().fold(f64::INFINITY, f64::min)
    };
    let least = by_chunks(solid, |tets| tets.map(of_tet).fold(f64::INFINITY, f64::min));
    least.into_iter().fold(f64::INFINITY, f64::min).sqrt()
}

/// How many vertices `separation` apart fit into the solid (§4.4).
///
/// The solid grown by δ/2 on all sides is at most its volume, a slab on each boundary facet, a cylinder round each
/// boundary edge and a ball round each boundary vertex.
pub(crate) fn vertex_bound(solid: &Subcomplex3, separation: f64) -> f64 {
    let of_tet = |t| signed_volume(solid.tetrahedron(t));
    let volumes = by_chunks(solid, |tets| tets.map(of_tet).sum::<f64>());
    let volume: f64 = volumes.into_iter().sum();
    let margin = separation / 2.0;
    let (mut slabs, mut cylinders, mut facets) = (0.0, 0.0, 0.0);
    for f in solid.boundary() {
        let [a, b, c] = solid.triangle(f);
        slabs += area([a, b, c]) * margin;
        // Each edge is met from two facets.
        let edges = a.distance(b) + b.distance(c) + c.distance(a);
        cylinders += edges / 2.0 * PI * margin * margin;
        facets += 1.0;
    }
    // Three corners for each facet: more than there are vertices.
    let balls = 3.0 * facets * 4.0 / 3.0 * PI * margin.powi(3);
    6.0 / (PI * separation.powi(3)) * (volume + slabs + cylinders + balls)
}

/// What `measure` makes of tetrahedra, always so many together; on all threads.
fn by_chunks<T: Send>(
    solid: &Subcomplex3,
    measure: impl Fn(&mut dyn Iterator<Item = TetId>) -> T + Sync,
) -> Vec<T> {
    const CHUNK: usize = 1 << 12;
    let slots = solid.mesh().tet_slots();
    let starts = (0..slots.div_ceil(CHUNK)).into_par_iter();
    let chunks = starts.map(|chunk| {
        let ids = chunk * CHUNK..slots.min((chunk + 1) * CHUNK);
        let mut tets = ids
            .map(TetId::new)
            .filter(|&t| solid.mesh().contains_tet(t) && !solid.mesh().is_ghost_tet(t));
        measure(&mut tets)
    });
    chunks.collect()
}
