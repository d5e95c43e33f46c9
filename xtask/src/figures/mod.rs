//! The figures: each a pure function of fixtures that gives a picture and a summary with the paper's numbers beside ours.
//!
//! `golden` holds a figure against what `docs/figures` has of it; tests, `cargo xtask figures` and `--check` all go through it.

pub mod bubble_mesh;
pub mod cvt_tet;
pub mod golden;
pub mod medial_blocking;
mod plot;
mod shades;
pub mod sink_refine;
pub mod table;
pub mod tolerance;

use std::error::Error;

/// A figure as it is now.
#[derive(Clone, Debug)]
pub struct Rendered {
    /// The picture, an SVG document.
    pub svg: String,
    /// Our numbers beside the paper's, as text.
    pub summary: String,
}

/// What a figure's function gives.
pub type Render = Result<Rendered, Box<dyn Error>>;

/// A figure and how it is made.
#[derive(Clone, Copy, Debug)]
pub struct Figure {
    /// Its name: paper, number and subject, as in the names of its files.
    pub name: &'static str,
    /// What it shows, one or two sentences.
    pub caption: &'static str,
    /// Makes it.
    pub render: fn() -> Render,
}

/// All figures, in the order of the papers.
pub fn all() -> impl Iterator<Item = &'static Figure> {
    medial_blocking::FIGURES
        .iter()
        .chain(sink_refine::FIGURES)
        .chain(bubble_mesh::FIGURES)
        .chain(cvt_tet::FIGURES)
}
