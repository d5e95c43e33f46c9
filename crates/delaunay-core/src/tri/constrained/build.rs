//! Points and segments to a triangulation: first the points, then one segment after the other.

use super::divide::{Crossings, Undivided};
use super::error::{ConstrainError, Crossing};
use super::recover::Crossed;
use super::triangulation::Constrained2;
use crate::ids::VertexId;
use crate::options::BuildOptions;
use crate::order::insertion_order;
use crate::progress::{Meter, Progress};
use crate::tri::delaunay::Delaunay2;
use glam::DVec2;
use std::ops::ControlFlow;

impl Constrained2 {
    /// The constrained Delaunay triangulation of points and segments; the ends of segments count the points from 0.
    ///
    /// Points may be ends of any number of segments or of none. Segments may overlap, repeat each other and run
    /// through points; what they cover is the same whatever their order. Takes the time of [`Delaunay2::build_on`], and for
    /// each segment usually a time proportional to the number k of triangles that it crosses, k log k in any case where segments do not
    /// hide points from each other.
    ///
    /// # Errors
    /// - [`ConstrainError::Build`] when the points have no triangulation or `report` stops the work;
    /// - [`ConstrainError::NoSuchVertex`], [`ConstrainError::NoLength`] for the first segment that is none;
    /// - [`ConstrainError::Crossing`] when segments cross and `crossings` refuses that: all segments that others are in the way of;
    /// - [`ConstrainError::TooManyDivisions`] when `crossings` does not allow as many as there would be, and
    ///   [`ConstrainError::TooClose`] where segments cross that rounded numbers cannot tell apart.
    ///
    /// ```
    /// use delaunay_core::{BuildOptions, Constrained2, Crossings, VertexId, progress::silent};
    /// use glam::DVec2;
    ///
    /// let corners = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]].map(DVec2::from);
    /// let diagonals = [[0, 2], [1, 3]].map(|ends| ends.map(VertexId::new));
    /// let build = |crossings| Constrained2::build(&corners, &diagonals, crossings, BuildOptions::default(), &mut silent);
    ///
    /// let refused = build(Crossings::Refuse).unwrap_err();
    /// assert_eq!(refused.to_string(), "segments 0 and 1 cross near (2, 2)");
    ///
    /// let divided = build(Crossings::Divide { at_most: 10 })?;
    /// assert_eq!(divided.faces().count(), 4);
    /// assert_eq!(divided.chain(diagonals[1]), Some([1, 4, 3].map(VertexId::new).to_vec()));
    /// # Ok::<(), delaunay_core::ConstrainError>(())
    /// ```
    pub fn build(
        points: &[DVec2],
        segments: &[[VertexId; 2]],
        crossings: Crossings,
        options: BuildOptions,
        report: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Self, ConstrainError> {
        check_ends(points, segments)?;
        let mut constrained = Self::of(Delaunay2::build_on(points, options, report)?);
        let mut meter = Meter::start(report, "recover segments", segments.len())?;
        let blocked = constrained.add_all(segments, &mut meter)?;
        match crossings {
            Crossings::Refuse if blocked.is_empty() => Ok(constrained),
            Crossings::Refuse => Err(constrained.crossings(&blocked)),
            Crossings::Divide { at_most } => {
                constrained.divide_all(segments, &blocked, at_most, report)?;
                Ok(constrained)
            }
        }
    }

    /// Makes the straight way between two vertices a segment with this number.
    ///
    /// Vertices on the way divide it. Takes the time that [`build`](Self::build) takes for one segment. Numbers have 32 bits: those
    /// from 2^32 - 2 on count as that.
    ///
    /// # Errors
    /// As [`build`](Self::build) for a segment that is none; and [`ConstrainError::Crossing`] for the first segment in its way; the
    /// way is laid from both ends up to those in its way then.
    pub fn add_segment(
        &mut self,
        number: usize,
        ends: [VertexId; 2],
    ) -> Result<(), ConstrainError> {
        check_segment(self.points(), number, ends)?;
        let laid = self.lay(ends.map(|v| self.vertex_at(v)), label(number), 0);
        laid.map_err(|crossed| self.crossings(&[(number, crossed)]))
    }

    /// Lays all segments that none is in the way of; gives the others, by number.
    fn add_all(
        &mut self,
        segments: &[[VertexId; 2]],
        meter: &mut Meter<'_>,
    ) -> Result<Vec<(usize, Crossed)>, ConstrainError> {
        let mut blocked = Vec::new();
        for number in self.near_each_other(segments) {
            let number = number as usize;
            let ends = segments[number].map(|v| self.vertex_at(v));
            if let Err(crossed) = self.lay(ends, label(number), 0) {
                // What is laid is a part of it, too, however the rest is divided.
                self.paths.note(crossed.path());
                blocked.push((number, crossed));
            }
            meter.advance()?;
        }
        blocked.sort_unstable_by_key(|(number, _)| *number);
        Ok(blocked)
    }

    /// The numbers of the segments in an order that keeps neighbours together. It depends on points alone, as which segments
    /// are in the way of which depends on it; faces have other numbers on more threads.
    fn near_each_other(&self, segments: &[[VertexId; 2]]) -> Vec<u32> {
        let starts = segments.iter().map(|&[start, _]| self.point(start));
        insertion_order(&starts.collect::<Vec<DVec2>>())
    }

    fn divide_all(
        &mut self,
        segments: &[[VertexId; 2]],
        blocked: &[(usize, Crossed)],
        limit: usize,
        report: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<(), ConstrainError> {
        let mut meter = Meter::start(report, "divide segments", blocked.len())?;
        let mut left = limit;
        for (number, _) in blocked {
            let ends = segments[*number].map(|v| self.vertex_at(v));
            self.lay_dividing(ends, label(*number), &mut left, &mut meter)
                .map_err(|undivided| match undivided {
                    Undivided::Cancelled(cancelled) => cancelled.into(),
                    Undivided::OutOfDivisions => ConstrainError::TooManyDivisions { limit },
                    Undivided::TooClose(other) => ConstrainError::TooClose {
                        first: other.min(*number),
                        second: other.max(*number),
                    },
                })?;
            meter.advance()?;
        }
        Ok(())
    }

    /// The error that names segments and those in their ways.
    fn crossings(&self, blocked: &[(usize, Crossed)]) -> ConstrainError {
        let crossing = |(number, crossed): &(usize, Crossed)| {
            let other = crossed.segment;
            Crossing {
                segments: [other.min(*number), other.max(*number)],
                place: self.meeting(crossed.way(), crossed.edge),
            }
        };
        let mut crossings: Vec<Crossing> = blocked.iter().map(crossing).collect();
        crossings.sort_by_key(|crossing| crossing.segments);
        ConstrainError::Crossing { crossings }
    }
}

fn label(number: usize) -> u32 {
    u32::try_from(number.saturating_add(1)).unwrap_or(u32::MAX)
}

fn check_ends(points: &[DVec2], segments: &[[VertexId; 2]]) -> Result<(), ConstrainError> {
    let mut numbered = segments.iter().enumerate();
    numbered.try_for_each(|(segment, &ends)| check_segment(points, segment, ends))
}

fn check_segment(
    points: &[DVec2],
    segment: usize,
    [start, end]: [VertexId; 2],
) -> Result<(), ConstrainError> {
    // The ghost has an index beyond all.
    if let Some(vertex) = [start, end].into_iter().find(|v| v.index() >= points.len()) {
        return Err(ConstrainError::NoSuchVertex {
            segment,
            vertex,
            points: points.len(),
        });
    }
    match points[start.index()] == points[end.index()] {
        true => Err(ConstrainError::NoLength {
            segment,
            start,
            end,
        }),
        false => Ok(()),
    }
}
