//! Graphs of numbers by rounds: the only place that draws axes.
//!
//! Graphs stand one above the other on one panel, whose coordinates are pixels from its lower left corner.

use mesh_io::svg::{Anchor, Color, Panel, Stroke, Style, Window};

use super::table::grouped;

/// A graph: lines over the numbers of rounds, 0 first.
#[derive(Clone, Debug)]
pub(super) struct Graph {
    scale: Scale,
    lines: Vec<Line>,
}

/// What equal steps upwards mean.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Scale {
    /// Equal differences, from zero.
    Linear,
    /// Equal ratios. Values that are not positive are left out.
    Log,
}

#[derive(Clone, Debug)]
struct Line {
    name: String,
    stroke: Stroke,
    values: Vec<f64>,
}

impl Graph {
    /// A graph without lines.
    pub(super) const fn new(scale: Scale) -> Self {
        let lines = Vec::new();
        Self { scale, lines }
    }

    /// The same with a line that has one value for each round.
    #[must_use]
    pub(super) fn line(
        mut self,
        name: &str,
        stroke: Stroke,
        values: impl IntoIterator<Item = f64>,
    ) -> Self {
        self.lines.push(Line {
            name: name.to_owned(),
            stroke,
            values: values.into_iter().collect(),
        });
        self
    }

    fn values(&self) -> impl Iterator<Item = f64> + '_ {
        let values = self.lines.iter().flat_map(|line| line.values.iter());
        values.copied().filter(|&value| self.scale.has(value))
    }

    /// The number of the last round.
    fn last(&self) -> f64 {
        let rounds = self.lines.iter().map(|line| line.values.len());
        rounds.max().unwrap_or(0).saturating_sub(1) as f64
    }
}

/// Graphs one above the other, the first on top, on a panel of a size in pixels.
pub(super) fn stacked(graphs: &[Graph], [width, height]: [f64; 2]) -> Panel {
    let mut panel = Panel::new(Window::new([0.0; 2], [width, height])).width(width);
    let share = height / graphs.len().max(1) as f64;
    for (k, graph) in graphs.iter().enumerate() {
        let foot = height - (k + 1) as f64 * share;
        draw(&mut panel, graph, [width, share], foot);
    }
    panel
}

/// Pixels round the field of a graph: left for the labels of ticks, right for half of one, below the same, above the names of
/// its lines.
const LEFT: f64 = 68.0;
const RIGHT: f64 = 12.0;
const BELOW: f64 = 22.0;
const ABOVE: f64 = 26.0;

/// Pixels of a tick, and between it and its label.
const TICK: f64 = 4.0;
const GAP: f64 = 4.0;

/// Pixels of a line in the heading, between entries, and of a letter on average.
const SAMPLE: f64 = 20.0;
const ENTRY_GAP: f64 = 18.0;
const LETTER: f64 = 6.6;

const AXIS: Stroke = Stroke {
    color: Color::INK,
    width: 0.8,
    dotted: false,
};
const GRID: Stroke = Stroke::thin(Color::MIST);

fn draw(panel: &mut Panel, graph: &Graph, [width, height]: [f64; 2], foot: f64) {
    let across = Axis::new(Scale::Linear, [0.0, graph.last()], [LEFT, width - RIGHT]);
    let up = Axis::of(graph, [foot + BELOW, foot + height - ABOVE]);
    draw_axes(panel, &across, &up);
    for line in &graph.lines {
        draw_line(panel, line, &across, &up);
    }
    draw_heading(panel, graph, foot + height - ABOVE / 2.0);
}

/// Both axes with ticks and labels, and lines across at the ticks of the upright one.
fn draw_axes(panel: &mut Panel, across: &Axis, up: &Axis) {
    let ([left, right], [foot, top]) = (across.pixels, up.pixels);
    let [columns, rows] = [across, up].map(Axis::ticks);
    let grid = rows.iter().map(|&value| up.position(value));
    panel
        .layer("grid", Style::line(GRID))
        .polylines(grid.map(|y| [[left, y], [right, y]]));
    let axes = panel.layer("axes", Style::line(AXIS));
    axes.polyline([[left, top], [left, foot], [right, foot]]);
    axes.polylines(columns.iter().map(|&value| {
        let x = across.position(value);
        [[x, foot], [x, foot - TICK]]
    }));
    axes.polylines(rows.iter().map(|&value| {
        let y = up.position(value);
        [[left, y], [left - TICK, y]]
    }));
    let labels = panel.layer("labels of ticks", Style::area(Color::INK));
    for value in columns {
        let at = [across.position(value), foot - TICK - GAP - 5.0];
        labels.text(at, [0.0; 2], Anchor::Middle, &label(value));
    }
    for value in rows {
        let at = [left - TICK - GAP, up.position(value)];
        labels.text(at, [0.0; 2], Anchor::End, &label(value));
    }
}

/// A line, broken where a value has no place on the scale.
fn draw_line(panel: &mut Panel, line: &Line, across: &Axis, up: &Axis) {
    let points: Vec<(f64, f64)> = line
        .values
        .iter()
        .enumerate()
        .map(|(round, &value)| (round as f64, value))
        .collect();
    let runs = points.split(|&(_, value)| !up.scale.has(value));
    let drawn = runs.filter(|run| !run.is_empty()).map(|run| {
        run.iter()
            .map(|&(round, value)| [across.position(round), up.position(value)])
    });
    panel
        .layer(&line.name, Style::line(line.stroke))
        .polylines(drawn);
}

/// The names of the lines, each after a piece of it.
fn draw_heading(panel: &mut Panel, graph: &Graph, y: f64) {
    let mut x = LEFT;
    for line in &graph.lines {
        let layer = panel.layer(&format!("name of {}", line.name), Style::line(line.stroke));
        layer.polyline([[x, y], [x + SAMPLE, y]]);
        x += SAMPLE + 6.0;
        panel.layer("name", Style::area(Color::INK)).text(
            [x, y],
            [0.0; 2],
            Anchor::Start,
            &line.name,
        );
        x += LETTER * line.name.chars().count() as f64 + ENTRY_GAP;
    }
}

/// From values to pixels.
struct Axis {
    scale: Scale,
    values: [f64; 2],
    pixels: [f64; 2],
}

impl Axis {
    fn new(scale: Scale, values: [f64; 2], pixels: [f64; 2]) -> Self {
        Self {
            scale,
            values,
            pixels,
        }
    }

    /// The upright axis of a graph: a little longer than its values ask for.
    fn of(graph: &Graph, pixels: [f64; 2]) -> Self {
        let lowest = graph.values().fold(f64::INFINITY, f64::min);
        let highest = graph.values().fold(f64::NEG_INFINITY, f64::max);
        let values = match graph.scale {
            _ if lowest > highest => [1.0, 1.0],
            Scale::Linear => [0.0, 1.05 * highest],
            Scale::Log => [lowest / 1.3, 1.1 * highest],
        };
        Self::new(graph.scale, values, pixels)
    }

    fn position(&self, value: f64) -> f64 {
        let [low, high] = self.values.map(|end| self.scale.measure(end));
        let [first, last] = self.pixels;
        let fraction = (self.scale.measure(value) - low) / (high - low).max(f64::MIN_POSITIVE);
        first + fraction * (last - first)
    }

    /// Round values, some three to seven of them.
    fn ticks(&self) -> Vec<f64> {
        let [low, high] = self.values;
        match self.scale {
            Scale::Linear => {
                let step = round_step((high - low) / 4.0);
                let first = (low / step).ceil() as i64;
                let last = (high / step).floor() as i64;
                (first..=last).map(|k| k as f64 * step).collect()
            }
            Scale::Log => {
                let fine = log_ticks(self.values, &[1.0, 2.0, 5.0]);
                if fine.len() <= 7 {
                    fine
                } else {
                    log_ticks(self.values, &[1.0])
                }
            }
        }
    }
}

impl Scale {
    /// Whether a value has a place.
    fn has(self, value: f64) -> bool {
        value.is_finite() && (self == Self::Linear || value > 0.0)
    }

    fn measure(self, value: f64) -> f64 {
        match self {
            Self::Linear => value,
            Self::Log => value.ln(),
        }
    }
}

/// The smallest of 1, 2, 5, 10, 20 ... that is not below `least`.
fn round_step(least: f64) -> f64 {
    let mut decade = 1.0;
    loop {
        let steps = [1.0, 2.0, 5.0].map(|factor| factor * decade);
        if let Some(step) = steps.into_iter().find(|&step| step >= least) {
            return step;
        }
        decade *= 10.0;
        if !f64::is_finite(least) {
            return decade;
        }
    }
}

/// The factors times powers of ten that lie between two positive values.
fn log_ticks([low, high]: [f64; 2], factors: &[f64]) -> Vec<f64> {
    let decades = (-12..=12).map(|power| 10f64.powi(power));
    let ticks = decades.flat_map(|decade| factors.iter().map(move |factor| factor * decade));
    ticks.filter(|tick| (low..=high).contains(tick)).collect()
}

fn label(value: f64) -> String {
    if value.fract() == 0.0 && value >= 0.0 {
        grouped(value as usize)
    } else {
        value.to_string()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn linear_ticks_are_round_and_few() {
        let axis = Axis::new(Scale::Linear, [0.0, 16_800.0], [0.0, 100.0]);
        assert_eq!(axis.ticks(), [0.0, 5000.0, 10_000.0, 15_000.0]);
        let axis = Axis::new(Scale::Linear, [0.0, 0.0], [0.0, 100.0]);
        assert_eq!(axis.ticks(), [0.0]);
    }

    #[test]
    fn log_ticks_thin_out_over_many_decades() {
        let ticks = |high| Axis::new(Scale::Log, [0.6, high], [0.0, 100.0]).ticks();
        assert_eq!(ticks(25.0), [1.0, 2.0, 5.0, 10.0, 20.0]);
        assert_eq!(ticks(2000.0), [1.0, 10.0, 100.0, 1000.0]);
    }

    #[test]
    fn equal_ratios_are_equal_steps_of_a_log_axis() {
        let axis = Axis::new(Scale::Log, [1.0, 100.0], [10.0, 30.0]);
        let positions = [1.0, 10.0, 100.0].map(|value| axis.position(value));
        assert!(
            positions
                .iter()
                .zip([10.0, 20.0, 30.0])
                .all(|(a, b)| (a - b).abs() < 1e-9)
        );
    }

    #[test]
    fn what_has_no_place_breaks_a_line_and_nothing_else() {
        let graph = Graph::new(Scale::Log).line("few", AXIS, [3.0, 0.0, 4.0, f64::NAN]);
        assert_eq!(graph.values().collect::<Vec<_>>(), [3.0, 4.0]);
        assert_eq!(graph.last(), 3.0);
        let empty = Axis::of(&Graph::new(Scale::Linear), [0.0, 100.0]);
        assert!(empty.position(1.0).is_finite());
    }
}
