//! How many triangles have which radius ratio: bars in a field, pixels from the lower left corner of a panel.

use delaunay_core::measure::Statistics;
use mesh_io::svg::{Anchor, Color, Panel, Stroke, Style};

/// Bars of a twentieth each.
const BINS: u16 = 20;

/// Pixels round the bars, and of a line of text.
const LEFT: f64 = 40.0;
const BELOW: f64 = 22.0;
const ABOVE: f64 = 24.0;
const LINE: f64 = 5.0;

/// A field for bars.
#[derive(Clone, Copy, Debug)]
pub(super) struct Field {
    /// The lower left corner.
    pub(super) corner: [f64; 2],
    /// Width and height.
    pub(super) size: [f64; 2],
}

/// Draws the bars of values from 0 to 1 with their shares of all, the tallest share being `tallest`.
pub(super) fn draw<I: Copy + Ord>(
    panel: &mut Panel,
    field: Field,
    title: &str,
    values: &Statistics<I>,
    tallest: f64,
) {
    let [x, y] = [field.corner[0] + LEFT, field.corner[1] + BELOW];
    let [width, height] = [field.size[0] - LEFT - 8.0, field.size[1] - BELOW - ABOVE];
    let place = |ratio: f64, share: f64| [x + ratio * width, y + share / tallest * height];
    let bars = shares(values).into_iter().enumerate();
    let bars = bars.filter(|(_, share)| *share > 0.0).map(|(k, share)| {
        let [from, to] = [k, k + 1].map(|k| k as f64 / f64::from(BINS));
        [
            place(from, 0.0),
            place(to, 0.0),
            place(to, share),
            place(from, share),
        ]
    });
    let bar = Style::line(Stroke::thin(Color::INK)).filled(Color::SKY);
    panel.layer(title, bar).polygons(bars);
    let axes = panel.layer("axes", Style::line(Stroke::thin(Color::INK)));
    axes.polyline([place(0.0, tallest), place(0.0, 0.0), place(1.0, 0.0)]);
    let text = panel.layer("labels", Style::area(Color::INK));
    for tenth in (0..=10).step_by(2) {
        let ratio = f64::from(tenth) / 10.0;
        let [at, _] = place(ratio, 0.0);
        text.text(
            [at, y - 3.0 * LINE],
            [0.0; 2],
            Anchor::Middle,
            &format!("{ratio:.1}"),
        );
    }
    for share in [0.25, 0.5, 0.75]
        .into_iter()
        .filter(|share| *share < tallest)
    {
        let [left, at] = place(0.0, share);
        text.text(
            [left - LINE, at - LINE],
            [0.0; 2],
            Anchor::End,
            &format!("{:.0} %", 100.0 * share),
        );
    }
    text.text(
        [x + width / 2.0, y + height + LINE],
        [0.0; 2],
        Anchor::Middle,
        title,
    );
}

/// The share of the fullest bar.
pub(super) fn tallest<I: Copy + Ord>(values: &Statistics<I>) -> f64 {
    shares(values).into_iter().fold(0.0, f64::max)
}

fn shares<I: Copy + Ord>(values: &Statistics<I>) -> Vec<f64> {
    let counts = values.histogram(0.0, 1.0, BINS).counts;
    let all = values.count() as f64;
    counts.into_iter().map(|count| count as f64 / all).collect()
}
