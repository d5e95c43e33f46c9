//! Nearby node bubbles (§3.3): those up to three edges away in the mesh that was generated.
//!
//! ```text
//!        3   3   3   3         The node itself is none of them. They are found once: while nodes move,
//!      3   2   2   2   3       their neighborhoods change so little that the lists stay good.
//!    3   2   1   1   2   3
//!      2   1   ·   1   2       In a mesh of equilateral triangles there are 6 + 12 + 18.
//! ```

use std::ops::ControlFlow;

use delaunay_core::progress::{Cancelled, Meter, Progress};
use delaunay_core::{Subcomplex2, TriMesh, VertexId};

use super::bubbles::Order;

/// How many edges away a node may be.
pub const RINGS: usize = 3;

/// For each interior node the numbers of the nodes nearby, in the order of their vertices.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Nearby {
    /// By interior node, where its list starts; one more at the end.
    starts: Vec<usize>,
    nodes: Vec<u32>,
}

impl Nearby {
    /// The lists of the nodes with numbers from `first` on. Takes time proportional to the sum of the degrees of all nodes
    /// listed.
    ///
    /// # Errors
    /// When `report` stops the search.
    pub(super) fn of(
        mesh: &TriMesh,
        order: &Order,
        first: usize,
        report: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Self, Cancelled> {
        let interior = &order.vertices[first..];
        let mut meter = Meter::start(report, "nearby", interior.len())?;
        let mut survey = Survey::new(mesh, order.vertices.len());
        let mut nearby = Self {
            starts: vec![0],
            nodes: Vec::new(),
        };
        for &node in interior {
            meter.advance()?;
            let found = survey.around(node);
            found.sort_unstable();
            nearby.nodes.extend(found.iter().map(|&v| order.number(v)));
            nearby.starts.push(nearby.nodes.len());
        }
        Ok(nearby)
    }

    /// The nodes near the interior node with this number, counted from the first interior node.
    pub(super) fn list(&self, interior: usize) -> &[u32] {
        &self.nodes[self.starts[interior]..self.starts[interior + 1]]
    }
}

/// The nodes of each level near a vertex: one edge away, two and three.
///
/// In no particular order within a level; none for what is no vertex. Takes time proportional to the number of vertices.
#[must_use]
pub fn rings(region: &Subcomplex2, node: VertexId) -> [Vec<VertexId>; RINGS] {
    let mut survey = Survey::new(region.mesh(), region.points().len());
    survey.around(node);
    let ends = survey.ends;
    let ring = |level: usize| survey.found[ends[level]..ends[level + 1]].to_vec();
    std::array::from_fn(ring)
}

/// Breadth-first search from one node after the other.
struct Survey<'a> {
    mesh: &'a TriMesh,
    /// By vertex, the search that has met it last.
    met: Vec<u32>,
    search: u32,
    /// The start, then level by level.
    found: Vec<VertexId>,
    /// Where each level ends in `found`, from level 0 on.
    ends: [usize; RINGS + 1],
}

impl<'a> Survey<'a> {
    fn new(mesh: &'a TriMesh, count: usize) -> Self {
        Self {
            mesh,
            met: vec![0; count],
            search: 0,
            found: Vec::new(),
            ends: [0; RINGS + 1],
        }
    }

    fn around(&mut self, node: VertexId) -> &mut [VertexId] {
        self.search += 1;
        self.found.clear();
        self.meet(node);
        self.ends[0] = self.found.len();
        let mut done = 0;
        for level in 1..=RINGS {
            for at in done..self.ends[level - 1] {
                for neighbor in self.mesh.neighbors(self.found[at]) {
                    if !neighbor.is_ghost() {
                        self.meet(neighbor);
                    }
                }
            }
            done = self.ends[level - 1];
            self.ends[level] = self.found.len();
        }
        self.found.get_mut(1..).unwrap_or_default()
    }

    fn meet(&mut self, v: VertexId) {
        if let Some(met) = self.met.get_mut(v.index())
            && *met != self.search
        {
            *met = self.search;
            self.found.push(v);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use delaunay_core::Delaunay2;
    use delaunay_core::progress::silent;
    use glam::DVec2;

    /// A piece of the lattice of equilateral triangles, the node in its middle first.
    fn lattice() -> Subcomplex2 {
        let steps = (-6..=6).flat_map(|i: i32| (-6..=6).map(move |j: i32| [i, j]));
        let mut steps: Vec<[i32; 2]> = steps.filter(|[i, j]| (i + j).abs() <= 6).collect();
        steps.sort_by_key(|[i, j]| i * i + i * j + j * j);
        let place = |[i, j]: [i32; 2]| {
            let [i, j] = [i, j].map(f64::from);
            DVec2::new(i + j / 2.0, j * 0.75f64.sqrt())
        };
        let points: Vec<DVec2> = steps.into_iter().map(place).collect();
        Subcomplex2::of(&Delaunay2::build(&points).unwrap(), |_| true)
    }

    #[test]
    fn a_lattice_has_rings_of_6_12_and_18() {
        let region = lattice();
        let rings = rings(&region, VertexId::new(0));
        assert_eq!(rings.each_ref().map(Vec::len), [6, 12, 18]);
        let distances = rings.map(|ring| {
            let lengths = ring.iter().map(|&v| region.point(v).length());
            lengths.fold(0.0, f64::max).round() as usize
        });
        assert_eq!(distances, [1, 2, 3]);
    }

    #[test]
    fn what_is_no_vertex_has_nothing_nearby() {
        for v in [VertexId::new(1000), VertexId::GHOST] {
            assert_eq!(rings(&lattice(), v).concat(), []);
        }
    }

    #[test]
    fn lists_are_the_rings_by_vertex() {
        let region = lattice();
        let order = Order::breadth_first(region.mesh(), 40, region.points().len());
        let nearby = Nearby::of(region.mesh(), &order, 40, &mut silent).unwrap();
        for (number, &node) in order.vertices[40..].iter().enumerate() {
            let mut all = rings(&region, node).concat();
            all.sort_unstable();
            assert!(!all.contains(&node));
            let listed = nearby.list(number).iter();
            let listed: Vec<VertexId> = listed.map(|&k| order.vertices[k as usize]).collect();
            assert_eq!(listed, all);
        }
    }
}
