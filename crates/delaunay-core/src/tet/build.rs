//! All points at once, in spatial order.
//!
//! The points are copied in the order of insertion (see [`crate::order`]) and numbered so while the
//! triangulation grows, which keeps what is used together near in memory; at the end the tetrahedra
//! take the caller's numbers.

use super::cavity::Cavity3;
use super::coplanar;
use super::delaunay::Delaunay3;
use super::locate::{Location3, walk};
use super::mesh::TetMesh;
use super::sight::Sight3;
use super::simplex::{first_simplex, glue_simplex};
use crate::error::BuildError;
use crate::ids::{TetId, VertexId};
use crate::progress::{Meter, Progress, silent};
use crate::tri::Duplicates;
use geo_predicates::check_points3;
use geo_predicates::filter::Filter3;
use glam::DVec3;
use std::ops::ControlFlow;

impl Delaunay3 {
    /// The Delaunay triangulation of `points`; point `i` is vertex `i`.
    ///
    /// Repeated points are vertices once, see [`duplicates`](Self::duplicates). Expected time
    /// n log n where the number of tetrahedra is linear, memory about 250 bytes per point when done.
    ///
    /// # Errors
    /// - [`BuildError::Coordinate`] when a coordinate is not accepted: which point, axis and value;
    /// - [`BuildError::TooManyPoints`] beyond [`MAX_POINTS`](Self::MAX_POINTS);
    /// - [`BuildError::TooManyTets`] when the tetrahedra outgrow their ids or the memory;
    /// - [`BuildError::Flat`] when the points span no tetrahedron: what they are instead, for points on
    ///   a plane with their triangulation.
    pub fn build(points: &[DVec3]) -> Result<Self, BuildError> {
        Self::build_with(points, &mut silent)
    }

    /// As [`build`](Self::build), reporting progress to `report`, which can stop the work.
    ///
    /// # Errors
    /// As [`build`](Self::build), and [`BuildError::Cancelled`] when `report` says so.
    pub fn build_with(
        points: &[DVec3],
        report: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Self, BuildError> {
        if points.len() > Self::MAX_POINTS {
            return Err(BuildError::TooManyPoints {
                count: points.len(),
                limit: Self::MAX_POINTS,
            });
        }
        check_points3(points)?;
        let mut meter = Meter::start(report, "tetrahedralize", points.len())?;
        Self::grow(points, &mut meter)
    }

    /// The triangulation of accepted points.
    pub(super) fn grow(points: &[DVec3], meter: &mut Meter<'_>) -> Result<Self, BuildError> {
        let order = insertion_order(points);
        let coords = in_order(points, &order);
        let simplex = match first_simplex(&coords) {
            Ok(simplex) => simplex,
            Err(cause) => {
                let flat = coplanar::describe(points, &cause, meter)?;
                return Err(BuildError::Flat(Box::new(flat)));
            }
        };
        let mut delaunay = Self::of_simplex(coords, simplex);
        let duplicates = delaunay.insert_rest(simplex, meter)?;
        delaunay.renumber(points, &order, duplicates);
        Ok(delaunay)
    }

    /// The triangulation of four of the coordinates, right-handed.
    fn of_simplex(coords: Vec<DVec3>, simplex: [VertexId; 4]) -> Self {
        let mut mesh = TetMesh::default();
        glue_simplex(&mut mesh, simplex);
        Self {
            filter: Filter3::for_points(&coords[1..]),
            coords,
            mesh,
            duplicates: Duplicates::default(),
            vacant: Vec::new(),
            vertex_count: 4,
            cavity: Cavity3::default(),
        }
    }

    /// Inserts every vertex but those of `simplex`; gives pairs (duplicate, its vertex).
    fn insert_rest(
        &mut self,
        simplex: [VertexId; 4],
        meter: &mut Meter<'_>,
    ) -> Result<Vec<(VertexId, VertexId)>, BuildError> {
        let mut duplicates = Vec::new();
        let mut cavity = Cavity3::default();
        let mut start = TetId::new(0);
        for slot in 1..self.coords.len() {
            meter.advance()?;
            let v = VertexId::from_slot(slot);
            if simplex.contains(&v) {
                continue;
            }
            let p = self.coords[slot];
            let sight = Sight3::new(&self.coords, self.filter, p);
            let seed = match walk(&self.mesh, &sight, start) {
                Location3::Vertex(vertex) => {
                    duplicates.push((v, vertex));
                    continue;
                }
                Location3::Tet(tet) | Location3::Edge { tet, .. } => tet,
                Location3::Facet(f) => f.tet(),
                Location3::Outside(f) => self.mesh.twin(f).tet(),
            };
            cavity.dig(&self.mesh, seed, |t| sight.in_conflict(&self.mesh, t));
            if !self.mesh.fill(&mut cavity, v) {
                let tets = self.mesh.tet_count();
                return Err(BuildError::TooManyTets { tets });
            }
            self.vertex_count += 1;
            start = cavity.tets[0];
        }
        Ok(duplicates)
    }

    /// Passes from numbers in insertion order to the caller's; of equal points the smallest
    /// number stands for all.
    fn renumber(&mut self, points: &[DVec3], order: &[u32], pairs: Vec<(VertexId, VertexId)>) {
        let given = order.iter().map(|&index| VertexId::new(index as usize));
        let mut names: Vec<VertexId> = [VertexId::GHOST].into_iter().chain(given).collect();
        for (duplicate, vertex) in &pairs {
            if names[duplicate.slot()] < names[vertex.slot()] {
                names.swap(duplicate.slot(), vertex.slot());
            }
        }
        let named = pairs
            .into_iter()
            .map(|(duplicate, vertex)| (names[duplicate.slot()], names[vertex.slot()]));
        self.duplicates = Duplicates::from_pairs(named.collect());
        self.mesh.compact();
        self.mesh.rename_vertices(&names);
        self.mesh.index_vertices(self.coords.len());
        self.coords
            .splice(1.., points.iter().map(|&p| p + DVec3::ZERO));
        self.filter = Filter3::GENERAL;
    }
}

/// The points in insertion order behind the ghost; `-0.0` becomes `0.0`.
fn in_order(points: &[DVec3], order: &[u32]) -> Vec<DVec3> {
    let mut coords = Vec::with_capacity(points.len() + 1);
    coords.push(DVec3::NAN);
    coords.extend(
        order
            .iter()
            .map(|&index| points[index as usize] + DVec3::ZERO),
    );
    coords
}

/// Stand-in until the spatial order serves space: the points in a scrambled order.
fn insertion_order(points: &[DVec3]) -> Vec<u32> {
    let mut order: Vec<u32> = (0..points.len() as u32).collect();
    order.sort_by_key(|&i| (i.wrapping_mul(0x9E37_79B9), i));
    order
}
