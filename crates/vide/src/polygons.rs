//! Which parts of the plane polygons cover.
//!
//! ```text
//!    +-------+-------+     The rings of all polygons run along the edges between the parts. On a walk from part to part, each ring that
//!    |   A   |   B   |     is crossed leads into its polygon or out of it again. Of the border between A and B the rings of both are
//!    |   +---+---+   |     crossed at once: out of one and into the other. The part in the middle is a hole of both, unless there is
//!    +---+  hole +---+     a polygon for it.
//!    |   +---+---+   |
//!    +-------+-------+
//! ```

use std::collections::BTreeMap;

use delaunay_core::{Components, Constrained2, HalfEdgeId, VertexId};

/// By part, whether any polygon covers it; `rings` gives by segment the polygons whose rings run along it.
///
/// A polygon with several rings covers what an odd number of them surround. Takes n log n time.
pub(crate) fn covered(
    segments: &[[VertexId; 2]],
    rings: &[Vec<u32>],
    triangulation: &Constrained2,
    components: &Components,
) -> Vec<bool> {
    let mut walk = Walk {
        rings: rings_by_edge(segments, rings, triangulation),
        doors: doors(triangulation, components),
        within: vec![false; rings.iter().flatten().max().map_or(0, |&p| p as usize + 1)],
        depth: 0,
        covered: vec![None; components.count()],
    };
    walk.through_all(triangulation, components);
    let covered = walk.covered.into_iter();
    covered.map(|covered| covered == Some(true)).collect()
}

/// One of the two half-edges of an edge, the same from both.
fn edge(triangulation: &Constrained2, h: HalfEdgeId) -> HalfEdgeId {
    h.min(triangulation.mesh().twin(h))
}

/// Segments may lie on each other, so rings come together here that have no segment in common.
fn rings_by_edge(
    segments: &[[VertexId; 2]],
    rings: &[Vec<u32>],
    triangulation: &Constrained2,
) -> BTreeMap<HalfEdgeId, Vec<u32>> {
    let mut by_edge: BTreeMap<HalfEdgeId, Vec<u32>> = BTreeMap::new();
    for (&ends, rings) in segments.iter().zip(rings) {
        let chain = triangulation.chain(ends).unwrap_or_default();
        for piece in chain.windows(2) {
            if let Some(h) = triangulation.mesh().find_half_edge(piece[0], piece[1]) {
                let known = by_edge.entry(edge(triangulation, h)).or_default();
                known.extend(rings);
            }
        }
    }
    by_edge
}

/// By part, the half-edges in it that lead to others.
fn doors(triangulation: &Constrained2, components: &Components) -> Vec<Vec<HalfEdgeId>> {
    let mut doors = vec![Vec::new(); components.count()];
    let mesh = triangulation.mesh();
    for h in triangulation.constrained_edges() {
        for h in [h, mesh.twin(h)] {
            doors[components.of(h.face())].push(h);
        }
    }
    doors
}

/// A walk through all parts, with the polygons that it is within.
struct Walk {
    rings: BTreeMap<HalfEdgeId, Vec<u32>>,
    doors: Vec<Vec<HalfEdgeId>>,
    /// By polygon.
    within: Vec<bool>,
    /// How many polygons it is within.
    depth: usize,
    /// By part that has been reached.
    covered: Vec<Option<bool>>,
}

impl Walk {
    fn through_all(&mut self, triangulation: &Constrained2, components: &Components) {
        self.covered[0] = Some(false);
        // The parts on the way, each with the door that led into it and how many of its own have been tried.
        let mut way: Vec<(usize, Option<HalfEdgeId>, usize)> = vec![(0, None, 0)];
        while let Some((part, entry, tried)) = way.last_mut() {
            let Some(&door) = self.doors[*part].get(*tried) else {
                let entry = *entry;
                self.cross(entry);
                way.pop();
                continue;
            };
            *tried += 1;
            let beyond = components.of(triangulation.mesh().twin(door).face());
            if self.covered[beyond].is_none() {
                let door = Some(edge(triangulation, door));
                self.cross(door);
                self.covered[beyond] = Some(self.depth > 0);
                way.push((beyond, door, 0));
            }
        }
    }

    fn cross(&mut self, door: Option<HalfEdgeId>) {
        let rings = door.and_then(|edge| self.rings.get(&edge));
        for &polygon in rings.into_iter().flatten() {
            let within = &mut self.within[polygon as usize];
            *within = !*within;
            match *within {
                true => self.depth += 1,
                false => self.depth -= 1,
            }
        }
    }
}
