//! The triangulation of a few points, inserted as they come.
//!
//! What [`Delaunay3::build`] does for many points, without the sorting and renumbering that pays only
//! for many.

use super::cavity::Cavity3;
use super::delaunay::Delaunay3;
use super::locate::walk;
use super::mesh::TetMesh;
use super::sight::Sight3;
use super::simplex::{FlatCause, first_simplex, glue_simplex};
use crate::guide::Guide;
use crate::ids::{TetId, VertexId};
use crate::tri::Duplicates;
use geo_predicates::filter::Filter3;
use glam::DVec3;

impl Delaunay3 {
    /// The triangulation of a few accepted points, all distinct; point `i` is vertex `i`.
    ///
    /// Takes quadratic time at worst.
    ///
    /// # Errors
    /// What the points span when it is not space.
    pub(super) fn grow_few(points: impl IntoIterator<Item = DVec3>) -> Result<Self, FlatCause> {
        let mut coords = vec![DVec3::NAN];
        coords.extend(points);
        let simplex = first_simplex(coords.as_slice(), coords.len())?;
        let mut mesh = TetMesh::default();
        glue_simplex(&mut mesh, simplex);
        mesh.index_vertices(coords.len());
        let mut few = Self {
            filter: Filter3::for_points(&coords[1..]),
            vertex_count: coords.len() - 1,
            coords,
            mesh,
            duplicates: Duplicates::default(),
            vacant: Vec::new(),
            cavity: Cavity3::default(),
            guide: Guide::default(),
        };
        few.insert_all_but(simplex);
        few.filter = Filter3::GENERAL;
        Ok(few)
    }

    fn insert_all_but(&mut self, simplex: [VertexId; 4]) {
        let mut start = TetId::new(0);
        let mut cavity = std::mem::take(&mut self.cavity);
        for (slot, &p) in self.coords.iter().enumerate().skip(1) {
            let v = VertexId::from_slot(slot);
            if simplex.contains(&v) {
                continue;
            }
            let sight = Sight3::new(self.coords.as_slice(), self.filter, p);
            let Ok(seed) = self.seed(walk(&self.mesh, &sight, start)) else {
                continue;
            };
            cavity.dig(&self.mesh, &self.coords, seed, |t| {
                sight.in_conflict(&self.mesh, t)
            });
            let filled = self.mesh.fill(&mut cavity, v);
            debug_assert!(filled, "few points have few tetrahedra");
            start = cavity.tets[0];
        }
        self.cavity = cavity;
    }
}
