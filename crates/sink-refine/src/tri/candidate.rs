//! The point to insert for a triangle of low quality: its sink or its circumcenter.

use super::flow::sink_triangle;
use super::records::Records;
use crate::params::Candidate;
use crate::stamp::Stamp;
use delaunay_core::measure::triangle::circumcenter;
use delaunay_core::{FaceId, Subcomplex2};
use glam::DVec2;
use rayon::prelude::*;

/// The circumcenter of a triangle: of one of low quality, or of a sink triangle.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Site {
    pub(crate) face: FaceId,
    pub(crate) stamp: Stamp,
}

impl Site {
    /// Whether its triangle is still there.
    pub(crate) fn is_there(&self, records: &Records<'_>) -> bool {
        records.stamp(self.face) == self.stamp
    }

    pub(crate) fn point(&self, region: &Subcomplex2) -> DVec2 {
        circumcenter(region.triangle(self.face))
    }
}

/// Finds candidates, and remembers which were rejected: a point inside the diametral circle of a boundary edge stays
/// there as long as its triangle does.
#[derive(Clone, Debug)]
pub(crate) struct Candidates {
    kind: Candidate,
    /// By face.
    rejected: Vec<Option<Stamp>>,
}

impl Candidates {
    pub(crate) fn new(kind: Candidate) -> Self {
        Self {
            kind,
            rejected: Vec::new(),
        }
    }

    /// The candidate of a triangle, unless the flow leaves or it has been rejected.
    pub(crate) fn of(
        &self,
        region: &Subcomplex2,
        records: &Records<'_>,
        f: FaceId,
    ) -> Option<Site> {
        let site = self.any_of(region, records, f)?;
        (!self.is_rejected(&site)).then_some(site)
    }

    /// The candidate of a triangle, rejected or not, unless the flow leaves.
    fn any_of(&self, region: &Subcomplex2, records: &Records<'_>, f: FaceId) -> Option<Site> {
        let face = match self.kind {
            Candidate::Circumcenter => f,
            Candidate::Sink => sink_triangle(region.mesh(), f, |f| records.exit(f))?,
        };
        let stamp = records.stamp(face);
        Some(Site { face, stamp })
    }

    /// The candidates of all triangles of low quality, rejected or not, each once; those of the worst triangles first.
    pub(crate) fn all(&self, region: &Subcomplex2, records: &Records<'_>) -> Vec<Site> {
        let faces = 0..records.slots();
        let found: Vec<(Site, f64)> = faces
            .into_par_iter()
            .map(FaceId::new)
            .filter(|&f| records.is_low(f))
            .filter_map(|f| Some((self.any_of(region, records, f)?, records.badness(f))))
            .collect();
        let mut worst = vec![0.0_f64; records.slots()];
        let mut sites = Vec::new();
        for (site, badness) in found {
            let known = &mut worst[site.face.index()];
            if *known == 0.0 {
                sites.push(site);
            }
            *known = known.max(badness);
        }
        let worst = |site: &Site| worst[site.face.index()];
        sites.par_sort_unstable_by(|a, b| worst(b).total_cmp(&worst(a)).then(a.face.cmp(&b.face)));
        sites
    }

    pub(crate) fn reject(&mut self, site: Site) {
        let index = site.face.index();
        if self.rejected.len() <= index {
            self.rejected.resize(index + 1, None);
        }
        self.rejected[index] = Some(site.stamp);
    }

    pub(crate) fn is_rejected(&self, site: &Site) -> bool {
        self.rejected.get(site.face.index()) == Some(&Some(site.stamp))
    }
}
