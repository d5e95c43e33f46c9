//! All points at once, in spatial order.
//!
//! The points are copied in the order of insertion (see [`crate::order`]) and numbered so while the
//! triangulation grows, which keeps what is used together near in memory; at the end the faces
//! take the caller's numbers. Between two insertions the walk starts at the side of the last star
//! that faces the next point.

use super::cavity::Cavity;
use super::delaunay::Delaunay2;
use super::duplicates::Duplicates;
use super::flat::Flat;
use super::mesh::TriMesh;
use crate::error::BuildError;
use crate::ids::{HalfEdgeId, VertexId};
use crate::memory::vec_with_capacity;
use crate::options::BuildOptions;
use crate::order::Order;
use crate::progress::{Meter, Progress, silent};
use geo_predicates::filter::Filter2;
use geo_predicates::{Sign, check_points2, orient2d};
use glam::DVec2;
use std::ops::ControlFlow;

impl Delaunay2 {
    /// The Delaunay triangulation of `points`; point `i` is vertex `i`.
    ///
    /// Repeated points are vertices once, see [`duplicates`](Self::duplicates). Expected time
    /// n log n, memory about 64 bytes per point when done.
    ///
    /// # Errors
    /// - [`BuildError::Coordinate`] when a coordinate is not accepted: which point, axis and value;
    /// - [`BuildError::TooManyPoints`] beyond [`MAX_POINTS`](Self::MAX_POINTS);
    /// - [`BuildError::Flat`] when the points span no triangle: what they are instead.
    pub fn build(points: &[DVec2]) -> Result<Self, BuildError> {
        Self::build_with(points, &mut silent)
    }

    /// As [`build`](Self::build), reporting progress to `report`, which can stop the work.
    ///
    /// # Errors
    /// As [`build`](Self::build), and [`BuildError::Cancelled`] when `report` says so.
    ///
    /// ```
    /// # use delaunay_core::{BuildError, Delaunay2};
    /// # use glam::DVec2;
    /// # use std::ops::ControlFlow;
    /// let points: Vec<DVec2> = (0..100).map(|i| DVec2::new(f64::from(i % 10), f64::from(i / 10))).collect();
    /// let stopped = Delaunay2::build_with(&points, &mut |_| ControlFlow::Break(()));
    /// assert!(matches!(stopped, Err(BuildError::Cancelled(_))));
    /// ```
    pub fn build_with(
        points: &[DVec2],
        report: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Self, BuildError> {
        Self::build_on(points, BuildOptions::default(), report)
    }

    /// As [`build_with`](Self::build_with), on several threads or in pages of another size.
    ///
    /// # Errors
    /// As [`build_with`](Self::build_with).
    ///
    /// ```
    /// # use delaunay_core::{BuildError, BuildOptions, Delaunay2, progress::silent};
    /// # use glam::DVec2;
    /// let points: Vec<DVec2> = (0..100).map(|i| DVec2::new(f64::from(i % 10), f64::from(i / 10))).collect();
    /// let one = Delaunay2::build(&points)?;
    /// let two = Delaunay2::build_on(&points, BuildOptions::on_threads(2), &mut silent)?;
    /// assert_eq!(one.mesh().canonical(), two.mesh().canonical());
    /// # Ok::<(), BuildError>(())
    /// ```
    pub fn build_on(
        points: &[DVec2],
        options: BuildOptions,
        report: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Self, BuildError> {
        if points.len() > Self::MAX_POINTS {
            return Err(BuildError::TooManyPoints {
                count: points.len(),
                limit: Self::MAX_POINTS,
            });
        }
        check_points2(points)?;
        let mut meter = Meter::start(report, "triangulate", points.len())?;
        let order = Order::of(points, options.threads.get());
        let coords = in_order(points, &order.indices);
        let Some(triangle) = first_triangle(&coords) else {
            return Err(BuildError::Flat(Box::new(Flat::sorted(points))));
        };
        let mut delaunay = Self::of_triangle(coords, triangle, options);
        let duplicates = delaunay.insert_rest(triangle, &mut meter)?;
        delaunay.renumber(points, &order.indices, duplicates);
        Ok(delaunay)
    }

    /// The triangulation of three of the coordinates, counterclockwise.
    fn of_triangle(coords: Vec<DVec2>, triangle: [VertexId; 3], options: BuildOptions) -> Self {
        let mut mesh = TriMesh {
            faces: vec_with_capacity(2 * coords.len(), options.huge_pages),
            outgoing: Vec::new(),
        };
        glue_triangle(&mut mesh, triangle);
        Self {
            filter: Filter2::for_points(&coords[1..]),
            coords,
            mesh,
            duplicates: Duplicates::default(),
            vacant: Vec::new(),
            cavity: Cavity::default(),
        }
    }

    /// Inserts every vertex but those of `triangle`; gives pairs (duplicate, its vertex).
    fn insert_rest(
        &mut self,
        triangle: [VertexId; 3],
        meter: &mut Meter<'_>,
    ) -> Result<Vec<(VertexId, VertexId)>, BuildError> {
        let mut duplicates = Vec::new();
        let mut cavity = Cavity::default();
        let mut start = HalfEdgeId::new(0);
        for slot in 1..self.coords.len() {
            meter.advance()?;
            let v = VertexId::from_slot(slot);
            if triangle.contains(&v) {
                continue;
            }
            let p = self.coords[slot];
            match self.seed(self.walk(p, start)) {
                Err(vertex) => duplicates.push((v, vertex)),
                Ok(seed) => {
                    let next = self.coords.get(slot + 1).copied().unwrap_or(p);
                    self.dig(p, seed, next, &mut cavity);
                    self.mesh.fill(&mut cavity, v);
                    start = self.next_start(&cavity);
                }
            }
        }
        self.cavity = cavity;
        Ok(duplicates)
    }

    /// The outer side of the new star at which it is aimed: where the next walk starts.
    #[inline(always)]
    fn next_start(&self, star: &Cavity) -> HalfEdgeId {
        let aimed = star.faces.get(star.aimed);
        aimed.map_or(HalfEdgeId::new(0), |f| self.real_side(f.half_edge(1)))
    }

    /// Passes from numbers in insertion order to the caller's; of equal points the smallest
    /// number stands for all.
    fn renumber(&mut self, points: &[DVec2], order: &[u32], pairs: Vec<(VertexId, VertexId)>) {
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
        self.mesh.index_vertices(self.coords.len());
        self.mesh.rename_vertices(&names);
        self.coords
            .splice(1.., points.iter().map(|&p| p + DVec2::ZERO));
        self.filter = Filter2::GENERAL;
    }
}

/// The points in insertion order behind the ghost; `-0.0` becomes `0.0`.
fn in_order(points: &[DVec2], order: &[u32]) -> Vec<DVec2> {
    let mut coords = Vec::with_capacity(points.len() + 1);
    coords.push(DVec2::NAN);
    coords.extend(
        order
            .iter()
            .map(|&index| points[index as usize] + DVec2::ZERO),
    );
    coords
}

/// The first vertices that span a triangle, counterclockwise; `None` when all are on a line.
fn first_triangle(coords: &[DVec2]) -> Option<[VertexId; 3]> {
    let &a = coords.get(1)?;
    let second = 2 + coords[2..].iter().position(|&b| b != a)?;
    let b = coords[second];
    let beyond = &coords[second + 1..];
    let third = beyond
        .iter()
        .position(|&c| orient2d(a, b, c) != Sign::Zero)?
        + second
        + 1;
    let [a, b, c] = [1, second, third].map(VertexId::from_slot);
    match orient2d(coords[1], coords[second], coords[third]) {
        Sign::Positive => Some([a, b, c]),
        _ => Some([a, c, b]),
    }
}

/// One triangle and the three ghosts round it, in an empty mesh.
fn glue_triangle(mesh: &mut TriMesh, [a, b, c]: [VertexId; 3]) {
    let face = mesh.push_face([a, b, c]);
    let ghosts = [[b, a], [c, b], [a, c]].map(|[u, w]| mesh.push_face([u, w, VertexId::GHOST]));
    for (i, ghost) in ghosts.into_iter().enumerate() {
        mesh.glue(face.half_edge(i), ghost.half_edge(0));
        // Ghost i ends where ghost i + 1 starts: (b, a), (c, b), (a, c).
        mesh.glue(ghosts[(i + 1) % 3].half_edge(1), ghost.half_edge(2));
    }
}
