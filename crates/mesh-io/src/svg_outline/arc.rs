//! Elliptic arcs as cubic curves.

use kurbo::{Affine, BezPath, PathEl, Point, SvgArc, Vec2};

/// An arc from the point reached to another, as path data have it.
pub(super) struct Arc {
    pub(super) to: Point,
    /// Signs do not count.
    pub(super) radii: Vec2,
    /// Radians from the x axis to the first radius.
    pub(super) x_rotation: f64,
    /// Whether it turns by more than half a circle.
    pub(super) large: bool,
    /// Whether its angle grows.
    pub(super) sweep: bool,
}

impl Arc {
    /// A quarter of an ellipse along the axes, with growing angle.
    pub(super) fn quarter(radii: Vec2, to: impl Into<Point>) -> Self {
        Self {
            to: to.into(),
            radii,
            x_rotation: 0.0,
            large: false,
            sweep: true,
        }
    }
}

/// Appends an arc that begins where the curves end.
///
/// A cubic turns by 36 degrees at most and strays by less than 1e-6 of the greater radius, which is less than 1e-4 of the
/// extent of the drawing in any direction, whatever the transform; the end is met exactly. Radii too small to reach the end are
/// grown. An arc is a straight line where SVG says so, and where a radius is below 1e-5 of the other.
pub(super) fn push_arc(curves: &mut BezPath, from: impl Into<Point>, arc: &Arc) {
    const STRAY: f64 = 1e-6;
    let (from, to) = (from.into(), arc.to);
    // In units of the greater radius, as seen from the begin, since what is small is measured in absolute numbers below.
    let unit = arc.radii.x.abs().max(arc.radii.y.abs());
    let seen_from_begin = SvgArc {
        from: Point::ORIGIN,
        to: ((to - from) / unit).to_point(),
        radii: arc.radii / unit,
        x_rotation: arc.x_rotation,
        large_arc: arc.large,
        sweep: arc.sweep,
    };
    let unit_arc = if unit > 0.0 {
        kurbo::Arc::from_svg_arc(&seen_from_begin)
    } else {
        None
    };
    let to_place = Affine::translate(from.to_vec2()) * Affine::scale(unit);
    let mut cubics = unit_arc.map_or_else(Vec::new, |arc| {
        let stray = STRAY * arc.radii.x.max(arc.radii.y);
        arc.append_iter(stray)
            .map(|cubic| to_place * cubic)
            .collect()
    });
    match cubics.last_mut() {
        Some(PathEl::CurveTo(_, _, end)) => *end = to,
        _ => cubics.push(PathEl::LineTo(to)),
    }
    curves.extend(cubics);
}
