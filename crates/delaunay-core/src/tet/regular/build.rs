//! All weighted points, in spatial order (Edelsbrunner and Shah 1996, *Incremental topological flipping
//! works for regular triangulations*; here with cavities in place of flips).
//!
//! A point above the lower hull of those before it is hidden: it is in conflict with no tetrahedron, the one
//! that contains it would be the first. It stays hidden, because further points only lower the hull. A
//! new vertex may hide old ones: those are swallowed, all tetrahedra round them are in the cavity.

use super::Regular3;
use super::sight::PowerSight3;
use crate::error::{BuildError, RegularError};
use crate::heaviest::Heaviest;
use crate::ids::{TetId, VertexId};
use crate::order::insertion_order;
use crate::progress::{Meter, Progress, silent};
use crate::tet::cavity::Cavity3;
use crate::tet::coplanar;
use crate::tet::locate::walk;
use crate::tet::mesh::TetMesh;
use crate::tet::simplex::{FlatCause, first_simplex, glue_simplex};
use crate::tri::{Duplicates, Flat};
use geo_predicates::{check_points3, check_weights};
use glam::DVec3;
use std::ops::ControlFlow;

impl Regular3 {
    /// The regular triangulation of `points` with one weight each, in squared units of length; point `i` is
    /// vertex `i`.
    ///
    /// Expected time n log n where the number of tetrahedra is linear, several times that of
    /// [`Delaunay3::build`](crate::Delaunay3::build).
    ///
    /// # Errors
    /// - [`RegularError::Count`] when there are not as many weights as points;
    /// - [`RegularError::Weight`] when a weight is not accepted: of which point, and its value;
    /// - [`RegularError::Build`] as for [`Delaunay3::build`](crate::Delaunay3::build). Points on a plane
    ///   are described with the regular triangulation of the plane, which lacks what is hidden there.
    pub fn build(points: &[DVec3], weights: &[f64]) -> Result<Self, RegularError> {
        Self::build_with(points, weights, &mut silent)
    }

    /// As [`build`](Self::build), reporting progress to `report`, which can stop the work.
    ///
    /// # Errors
    /// As [`build`](Self::build), and [`BuildError::Cancelled`] when `report` says so.
    pub fn build_with(
        points: &[DVec3],
        weights: &[f64],
        report: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Self, RegularError> {
        let count = points.len();
        if count != weights.len() {
            let weights = weights.len();
            return Err(RegularError::Count {
                points: count,
                weights,
            });
        }
        if count > Self::MAX_POINTS {
            let limit = Self::MAX_POINTS;
            return Err(BuildError::TooManyPoints { count, limit }.into());
        }
        check_points3(points).map_err(BuildError::Coordinate)?;
        check_weights(weights)?;
        let mut meter =
            Meter::start(report, "tetrahedralize", count).map_err(BuildError::Cancelled)?;
        Ok(Self::grow(points, weights, &mut meter)?)
    }

    /// The triangulation of accepted points and weights.
    fn grow(points: &[DVec3], weights: &[f64], meter: &mut Meter<'_>) -> Result<Self, BuildError> {
        let place = |v: VertexId| points[v.index()] + DVec3::ZERO;
        let heaviest = Heaviest::of(weights, |v| place(v).to_array());
        let order = spatial_order(&heaviest.vertices, place);
        let places = order.iter().map(|&v| place(v));
        let in_order: Vec<DVec3> = [DVec3::NAN].into_iter().chain(places).collect();
        let simplex = match first_simplex(in_order.as_slice(), in_order.len()) {
            Ok(simplex) => simplex.map(|rank| order[rank.index()]),
            Err(cause) => {
                let flat = describe(points, weights, heaviest, &cause, meter)?;
                return Err(BuildError::Flat(Box::new(flat)));
            }
        };
        let mut regular = Self::of_simplex(points, weights, simplex);
        let rest = order.into_iter().filter(|v| !simplex.contains(v));
        regular.insert_all(rest, meter)?;
        regular.find_hidden(heaviest.vertices);
        regular.duplicates = heaviest.duplicates;
        Ok(regular)
    }

    /// The triangulation of four of the points, right-handed.
    fn of_simplex(points: &[DVec3], weights: &[f64], simplex: [VertexId; 4]) -> Self {
        let places = points.iter().map(|&p| p + DVec3::ZERO);
        let coords: Vec<DVec3> = [DVec3::NAN].into_iter().chain(places).collect();
        let mut mesh = TetMesh::default();
        glue_simplex(&mut mesh, simplex);
        mesh.index_vertices(coords.len());
        Self {
            coords,
            weights: [f64::NAN]
                .into_iter()
                .chain(weights.iter().copied())
                .collect(),
            mesh,
            duplicates: Duplicates::default(),
            hidden: Vec::new(),
        }
    }

    fn insert_all(
        &mut self,
        vertices: impl Iterator<Item = VertexId>,
        meter: &mut Meter<'_>,
    ) -> Result<(), BuildError> {
        let mut cavity = Cavity3::default();
        let mut start = TetId::new(0);
        for v in vertices {
            meter.advance()?;
            let sight = PowerSight3::new(self, v);
            // Places differ, so no vertex is there already.
            let Ok(seed) = walk(&self.mesh, &sight.places(), start).seed(&self.mesh) else {
                continue;
            };
            start = seed;
            if !sight.in_conflict(&self.mesh, seed) {
                continue;
            }
            cavity.dig(&self.mesh, &self.coords, seed, |t| {
                sight.in_conflict(&self.mesh, t)
            });
            self.fill(&mut cavity, v)?;
            start = cavity.tets[0];
        }
        Ok(())
    }

    /// Replaces the cavity by the star of `v` and forgets the vertices that it swallows.
    fn fill(&mut self, cavity: &mut Cavity3, v: VertexId) -> Result<(), BuildError> {
        let corners = cavity.tets.iter().flat_map(|&t| self.mesh.tet_vertices(t));
        let before: Vec<VertexId> = corners.filter(|v| !v.is_ghost()).collect();
        if !self.mesh.fill(cavity, v) {
            let tets = self.mesh.tet_count();
            return Err(BuildError::TooManyTets { tets });
        }
        for v in before {
            // The vertices round the cavity are at home in the star.
            let home = self.mesh.home(v);
            if home.is_some_and(|t| self.mesh.corner_of(t, v).is_none()) {
                self.mesh.forget_vertex(v);
            }
        }
        Ok(())
    }

    /// Takes down which of `vertices` have no tetrahedron.
    fn find_hidden(&mut self, mut vertices: Vec<VertexId>) {
        vertices.retain(|&v| !self.contains_vertex(v));
        vertices.sort_unstable();
        self.hidden = vertices;
    }
}

/// The vertices in the order in which they are inserted.
fn spatial_order(vertices: &[VertexId], place: impl Fn(VertexId) -> DVec3) -> Vec<VertexId> {
    let places: Vec<DVec3> = vertices.iter().map(|&v| place(v)).collect();
    let order = insertion_order(&places).into_iter();
    order.map(|index| vertices[index as usize]).collect()
}

/// What points without a tetrahedron are; those on a plane with their regular triangulation.
fn describe(
    points: &[DVec3],
    weights: &[f64],
    heaviest: Heaviest,
    cause: &FlatCause,
    meter: &mut Meter<'_>,
) -> Result<Flat, BuildError> {
    let weight = |v: &VertexId| weights[v.index()];
    let mut raised_weights: Vec<f64> = heaviest.vertices.iter().map(weight).collect();
    // The apex beside the plane is a vertex whatever its weight.
    raised_weights.push(0.0);
    let flat = Flat {
        vertices: heaviest.vertices,
        duplicates: heaviest.duplicates,
        plane: None,
    };
    coplanar::with_plane(flat, points, cause, |raised| {
        Ok(Regular3::grow(raised, &raised_weights, meter)?.into_mesh())
    })
}
