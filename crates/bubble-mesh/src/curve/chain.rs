//! Curves: pieces that meet end to end.

use std::f64::consts::TAU;

use glam::DVec2;

use super::error::CurveError;
use super::interval::Interval;
use super::piece::Piece;
use super::stretch::Stretch;

/// Ends meet when they are closer than this part of the length of the curve.
const MEETING: f64 = 1e-9;

/// A closed loop or an open chain of smooth pieces.
///
/// The places where pieces meet, smoothly or in a corner, are nodes of every sampling; so are both ends of an open chain and the
/// place where a closed one begins.
///
/// ```
/// use bubble_mesh::curve::{Curve, Piece};
/// use glam::DVec2;
/// use std::f64::consts::PI;
///
/// // A stadium: two straight sides, two half circles.
/// let [a, b, c, d] = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]].map(DVec2::from);
/// let stadium = Curve::closed(vec![
///     Piece::line(a, b)?,
///     Piece::arc_through(b, DVec2::new(3.0, 1.0), c)?,
///     Piece::line(c, d)?,
///     Piece::arc_through(d, DVec2::new(-1.0, 1.0), a)?,
/// ])?;
/// assert!((stadium.length() - (4.0 + 2.0 * PI)).abs() < 1e-12);
/// assert!(Curve::closed(vec![Piece::line(a, b)?, Piece::line(c, d)?]).is_err());
/// # Ok::<(), bubble_mesh::curve::CurveError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    pieces: Vec<Piece>,
    is_closed: bool,
    length: f64,
}

impl Curve {
    /// The loop of these pieces, each of which begins where the one before it ends, the first where the last ends.
    ///
    /// Where ends differ, by less than 1e-9 of the length, the piece that begins says where the node is.
    ///
    /// # Errors
    /// No pieces, or two that do not meet.
    pub fn closed(pieces: Vec<Piece>) -> Result<Self, CurveError> {
        Self::of(pieces, true)
    }

    /// The chain of these pieces, each of which begins where the one before it ends.
    ///
    /// # Errors
    /// As [`closed`](Self::closed), but that first and last need not meet.
    pub fn open(pieces: Vec<Piece>) -> Result<Self, CurveError> {
        Self::of(pieces, false)
    }

    /// The loop of straight pieces with these corners.
    ///
    /// # Errors
    /// A coordinate that is not accepted, no corners, or two consecutive ones at one place.
    pub fn polygon(corners: &[DVec2]) -> Result<Self, CurveError> {
        let next = corners.iter().cycle().skip(1);
        let sides = corners.iter().zip(next);
        let sides: Result<_, _> = sides.map(|(&a, &b)| Piece::line(a, b)).collect();
        Self::closed(sides?)
    }

    /// The circle; its first node is in the direction of x.
    ///
    /// # Errors
    /// A coordinate or a radius that is not accepted.
    pub fn circle(center: DVec2, radius: f64) -> Result<Self, CurveError> {
        Self::closed(vec![Piece::arc(center, radius, 0.0, TAU)?])
    }

    /// The ellipse whose first half-axis has the angle `turn` to the x axis, in radians; its first node is at the end of it.
    ///
    /// # Errors
    /// A coordinate or a radius that is not accepted, or an angle that is not finite.
    pub fn ellipse(center: DVec2, radii: [f64; 2], turn: f64) -> Result<Self, CurveError> {
        Self::closed(vec![Piece::elliptic_arc(center, radii, turn, [0.0, TAU])?])
    }

    /// The periodic cubic spline through the points in their order, twice continuously differentiable in the chord length.
    ///
    /// Only the first point is a node for sure.
    ///
    /// # Errors
    /// A coordinate that is not accepted, fewer than three points, or two consecutive ones at one place.
    pub fn closed_spline(points: &[DVec2]) -> Result<Self, CurveError> {
        Self::closed(vec![Piece::closed_spline(points)?])
    }

    /// Whether it ends where it begins.
    #[must_use]
    pub fn is_closed(&self) -> bool {
        self.is_closed
    }

    /// The arc length, rounded in about the tenth digit.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.length
    }

    /// The pieces, in their order.
    #[must_use]
    pub fn pieces(&self) -> &[Piece] {
        &self.pieces
    }

    /// How many stretches it has, those of a spline between two of its points, one after the other.
    pub(crate) fn stretch_count(&self) -> f64 {
        let counts = self.pieces.iter().map(|piece| piece.stretches.len());
        counts.sum::<usize>() as f64
    }

    /// The place after so many stretches, whole ones and a part by its parameter.
    pub(crate) fn point(&self, at: f64) -> DVec2 {
        self.stretch_at(at)
            .map_or(DVec2::NAN, |(stretch, t)| stretch.point(t))
    }

    /// The derivative of [`Curve::point`].
    pub(crate) fn velocity(&self, at: f64) -> DVec2 {
        self.stretch_at(at)
            .map_or(DVec2::NAN, |(stretch, t)| stretch.velocity(t))
    }

    fn stretch_at(&self, at: f64) -> Option<(&Stretch, f64)> {
        let last = self.stretch_count() - 1.0;
        let before = at.floor().clamp(0.0, last);
        let mut skip = before as usize;
        for piece in &self.pieces {
            match piece.stretches.get(skip) {
                Some(stretch) => return Some((stretch, at - before)),
                None => skip -= piece.stretches.len(),
            }
        }
        None
    }

    fn of(pieces: Vec<Piece>, is_closed: bool) -> Result<Self, CurveError> {
        if pieces.is_empty() {
            return Err(CurveError::Empty);
        }
        let stretches = pieces.iter().flat_map(|piece| &piece.stretches);
        let length = stretches
            .flat_map(Interval::of)
            .map(|part| part.length)
            .sum();
        let curve = Self {
            pieces,
            is_closed,
            length,
        };
        curve.check_joints()?;
        Ok(curve)
    }

    fn check_joints(&self) -> Result<(), CurveError> {
        let count = self.pieces.len();
        for piece in usize::from(!self.is_closed)..count {
            let end = self.pieces[(piece + count - 1) % count].ends()[1];
            let gap = end.distance(self.pieces[piece].ends()[0]);
            if gap > MEETING * self.length {
                return Err(CurveError::Apart { piece, gap });
            }
        }
        Ok(())
    }
}
