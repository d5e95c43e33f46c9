//! Smoothing: a vertex inside moves to where the worst tetrahedron of its star is best.

use crate::ascent::Ascent;
use crate::plan::Move;
use crate::quality::{min_sine, power_of_two};
use crate::records::Records;
use crate::stars::Stars;
use delaunay_core::{Complex3, VertexId};
use glam::DVec3;

/// Finds better places for vertices.
#[derive(Clone, Debug, Default)]
pub(crate) struct Smoother {
    pub(crate) stars: Stars,
    ascent: Ascent,
    link: Vec<[DVec3; 3]>,
}

impl Smoother {
    /// The best place found for `v`; that it is better than the old one is not said. `None` on the boundary.
    ///
    /// The star of `v` is the last of [`stars`](Self::stars) then.
    pub(crate) fn plan(
        &mut self,
        complex: &Complex3,
        records: &Records,
        v: VertexId,
        goal: f64,
    ) -> Option<Move> {
        if records.is_on_boundary(v) {
            return None;
        }
        let mesh = complex.mesh();
        self.link.clear();
        for &t in self.stars.of(mesh, v) {
            let facet = t.facet(mesh.corner_of(t, v)?);
            self.link
                .push(mesh.facet_vertices(facet).map(|w| complex.point(w)));
        }
        let place = climb(&mut self.ascent, &mut self.link, complex.point(v), goal);
        // The records will have the same numbers, to the last bit: the order of the corners is theirs.
        let with_v_there = |w: VertexId| if w == v { place } else { complex.point(w) };
        let star = self.stars.last().iter();
        let qualities = star.map(|&t| min_sine(mesh.tet_vertices(t).map(with_v_there)));
        Some(Move {
            vertex: v,
            place,
            quality: qualities.fold(f64::INFINITY, f64::min),
        })
    }
}

/// The best place found in the sight of `link`, triangles in the order of [`Ascent::climb`], from `start` on. The link
/// becomes relative to the start, in units of its size: so derivatives keep their digits wherever the mesh is.
pub(crate) fn climb(
    ascent: &mut Ascent,
    link: &mut [[DVec3; 3]],
    start: DVec3,
    goal: f64,
) -> DVec3 {
    let corners = link.as_flattened();
    let distances = corners.iter().map(|&p| (p - start).abs().max_element());
    let unit = power_of_two(distances.fold(0.0, f64::max));
    for p in link.as_flattened_mut() {
        *p = (*p - start) / unit;
    }
    start + unit * ascent.climb(link, DVec3::ZERO, goal)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample::{Frame, cube};

    #[test]
    fn vertices_inside_move_to_better_places_and_those_of_the_boundary_do_not() {
        for seed in 0..8 {
            let mut complex = cube(4, seed);
            let frame = Frame::of(&complex);
            let mut records = Records::of(&complex);
            let mut smoother = Smoother::default();
            let mut moved = 0;
            for v in (0..complex.points().len()).map(VertexId::new) {
                let plan = smoother.plan(&complex, &records, v, 1.0);
                assert_eq!(plan.is_none(), records.is_on_boundary(v));
                let Some(plan) = plan else { continue };
                let star = smoother.stars.last().to_vec();
                let before = records.worst(&star);
                assert!(plan.quality >= before * (1.0 - 1e-12));
                complex.move_vertex(v, plan.place).unwrap();
                records.note_change(&complex, &[], &star);
                assert_eq!(records.worst(&star), plan.quality);
                moved += usize::from(plan.quality > before * 1.01);
            }
            frame.assert_holds(&complex);
            assert!(moved > 15, "{moved} of 27");
        }
    }
}
