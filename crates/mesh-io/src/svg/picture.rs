//! A picture: panels side by side under a title, above a key of the line styles.

use super::color::Color;
use super::error::PictureError;
use super::panel::Panel;
use super::style::{Stroke, Style};
use super::write::document;

/// What a key shows beside its text.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Sample {
    /// A piece of line.
    Line(Stroke),
    /// A small area.
    Area(Style),
    /// A dot.
    Dot(Color),
}

/// Panels side by side.
///
/// ```
/// use mesh_io::svg::{Color, Panel, Picture, Sample, Stroke, Style, Window};
///
/// let mut panel = Panel::new(Window::new([-1.5, -1.5], [1.5, 1.5])).caption("a circle");
/// let wall = Stroke::medium(Color::INK);
/// panel.layer("wall", Style::line(wall).filled(Color::MIST)).circle([0.0, 0.0], 1.0);
/// let svg = Picture::new("One circle").panel(panel).key("wall", Sample::Line(wall)).to_svg()?;
/// assert!(svg.starts_with("<svg ") && svg.contains("<circle cx=\"210\" cy=\"210\" r=\"140\"/>"));
/// # Ok::<(), mesh_io::svg::PictureError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Picture {
    pub(super) title: String,
    pub(super) panels: Vec<Panel>,
    pub(super) key: Vec<(String, Sample)>,
}

impl Picture {
    /// An empty picture with a title, which may be empty.
    #[must_use]
    pub fn new(title: &str) -> Self {
        Self {
            title: title.to_owned(),
            panels: Vec::new(),
            key: Vec::new(),
        }
    }

    /// The same with one more panel on the right.
    #[must_use]
    pub fn panel(mut self, panel: Panel) -> Self {
        self.panels.push(panel);
        self
    }

    /// The same with one more entry in the key below the panels.
    #[must_use]
    pub fn key(mut self, text: &str, sample: Sample) -> Self {
        self.key.push((text.to_owned(), sample));
        self
    }

    /// The SVG document: UTF-8, numbers with at most three decimals, the same bytes for the same picture.
    ///
    /// # Errors
    /// [`PictureError`] for a window that is empty and for coordinates that are not finite or more than a million pixels away.
    ///
    /// O(number of points).
    pub fn to_svg(&self) -> Result<String, PictureError> {
        document(self)
    }
}
