//! Which triangles an outline encloses.
//!
//! The segments of the outline are looked up among the edges of the Delaunay triangulation of its vertices. When all
//! are there, the triangles are told apart from the outside inwards: across a segment of the outline, outside becomes
//! inside and inside outside.

use super::crossing::first_crossing;
use super::delaunay::Delaunay2;
use super::mesh::TriMesh;
use super::outline::{Outline, sorted};
use crate::error::BuildError;
use crate::ids::{FaceId, VertexId};
use crate::options::BuildOptions;
use crate::progress::{Cancelled, Meter, Progress};
use rustc_hash::FxHashMap;
use std::ops::ControlFlow;
use thiserror::Error;

/// The Delaunay triangulation of the vertices of an outline, and which of its triangles are inside.
#[derive(Clone, Debug)]
pub struct Region {
    delaunay: Delaunay2,
    /// By face.
    inside: Vec<bool>,
}

/// Why an outline bounds no triangles of the Delaunay triangulation of its vertices.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum RegionError {
    /// The vertices have no triangulation, or the report closure stopped the work.
    #[error(transparent)]
    Build(#[from] BuildError),
    /// Two segments have more in common than an end.
    #[error("segments {first} and {second} of the outline cross")]
    Crossing {
        /// The smaller index.
        first: usize,
        /// The other.
        second: usize,
    },
    /// No segments cross, but some are not Delaunay: the outline needs more vertices there.
    #[error("{}", missing_text(.segments))]
    MissingSegments {
        /// Indices of the segments that are no edges of the triangulation, in order; at least one.
        segments: Vec<usize>,
    },
    /// A point given as one inside is outside.
    #[error("{vertex} is not inside the outline")]
    NotInside {
        /// The first such point.
        vertex: VertexId,
    },
}

impl From<Cancelled> for RegionError {
    fn from(cancelled: Cancelled) -> Self {
        Self::Build(cancelled.into())
    }
}

impl Region {
    /// The triangulation of the vertices, inside and outside.
    #[must_use]
    pub fn delaunay(&self) -> &Delaunay2 {
        &self.delaunay
    }

    /// Whether `f` is inside; ghosts and faces that do not exist are not.
    #[must_use]
    pub fn is_inside(&self, f: FaceId) -> bool {
        self.inside.get(f.index()).is_some_and(|&inside| inside)
    }

    /// Whether all triangles at a vertex are inside.
    fn surrounds(&self, v: VertexId) -> bool {
        self.delaunay.mesh().star(v).all(|f| self.is_inside(f))
    }

    /// The triangles inside, by id.
    pub fn faces(&self) -> impl Iterator<Item = FaceId> + Clone + '_ {
        self.delaunay.faces().filter(|&f| self.is_inside(f))
    }
}

impl Outline {
    /// The region that the outline bounds, in triangles with its vertices and no others.
    ///
    /// A place is inside when a path to it from infinity crosses the outline an odd number of times.
    ///
    /// Takes the time of [`Delaunay2::build_on`] and linear expected time for the rest. When segments are missing, the
    /// search for a crossing takes n log n and, in usual outlines, about √n for each one missing.
    ///
    /// # Errors
    /// - [`RegionError::Build`] when the vertices have no triangulation or `report` stops the work;
    /// - [`RegionError::Crossing`] when two segments cross, which never goes unnoticed;
    /// - [`RegionError::MissingSegments`] when the triangulation lacks segments of the outline, also because a point given
    ///   as one inside is on them;
    /// - [`RegionError::NotInside`] when a point given as one inside is outside.
    pub fn region(
        &self,
        options: BuildOptions,
        report: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Region, RegionError> {
        let delaunay = Delaunay2::build_on(self.points(), options, report)?;
        let edges = OutlineEdges::of(self, delaunay.mesh());
        if !edges.found.iter().all(|&found| found) {
            return Err(self.why_missing(&edges.found));
        }
        let mut meter = Meter::start(report, "find inside", delaunay.mesh().face_count())?;
        let inside = inside(delaunay.mesh(), &edges.in_outline, &mut meter)?;
        let region = Region { delaunay, inside };
        let mut interior = self.interior().iter();
        match interior.find(|&&v| !region.surrounds(v)) {
            Some(&vertex) => Err(RegionError::NotInside { vertex }),
            None => Ok(region),
        }
    }

    /// The error for segments that are no edges. Edges of one triangulation do not cross, so of two segments that do,
    /// one is missing.
    fn why_missing(&self, found: &[bool]) -> RegionError {
        let missing: Vec<bool> = found.iter().map(|found| !found).collect();
        if let Some([first, second]) = first_crossing(self, &missing) {
            return RegionError::Crossing { first, second };
        }
        let indices = 0..missing.len();
        let segments = indices.filter(|&segment| missing[segment]).collect();
        RegionError::MissingSegments { segments }
    }
}

/// Which half-edges of a triangulation are segments of an outline, and which segments are edges.
struct OutlineEdges {
    /// By half-edge; the same for both sides.
    in_outline: Vec<bool>,
    /// By segment.
    found: Vec<bool>,
}

impl OutlineEdges {
    fn of(outline: &Outline, mesh: &TriMesh) -> Self {
        let indexed = outline.segments().iter().enumerate();
        let segment_of: FxHashMap<[VertexId; 2], usize> = indexed
            .map(|(index, &ends)| (sorted(ends), index))
            .collect();
        let mut edges = Self {
            in_outline: vec![false; 4 * mesh.face_count()],
            found: vec![false; outline.segments().len()],
        };
        for h in mesh.half_edges() {
            let ends = sorted([mesh.origin(h), mesh.target(h)]);
            if let Some(&segment) = segment_of.get(&ends) {
                edges.in_outline[h.index()] = true;
                edges.found[segment] = true;
            }
        }
        edges
    }
}

/// By face, whether it is inside, from the ghosts on, which are not.
fn inside(
    mesh: &TriMesh,
    in_outline: &[bool],
    meter: &mut Meter<'_>,
) -> Result<Vec<bool>, Cancelled> {
    let mut inside: Vec<Option<bool>> = vec![None; mesh.face_count()];
    let mut pending: Vec<(FaceId, bool)> = Vec::new();
    for ghost in mesh.star(VertexId::GHOST) {
        inside[ghost.index()] = Some(false);
        pending.push((ghost, false));
    }
    while let Some((f, here)) = pending.pop() {
        meter.advance()?;
        for h in f.half_edges() {
            let across = mesh.twin(h).face();
            let there = here ^ in_outline[h.index()];
            match inside[across.index()] {
                None => {
                    inside[across.index()] = Some(there);
                    pending.push((across, there));
                }
                Some(known) => debug_assert_eq!(known, there, "{h}: the outline is closed"),
            }
        }
    }
    let told = inside.into_iter().map(|inside| inside == Some(true));
    Ok(told.collect())
}

fn missing_text(segments: &[usize]) -> String {
    const SHOWN: usize = 3;
    let mut list: Vec<String> = segments.iter().take(SHOWN).map(usize::to_string).collect();
    if segments.len() > SHOWN {
        list.push(format!("{} more", segments.len() - SHOWN));
    }
    let which = match list.as_slice() {
        [only] => format!("segment {only} of the outline is"),
        [before @ .., last] => {
            let before = before.join(", ");
            format!("segments {before} and {last} of the outline are")
        }
        [] => "nothing of the outline is".to_owned(),
    };
    format!("{which} not in the Delaunay triangulation of its vertices")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::progress::silent;
    use glam::DVec2;

    fn region(points: &[[f64; 2]], loops: &[&[usize]]) -> Result<Region, RegionError> {
        let points = points.iter().copied().map(DVec2::from).collect();
        let mut segments = Vec::new();
        for corners in loops {
            let next = corners.iter().cycle().skip(1);
            segments.extend(
                corners
                    .iter()
                    .zip(next)
                    .map(|(&a, &b)| [a, b].map(VertexId::new)),
            );
        }
        let outline = Outline::new(points, segments).unwrap();
        outline.region(BuildOptions::default(), &mut silent)
    }

    const BOW: [[f64; 2]; 5] = [
        [0.0, 0.0],
        [3.0, 1.0],
        [3.0, -1.0],
        [-3.0, 1.0],
        [-3.0, -1.0],
    ];

    #[test]
    fn points_given_as_inside_are_inside_or_named() {
        let region = |point: [f64; 2]| {
            let corners = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], point].map(DVec2::from);
            let segments = [[0, 1], [1, 2], [2, 3], [3, 0]].map(|ends| ends.map(VertexId::new));
            let outline = Outline::with_interior(corners.to_vec(), segments.to_vec()).unwrap();
            assert_eq!(outline.interior(), [VertexId::new(4)]);
            outline.region(BuildOptions::default(), &mut silent)
        };
        assert_eq!(region([1.0, 2.0]).unwrap().faces().count(), 4);
        insta::assert_snapshot!(region([9.0, 9.0]).unwrap_err(), @"v4 is not inside the outline");
        assert!(matches!(
            region([2.0, 0.0]),
            Err(RegionError::MissingSegments { .. })
        ));
    }

    #[test]
    fn triangles_that_touch_at_a_vertex_are_both_inside() {
        let region = region(&BOW, &[&[0, 1, 2], &[0, 3, 4]]).unwrap();
        assert_eq!(region.faces().count(), 2);
        assert!(region.delaunay().faces().count() > 2);
    }

    #[test]
    fn a_loop_in_a_loop_is_a_hole() {
        let square = |s: f64| [[-s, -s], [s, -s], [s, s], [-s, s]];
        let points = [square(2.0), square(1.0)].concat();
        let region = region(&points, &[&[0, 1, 2, 3], &[4, 5, 6, 7]]).unwrap();
        assert_eq!(
            (region.faces().count(), region.delaunay().faces().count()),
            (8, 10)
        );
    }

    #[test]
    fn what_does_not_exist_is_not_inside() {
        let region = region(&BOW[..3], &[&[0, 1, 2]]).unwrap();
        let faces = region.delaunay().mesh().face_count();
        assert!(!region.is_inside(FaceId::new(faces)));
        let all = (0..faces).map(FaceId::new);
        assert_eq!(all.filter(|&f| region.is_inside(f)).count(), 1);
    }

    #[test]
    fn a_flat_outline_bounds_nothing() {
        let points = [[0.0, 0.0], [4.0, 0.0], [1.0, 0.0]];
        let error = region(&points, &[&[0, 1, 2]]).unwrap_err();
        insta::assert_snapshot!(error, @"the 3 distinct points lie on one line, from v0 to v1");
    }

    #[test]
    fn segments_that_cross_are_named() {
        let error = region(&BOW[1..], &[&[0, 1, 2, 3]]).unwrap_err();
        insta::assert_snapshot!(error, @"segments 1 and 3 of the outline cross");
    }

    #[test]
    fn segments_that_are_not_delaunay_are_listed() {
        let points = [[-9.0, 0.0], [0.0, -0.1], [9.0, 0.0], [0.0, 5.0]];
        let flat = [points.as_slice(), &[[0.0, -1.0]]].concat();
        let error = region(&flat, &[&[0, 2, 3], &[0, 1, 4]]).unwrap_err();
        insta::assert_snapshot!(error, @"segment 0 of the outline is not in the Delaunay triangulation of its vertices");
        let listed = |count: usize| missing_text(&(5..5 + count).collect::<Vec<_>>());
        insta::assert_snapshot!(listed(2), @"segments 5 and 6 of the outline are not in the Delaunay triangulation of its vertices");
        insta::assert_snapshot!(listed(9), @"segments 5, 6, 7 and 6 more of the outline are not in the Delaunay triangulation of its vertices");
    }

    #[test]
    fn the_report_stops_the_search_for_the_inside() {
        let points = BOW.map(DVec2::from)[..3].to_vec();
        let segments = [[0, 1], [1, 2], [2, 0]].map(|ends| ends.map(VertexId::new));
        let outline = Outline::new(points, segments.to_vec()).unwrap();
        let mut stop = |progress: Progress| match progress.stage == "find inside" {
            true => ControlFlow::Break(()),
            false => ControlFlow::Continue(()),
        };
        let error = outline
            .region(BuildOptions::default(), &mut stop)
            .unwrap_err();
        assert!(error.to_string().contains("find inside"), "{error}");
    }
}
