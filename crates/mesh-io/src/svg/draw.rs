//! Marks as SVG elements.

use std::fmt::Write;

use super::color::Color;
use super::error::PictureError;
use super::frame::{Frame, Place};
use super::layer::{Anchor, Layer, Mark, Point};
use super::number::Rounded;
use super::style::{Stroke, Style};
use super::write::{Escaped, TEXT_SIZE};

/// Pixels of an arrow's head.
const HEAD: [f64; 2] = [8.0, 3.2];

/// Width of the line in its own colour that closes the hairline gap between neighbouring areas.
const SEAM: f64 = 0.4;

pub(super) fn draw_layer(
    body: &mut String,
    frame: &Frame,
    layer: &Layer,
) -> Result<(), PictureError> {
    let style = Attributes(layer.style);
    let _ = writeln!(body, "<g data-layer=\"{}\"{style}>", Escaped(&layer.name));
    for (index, mark) in layer.marks.iter().enumerate() {
        Pen {
            body,
            frame,
            style: layer.style,
            place: Place {
                layer: &layer.name,
                mark: index,
            },
        }
        .draw(mark)?;
    }
    body.push_str("</g>\n");
    Ok(())
}

/// Stroke and fill as attributes of an element.
pub(super) struct Attributes(pub(super) Style);

impl std::fmt::Display for Attributes {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self.0.fill {
            Some(color) => write!(f, " fill=\"{color}\"")?,
            None => f.write_str(" fill=\"none\"")?,
        }
        if let Some(Stroke {
            color,
            width,
            dotted,
        }) = self.0.stroke
        {
            write!(f, " stroke=\"{color}\" stroke-width=\"{}\"", Rounded(width))?;
            if dotted {
                write!(f, " stroke-dasharray=\"0.1 {}\"", Rounded(3.0 * width))?;
            }
        }
        Ok(())
    }
}

/// Draws the marks of one layer.
struct Pen<'a> {
    body: &'a mut String,
    frame: &'a Frame,
    style: Style,
    place: Place<'a>,
}

impl Pen<'_> {
    fn draw(&mut self, mark: &Mark) -> Result<(), PictureError> {
        match mark {
            Mark::Lines(lines) => self.path(lines, "", " fill=\"none\""),
            Mark::Polygons { rings, color: None } => self.path(rings, "Z", ""),
            Mark::Polygons {
                rings,
                color: Some(color),
            } => {
                let seam = Stroke {
                    color: *color,
                    width: SEAM,
                    dotted: false,
                };
                self.path(
                    rings,
                    "Z",
                    &Attributes(Style::line(seam).filled(*color)).to_string(),
                )
            }
            Mark::Circle { center, radius } => {
                let radius = self.frame.length(*radius, self.place)?;
                self.circle(*center, radius, "")
            }
            Mark::Dot { center, pixels } => {
                let attributes = format!(" stroke=\"none\" fill=\"{}\"", self.color());
                self.circle(*center, *pixels, &attributes)
            }
            Mark::Text {
                at,
                nudge,
                anchor,
                text,
            } => self.text(*at, *nudge, *anchor, text),
            Mark::Arrow { from, to } => self.arrow(*from, *to),
        }
    }

    /// The colour of what is neither line nor area.
    fn color(&self) -> Color {
        self.style
            .fill
            .or(self.style.stroke.map(|stroke| stroke.color))
            .unwrap_or(Color::INK)
    }

    fn path(
        &mut self,
        lines: &[Vec<Point>],
        close: &str,
        attributes: &str,
    ) -> Result<(), PictureError> {
        self.body.push_str("<path d=\"");
        for line in lines {
            for (k, &point) in line.iter().enumerate() {
                let [x, y] = self.frame.position(point, self.place)?;
                let command = if k == 0 { 'M' } else { ' ' };
                let _ = write!(self.body, "{command}{} {}", Rounded(x), Rounded(y));
            }
            self.body.push_str(close);
        }
        let _ = writeln!(self.body, "\"{attributes}/>");
        Ok(())
    }

    fn circle(&mut self, center: Point, pixels: f64, attributes: &str) -> Result<(), PictureError> {
        let [x, y] = self.frame.position(center, self.place)?.map(Rounded);
        let _ = writeln!(
            self.body,
            "<circle cx=\"{x}\" cy=\"{y}\" r=\"{}\"{attributes}/>",
            Rounded(pixels.max(0.0))
        );
        Ok(())
    }

    /// Text over a white halo, so that lines below do not disturb it.
    fn text(
        &mut self,
        at: Point,
        nudge: Point,
        anchor: Anchor,
        text: &str,
    ) -> Result<(), PictureError> {
        let [x, y] = self.frame.position(at, self.place)?;
        let (x, y) = (
            Rounded(x + nudge[0]),
            Rounded(y - nudge[1] + 0.35 * TEXT_SIZE),
        );
        let anchor = match anchor {
            Anchor::Start => "start",
            Anchor::Middle => "middle",
            Anchor::End => "end",
        };
        let (color, paper, text) = (self.color(), Color::WHITE, Escaped(text));
        for look in [
            format!("fill=\"{paper}\" stroke=\"{paper}\" stroke-width=\"3\""),
            format!("fill=\"{color}\" stroke=\"none\""),
        ] {
            let _ = writeln!(
                self.body,
                "<text x=\"{x}\" y=\"{y}\" text-anchor=\"{anchor}\" {look}>{text}</text>"
            );
        }
        Ok(())
    }

    fn arrow(&mut self, from: Point, to: Point) -> Result<(), PictureError> {
        self.path(&[vec![from, to]], "", " fill=\"none\"")?;
        let ([fx, fy], [x, y]) = (
            self.frame.position(from, self.place)?,
            self.frame.position(to, self.place)?,
        );
        let length = (x - fx).hypot(y - fy).max(f64::MIN_POSITIVE);
        let [dx, dy] = [(x - fx) / length, (y - fy) / length];
        let wing = |side: f64| {
            [
                x - HEAD[0] * dx - side * HEAD[1] * dy,
                y - HEAD[0] * dy + side * HEAD[1] * dx,
            ]
        };
        let [[ax, ay], [bx, by]] = [wing(1.0), wing(-1.0)].map(|point| point.map(Rounded));
        let (x, y, color) = (Rounded(x), Rounded(y), self.color());
        let _ = writeln!(
            self.body,
            "<path d=\"M{x} {y} {ax} {ay} {bx} {by}Z\" fill=\"{color}\" stroke=\"none\"/>"
        );
        Ok(())
    }
}
