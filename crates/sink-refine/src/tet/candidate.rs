//! The points to insert for a tetrahedron of low quality: its sinks or its circumcenter.

use super::flow::FlowWalk;
use super::records::Records;
use super::watershed::Watersheds;
use crate::params::Candidate;
use crate::stamp::Stamp;
use delaunay_core::measure::tetrahedron::circumcenter;
use delaunay_core::{Subcomplex3, TetId};
use glam::DVec3;
use rayon::prelude::*;

/// The circumcenter of a tetrahedron: of one of low quality, or of a sink tetrahedron.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Site {
    pub(crate) tet: TetId,
    pub(crate) stamp: Stamp,
}

impl Site {
    pub(crate) fn of(tet: TetId, records: &Records<'_>) -> Self {
        let stamp = records.stamp(tet);
        Self { tet, stamp }
    }

    /// Whether its tetrahedron is still there.
    pub(crate) fn is_there(&self, records: &Records<'_>) -> bool {
        records.stamp(self.tet) == self.stamp
    }

    /// The circumsphere of its tetrahedron.
    pub(crate) fn sphere(&self, solid: &Subcomplex3) -> (DVec3, f64) {
        let corners = solid.tetrahedron(self.tet);
        let center = circumcenter(corners);
        (center, center.distance(corners[0]))
    }

    pub(crate) fn point(&self, solid: &Subcomplex3) -> DVec3 {
        circumcenter(solid.tetrahedron(self.tet))
    }
}

/// Finds candidates, and remembers which were rejected: a point inside the diametral sphere of a boundary facet stays
/// there as long as its tetrahedron does.
#[derive(Clone, Debug)]
pub(crate) struct Candidates {
    kind: Candidate,
    /// By tetrahedron.
    rejected: Vec<Option<Stamp>>,
    watersheds: Watersheds,
}

impl Candidates {
    pub(crate) fn new(kind: Candidate) -> Self {
        Self {
            kind,
            rejected: Vec::new(),
            watersheds: Watersheds::default(),
        }
    }

    /// Whether candidates may be outside of their tetrahedra.
    pub(crate) fn are_far_away(&self) -> bool {
        self.kind == Candidate::Circumcenter
    }

    /// The candidates of a tetrahedron that have not been rejected.
    pub(crate) fn of<'a>(
        &'a self,
        solid: &Subcomplex3,
        records: &'a Records<'_>,
        walk: &'a mut FlowWalk,
        t: TetId,
    ) -> impl Iterator<Item = Site> + 'a {
        let tets = match self.kind {
            Candidate::Circumcenter => walk.stay(t),
            Candidate::Sink => walk.follow(solid, t, |t| records.flow(t)),
        };
        let sites = tets.iter().map(|&tet| Site::of(tet, records));
        sites.filter(|site| !self.is_rejected(site))
    }

    /// The candidates of all tetrahedra of low quality, rejected or not, each once; those of the worst tetrahedra first.
    pub(crate) fn all(&mut self, solid: &Subcomplex3, records: &Records<'_>) -> Vec<Site> {
        let mut found = match self.kind {
            Candidate::Sink => self.watersheds.sinks(solid, records),
            Candidate::Circumcenter => records.all_low().collect(),
        };
        found.par_sort_unstable_by(|(s, r), (t, q)| q.total_cmp(r).then(s.cmp(t)));
        let sites = found.into_iter().map(|(tet, _)| Site::of(tet, records));
        sites.collect()
    }

    pub(crate) fn reject(&mut self, site: Site) {
        let index = site.tet.index();
        if self.rejected.len() <= index {
            self.rejected.resize(index + 1, None);
        }
        self.rejected[index] = Some(site.stamp);
    }

    pub(crate) fn is_rejected(&self, site: &Site) -> bool {
        self.rejected.get(site.tet.index()) == Some(&Some(site.stamp))
    }
}
