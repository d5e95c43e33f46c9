//! What may be done for a tetrahedron: each function makes one change, the best of its kind or the first that helps, and
//! tells whether there was one.

use crate::improver::Improver;
use crate::plan::Exchange;
use crate::records::Moment;
use crate::ring::EDGES;
use crate::{contraction, edge_removal, face_removal};
use delaunay_core::{FacetId, TetId, VertexId};
use glam::DVec3;

impl Improver<'_> {
    /// Makes the best exchange that makes `t`, or a worse one round it, better; tells whether there was one.
    ///
    /// At `since` there was none; so exchanges are only tried where something has changed since.
    pub(crate) fn exchange_at(&mut self, t: TetId, since: Moment) -> bool {
        self.remove_edge(t, since) || self.remove_facet(t, since)
    }

    fn remove_edge(&mut self, t: TetId, since: Moment) -> bool {
        let corners = self.complex.mesh().tet_vertices(t);
        let is_news = |v: VertexId| self.records.is_news(v, since);
        let edges = (0..6).filter(|&edge| {
            let [i, j, _, _] = EDGES[edge];
            is_news(corners[i]) && is_news(corners[j])
        });
        let plans =
            edges.filter_map(|edge| edge_removal::plan(&self.complex, &self.records, t, edge));
        let made = best(plans).is_some_and(|plan| self.exchange(&plan));
        self.counters.edges_removed += usize::from(made);
        made
    }

    fn remove_facet(&mut self, t: TetId, since: Moment) -> bool {
        let mesh = self.complex.mesh();
        let inside = |f: &FacetId| !self.complex.is_boundary(*f);
        let is_news = |f: &FacetId| {
            let ends = [*f, mesh.twin(*f)].map(|f| mesh.apex(f));
            ends.into_iter().any(|v| self.records.is_news(v, since))
        };
        let facets = t.facets().into_iter().filter(inside).filter(is_news);
        let plans = facets.filter_map(|f| face_removal::plan(&self.complex, &self.records, f));
        let made = best(plans).is_some_and(|plan| self.exchange(&plan));
        self.counters.facets_removed += usize::from(made);
        made
    }

    /// Moves a corner to a better place.
    pub(crate) fn move_corner(&mut self, t: TetId) -> bool {
        for v in self.complex.mesh().tet_vertices(t) {
            if self.records.is_settled(v) {
                continue;
            }
            let plan = self
                .smoother
                .plan(&self.complex, &self.records, v, self.goal);
            if plan.is_some_and(|plan| self.carry_out(plan)) {
                self.counters.moves += 1;
                return true;
            }
            self.records.settle(v);
        }
        false
    }

    /// Moves a corner onto another one.
    pub(crate) fn contract_edge(&mut self, t: TetId) -> bool {
        let corners = self.complex.mesh().tet_vertices(t);
        let stars = &mut self.smoother.stars;
        let mut plans = Vec::new();
        for v in corners {
            for onto in corners.into_iter().filter(|&w| w != v) {
                plans.extend(contraction::plan(
                    &self.complex,
                    &self.records,
                    stars,
                    [v, onto],
                ));
            }
        }
        let made = best(plans).is_some_and(|plan| self.exchange(&plan));
        self.counters.contractions += usize::from(made);
        made
    }

    /// Inserts a vertex, found from the middle of `t` or of one of its edges: a tetrahedron with all corners on the boundary
    /// mostly goes together with others round an edge only.
    pub(crate) fn insert_vertex(&mut self, t: TetId) -> bool {
        let corners = self.complex.tetrahedron(t);
        let center = corners.into_iter().sum::<DVec3>() / 4.0;
        let middles = EDGES.map(|[i, j, _, _]| corners[i].midpoint(corners[j]));
        let mut starts = [center].into_iter().chain(middles);
        let made = starts.any(|start| {
            let plan = self.inserter.plan(&self.complex, t, start, self.goal);
            plan.is_some_and(|plan| self.insert(&plan))
        });
        self.counters.insertions += usize::from(made);
        made
    }
}

/// The one that makes the best tetrahedra; of equal ones the last.
fn best(plans: impl IntoIterator<Item = Exchange>) -> Option<Exchange> {
    let plans = plans.into_iter();
    plans.max_by(|a, b| a.quality.total_cmp(&b.quality))
}
