//! Pieces of curves: smooth from end to end.

use std::f64::consts::TAU;

use delaunay_core::geo_predicates::coordinate::{MAX_MAGNITUDE, MIN_MAGNITUDE};
use delaunay_core::geo_predicates::{Sign, check_points2, orient2d};
use glam::DVec2;

use super::error::CurveError;
use super::spline;
use super::stretch::{Arc, Stretch};

/// Angles, in radians, that differ by less are taken for the same.
const ROUNDING: f64 = 1e-12;

/// A smooth part of a [`Curve`](super::Curve), from one end to the other.
#[derive(Clone, Debug, PartialEq)]
pub struct Piece {
    /// At least one; each ends where the next begins.
    pub(super) stretches: Vec<Stretch>,
}

impl Piece {
    /// The straight piece from `a` to `b`.
    ///
    /// # Errors
    /// A coordinate that is not accepted, or two ends at one place.
    pub fn line(a: DVec2, b: DVec2) -> Result<Self, CurveError> {
        check_points2(&[a, b])?;
        if a == b {
            return Err(CurveError::NoLength);
        }
        Ok(Self::of(Stretch::Line([a, b])))
    }

    /// The arc of a circle from the angle `start` on, as far as `sweep`, in radians: counterclockwise when that is positive.
    ///
    /// # Errors
    /// A coordinate or a radius that is not accepted, an angle that is not finite, a sweep of zero or of more than a full turn.
    pub fn arc(center: DVec2, radius: f64, start: f64, sweep: f64) -> Result<Self, CurveError> {
        Self::elliptic_arc(center, [radius; 2], 0.0, [start, sweep])
    }

    /// The arc of an ellipse whose first half-axis has the angle `turn` to the x axis, the second one a quarter turn more.
    ///
    /// The angles of start and sweep are eccentric ones: the place at `a` is the sum of `cos a` first and `sin a` second half-axes.
    ///
    /// # Errors
    /// As [`arc`](Self::arc).
    pub fn elliptic_arc(
        center: DVec2,
        radii: [f64; 2],
        turn: f64,
        [start, sweep]: [f64; 2],
    ) -> Result<Self, CurveError> {
        check_points2(&[center])?;
        for radius in radii {
            check_radius(radius)?;
        }
        for angle in [turn, start, sweep] {
            check_angle(angle)?;
        }
        if sweep.abs() > TAU * (1.0 + ROUNDING) {
            return Err(CurveError::Angle { angle: sweep });
        }
        if sweep.abs() < ROUNDING {
            return Err(CurveError::NoLength);
        }
        let axis = DVec2::from_angle(turn);
        let (u, v) = (radii[0] * axis, radii[1] * axis.perp());
        let place = |angle: f64| center + angle.cos() * u + angle.sin() * v;
        let first = place(start);
        let is_whole = sweep.abs() >= TAU * (1.0 - ROUNDING);
        let last = if is_whole {
            first
        } else {
            place(start + sweep)
        };
        Ok(Self::of(Stretch::Arc(Arc {
            center,
            u,
            v,
            start,
            sweep: if is_whole { TAU.copysign(sweep) } else { sweep },
            ends: [first, last],
        })))
    }

    /// The arc of a circle from `a` through `via` to `b`; both ends are exact.
    ///
    /// # Errors
    /// A coordinate that is not accepted, or three points on a line.
    pub fn arc_through(a: DVec2, via: DVec2, b: DVec2) -> Result<Self, CurveError> {
        check_points2(&[a, via, b])?;
        let turn = orient2d(a, via, b);
        let (p, q) = (via - a, b - a);
        let doubled = 2.0 * p.perp_dot(q);
        let offset = (q.perp() * p.length_squared() - p.perp() * q.length_squared()) / doubled;
        // Seen from `a`, the center is where the bisectors of both chords meet.
        let (center, radius) = (a - offset, offset.length());
        if turn == Sign::Zero || check_radius(radius).is_err() {
            return Err(CurveError::Straight);
        }
        let [start, end] = [a, b].map(|end| (end - center).to_angle());
        let sweep = match turn {
            Sign::Positive => (end - start).rem_euclid(TAU),
            _ => -(start - end).rem_euclid(TAU),
        };
        Ok(Self::of(Stretch::Arc(Arc {
            center,
            u: radius * DVec2::X,
            v: radius * DVec2::Y,
            start,
            sweep,
            ends: [a, b],
        })))
    }

    /// The cubic with these control points of Bézier; it begins at the first and ends at the last.
    ///
    /// # Errors
    /// A coordinate that is not accepted, or four points at one place.
    pub fn bezier(control: [DVec2; 4]) -> Result<Self, CurveError> {
        check_points2(&control)?;
        if control.iter().all(|&point| point == control[0]) {
            return Err(CurveError::NoLength);
        }
        Ok(Self::of(Stretch::Cubic(control)))
    }

    /// The natural cubic spline through the points in their order, twice continuously differentiable in the chord length.
    ///
    /// Its second derivative is zero at both ends. Only the first and the last point are nodes for sure.
    ///
    /// # Errors
    /// A coordinate that is not accepted, fewer than two points, or two consecutive points at one place.
    pub fn spline(points: &[DVec2]) -> Result<Self, CurveError> {
        check_knots(points, 2)?;
        if let Some(before) = points.windows(2).position(|pair| pair[0] == pair[1]) {
            let index = before + 1;
            return Err(CurveError::RepeatedPoint { index });
        }
        Ok(Self {
            stretches: spline::open(points),
        })
    }

    /// The straight stretches from each point to the next.
    pub(crate) fn straight(points: &[DVec2]) -> Result<Self, CurveError> {
        let sides = points.windows(2).map(|ends| Self::line(ends[0], ends[1]));
        let sides: Vec<Self> = sides.collect::<Result<_, _>>()?;
        Ok(Self {
            stretches: sides.into_iter().flat_map(|side| side.stretches).collect(),
        })
    }

    /// The periodic cubic spline through the points in their order and back to the first.
    pub(super) fn closed_spline(points: &[DVec2]) -> Result<Self, CurveError> {
        check_knots(points, 3)?;
        let before = |i: usize| (i + points.len() - 1) % points.len();
        if let Some(index) = (0..points.len()).find(|&i| points[i] == points[before(i)]) {
            return Err(CurveError::RepeatedPoint { index });
        }
        Ok(Self {
            stretches: spline::closed(points),
        })
    }

    /// Where it begins and where it ends.
    #[must_use]
    pub fn ends(&self) -> [DVec2; 2] {
        let [first, last] = [self.stretches.first(), self.stretches.last()];
        let end =
            |stretch: Option<&Stretch>, end: usize| stretch.map_or(DVec2::NAN, |s| s.ends()[end]);
        [end(first, 0), end(last, 1)]
    }

    fn of(stretch: Stretch) -> Self {
        let stretches = vec![stretch];
        Self { stretches }
    }
}

fn check_radius(radius: f64) -> Result<(), CurveError> {
    match (MIN_MAGNITUDE..=MAX_MAGNITUDE).contains(&radius) {
        true => Ok(()),
        false => Err(CurveError::Radius { radius }),
    }
}

fn check_angle(angle: f64) -> Result<(), CurveError> {
    match angle.is_finite() {
        true => Ok(()),
        false => Err(CurveError::Angle { angle }),
    }
}

fn check_knots(points: &[DVec2], least: usize) -> Result<(), CurveError> {
    check_points2(points)?;
    let count = points.len();
    match count >= least {
        true => Ok(()),
        false => Err(CurveError::TooFewPoints { count, least }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{FRAC_PI_2, PI};

    const O: DVec2 = DVec2::ZERO;

    fn error(piece: Result<Piece, CurveError>) -> String {
        piece.unwrap_err().to_string()
    }

    #[test]
    fn what_is_no_piece_is_named() {
        insta::assert_snapshot!(error(Piece::line(O, O)), @"the piece has no length");
        insta::assert_snapshot!(error(Piece::line(O, DVec2::NAN)), @"point 1 has x = NaN, which is neither zero nor of magnitude 2^-142 to 2^201 (about 1.8e-43 to 3.2e60)");
        insta::assert_snapshot!(error(Piece::arc(O, 0.0, 0.0, 1.0)), @"the radius 0e0 is not a number of 2^-142 to 2^201 (about 1.8e-43 to 3.2e60)");
        insta::assert_snapshot!(error(Piece::arc(O, f64::INFINITY, 0.0, 1.0)), @"the radius inf is not a number of 2^-142 to 2^201 (about 1.8e-43 to 3.2e60)");
        insta::assert_snapshot!(error(Piece::arc(O, 1.0, 0.0, 7.0)), @"the angle 7 is not finite, or more than a full turn");
        insta::assert_snapshot!(error(Piece::arc(O, 1.0, f64::NAN, 1.0)), @"the angle NaN is not finite, or more than a full turn");
        insta::assert_snapshot!(error(Piece::arc(O, 1.0, 0.0, 0.0)), @"the piece has no length");
        insta::assert_snapshot!(error(Piece::arc_through(O, DVec2::X, 2.0 * DVec2::X)), @"no circle goes through three points on a line");
        insta::assert_snapshot!(error(Piece::bezier([DVec2::ONE; 4])), @"the piece has no length");
        insta::assert_snapshot!(error(Piece::spline(&[O])), @"1 points are given, at least 2 are needed");
        insta::assert_snapshot!(error(Piece::spline(&[O, DVec2::X, DVec2::X])), @"point 2 is at the place of the point before it");
        insta::assert_snapshot!(error(Piece::closed_spline(&[O, DVec2::X, DVec2::Y, O])), @"point 0 is at the place of the point before it");
    }

    #[test]
    fn an_arc_through_points_meets_them_and_goes_round_the_right_way() {
        let places = [DVec2::X, DVec2::from_angle(2.0), DVec2::from_angle(-3.0)];
        for order in [[0, 1, 2], [2, 1, 0], [0, 2, 1], [1, 0, 2], [1, 2, 0]] {
            let [a, via, b] = order.map(|i| 3.0 * places[i] + DVec2::new(1.0, -2.0));
            let piece = Piece::arc_through(a, via, b).unwrap();
            assert_eq!(piece.ends(), [a, b]);
            let along = (0..=1000).map(|i| piece.stretches[0].point(f64::from(i) / 1000.0));
            let along: Vec<DVec2> = along.collect();
            assert!(
                along
                    .windows(2)
                    .all(|pair| pair[0].distance(pair[1]) < 0.02)
            );
            assert!(along.iter().any(|p| p.distance(via) < 0.01));
            assert!(
                along
                    .iter()
                    .all(|p| (p.distance(DVec2::new(1.0, -2.0)) - 3.0).abs() < 1e-12)
            );
        }
    }

    #[test]
    fn the_half_axes_of_an_ellipse_are_where_they_should_be() {
        let quarter =
            Piece::elliptic_arc(DVec2::X, [2.0, 1.0], FRAC_PI_2, [0.0, PI / 2.0]).unwrap();
        let [start, end] = quarter.ends();
        assert!(start.distance(DVec2::new(1.0, 2.0)) < 1e-15);
        assert!(end.distance(DVec2::ZERO) < 1e-15);
    }
}
