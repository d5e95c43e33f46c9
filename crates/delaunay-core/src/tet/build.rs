//! All points at once, in spatial order.
//!
//! The points are copied in the order of insertion (see [`crate::order`]) and numbered so while the
//! triangulation grows, which keeps what is used together near in memory; at the end the tetrahedra
//! take the caller's numbers.

use super::bulk::{self, Grown, NotGrown};
use super::cavity::Cavity3;
use super::coplanar;
use super::delaunay::Delaunay3;
use crate::error::BuildError;
use crate::guide::Guide;
use crate::ids::VertexId;
use crate::memory::vec_with_capacity;
use crate::options::BuildOptions;
use crate::order::Order;
use crate::progress::{Meter, Progress, silent};
use crate::threads;
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
        Self::build_on(points, BuildOptions::default(), report)
    }

    /// As [`build_with`](Self::build_with), on several threads if `options` say so. The triangulation is
    /// the same for any number of threads; ids of tetrahedra are not, but depend on that number alone,
    /// and the [canonical](super::TetMesh::canonical) mesh is the same bit for bit.
    ///
    /// # Errors
    /// As [`build_with`](Self::build_with).
    pub fn build_on(
        points: &[DVec3],
        options: BuildOptions,
        report: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Self, BuildError> {
        if points.len() > Self::MAX_POINTS {
            return Err(BuildError::TooManyPoints {
                count: points.len(),
                limit: Self::MAX_POINTS,
            });
        }
        let options = options.for_points(points.len());
        threads::check(points, options.threads.get(), check_points3)?;
        let mut meter = Meter::start(report, "tetrahedralize", points.len())?;
        Self::grow(points, options, &mut meter)
    }

    /// The triangulation of accepted points.
    pub(super) fn grow(
        points: &[DVec3],
        options: BuildOptions,
        meter: &mut Meter<'_>,
    ) -> Result<Self, BuildError> {
        let order = Order::of(points, options);
        let grown = match bulk::grow(points, &order, options, meter) {
            Ok(grown) => grown,
            Err(NotGrown::Failed(error)) => return Err(error),
            Err(NotGrown::Flat(cause)) => {
                let flat = coplanar::describe(points, &cause, meter)?;
                return Err(BuildError::Flat(Box::new(flat)));
            }
        };
        Ok(Self::renumbered(points, &order.indices, grown, options))
    }

    /// Passes from numbers in insertion order to the caller's; of equal points the smallest
    /// number stands for all.
    fn renumbered(points: &[DVec3], order: &[u32], grown: Grown, options: BuildOptions) -> Self {
        let given = order.iter().map(|&index| VertexId::new(index as usize));
        let mut names: Vec<VertexId> = [VertexId::GHOST].into_iter().chain(given).collect();
        for (duplicate, vertex) in &grown.duplicates {
            if names[duplicate.slot()] < names[vertex.slot()] {
                names.swap(duplicate.slot(), vertex.slot());
            }
        }
        let named = grown
            .duplicates
            .into_iter()
            .map(|(duplicate, vertex)| (names[duplicate.slot()], names[vertex.slot()]));
        let duplicates = Duplicates::from_pairs(named.collect());
        let mut mesh = grown.mesh;
        mesh.rename_vertices(&names, options.huge_pages);
        let mut coords = vec_with_capacity(points.len() + 1, options.huge_pages);
        coords.push(DVec3::NAN);
        coords.extend(points.iter().map(|&p| p + DVec3::ZERO));
        Self {
            coords,
            mesh,
            filter: Filter3::GENERAL,
            vertex_count: points.len() - duplicates.len(),
            duplicates,
            vacant: Vec::new(),
            cavity: Cavity3::default(),
            guide: Guide::default(),
        }
    }
}
