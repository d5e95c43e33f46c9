//! A boundary facet, or a crease, is divided by a vertex put on it.
//!
//! A facet is divided at its circumcenter, unless that is inside the diametral sphere of a crease: then the crease is divided
//! first, in the middle. So corners of the boundary are cut off from the inside out, as in Ruppert's method in the plane.

use super::super::proposal::Proposal;
use super::super::refiner::Refiner;
use super::clearance::{Clearance, Pull};
use super::creases::{Creases, unit_normal};
use super::patch::{Way, way_to};
use crate::boundary::PARTS;
use crate::stop::Stop;
use delaunay_core::geo_predicates::{
    Sign, check_point3, in_diametral_ball, in_diametral_sphere, orient3d,
};
use delaunay_core::measure::facet::circumcenter;
use delaunay_core::{FacetId, Met, Subcomplex3, TetId, VertexId};
use glam::DVec3;
use rustc_hash::FxHashSet;

/// A point so near to the plane of a facet, in parts of its longest edge, counts as in it.
const FLAT: f64 = 1e-9;

/// What has to be known of a boundary to divide it.
#[derive(Debug)]
pub(super) struct Splitter {
    creases: Creases,
    clearance: Clearance,
    /// By vertex: the length of the shortest boundary edge there, as given; infinite inside.
    sizes: Vec<f64>,
    proposal: Proposal,
    disk: Vec<FacetId>,
    rim: Vec<[VertexId; 2]>,
}

impl Splitter {
    /// For a boundary with creases where it turns by more than so many degrees.
    pub(super) fn new(solid: &Subcomplex3, crease: f64) -> Self {
        let mut sizes = vec![f64::INFINITY; solid.points().len()];
        for f in solid.boundary() {
            for (edge, _) in solid.across_edges(f) {
                let [a, b] = edge.map(|v| solid.point(v));
                for v in edge {
                    sizes[v.index()] = sizes[v.index()].min(a.distance(b));
                }
            }
        }
        Self {
            creases: Creases::of(solid, crease),
            clearance: Clearance::default(),
            sizes,
            proposal: Proposal::default(),
            disk: Vec::new(),
            rim: Vec::new(),
        }
    }

    /// Divides a boundary facet, or a crease near it; tells whether it did.
    ///
    /// # Errors
    /// Why no more points are inserted.
    pub(super) fn split_facet(
        &mut self,
        refiner: &mut Refiner<'_>,
        f: FacetId,
    ) -> Result<bool, Stop> {
        refiner.count_test(None);
        let center = circumcenter(refiner.solid.triangle(f));
        match way_to(&refiner.solid, &self.creases, f, center) {
            Way::Crease(edge) => self.split_crease(refiner, edge),
            Way::Lost => Ok(false),
            Way::Facet(over, places) => {
                for place in places {
                    if self.split_at(refiner, over, place)? {
                        return Ok(true);
                    }
                }
                Ok(false)
            }
        }
    }

    /// Divides a boundary facet at a point, or instead a crease that the point would be too near to, if one can be; tells
    /// whether it did.
    fn split_at(
        &mut self,
        refiner: &mut Refiner<'_>,
        f: FacetId,
        point: DVec3,
    ) -> Result<bool, Stop> {
        let mut found = self.propose(refiner, point, &[f]);
        let around = match found {
            true => self.facets_around(&refiner.solid),
            false => vec![f],
        };
        let creases = self.encroached(&refiner.solid, point, around);
        for &edge in &creases {
            if self.split_crease(refiner, edge)? {
                return Ok(true);
            }
        }
        if !creases.is_empty() {
            // What was proposed last is the middle of a crease.
            found = self.propose(refiner, point, &[f]);
        }
        if found {
            self.insert(refiner)?;
        }
        Ok(found)
    }

    /// Divides a crease; tells whether it did.
    fn split_crease(
        &mut self,
        refiner: &mut Refiner<'_>,
        edge: [VertexId; 2],
    ) -> Result<bool, Stop> {
        let solid = &refiner.solid;
        let middle = self.creases.middle(solid, edge);
        let facets = facets_on(solid, edge);
        if facets.len() != 2 || !self.propose(refiner, middle, &facets) {
            return Ok(false);
        }
        let vertex = self.insert(refiner)?;
        self.creases.divide(edge, vertex);
        Ok(true)
    }

    /// Finds what has to give way when a point near the facets `first` becomes a vertex of the boundary; tells whether it may.
    fn propose(&mut self, refiner: &Refiner<'_>, point: DVec3, first: &[FacetId]) -> bool {
        let solid = &refiner.solid;
        if check_point3(0, point).is_err() {
            return false;
        }
        self.proposal.point = point;
        let creases = &self.creases;
        let joins = |met: Met| {
            let is_smooth = met.across.is_none_or(|edge| !creases.contain(edge));
            is_smooth && gives_way(solid, met, point)
        };
        if !solid.dig_on(point, first, joins, &mut self.proposal.prestar) {
            return false;
        }
        self.list_disk(solid);
        let allowed = first
            .iter()
            .map(|f| refiner.records.largest_radius(solid, f.tet()));
        let least = allowed.fold(self.size(), f64::min) / PARTS;
        self.keeps_separation(solid, least)
            && self.clearance.is_given(
                solid,
                Pull {
                    point,
                    disk: &self.disk,
                    rim: &self.rim,
                },
            )
    }

    /// Lists the boundary facets that would give way, and the edges round them.
    fn list_disk(&mut self, solid: &Subcomplex3) {
        self.disk.clear();
        self.disk
            .extend(facets_under(solid, self.proposal.prestar.tets()));
        self.rim.clear();
        let on_disk: FxHashSet<FacetId> = self.disk.iter().copied().collect();
        for &f in &self.disk {
            let across = solid.across_edges(f);
            let rim = across.filter(|(_, beyond)| !on_disk.contains(beyond));
            self.rim.extend(rim.map(|(edge, _)| edge));
        }
    }

    /// Whether the point is at least so far from all vertices round it.
    fn keeps_separation(&self, solid: &Subcomplex3, least: f64) -> bool {
        let outer = self.proposal.prestar.boundary().iter();
        let mut round = outer.flat_map(|&f| solid.mesh().facet_vertices(f));
        round.all(|v| v.is_ghost() || solid.point(v).distance(self.proposal.point) >= least)
    }

    /// The least size at a vertex round the disk.
    fn size(&self) -> f64 {
        let round = self.rim.iter().flatten().map(|v| self.sizes[v.index()]);
        round.fold(f64::INFINITY, f64::min)
    }

    /// The boundary facets of the prestar and round it.
    fn facets_around(&self, solid: &Subcomplex3) -> Vec<FacetId> {
        let mesh = solid.mesh();
        let outer = self.proposal.prestar.boundary().iter();
        let bases = outer.filter(|f| mesh.is_ghost_tet(f.tet()) && f.corner() == 3);
        let around = bases.map(|&base| mesh.twin(base));
        around.chain(self.disk.iter().copied()).collect()
    }

    /// The creases of boundary facets that have the point inside their diametral spheres or on them.
    fn encroached(
        &self,
        solid: &Subcomplex3,
        point: DVec3,
        facets: Vec<FacetId>,
    ) -> Vec<[VertexId; 2]> {
        let edges = facets.into_iter().flat_map(|f| solid.across_edges(f));
        let mut encroached: Vec<[VertexId; 2]> = edges
            .map(|(edge, _)| edge)
            .filter(|&edge| self.creases.contain(edge))
            .filter(|edge| {
                let [a, b] = edge.map(|v| solid.point(v));
                in_diametral_sphere(a, b, point) != Sign::Negative
            })
            .map(|[a, b]| [a.min(b), a.max(b)])
            .collect();
        encroached.sort_unstable();
        encroached.dedup();
        encroached
    }

    /// Inserts the point proposed.
    fn insert(&mut self, refiner: &mut Refiner<'_>) -> Result<VertexId, Stop> {
        let size = self.size();
        self.clearance.forget(&refiner.solid, &self.disk);
        let vertex = refiner.insert_on_boundary(&mut self.proposal, self.disk[0])?;
        let solid = &refiner.solid;
        self.sizes.resize(solid.points().len(), f64::INFINITY);
        self.sizes[vertex.index()] = size;
        let new = facets_under(solid, self.proposal.prestar.tets());
        self.clearance.note(solid, new);
        Ok(vertex)
    }
}

/// Whether a boundary facet gives way to a point.
///
/// It has to when the point is inside its diametral sphere, and when the tetrahedron inside gives way and the point is outside the
/// facet, or so near to its plane that the tetrahedron between the two would be flat. When the tetrahedron inside stays, the
/// new one on top must not be flat.
fn gives_way(solid: &Subcomplex3, met: Met, p: DVec3) -> bool {
    let [a, b, c] = solid.triangle(met.facet);
    let longest = [b - a, c - b, a - c].map(DVec3::length);
    let longest = longest.into_iter().fold(0.0, f64::max);
    let height = unit_normal([a, b, c]).dot(p - a);
    let is_flat = height.abs() <= FLAT * longest;
    let is_inside = in_diametral_ball(a, b, c, p) != Sign::Negative;
    match met.opens {
        true => {
            is_inside || is_flat || met.across.is_none() || orient3d(a, b, c, p) != Sign::Negative
        }
        false => is_inside && !is_flat,
    }
}

/// The boundary facets on an edge, in order round it.
fn facets_on(solid: &Subcomplex3, [a, b]: [VertexId; 2]) -> Vec<FacetId> {
    let mesh = solid.mesh();
    let Some(t) = mesh.find_edge(a, b) else {
        return Vec::new();
    };
    let ring: Vec<TetId> = mesh.ring(t, a, b).collect();
    facets_under(solid, &ring).collect()
}

/// The boundary facets of the ghosts among tetrahedra.
fn facets_under(solid: &Subcomplex3, tets: &[TetId]) -> impl Iterator<Item = FacetId> {
    let ghosts = tets.iter().filter(|&&t| solid.mesh().is_ghost_tet(t));
    ghosts.map(|&ghost| solid.facet_under(ghost))
}
