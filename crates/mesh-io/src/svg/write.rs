//! The document: layout of title, panels and key.

use std::fmt::Write;

use super::color::Color;
use super::draw::draw_layer;
use super::error::PictureError;
use super::frame::Frame;
use super::legend::{KEY_HEIGHT, color_bar, color_bar_width, key, key_width};
use super::number::Rounded;
use super::panel::Panel;
use super::picture::Picture;

/// Pixels round the picture and between its panels.
const MARGIN: f64 = 12.0;
const GAP: f64 = 24.0;
const TITLE_HEIGHT: f64 = 30.0;
const CAPTION_HEIGHT: f64 = 26.0;

/// Pixels of the letters in titles and in everything else.
const TITLE_SIZE: f64 = 16.0;
pub(super) const TEXT_SIZE: f64 = 13.0;

pub(super) fn document(picture: &Picture) -> Result<String, PictureError> {
    let mut body = String::new();
    let panels: f64 = picture
        .panels
        .iter()
        .map(|panel| outer_width(panel) + GAP)
        .sum::<f64>()
        - GAP;
    let inner = panels.max(key_width(&picture.key)).max(0.0);
    let width = inner + 2.0 * MARGIN;
    let top = MARGIN
        + if picture.title.is_empty() {
            0.0
        } else {
            TITLE_HEIGHT
        };
    let mut left = MARGIN + (inner - panels) / 2.0;
    let tallest = picture.panels.iter().map(Panel::height).fold(0.0, f64::max);
    for (index, panel) in picture.panels.iter().enumerate() {
        draw_panel(&mut body, index, panel, [left, top])?;
        caption(
            &mut body,
            panel,
            [
                left + panel.width / 2.0,
                top + tallest + CAPTION_HEIGHT - 8.0,
            ],
        );
        left += outer_width(panel) + GAP;
    }
    let captioned = picture.panels.iter().any(|panel| panel.caption.is_some());
    let mut bottom = top + tallest + if captioned { CAPTION_HEIGHT } else { 0.0 };
    if !picture.key.is_empty() {
        bottom += KEY_HEIGHT;
        key(
            &mut body,
            &picture.key,
            [width / 2.0, bottom - KEY_HEIGHT / 2.0],
        );
    }
    title(&mut body, &picture.title, width);
    Ok(wrapped(&body, width, bottom + MARGIN))
}

/// Pixels of a panel with its colour bar.
fn outer_width(panel: &Panel) -> f64 {
    panel.width + color_bar_width(panel.color_bar.as_ref())
}

/// The document element round its body, on white paper.
fn wrapped(body: &str, width: f64, height: f64) -> String {
    let (width, height) = (Rounded(width), Rounded(height));
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\" \
         font-family=\"Helvetica, Arial, sans-serif\" font-size=\"{size}\" stroke-linejoin=\"round\" stroke-linecap=\"round\">\n\
         <rect width=\"{width}\" height=\"{height}\" fill=\"{paper}\"/>\n{body}</svg>\n",
        size = Rounded(TEXT_SIZE),
        paper = Color::WHITE,
    )
}

/// A panel is an inner document, which cuts off what lies outside its window.
fn draw_panel(
    body: &mut String,
    index: usize,
    panel: &Panel,
    [left, top]: [f64; 2],
) -> Result<(), PictureError> {
    let frame = Frame::of(index, panel)?;
    let (width, height) = (panel.width, panel.height());
    let [x, y, w, h] = [left, top, width, height].map(Rounded);
    let _ = writeln!(
        body,
        "<svg x=\"{x}\" y=\"{y}\" width=\"{w}\" height=\"{h}\">"
    );
    for layer in &panel.layers {
        draw_layer(body, &frame, layer)?;
    }
    body.push_str("</svg>\n");
    if let Some(bar) = &panel.color_bar {
        color_bar(body, bar, [left + width, top], height);
    }
    Ok(())
}

fn title(body: &mut String, text: &str, width: f64) {
    if !text.is_empty() {
        let (x, y) = (Rounded(width / 2.0), Rounded(MARGIN + TITLE_SIZE));
        let size = Rounded(TITLE_SIZE);
        let _ = writeln!(
            body,
            "<text x=\"{x}\" y=\"{y}\" font-size=\"{size}\" font-weight=\"bold\" text-anchor=\"middle\" fill=\"{}\">{}</text>",
            Color::INK,
            Escaped(text),
        );
    }
}

fn caption(body: &mut String, panel: &Panel, [x, y]: [f64; 2]) {
    if let Some(text) = &panel.caption {
        let (x, y) = (Rounded(x), Rounded(y));
        let _ = writeln!(
            body,
            "<text x=\"{x}\" y=\"{y}\" text-anchor=\"middle\" fill=\"{}\">{}</text>",
            Color::INK,
            Escaped(text)
        );
    }
}

/// Text in which what XML keeps for itself is escaped and what it forbids is replaced.
pub(super) struct Escaped<'a>(pub(super) &'a str);

impl std::fmt::Display for Escaped<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.0.chars().try_for_each(|c| match c {
            '<' => f.write_str("&lt;"),
            '>' => f.write_str("&gt;"),
            '&' => f.write_str("&amp;"),
            '"' => f.write_str("&quot;"),
            c if c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}') => f.write_char('\u{fffd}'),
            c => f.write_char(c),
        })
    }
}
