//! Walks the XML and gathers the curves of all shapes.

use kurbo::{Affine, BezPath};
use memchr::memchr_iter;
use quick_xml::Reader;
use quick_xml::events::{BytesStart, Event};

use super::element::Element;
use super::{DEEPEST_NESTING, DrawingDefect, shape};
use crate::error::{ReadError, ReadProblem};
use crate::lines::quoted;

/// The curves of every shape, in a plane with y up.
pub(super) fn curves(text: &str) -> Result<BezPath, ReadError> {
    let mut reader = Reader::from_str(text);
    let mut lines = LineCounter::new(text);
    let mut walk = Walk::default();
    loop {
        let line = lines.line_of(reader.buffer_position() as usize);
        let event = reader
            .read_event()
            .map_err(|error| ReadProblem::Syntax(error.to_string()));
        let more = event.and_then(|event| walk.step(&event));
        if !more.map_err(|problem| ReadError::at_line(line, problem))? {
            return Ok(walk.curves);
        }
    }
}

/// What is known between two events.
#[derive(Default)]
struct Walk {
    /// The open elements, outermost first.
    open: Vec<Inside>,
    root_seen: bool,
    curves: BezPath,
}

/// What holds inside an element.
#[derive(Clone, Copy)]
enum Inside {
    /// Shapes are drawn, and brought into the plane by this map.
    Drawn(Affine),
    /// Nothing is drawn.
    Ignored,
}

impl Walk {
    /// Takes one event; whether more may follow.
    fn step(&mut self, event: &Event) -> Result<bool, ReadProblem> {
        match event {
            Event::Start(tag) => {
                let inside = self.enter(tag)?;
                self.open.push(inside);
            }
            Event::Empty(tag) => {
                self.enter(tag)?;
            }
            Event::End(_) => {
                self.open.pop();
            }
            Event::Text(text) if self.open.is_empty() && !text.trim().is_empty() => {
                return Err(unexpected("nothing outside of <svg>", text.trim()));
            }
            Event::Eof if !self.root_seen => return Err(truncated("an <svg>")),
            Event::Eof if !self.open.is_empty() => return Err(truncated("the end of an element")),
            Event::Eof => return Ok(false),
            _ => {}
        }
        Ok(true)
    }

    /// Draws an element if it is a shape, and says what holds inside it.
    fn enter(&mut self, tag: &BytesStart) -> Result<Inside, ReadProblem> {
        let element = Element::of(tag);
        if self.open.len() >= DEEPEST_NESTING {
            return Err(DrawingDefect::TooDeep {
                element: element.label(),
                limit: DEEPEST_NESTING,
            }
            .into());
        }
        let outer = match self.open.last() {
            Some(&outer) => outer,
            None => self.root(&element)?,
        };
        let Inside::Drawn(outer) = outer else {
            return Ok(Inside::Ignored);
        };
        let is_group = matches!(element.name(), "svg" | "g" | "a" | "switch");
        if !is_group && !shape::is_shape(&element) || !element.is_displayed()? {
            return Ok(Inside::Ignored);
        }
        let to_plane = outer * element.transform()?;
        if is_group {
            if !self.open.is_empty() {
                refuse_moved_drawing(&element)?;
            }
            return Ok(Inside::Drawn(to_plane));
        }
        let curves = to_plane * shape::curves(&element)?;
        if !curves.is_finite() {
            let element = element.label();
            return Err(DrawingDefect::NotFinite { element }.into());
        }
        self.curves.extend(curves);
        Ok(Inside::Ignored)
    }

    /// What holds around the outermost element, which must be one `<svg>`.
    fn root(&mut self, element: &Element) -> Result<Inside, ReadProblem> {
        if self.root_seen {
            return Err(unexpected("nothing after </svg>", element.name()));
        }
        if element.name() != "svg" {
            return Err(unexpected("an <svg>", element.name()));
        }
        self.root_seen = true;
        Ok(Inside::Drawn(Affine::FLIP_Y))
    }
}

/// Refuses a drawing inside the drawing that has a place or a scale of its own.
fn refuse_moved_drawing(element: &Element) -> Result<(), ReadProblem> {
    if element.name() == "svg" {
        for name in ["x", "y", "viewBox"] {
            if element.attribute(name)?.is_some() {
                let what = format!("{name} of the nested {}", element.label());
                return Err(ReadProblem::Unsupported(what));
            }
        }
    }
    Ok(())
}

fn unexpected(expected: &str, found: &str) -> ReadProblem {
    ReadProblem::Expected {
        expected: expected.into(),
        found: quoted(found),
    }
}

fn truncated(expected: &str) -> ReadProblem {
    ReadProblem::Truncated {
        expected: expected.into(),
    }
}

/// Counts lines on from the last position, so that a whole walk is linear.
struct LineCounter<'a> {
    text: &'a str,
    line: usize,
    counted: usize,
}

impl<'a> LineCounter<'a> {
    fn new(text: &'a str) -> Self {
        Self {
            text,
            line: 1,
            counted: 0,
        }
    }

    /// The line, from 1, of a position that is no less than the one before.
    fn line_of(&mut self, position: usize) -> usize {
        let passed = self.text.as_bytes().get(self.counted..position);
        self.line += memchr_iter(b'\n', passed.unwrap_or_default()).count();
        self.counted = position.max(self.counted);
        self.line
    }
}
