//! All weighted points, in spatial order (Edelsbrunner and Shah 1996, *Incremental topological flipping
//! works for regular triangulations*; here with cavities in place of flips).
//!
//! A point above the lower hull of those before it is hidden: it is not in conflict with the face that
//! contains it. It stays hidden, because further points only lower the hull. A new vertex may hide old
//! ones: those are swallowed, all faces round them are in the cavity.

use super::Regular2;
use super::cavity::WideCavity;
use super::sight::PowerSight2;
use crate::error::{BuildError, RegularError};
use crate::heaviest::Heaviest;
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::order::insertion_order;
use crate::progress::{Meter, Progress, silent};
use crate::tri::{Duplicates, Flat, TriMesh};
use geo_predicates::{Sign, check_points2, check_weights, orient2d};
use glam::DVec2;
use std::ops::ControlFlow;

impl Regular2 {
    /// The regular triangulation of `points` with one weight each, in squared units of length; point `i` is
    /// vertex `i`.
    ///
    /// Expected time n log n, several times that of [`Delaunay2::build`](crate::Delaunay2::build).
    ///
    /// # Errors
    /// - [`RegularError::Count`] when there are not as many weights as points;
    /// - [`RegularError::Weight`] when a weight is not accepted: of which point, and its value;
    /// - [`RegularError::Build`] as for [`Delaunay2::build`](crate::Delaunay2::build). Points on a line are
    ///   described without regard to their weights, except that the heaviest of a place stands for all.
    pub fn build(points: &[DVec2], weights: &[f64]) -> Result<Self, RegularError> {
        Self::build_with(points, weights, &mut silent)
    }

    /// As [`build`](Self::build), reporting progress to `report`, which can stop the work.
    ///
    /// # Errors
    /// As [`build`](Self::build), and [`BuildError::Cancelled`] when `report` says so.
    pub fn build_with(
        points: &[DVec2],
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
        check_points2(points).map_err(BuildError::Coordinate)?;
        check_weights(weights)?;
        let mut meter =
            Meter::start(report, "triangulate", count).map_err(BuildError::Cancelled)?;
        Ok(Self::grow(points, weights, &mut meter)?)
    }

    /// The triangulation of accepted points and weights.
    fn grow(points: &[DVec2], weights: &[f64], meter: &mut Meter<'_>) -> Result<Self, BuildError> {
        let place = |v: VertexId| points[v.index()] + DVec2::ZERO;
        let heaviest = Heaviest::of(weights, |v| place(v).to_array());
        let order = spatial_order(&heaviest.vertices, place);
        let Some(triangle) = first_triangle(&order, place) else {
            return Err(BuildError::Flat(Box::new(Flat {
                vertices: heaviest.vertices,
                duplicates: heaviest.duplicates,
                plane: None,
            })));
        };
        let mut regular = Self::of_triangle(points, weights, triangle);
        let rest = order.into_iter().filter(|v| !triangle.contains(v));
        regular.insert_all(rest, meter)?;
        regular.find_hidden(heaviest.vertices);
        regular.duplicates = heaviest.duplicates;
        Ok(regular)
    }

    /// The triangulation of three of the points, counterclockwise.
    fn of_triangle(points: &[DVec2], weights: &[f64], [a, b, c]: [VertexId; 3]) -> Self {
        let mut mesh = TriMesh::default();
        let face = mesh.push_face([a, b, c]);
        let ghosts = [[b, a], [c, b], [a, c]].map(|[u, w]| mesh.push_face([u, w, VertexId::GHOST]));
        for (i, ghost) in ghosts.into_iter().enumerate() {
            mesh.glue(face.half_edge(i), ghost.half_edge(0));
            // Ghost i ends where ghost i + 1 starts: (b, a), (c, b), (a, c).
            mesh.glue(ghosts[(i + 1) % 3].half_edge(1), ghost.half_edge(2));
        }
        mesh.index_vertices(points.len() + 1);
        let places = points.iter().map(|&p| p + DVec2::ZERO);
        let weights = weights.iter().copied();
        Self {
            coords: [DVec2::NAN].into_iter().chain(places).collect(),
            weights: [f64::NAN].into_iter().chain(weights).collect(),
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
        let mut cavity = WideCavity::default();
        let mut start = FaceId::new(0);
        for v in vertices {
            meter.advance()?;
            let sight = PowerSight2::new(self, v);
            start = sight.walk(start);
            if !sight.in_conflict(start) {
                continue;
            }
            cavity.dig(&self.mesh, start, |f| sight.in_conflict(f));
            self.mesh.fill_wide(&mut cavity, v);
            start = self
                .mesh
                .outgoing(v)
                .map_or(FaceId::new(0), HalfEdgeId::face);
        }
        Ok(())
    }

    /// Takes down which of `vertices` have no face.
    fn find_hidden(&mut self, mut vertices: Vec<VertexId>) {
        vertices.retain(|&v| !self.contains_vertex(v));
        vertices.sort_unstable();
        self.hidden = vertices;
    }
}

/// The vertices in the order in which they are inserted.
fn spatial_order(vertices: &[VertexId], place: impl Fn(VertexId) -> DVec2) -> Vec<VertexId> {
    let places: Vec<DVec2> = vertices.iter().map(|&v| place(v)).collect();
    let order = insertion_order(&places).into_iter();
    order.map(|index| vertices[index as usize]).collect()
}

/// The first of the vertices, all in different places, that span a triangle, counterclockwise; `None`
/// when all are on a line.
fn first_triangle(
    vertices: &[VertexId],
    place: impl Fn(VertexId) -> DVec2,
) -> Option<[VertexId; 3]> {
    let &[a, b, ..] = vertices else { return None };
    let side = |&v: &VertexId| orient2d(place(a), place(b), place(v));
    let &c = vertices.iter().find(|v| side(v) != Sign::Zero)?;
    match side(&c) {
        Sign::Positive => Some([a, b, c]),
        _ => Some([a, c, b]),
    }
}
