//! Voronoi cells carved out of a window by the bisectors to the Delaunay neighbours.
//!
//! The nearest neighbours come first: they make the cell small, and a bisector farther away than the farthest
//! corner, hence all that follow, cannot cut it. All coordinates are relative to the vertex of the cell,
//! where the bisectors round least.

use super::delaunay::Delaunay3;
use super::face_plane::FacePlane;
use super::polyhedron::{ConvexPolyhedron, Side};
use super::rim::Clipper;
use crate::ids::{TetId, VertexId};
use rustc_hash::FxHashSet;

/// Makes Voronoi cells, one at a time, in room that it keeps: after a few cells nothing is allocated.
///
/// For cells on several threads each has its own. See [`Voronoi3::carver`](super::dual::Voronoi3::carver).
#[derive(Clone, Debug)]
pub struct CellCarver<'a> {
    delaunay: &'a Delaunay3,
    window: &'a ConvexPolyhedron,
    cell: ConvexPolyhedron,
    clipper: Clipper,
    neighbors: Neighbors,
}

impl<'a> CellCarver<'a> {
    pub(super) fn new(delaunay: &'a Delaunay3, window: &'a ConvexPolyhedron) -> Self {
        Self {
            delaunay,
            window,
            cell: ConvexPolyhedron::default(),
            clipper: Clipper::default(),
            neighbors: Neighbors::default(),
        }
    }

    /// The cell of `v`: the part of the window that is nearer to `v` than to any other vertex.
    ///
    /// Empty when `v` is not a vertex or its cell lies outside the window.
    pub fn cell(&mut self, v: VertexId) -> &ConvexPolyhedron {
        if self.delaunay.contains_vertex(v) {
            self.carve(v);
        } else {
            self.cell.clear();
        }
        &self.cell
    }

    /// Gives the last cell away.
    #[must_use]
    pub fn into_cell(self) -> ConvexPolyhedron {
        self.cell
    }

    fn carve(&mut self, v: VertexId) {
        /// Twice the reach, squared, and some for rounding of the distances.
        const FAR: f64 = 4.0 + 1e-9;
        let center = self.delaunay.point(v);
        self.cell.assign(self.window, center);
        self.neighbors.gather(self.delaunay, v);
        let mut reach = Reach::of(&self.cell);
        for &(squared_distance, u) in &self.neighbors.nearest_first {
            if squared_distance > FAR * reach.squared {
                break;
            }
            let bisector = FacePlane::bisector(center, self.delaunay.point(u), center);
            if self
                .cell
                .cut(&bisector, Side::Neighbor(u), &mut self.clipper)
            {
                reach.shrink(&self.cell);
            }
        }
    }
}

/// A bound on the distance of the corners of a cell from its vertex.
struct Reach {
    squared: f64,
    cuts: usize,
}

impl Reach {
    fn of(cell: &ConvexPolyhedron) -> Self {
        let corners = cell.corners.iter();
        let squares = corners.map(|corner| (corner.place.abs() + corner.blur).length_squared());
        Self {
            squared: squares.fold(0.0, f64::max),
            cuts: 0,
        }
    }

    /// Takes note of a cut. Looks at all corners once in as many cuts as keep the time per cut constant; an
    /// old bound is still a bound.
    fn shrink(&mut self, cell: &ConvexPolyhedron) {
        self.cuts += 1;
        if 16 * self.cuts >= cell.corners.len() {
            *self = Self::of(cell);
        }
    }
}

/// The real neighbours of a vertex, and room to find them.
#[derive(Clone, Debug, Default)]
struct Neighbors {
    /// With their squared distances.
    nearest_first: Vec<(f64, VertexId)>,
    seen: FxHashSet<VertexId>,
    star: FxHashSet<TetId>,
    pending: Vec<TetId>,
}

impl Neighbors {
    /// Finds the neighbours of `v` by crossing facets through its star.
    fn gather(&mut self, delaunay: &Delaunay3, v: VertexId) {
        self.clear();
        let mesh = delaunay.mesh();
        let Some(home) = mesh.home(v) else { return };
        self.star.insert(home);
        self.pending.push(home);
        self.seen.insert(v);
        for u in mesh.tet_vertices(home) {
            self.see(delaunay, v, u);
        }
        while let Some(t) = self.pending.pop() {
            for f in t.facets() {
                let twin = mesh.twin(f);
                if mesh.apex(f) != v && self.star.insert(twin.tet()) {
                    self.pending.push(twin.tet());
                    self.see(delaunay, v, mesh.apex(twin));
                }
            }
        }
        let by_distance = |a: &(f64, VertexId), b: &(f64, VertexId)| a.0.total_cmp(&b.0);
        self.nearest_first
            .sort_unstable_by(|a, b| by_distance(a, b).then(a.1.cmp(&b.1)));
    }

    fn see(&mut self, delaunay: &Delaunay3, v: VertexId, u: VertexId) {
        if !u.is_ghost() && self.seen.insert(u) {
            let squared = delaunay.point(u).distance_squared(delaunay.point(v));
            self.nearest_first.push((squared, u));
        }
    }

    /// Empties the room, and gives back what a vertex of many neighbours needed: clearing it for every
    /// vertex that follows would take longer than finding theirs.
    fn clear(&mut self) {
        const USUAL: usize = 512;
        self.nearest_first.clear();
        self.pending.clear();
        self.seen.clear();
        self.star.clear();
        self.seen.shrink_to(USUAL);
        self.star.shrink_to(USUAL);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    fn capacities(carver: &CellCarver<'_>) -> [usize; 6] {
        let (cell, neighbors) = (&carver.cell, &carver.neighbors);
        [
            cell.corners.capacity(),
            cell.faces.capacity(),
            neighbors.nearest_first.capacity(),
            neighbors.pending.capacity(),
            neighbors.seen.capacity(),
            neighbors.star.capacity(),
        ]
    }

    #[test]
    fn a_second_round_of_cells_needs_no_more_room() {
        let scattered = |i: u32| (f64::from(i * i) * DVec3::new(0.1234, 0.2345, 0.3456)).fract();
        let points: Vec<DVec3> = (0..300).map(scattered).collect();
        let delaunay = Delaunay3::build(&points).unwrap();
        let window = ConvexPolyhedron::cuboid(DVec3::ZERO, DVec3::ONE).unwrap();
        let mut carver = CellCarver::new(&delaunay, &window);
        let mut round = || {
            for v in delaunay.vertices() {
                carver.cell(v);
            }
            capacities(&carver)
        };
        assert_eq!(round(), round());
    }
}
