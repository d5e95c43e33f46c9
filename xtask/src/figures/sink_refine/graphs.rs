//! What the graphs of figures 7 to 11 have in common.

use mesh_io::svg::{Color, Panel, Stroke};
use sink_refine::Round;

use crate::figures::plot::{Graph, Scale, stacked};

/// Pixels of the panel.
const SIZE: [f64; 2] = [424.0, 420.0];

/// A panel of graphs, one above the other.
pub(super) fn panel(graphs: &[Graph], caption: &str) -> Panel {
    stacked(graphs, SIZE).caption(caption)
}

/// Largest, mean and smallest r/l by rounds, and the bound above which quality is low.
pub(super) fn ratios(rounds: &[Round], bound: f64) -> Graph {
    let of = |value: fn(&Round) -> f64| rounds.iter().map(value);
    let [ink, blue, red] = [Color::INK, Color::BLUE, Color::RED].map(Stroke::medium);
    Graph::new(Scale::Log)
        .line("largest r/l", red, of(|round| round.max_ratio))
        .line("mean", ink, of(|round| round.mean_ratio))
        .line("smallest", blue, of(|round| round.min_ratio))
        .line(
            "bound",
            Stroke::dotted(Color::GREY),
            rounds.iter().map(|_| bound),
        )
}
