//! Which triangles an outline encloses.
//!
//! The segments of the outline become edges of the constrained Delaunay triangulation of its vertices. Then the triangles
//! are told apart from the outside inwards: across a segment of the outline, outside becomes inside and inside outside.

use super::constrained::{ConstrainError, Constrained2, Crossings};
use super::crossing::{first_crossing, is_on};
use super::outline::Outline;
use super::subcomplex::Subcomplex2;
use crate::error::BuildError;
use crate::ids::{FaceId, VertexId};
use crate::options::BuildOptions;
use crate::progress::{Cancelled, Progress};
use std::ops::ControlFlow;
use thiserror::Error;

/// The constrained Delaunay triangulation of an outline, and which of its triangles are inside.
#[derive(Clone, Debug)]
pub struct Region {
    triangulation: Constrained2,
    /// By face.
    inside: Vec<bool>,
}

/// Why an outline bounds no triangles.
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
    /// A point given as one inside is on a segment.
    #[error("{vertex}, which is to be inside, is on segment {segment} of the outline")]
    OnSegment {
        /// The point.
        vertex: VertexId,
        /// Index of the segment.
        segment: usize,
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
    /// The triangulation, inside and outside; segment `i` of the outline is its segment `i`.
    #[must_use]
    pub fn triangulation(&self) -> &Constrained2 {
        &self.triangulation
    }

    /// The part inside. Takes the time of [`Constrained2::subcomplex`].
    #[must_use]
    pub fn subcomplex(&self) -> Subcomplex2 {
        self.triangulation.subcomplex(|f| self.is_inside(f))
    }

    /// Whether `f` is inside; ghosts and faces that do not exist are not.
    #[must_use]
    pub fn is_inside(&self, f: FaceId) -> bool {
        self.inside.get(f.index()).is_some_and(|&inside| inside)
    }

    /// Whether all triangles at a vertex are inside.
    fn surrounds(&self, v: VertexId) -> bool {
        self.triangulation.mesh().star(v).all(|f| self.is_inside(f))
    }

    /// The triangles inside, by id.
    pub fn faces(&self) -> impl Iterator<Item = FaceId> + Clone + '_ {
        self.triangulation.faces().filter(|&f| self.is_inside(f))
    }
}

impl Outline {
    /// The region that the outline bounds, in triangles with its vertices and no others.
    ///
    /// A place is inside when a path to it from infinity crosses the outline an odd number of times.
    ///
    /// Takes the time of [`Constrained2::build`] and linear time for the rest. When segments cross, the search for the first
    /// ones takes n log n and, in usual outlines, about √n for each that is not in order.
    ///
    /// # Errors
    /// - [`RegionError::Build`] when the vertices have no triangulation or `report` stops the work;
    /// - [`RegionError::Crossing`] when two segments cross or touch, which never goes unnoticed;
    /// - [`RegionError::OnSegment`], [`RegionError::NotInside`] when a point given as one inside is elsewhere.
    pub fn region(
        &self,
        options: BuildOptions,
        report: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Region, RegionError> {
        let (points, segments) = (self.points(), self.segments());
        let built = Constrained2::build(points, segments, Crossings::Refuse, options, report);
        let triangulation = match built {
            Ok(triangulation) => triangulation,
            Err(ConstrainError::Build(error)) => return Err(error.into()),
            Err(_) => return Err(self.why_not(&vec![true; segments.len()])),
        };
        let edge = |&[a, b]: &[VertexId; 2]| triangulation.mesh().find_half_edge(a, b);
        let is_through_vertex = |ends: &[VertexId; 2]| edge(ends).is_none();
        let through_vertices: Vec<bool> = segments.iter().map(is_through_vertex).collect();
        if through_vertices.contains(&true) {
            return Err(self.why_not(&through_vertices));
        }
        let components = triangulation.components(report)?;
        let inside = triangulation.mesh().faces().map(|f| components.is_odd(f));
        let region = Region {
            inside: inside.collect(),
            triangulation,
        };
        let mut interior = self.interior().iter();
        match interior.find(|&&v| !region.surrounds(v)) {
            Some(&vertex) => Err(RegionError::NotInside { vertex }),
            None => Ok(region),
        }
    }

    /// The error for an outline of which some segments cross others or lead through vertices.
    fn why_not(&self, suspect: &[bool]) -> RegionError {
        if let Some([first, second]) = first_crossing(self, suspect) {
            return RegionError::Crossing { first, second };
        }
        // Only a point that ends no segment is on one without crossing another.
        let place = |v: VertexId| self.points()[v.index()];
        let holds = |v: VertexId, ends: [VertexId; 2]| {
            let [a, b] = ends.map(place);
            is_on(place(v), [a, b])
        };
        let segments = (0..).zip(self.segments()).filter(|(i, _)| suspect[*i]);
        let on = segments.flat_map(|(segment, &ends)| {
            let interior = self.interior().iter().filter(move |&&v| holds(v, ends));
            interior.map(move |&vertex| RegionError::OnSegment { vertex, segment })
        });
        let vertex = self.interior().first().copied().unwrap_or(VertexId::GHOST);
        on.into_iter()
            .next()
            .unwrap_or(RegionError::NotInside { vertex })
    }
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
        insta::assert_snapshot!(region([2.0, 0.0]).unwrap_err(), @"v4, which is to be inside, is on segment 0 of the outline");
    }

    #[test]
    fn triangles_that_touch_at_a_vertex_are_both_inside() {
        let region = region(&BOW, &[&[0, 1, 2], &[0, 3, 4]]).unwrap();
        assert_eq!(region.faces().count(), 2);
        assert!(region.triangulation().faces().count() > 2);
    }

    #[test]
    fn a_loop_in_a_loop_is_a_hole() {
        let square = |s: f64| [[-s, -s], [s, -s], [s, s], [-s, s]];
        let points = [square(2.0), square(1.0)].concat();
        let region = region(&points, &[&[0, 1, 2, 3], &[4, 5, 6, 7]]).unwrap();
        assert_eq!(
            (
                region.faces().count(),
                region.triangulation().faces().count()
            ),
            (8, 10)
        );
    }

    #[test]
    fn what_does_not_exist_is_not_inside() {
        let region = region(&BOW[..3], &[&[0, 1, 2]]).unwrap();
        let faces = region.triangulation().mesh().face_count();
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
    fn segments_that_are_not_delaunay_become_edges() {
        let points = [[-9.0, 0.0], [0.0, -0.1], [9.0, 0.0], [0.0, 5.0]];
        let flat = [points.as_slice(), &[[0.0, -1.0]]].concat();
        let region = region(&flat, &[&[0, 2, 3], &[0, 1, 4]]).unwrap();
        assert_eq!(region.faces().count(), 2);
        assert_eq!(region.triangulation().check(), Ok(()));
        assert!(region.triangulation().as_delaunay().is_none());
        assert_eq!(region.subcomplex().check(), Ok(()));
    }

    #[test]
    fn outlines_that_touch_a_segment_are_named() {
        let points = [
            [0.0, 0.0],
            [4.0, 0.0],
            [4.0, 4.0],
            [2.0, 0.0],
            [3.0, -1.0],
            [1.0, -1.0],
        ];
        let error = region(&points, &[&[0, 1, 2], &[3, 4, 5]]).unwrap_err();
        insta::assert_snapshot!(error, @"segments 0 and 3 of the outline cross");
    }

    #[test]
    fn the_report_stops_the_search_for_the_inside() {
        let points = BOW.map(DVec2::from)[..3].to_vec();
        let segments = [[0, 1], [1, 2], [2, 0]].map(|ends| ends.map(VertexId::new));
        let outline = Outline::new(points, segments.to_vec()).unwrap();
        let mut stop = |progress: Progress| match progress.stage == "find parts" {
            true => ControlFlow::Break(()),
            false => ControlFlow::Continue(()),
        };
        let error = outline
            .region(BuildOptions::default(), &mut stop)
            .unwrap_err();
        assert!(error.to_string().contains("find parts"), "{error}");
    }
}
