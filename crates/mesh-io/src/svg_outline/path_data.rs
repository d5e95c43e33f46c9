//! Path data: the attribute `d` as curves.

use kurbo::{BezPath, PathEl, Point, Vec2};
use svgtypes::{Error, PathParser, PathSegment};

use super::arc::{Arc, push_arc};

/// Longest gap that `Z` closes by moving the last point onto the first, as a share of the greatest coordinate so far.
///
/// Relative coordinates add up to a gap of some units in the last place where the drawing has none. A line over it would be
/// shorter by far than anything that is drawn.
const ROUNDING: f64 = 1e-12;

/// The curves that path data say, in absolute coordinates.
///
/// # Errors
/// What is no path data, with the position of the character to blame. SVG would draw what comes before it.
pub(super) fn curves(data: &str) -> Result<BezPath, Error> {
    let mut pen = Pen::default();
    for command in PathParser::from(data) {
        pen.draw(command?);
    }
    Ok(pen.curves)
}

/// What the next command may refer to.
#[derive(Default)]
struct Pen {
    curves: BezPath,
    /// Where the subpath began.
    start: Point,
    /// Where the last command ended.
    at: Point,
    /// The last control point of the last command.
    control: Control,
    /// The greatest coordinate of `at` so far, without its sign.
    greatest: f64,
}

/// A control point that a smooth curve continues.
#[derive(Clone, Copy, Default)]
enum Control {
    #[default]
    None,
    Quadratic(Point),
    Cubic(Point),
}

impl Pen {
    fn draw(&mut self, command: PathSegment) {
        let origin = if command.is_abs() {
            Vec2::ZERO
        } else {
            self.at.to_vec2()
        };
        let place = |x: f64, y: f64| Point::new(x, y) + origin;
        let control = std::mem::take(&mut self.control);
        match command {
            PathSegment::MoveTo { x, y, .. } => {
                self.at = place(x, y);
                self.start = self.at;
                self.curves.move_to(self.at);
            }
            PathSegment::LineTo { x, y, .. } => self.line_to(place(x, y)),
            PathSegment::HorizontalLineTo { x, .. } => {
                self.line_to(Point::new(x + origin.x, self.at.y));
            }
            PathSegment::VerticalLineTo { y, .. } => {
                self.line_to(Point::new(self.at.x, y + origin.y));
            }
            PathSegment::Quadratic { x1, y1, x, y, .. } => {
                self.quadratic_to(place(x1, y1), place(x, y));
            }
            PathSegment::SmoothQuadratic { x, y, .. } => {
                let first = match control {
                    Control::Quadratic(last) => self.mirrored(last),
                    _ => self.at,
                };
                self.quadratic_to(first, place(x, y));
            }
            PathSegment::CurveTo {
                x1,
                y1,
                x2,
                y2,
                x,
                y,
                ..
            } => self.cubic_to(place(x1, y1), place(x2, y2), place(x, y)),
            PathSegment::SmoothCurveTo { x2, y2, x, y, .. } => {
                let first = match control {
                    Control::Cubic(last) => self.mirrored(last),
                    _ => self.at,
                };
                self.cubic_to(first, place(x2, y2), place(x, y));
            }
            PathSegment::EllipticalArc {
                rx,
                ry,
                x_axis_rotation,
                large_arc,
                sweep,
                x,
                y,
                ..
            } => {
                let arc = Arc {
                    to: place(x, y),
                    radii: Vec2::new(rx, ry),
                    x_rotation: x_axis_rotation.to_radians(),
                    large: large_arc,
                    sweep,
                };
                push_arc(&mut self.curves, self.at, &arc);
                self.at = place(x, y);
            }
            PathSegment::ClosePath { .. } => self.close(),
        }
        self.greatest = self.greatest.max(self.at.x.abs()).max(self.at.y.abs());
    }

    fn close(&mut self) {
        if (self.at - self.start).hypot() <= ROUNDING * self.greatest
            && let Some(PathEl::LineTo(end) | PathEl::QuadTo(_, end) | PathEl::CurveTo(_, _, end)) =
                self.curves.elements_mut().last_mut()
        {
            *end = self.start;
        }
        self.curves.close_path();
        self.at = self.start;
    }

    fn line_to(&mut self, end: Point) {
        self.curves.line_to(end);
        self.at = end;
    }

    fn quadratic_to(&mut self, control: Point, end: Point) {
        self.curves.quad_to(control, end);
        self.control = Control::Quadratic(control);
        self.at = end;
    }

    fn cubic_to(&mut self, first: Point, second: Point, end: Point) {
        self.curves.curve_to(first, second, end);
        self.control = Control::Cubic(second);
        self.at = end;
    }

    /// The control point on the other side of where the pen is.
    fn mirrored(&self, control: Point) -> Point {
        self.at + (self.at - control)
    }
}
