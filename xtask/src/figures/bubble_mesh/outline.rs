//! From the regions in `fixtures` to domains.

use std::error::Error;

use bubble_mesh::Domain;
use delaunay_core::progress::silent;
use delaunay_core::{BuildOptions, Outline, VertexId};
use glam::DVec2;
use mesh_io::PlanarGraph;

/// The region that a graph bounds.
pub(super) fn domain_of_graph(graph: PlanarGraph) -> Result<Domain, Box<dyn Error>> {
    let points = graph.points.into_iter().map(DVec2::from).collect();
    let segments = graph.segments.iter();
    let segments = segments.map(|ends| ends.map(|v| v as usize)).collect();
    domain(points, segments)
}

/// The region inside one closed curve through `nodes`.
pub(super) fn domain_of_loop(nodes: Vec<DVec2>) -> Result<Domain, Box<dyn Error>> {
    let count = nodes.len();
    let segments = (0..count).map(|i| [i, (i + 1) % count]).collect();
    domain(nodes, segments)
}

fn domain(points: Vec<DVec2>, segments: Vec<[usize; 2]>) -> Result<Domain, Box<dyn Error>> {
    let segments = segments.into_iter().map(|ends| ends.map(VertexId::new));
    let outline = Outline::new(points, segments.collect())?;
    Ok(Domain::new(&outline, BuildOptions::default(), &mut silent)?)
}
