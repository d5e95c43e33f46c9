//! Marks: what is drawn, in the coordinates of the drawing, y up.

use super::color::Color;
use super::color_map::ColorMap;
use super::style::Style;

/// A point of the drawing, `[x, y]` with y up.
pub type Point = [f64; 2];

/// On which side of its point a text stands.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Anchor {
    /// The text is centred on the point.
    #[default]
    Middle,
    /// The text starts at the point.
    Start,
    /// The text ends at the point.
    End,
}

#[derive(Clone, Debug)]
pub(super) enum Mark {
    Lines(Vec<Vec<Point>>),
    Polygons {
        rings: Vec<Vec<Point>>,
        color: Option<Color>,
    },
    Circle {
        center: Point,
        radius: f64,
    },
    Dot {
        center: Point,
        pixels: f64,
    },
    Text {
        at: Point,
        nudge: Point,
        anchor: Anchor,
        text: String,
    },
    Arrow {
        from: Point,
        to: Point,
    },
}

/// Marks that share a name and a style; one group of the SVG document.
#[derive(Clone, Debug)]
pub struct Layer {
    pub(super) name: String,
    pub(super) style: Style,
    pub(super) marks: Vec<Mark>,
}

impl Layer {
    pub(super) fn new(name: &str, style: Style) -> Self {
        Self {
            name: name.to_owned(),
            style,
            marks: Vec::new(),
        }
    }

    /// An open line through points, at least two.
    pub fn polyline<P: Into<Point>>(&mut self, points: impl IntoIterator<Item = P>) -> &mut Self {
        self.polylines([points])
    }

    /// Open lines that are one mark, which takes less room than a mark each.
    pub fn polylines<P: Into<Point>>(
        &mut self,
        lines: impl IntoIterator<Item = impl IntoIterator<Item = P>>,
    ) -> &mut Self {
        self.push(Mark::Lines(gathered(lines)))
    }

    /// A closed polygon.
    pub fn polygon<P: Into<Point>>(&mut self, corners: impl IntoIterator<Item = P>) -> &mut Self {
        self.polygons([corners])
    }

    /// Closed polygons that are one mark.
    pub fn polygons<P: Into<Point>>(
        &mut self,
        polygons: impl IntoIterator<Item = impl IntoIterator<Item = P>>,
    ) -> &mut Self {
        self.push(Mark::Polygons {
            rings: gathered(polygons),
            color: None,
        })
    }

    /// Closed polygons coloured by a value each, one mark per class of `map`; the style of the layer does not apply.
    pub fn colored_polygons<P: Into<Point>>(
        &mut self,
        map: &ColorMap,
        polygons: impl IntoIterator<Item = (impl IntoIterator<Item = P>, f64)>,
    ) -> &mut Self {
        // The last class holds values that are no number.
        let mut classes = vec![Vec::new(); ColorMap::CLASSES + 1];
        for (corners, value) in polygons {
            let class = map.class(value).unwrap_or(ColorMap::CLASSES);
            classes[class].push(corners.into_iter().map(Into::into).collect());
        }
        for (class, rings) in classes
            .into_iter()
            .enumerate()
            .filter(|(_, rings)| !rings.is_empty())
        {
            let color = if class < ColorMap::CLASSES {
                ColorMap::class_color(class)
            } else {
                Color::WHITE
            };
            self.push(Mark::Polygons {
                rings,
                color: Some(color),
            });
        }
        self
    }

    /// A circle whose radius is measured in the drawing.
    pub fn circle(&mut self, center: impl Into<Point>, radius: f64) -> &mut Self {
        self.push(Mark::Circle {
            center: center.into(),
            radius,
        })
    }

    /// A dot whose radius is measured in pixels, in the fill colour of the layer, or else its stroke's.
    pub fn dot(&mut self, center: impl Into<Point>, pixels: f64) -> &mut Self {
        self.push(Mark::Dot {
            center: center.into(),
            pixels,
        })
    }

    /// Text beside a point: moved by `nudge` pixels, x to the right and y up. The characters `<`, `>` and `&` stand for themselves.
    pub fn text(
        &mut self,
        at: impl Into<Point>,
        nudge: Point,
        anchor: Anchor,
        text: &str,
    ) -> &mut Self {
        self.push(Mark::Text {
            at: at.into(),
            nudge,
            anchor,
            text: text.to_owned(),
        })
    }

    /// A straight arrow with its head at `to`.
    pub fn arrow(&mut self, from: impl Into<Point>, to: impl Into<Point>) -> &mut Self {
        self.push(Mark::Arrow {
            from: from.into(),
            to: to.into(),
        })
    }

    fn push(&mut self, mark: Mark) -> &mut Self {
        self.marks.push(mark);
        self
    }
}

fn gathered<P: Into<Point>>(
    lines: impl IntoIterator<Item = impl IntoIterator<Item = P>>,
) -> Vec<Vec<Point>> {
    lines
        .into_iter()
        .map(|line| line.into_iter().map(Into::into).collect())
        .collect()
}
