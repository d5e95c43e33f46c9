//! Whether a boundary whose nodes have moved meets itself.

use delaunay_core::progress::silent;
use delaunay_core::{BuildOptions, Complex2, Constrained2, Crossings, VertexId};
use glam::DVec2;

/// Whether no two edges of the boundary meet but in common nodes. Takes n log n time for the boundary.
pub(crate) fn is_boundary_simple(complex: &Complex2) -> bool {
    let mesh = complex.mesh();
    let bases = mesh.faces().filter_map(|f| mesh.ghost_base(f));
    let edges = bases.map(|h| [mesh.origin(h), mesh.target(h)]);
    let mut edges: Vec<[VertexId; 2]> = edges.map(|[a, b]| [a.min(b), a.max(b)]).collect();
    edges.sort_unstable();
    edges.dedup();
    let mut nodes: Vec<VertexId> = edges.iter().flatten().copied().collect();
    nodes.sort_unstable();
    nodes.dedup();
    let points: Vec<DVec2> = nodes.iter().map(|&v| complex.point(v)).collect();
    let number = |v: VertexId| VertexId::new(nodes.partition_point(|&w| w < v));
    let segments: Vec<[VertexId; 2]> = edges.iter().map(|ends| ends.map(number)).collect();
    let options = BuildOptions::default();
    let built = Constrained2::build(&points, &segments, Crossings::Refuse, options, &mut silent);
    built.is_ok_and(|built| {
        let is_apart = built.duplicates().iter().next().is_none();
        // A segment through a node is in two parts.
        let whole = |&[a, b]: &[VertexId; 2]| built.mesh().neighbors(a).any(|v| v == b);
        is_apart && segments.iter().all(whole)
    })
}
