//! Edelsbrunner & Guoy, *Sink-insertion for mesh improvement*.

mod flow;

use super::Figure;

/// The flow and its sinks.
pub const FIGURES: &[Figure] = &[Figure {
    name: "sinks_flow",
    caption: "From a triangle that does not contain its circumcentre the flow runs towards it, into the next triangle; it ends in \
              sinks, the centres of empty circles that lie in their own triangles, or outside. Triangles are coloured by their end.",
    render: flow::figure,
}];
