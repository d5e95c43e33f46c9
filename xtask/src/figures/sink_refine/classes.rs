//! Classes of ratios r/l, each with a colour.

use glam::DVec2;
use mesh_io::svg::{Color, Panel, Picture, Sample, Stroke, Style};

/// Those up to a bound that belong to no class before.
pub(super) struct Class {
    pub(super) bound: f64,
    pub(super) color: Color,
    pub(super) text: &'static str,
}

/// Classes in ascending order, the last without a bound, and the line round each piece.
pub(super) struct Classes {
    pub(super) all: &'static [Class],
    pub(super) edge: Stroke,
}

impl Classes {
    /// Draws pieces of known ratios, one layer for each class.
    pub(super) fn draw(&self, panel: &mut Panel, pieces: &[(f64, Vec<DVec2>)]) {
        for (index, class) in self.all.iter().enumerate() {
            let of_class = pieces
                .iter()
                .filter(|(ratio, _)| self.index_of(*ratio) == index);
            panel
                .layer(class.text, self.style(class))
                .polygons(of_class.map(|(_, corners)| corners.iter().copied()));
        }
    }

    /// Adds the classes to the key.
    pub(super) fn keyed(&self, picture: Picture) -> Picture {
        self.all.iter().fold(picture, |picture, class| {
            picture.key(class.text, Sample::Area(self.style(class)))
        })
    }

    fn style(&self, class: &Class) -> Style {
        Style::line(self.edge).filled(class.color)
    }

    fn index_of(&self, ratio: f64) -> usize {
        let class = self.all.iter().position(|class| ratio <= class.bound);
        class.unwrap_or(self.all.len() - 1)
    }
}
