//! Removal of a vertex of a subcomplex, in two steps: what would fill its place is found first, and may be judged.
//!
//! The hole is [wrapped](Wrapping) in rounded numbers, which exact signs check. Where that does not do, because points are on a
//! common sphere or the boundary is not stable, the neighbours are triangulated with exact signs, as in
//! [`remove`](super::remove).

use super::delaunay::Delaunay3;
use super::remove::Hole;
use super::subcomplex::Subcomplex3;
use super::wrapping::{Across, WrappedTet, Wrapping};
use crate::ids::{FacetId, TetId, VertexId};
use glam::DVec3;

/// What would fill the hole that a vertex leaves.
#[derive(Clone, Debug)]
pub struct Patch {
    vertex: VertexId,
    star: Vec<TetId>,
    outer: Vec<FacetId>,
    made: Vec<[VertexId; 4]>,
}

impl Patch {
    /// The tetrahedra that would go: the star of the vertex.
    #[must_use]
    pub fn star(&self) -> &[TetId] {
        &self.star
    }

    /// The corners of the tetrahedra that would come, right-handed.
    #[must_use]
    pub fn made(&self) -> &[[VertexId; 4]] {
        &self.made
    }
}

/// Rounded numbers have not found the tetrahedra of Delaunay.
struct Failed;

impl Subcomplex3 {
    /// What would fill the hole if `v` were removed: the tetrahedra of its neighbours. Nothing changes.
    ///
    /// `None` when `v` is on the boundary or no vertex, when its neighbours lie on one plane, and where a boundary that
    /// is not stable is so near that their Delaunay tetrahedra do not fill the hole.
    #[must_use]
    pub fn patch(&self, v: VertexId) -> Option<Patch> {
        self.patch_within(v, |_| true)
    }

    /// As [`patch`](Self::patch), but gives up with `None` at the first tetrahedron that is not `open`; not all of those asked
    /// about need be in the patch.
    #[must_use]
    pub fn patch_within(
        &self,
        v: VertexId,
        mut open: impl FnMut([VertexId; 4]) -> bool,
    ) -> Option<Patch> {
        self.mesh.home(v)?;
        let hole = Hole::of(&self.mesh, v);
        if hole.star.iter().any(|&t| self.mesh.is_ghost_tet(t)) {
            return None;
        }
        let made = match self.wrapped(&hole, &mut open)? {
            Ok(made) => made,
            Err(Failed) => self.triangulated(&hole, v)?,
        };
        let Hole { star, outer, .. } = hole;
        Some(Patch {
            vertex: v,
            star,
            outer,
            made,
        })
    }

    /// Removes the vertex of a patch just found. Gives the new tetrahedra; `None`, with nothing changed, when they do
    /// not fill the hole or ids run out.
    pub fn remove(&mut self, patch: &Patch) -> Option<Vec<TetId>> {
        let Patch {
            star, outer, made, ..
        } = patch;
        let new = self.mesh.exchange(star, outer, made)?;
        self.forget(patch.vertex);
        Some(new)
    }

    /// The tetrahedra that fill a hole, if rounded numbers find those of Delaunay; `None` when one of them is not `open`.
    fn wrapped(
        &self,
        hole: &Hole,
        open: &mut impl FnMut([VertexId; 4]) -> bool,
    ) -> Option<Result<Vec<[VertexId; 4]>, Failed>> {
        let real = &hole.real;
        let points: Vec<DVec3> = real.iter().map(|&u| self.point(u)).collect();
        let facets = hole.outer.iter().map(|&outer| {
            let corners = self.mesh.facet_vertices(self.mesh.twin(outer));
            corners.map(|u| real.binary_search(&u).unwrap_or(0))
        });
        let mut made = Vec::with_capacity(hole.star.len());
        let mut all_open = true;
        let mut wrapping = Wrapping::default();
        let filled = wrapping.fill(&points, facets, |tet| {
            let corners = tet.corners.map(|corner| real[corner]);
            made.push(corners);
            all_open = open(corners);
            all_open
        });
        if !all_open {
            return None;
        }
        let is_delaunay = filled.is_some_and(|tets| self.are_delaunay(tets, &made, &hole.outer));
        Some(is_delaunay.then_some(made).ok_or(Failed))
    }

    /// Whether tetrahedra that fill a hole are right-handed, and Delaunay across all their facets that are no boundary; they
    /// have the corners `made`. Exact.
    fn are_delaunay(&self, tets: &[WrappedTet], made: &[[VertexId; 4]], outer: &[FacetId]) -> bool {
        let is_empty = |corners: [VertexId; 4], across: Across| match across {
            Across::Tet(other) => {
                let mut apexes = made[other].iter().filter(|v| !corners.contains(v));
                apexes.all(|&apex| self.is_locally_delaunay(corners, apex))
            }
            Across::Facet(number) => {
                self.is_locally_delaunay(corners, self.mesh.apex(outer[number]))
            }
        };
        tets.iter()
            .zip(made)
            .enumerate()
            .all(|(index, (tet, &corners))| {
                // Facets between two tetrahedra once.
                let mut sides = tet.across.into_iter();
                let once =
                    |across: &Across| !matches!(across, Across::Tet(other) if *other < index);
                self.is_right_handed(corners)
                    && sides.all(|across| !once(&across) || is_empty(corners, across))
            })
    }

    /// The tetrahedra that fill the hole of `v`, by the exact triangulation of the vertices round it.
    fn triangulated(&self, hole: &Hole, v: VertexId) -> Option<Vec<[VertexId; 4]>> {
        let points = hole.real.iter().map(|&u| self.point(u));
        let link = Delaunay3::grow_few(points).ok()?;
        let made = hole.cavity_in(&link, self.point(v));
        let is_real = !made.iter().flatten().any(|v| v.is_ghost());
        is_real.then_some(made)
    }
}
