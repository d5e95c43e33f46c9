//! Curves as chords.

use kurbo::{
    BezPath, CubicBez, ParamCurve, ParamCurveExtrema, PathSeg, Point, QuadBez, Rect, Vec2,
};

use super::graph::Joined;
use super::{DrawingDefect, FLATNESS, MOST_POINTS};
use crate::planar_graph::PlanarGraph;

/// The chords of curves with finite coordinates, joined where they meet.
pub(super) fn outlines(curves: &BezPath) -> Result<PlanarGraph, DrawingDefect> {
    // The other tenth is what the cubics of an arc stray from it.
    let tolerance = 0.9 * FLATNESS * diagonal(curves)?;
    let mut joined = Joined::default();
    for curve in curves.segments() {
        let chords = chord_count(curve, tolerance)?;
        let mut from = curve.start();
        for index in 1..=chords {
            let to = if index == chords {
                curve.end()
            } else {
                curve.eval(index as f64 / chords as f64)
            };
            joined.push(from, to)?;
            from = to;
        }
    }
    joined.graph()
}

/// Length of the diagonal of the bounding box.
fn diagonal(curves: &BezPath) -> Result<f64, DrawingDefect> {
    let boxes = curves.segments().map(|curve| curve.bounding_box());
    let all = boxes.reduce(|all, one| all.union(one));
    let size = all.map_or(Vec2::ZERO, |Rect { x0, y0, x1, y1 }| {
        Vec2::new(x1 - x0, y1 - y0)
    });
    let diagonal = size.hypot();
    if diagonal.is_finite() {
        Ok(diagonal)
    } else {
        Err(DrawingDefect::TooWide)
    }
}

/// A number of equal steps of the parameter whose chords stray by no more than the tolerance.
///
/// A chord over a step h strays by at most h^2 / 8 times the greatest second derivative, and that of a curve of degree d is at
/// most d (d - 1) times the longest second difference of its control points. Control points are no farther out than a fixed
/// multiple of the extent of the curve, so a curve has some dozens of chords. Source: Wang, 1984; Filip, Magedson and Markot,
/// "Surface algorithms using bounds on derivatives", CAGD 3, 1986.
fn chord_count(curve: PathSeg, tolerance: f64) -> Result<usize, DrawingDefect> {
    let second_difference = |a: Point, b: Point, c: Point| ((a - b) + (c - b)).hypot();
    let second_derivative = match curve {
        PathSeg::Line(_) => return Ok(1),
        PathSeg::Quad(QuadBez { p0, p1, p2 }) => 2.0 * second_difference(p0, p1, p2),
        PathSeg::Cubic(CubicBez { p0, p1, p2, p3 }) => {
            6.0 * second_difference(p0, p1, p2).max(second_difference(p1, p2, p3))
        }
    };
    let chords = (second_derivative / (8.0 * tolerance)).sqrt().ceil();
    if chords > MOST_POINTS as f64 {
        return Err(DrawingDefect::TooManyPoints { limit: MOST_POINTS });
    }
    // A curve without any extent gives 0 / 0, which becomes 0.
    Ok((chords as usize).max(1))
}
