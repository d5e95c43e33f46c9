//! Which tetrahedra a surface encloses.
//!
//! The triangles of the surface are looked up among the facets of the Delaunay triangulation of its vertices. When all
//! are there, the tetrahedra are told apart from the outside inwards: across a facet of the surface, outside becomes
//! inside and inside outside.

use super::delaunay::Delaunay3;
use super::mesh::TetMesh;
use super::surface::{Surface, sorted};
use super::sweep::first_intersection;
use crate::error::BuildError;
use crate::ids::{TetId, VertexId};
use crate::options::BuildOptions;
use crate::progress::{Cancelled, Meter, Progress};
use rustc_hash::FxHashMap;
use std::ops::ControlFlow;
use thiserror::Error;

/// The Delaunay triangulation of the vertices of a surface, and which of its tetrahedra are inside.
#[derive(Clone, Debug)]
pub struct Solid {
    delaunay: Delaunay3,
    /// By tetrahedron.
    inside: Vec<bool>,
}

/// Why a surface bounds no tetrahedra of the Delaunay triangulation of its vertices.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum SolidError {
    /// The vertices have no triangulation, or the report closure stopped the work.
    #[error(transparent)]
    Build(#[from] BuildError),
    /// Two triangles have more in common than corners or an edge.
    #[error("triangles {first} and {second} of the surface intersect")]
    SelfIntersection {
        /// The smaller index.
        first: usize,
        /// The other.
        second: usize,
    },
    /// No triangles intersect, but some are not Delaunay: the surface needs more vertices there.
    #[error("{}", missing_text(.triangles))]
    MissingTriangles {
        /// Indices of the triangles that are no facets of the triangulation, in order; at least one.
        triangles: Vec<usize>,
    },
    /// A point given as one inside is outside.
    #[error("{vertex} is not inside the surface")]
    NotInside {
        /// The first such point.
        vertex: VertexId,
    },
}

impl From<Cancelled> for SolidError {
    fn from(cancelled: Cancelled) -> Self {
        Self::Build(cancelled.into())
    }
}

impl Solid {
    /// The triangulation of the vertices, inside and outside.
    #[must_use]
    pub fn delaunay(&self) -> &Delaunay3 {
        &self.delaunay
    }

    /// Whether `t` is inside; ghosts and tetrahedra that do not exist are not.
    #[must_use]
    pub fn is_inside(&self, t: TetId) -> bool {
        self.inside.get(t.index()).is_some_and(|&inside| inside)
    }

    /// The tetrahedra inside, by id.
    #[must_use]
    pub fn tets(&self) -> impl DoubleEndedIterator<Item = TetId> + Clone + '_ {
        self.delaunay.tets().filter(|&t| self.is_inside(t))
    }

    /// Whether a vertex that is no corner of the surface is inside. It is on no triangle either, as all of them are facets,
    /// so its tetrahedra are on one side.
    fn surrounds(&self, v: VertexId) -> bool {
        self.delaunay
            .mesh()
            .home(v)
            .is_some_and(|t| self.is_inside(t))
    }
}

impl Surface {
    /// The solid that the surface bounds, in tetrahedra with its vertices and no others.
    ///
    /// A place is inside when a path to it from infinity crosses the surface an odd number of times.
    ///
    /// Takes the time of [`Delaunay3::build_on`] and linear expected time for the rest. When triangles are missing, the
    /// search for an intersection takes n log n and, on a surface of even triangles, about √n for each one missing.
    ///
    /// # Errors
    /// - [`SolidError::Build`] when the vertices have no triangulation or `report` stops the work;
    /// - [`SolidError::SelfIntersection`] when two triangles intersect, which never goes unnoticed;
    /// - [`SolidError::MissingTriangles`] when the triangulation lacks triangles of the surface, also because a point
    ///   given as one inside is on them;
    /// - [`SolidError::NotInside`] when a point given as one inside is outside.
    pub fn solid(
        &self,
        options: BuildOptions,
        report: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Solid, SolidError> {
        let delaunay = Delaunay3::build_on(self.points(), options, report)?;
        let facets = SurfaceFacets::of(self, delaunay.mesh());
        if !facets.found.iter().all(|&found| found) {
            return Err(self.why_missing(&facets.found, report)?);
        }
        let mut meter = Meter::start(report, "find inside", delaunay.mesh().tet_count())?;
        let inside = inside(delaunay.mesh(), &facets.in_surface, &mut meter)?;
        let solid = Solid { delaunay, inside };
        match self.interior().iter().find(|&&v| !solid.surrounds(v)) {
            Some(&vertex) => Err(SolidError::NotInside { vertex }),
            None => Ok(solid),
        }
    }

    /// The error for triangles that are no facets. Facets of one triangulation do not intersect, so of two triangles
    /// that do, one is missing.
    fn why_missing(
        &self,
        found: &[bool],
        report: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<SolidError, Cancelled> {
        let mut meter = Meter::start(report, "find intersection", found.len())?;
        let missing: Vec<bool> = found.iter().map(|found| !found).collect();
        if let Some([first, second]) = first_intersection(self, &missing, &mut meter)? {
            return Ok(SolidError::SelfIntersection { first, second });
        }
        let indices = 0..missing.len();
        let triangles = indices.filter(|&triangle| missing[triangle]).collect();
        Ok(SolidError::MissingTriangles { triangles })
    }
}

/// Which facets of a triangulation are triangles of a surface, and which triangles are facets.
struct SurfaceFacets {
    /// By facet; the same for both sides.
    in_surface: Vec<bool>,
    /// By triangle.
    found: Vec<bool>,
}

impl SurfaceFacets {
    fn of(surface: &Surface, mesh: &TetMesh) -> Self {
        let indexed = surface.triangles().iter().enumerate();
        let triangle_of: FxHashMap<[VertexId; 3], usize> = indexed
            .map(|(index, &corners)| (sorted(corners), index))
            .collect();
        let mut facets = Self {
            in_surface: vec![false; 4 * mesh.tet_slots()],
            found: vec![false; surface.triangles().len()],
        };
        for f in mesh.facets() {
            if let Some(&triangle) = triangle_of.get(&sorted(mesh.facet_vertices(f))) {
                facets.in_surface[f.index()] = true;
                facets.found[triangle] = true;
            }
        }
        facets
    }
}

/// By tetrahedron, whether it is inside, from the ghosts on, which are not.
fn inside(
    mesh: &TetMesh,
    in_surface: &[bool],
    meter: &mut Meter<'_>,
) -> Result<Vec<bool>, Cancelled> {
    let mut inside: Vec<Option<bool>> = vec![None; mesh.tet_slots()];
    let mut pending: Vec<(TetId, bool)> = Vec::new();
    for ghost in mesh.tets().filter(|&t| mesh.is_ghost_tet(t)) {
        inside[ghost.index()] = Some(false);
        pending.push((ghost, false));
    }
    while let Some((t, here)) = pending.pop() {
        meter.advance()?;
        for f in t.facets() {
            let across = mesh.twin(f).tet();
            let there = here ^ in_surface[f.index()];
            match inside[across.index()] {
                None => {
                    inside[across.index()] = Some(there);
                    pending.push((across, there));
                }
                Some(known) => debug_assert_eq!(known, there, "{f}: the surface is closed"),
            }
        }
    }
    let told = inside.into_iter().map(|inside| inside == Some(true));
    Ok(told.collect())
}

fn missing_text(triangles: &[usize]) -> String {
    const SHOWN: usize = 3;
    let mut list: Vec<String> = triangles.iter().take(SHOWN).map(usize::to_string).collect();
    if triangles.len() > SHOWN {
        list.push(format!("{} more", triangles.len() - SHOWN));
    }
    let which = match list.as_slice() {
        [only] => format!("triangle {only} of the surface is"),
        [before @ .., last] => {
            let before = before.join(", ");
            format!("triangles {before} and {last} of the surface are")
        }
        [] => "nothing of the surface is".to_owned(),
    };
    format!("{which} not in the Delaunay triangulation of its vertices")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::progress::silent;
    use glam::DVec3;

    fn solid(points: &[[f64; 3]], triangles: &[[usize; 3]]) -> Result<Solid, SolidError> {
        let points = points.iter().copied().map(DVec3::from).collect();
        let named = triangles.iter().map(|corners| corners.map(VertexId::new));
        let surface = Surface::new(points, named.collect()).unwrap();
        surface.solid(BuildOptions::default(), &mut silent)
    }

    /// The triangles of the tetrahedron on these vertices.
    fn tetrahedron([a, b, c, d]: [usize; 4]) -> [[usize; 3]; 4] {
        [[b, c, d], [c, a, d], [a, b, d], [c, b, a]]
    }

    #[test]
    fn tetrahedra_that_touch_along_an_edge_are_both_inside() {
        let points = [
            [0.0, 0.0, 0.0],
            [0.0, 0.0, 1.0],
            [1.0, 0.0, 0.0],
            [1.0, 1.0, 0.0],
            [-1.0, 0.0, 0.0],
            [-1.0, -1.0, 0.0],
        ];
        let triangles = [tetrahedron([0, 1, 2, 3]), tetrahedron([0, 1, 4, 5])].concat();
        let solid = solid(&points, &triangles).unwrap();
        assert_eq!(solid.tets().count(), 2);
        assert!(solid.delaunay().tets().count() > 2);
    }

    #[test]
    fn points_inside_become_vertices_and_others_are_named() {
        let corners = [[0.0; 3], [8.0, 0.0, 0.0], [0.0, 8.0, 0.0], [0.0, 0.0, 8.0]];
        let solid = |inside: &[[f64; 3]]| {
            let points = corners.iter().chain(inside).copied().map(DVec3::from);
            let named = tetrahedron([0, 1, 2, 3]).map(|corners| corners.map(VertexId::new));
            let surface = Surface::with_interior(points.collect(), named.to_vec()).unwrap();
            surface.solid(BuildOptions::default(), &mut silent)
        };
        let two = solid(&[[1.0; 3], [2.0, 1.0, 1.0]]).unwrap();
        assert!(two.tets().all(|t| two.is_inside(t)));
        assert_eq!(two.delaunay().vertex_count(), 6);
        insta::assert_snapshot!(solid(&[[1.0; 3], [20.0; 3]]).unwrap_err(), @"v5 is not inside the surface");
        insta::assert_snapshot!(solid(&[[2.0, 2.0, 0.0]]).unwrap_err(), @"triangle 3 of the surface is not in the Delaunay triangulation of its vertices");
    }

    #[test]
    fn what_does_not_exist_is_not_inside() {
        let points = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let solid = solid(&points, &tetrahedron([0, 1, 2, 3])).unwrap();
        let beyond = TetId::new(solid.delaunay().mesh().tet_slots());
        assert!(!solid.is_inside(beyond));
        let mut ghosts = solid.delaunay().mesh().tets();
        assert_eq!(ghosts.by_ref().filter(|&t| solid.is_inside(t)).count(), 1);
    }

    #[test]
    fn a_flat_surface_bounds_nothing() {
        let points = [[0.0; 3], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0], [1.0, 1.0, 0.0]];
        let error = solid(&points, &tetrahedron([0, 1, 2, 3])).unwrap_err();
        insta::assert_snapshot!(error, @"the 4 distinct points lie on one plane");
    }

    #[test]
    fn tetrahedra_that_run_through_each_other_are_refused() {
        let points = [
            [0.0, 0.0, 0.0],
            [4.0, 0.0, 0.0],
            [0.0, 4.0, 0.0],
            [0.0, 0.0, 4.0],
            [1.0, 1.0, -1.0],
            [5.0, 1.0, -1.0],
            [1.0, 5.0, -1.0],
            [1.0, 1.0, 0.5],
        ];
        let triangles = [tetrahedron([0, 1, 2, 3]), tetrahedron([4, 5, 6, 7])].concat();
        let error = solid(&points, &triangles).unwrap_err();
        insta::assert_snapshot!(error, @"triangles 3 and 4 of the surface intersect");
    }

    /// Closed, every edge with two triangles, but without an inside: no such surface fits into space.
    #[test]
    fn a_projective_plane_intersects_itself() {
        let places = [
            [0.0, 0.0, 0.0],
            [3.0, 0.0, 1.0],
            [1.0, 4.0, 0.0],
            [-2.0, 2.0, 1.5],
            [-2.0, -3.0, 1.0],
            [1.0, -2.0, 5.0],
        ];
        let fan = [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5], [0, 5, 1]];
        let rest = [[1, 2, 4], [2, 3, 5], [3, 4, 1], [4, 5, 2], [5, 1, 3]];
        let error = solid(&places, &[fan, rest].concat()).unwrap_err();
        assert!(
            matches!(error, SolidError::SelfIntersection { .. }),
            "{error}"
        );
    }

    #[test]
    fn triangles_that_are_not_delaunay_are_listed() {
        let (points, triangles) = one_close_below_the_other();
        let error = solid(&points, &triangles).unwrap_err();
        insta::assert_snapshot!(error, @"triangle 3 of the surface is not in the Delaunay triangulation of its vertices");
        let listed = |count: usize| missing_text(&(5..5 + count).collect::<Vec<_>>());
        insta::assert_snapshot!(listed(2), @"triangles 5 and 6 of the surface are not in the Delaunay triangulation of its vertices");
        insta::assert_snapshot!(listed(3), @"triangles 5, 6 and 7 of the surface are not in the Delaunay triangulation of its vertices");
        insta::assert_snapshot!(listed(9), @"triangles 5, 6, 7 and 6 more of the surface are not in the Delaunay triangulation of its vertices");
    }

    /// A small tetrahedron whose tip comes close to a large triangle of another.
    fn one_close_below_the_other() -> ([[f64; 3]; 8], Vec<[usize; 3]>) {
        let points = [
            [-9.0, -9.0, 0.0],
            [9.0, -9.0, 0.0],
            [0.0, 9.0, 0.0],
            [0.0, 0.0, 9.0],
            [0.0, 0.0, -0.1],
            [1.0, 0.0, -1.0],
            [0.0, 1.0, -1.0],
            [-1.0, -1.0, -1.0],
        ];
        let triangles = [tetrahedron([0, 1, 2, 3]), tetrahedron([4, 5, 6, 7])].concat();
        (points, triangles)
    }

    #[test]
    fn the_report_stops_every_stage() {
        let (points, triangles) = one_close_below_the_other();
        let tetrahedron_alone = (points[..4].to_vec(), triangles[..4].to_vec());
        for ((points, triangles), stage) in [
            (tetrahedron_alone, "find inside"),
            ((points.to_vec(), triangles), "find intersection"),
        ] {
            let points = points.into_iter().map(DVec3::from).collect();
            let named = triangles.iter().map(|corners| corners.map(VertexId::new));
            let surface = Surface::new(points, named.collect()).unwrap();
            let mut stop = |progress: Progress| match progress.stage == stage {
                true => ControlFlow::Break(()),
                false => ControlFlow::Continue(()),
            };
            let error = surface
                .solid(BuildOptions::default(), &mut stop)
                .unwrap_err();
            assert!(error.to_string().contains(stage), "{error}");
        }
    }
}
