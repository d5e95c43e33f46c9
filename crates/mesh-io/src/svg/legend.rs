//! Colour bars and keys.

use std::fmt::Write;

use super::color::Color;
use super::color_map::ColorMap;
use super::draw::Attributes;
use super::number::Rounded;
use super::panel::ColorBar;
use super::picture::Sample;
use super::style::{Stroke, Style};
use super::write::{Escaped, TEXT_SIZE};

pub(super) const KEY_HEIGHT: f64 = 30.0;

/// Pixels from the panel to the bar, of the bar, and of its tick labels.
const BAR: [f64; 3] = [14.0, 12.0, 46.0];

/// Pixels of a sample in the key, and between entries.
const SAMPLE: f64 = 28.0;
const ENTRY_GAP: f64 = 24.0;

/// Mean width of a letter in units of its size, enough to centre a line of text.
const LETTER: f64 = 0.52;

pub(super) fn color_bar_width(bar: Option<&ColorBar>) -> f64 {
    bar.map_or(0.0, |_| BAR.iter().sum())
}

/// A bar to the right of the panel's edge, as tall as three quarters of the panel, bright end up.
pub(super) fn color_bar(
    body: &mut String,
    bar: &ColorBar,
    [edge, top]: [f64; 2],
    panel_height: f64,
) {
    let (left, height) = (edge + BAR[0], 0.75 * panel_height);
    let upper = top + 0.125 * panel_height;
    let _ = writeln!(
        body,
        "<g data-layer=\"colour bar\" fill=\"{}\">",
        Color::INK
    );
    // Every class reaches down to the foot of the bar and is covered by the next darker one: no hairline gaps.
    for class in (0..ColorMap::CLASSES).rev() {
        let share = (class + 1) as f64 / ColorMap::CLASSES as f64 * height;
        let [x, y, w, h] = [left, upper + height - share, BAR[1], share].map(Rounded);
        let color = ColorMap::class_color(class);
        let _ = writeln!(
            body,
            "<rect x=\"{x}\" y=\"{y}\" width=\"{w}\" height=\"{h}\" fill=\"{color}\"/>"
        );
    }
    let (x, y) = (Rounded(left + BAR[1]), Rounded(upper - 10.0));
    let _ = writeln!(
        body,
        "<text x=\"{x}\" y=\"{y}\" text-anchor=\"middle\">{}</text>",
        Escaped(&bar.title)
    );
    for &tick in &bar.ticks {
        let fraction = (tick - bar.map.low()) / (bar.map.high() - bar.map.low());
        if (0.0..=1.0).contains(&fraction) {
            let (x, y) = (left + BAR[1], upper + (1.0 - fraction) * height);
            color_bar_tick(body, [x, y], tick, &bar.unit);
        }
    }
    body.push_str("</g>\n");
}

fn color_bar_tick(body: &mut String, [x, y]: [f64; 2], tick: f64, unit: &str) {
    let (end, text, base) = (
        Rounded(x + 4.0),
        Rounded(x + 8.0),
        Rounded(y + 0.35 * TEXT_SIZE),
    );
    let (x, y, ink, tick, unit) = (
        Rounded(x),
        Rounded(y),
        Color::INK,
        Rounded(tick),
        Escaped(unit),
    );
    let _ = writeln!(
        body,
        "<path d=\"M{x} {y} {end} {y}\" stroke=\"{ink}\" stroke-width=\"0.8\"/>"
    );
    let _ = writeln!(body, "<text x=\"{text}\" y=\"{base}\">{tick}{unit}</text>");
}

/// Pixels of the whole key.
pub(super) fn key_width(entries: &[(String, Sample)]) -> f64 {
    let entries = entries
        .iter()
        .map(|(text, _)| entry_width(text) + ENTRY_GAP);
    (entries.sum::<f64>() - ENTRY_GAP).max(0.0)
}

fn entry_width(text: &str) -> f64 {
    SAMPLE + 6.0 + LETTER * TEXT_SIZE * text.chars().count() as f64
}

/// One line of samples and texts, centred.
pub(super) fn key(body: &mut String, entries: &[(String, Sample)], [center, y]: [f64; 2]) {
    let mut left = center - key_width(entries) / 2.0;
    body.push_str("<g data-layer=\"key\">\n");
    for (text, sample) in entries {
        key_sample(body, sample, [left, y]);
        let (x, base) = (Rounded(left + SAMPLE + 6.0), Rounded(y + 0.35 * TEXT_SIZE));
        let _ = writeln!(
            body,
            "<text x=\"{x}\" y=\"{base}\" fill=\"{}\">{}</text>",
            Color::INK,
            Escaped(text)
        );
        left += entry_width(text) + ENTRY_GAP;
    }
    body.push_str("</g>\n");
}

fn key_sample(body: &mut String, sample: &Sample, [left, y]: [f64; 2]) {
    let (x0, x1, middle) = (
        Rounded(left),
        Rounded(left + SAMPLE),
        Rounded(left + SAMPLE / 2.0),
    );
    let (line, upper) = (Rounded(y), Rounded(y - 6.0));
    let _ = match sample {
        Sample::Line(stroke) => {
            writeln!(
                body,
                "<path d=\"M{x0} {line} {x1} {line}\"{}/>",
                Attributes(Style::line(*stroke))
            )
        }
        Sample::Area(style) => {
            let (width, style) = (Rounded(SAMPLE), Attributes(*style));
            writeln!(
                body,
                "<rect x=\"{x0}\" y=\"{upper}\" width=\"{width}\" height=\"12\"{style}/>"
            )
        }
        Sample::Dot(color) => {
            let style = Attributes(Style {
                stroke: None::<Stroke>,
                fill: Some(*color),
            });
            writeln!(
                body,
                "<circle cx=\"{middle}\" cy=\"{line}\" r=\"3.5\"{style}/>"
            )
        }
    };
}
