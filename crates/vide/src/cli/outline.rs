//! Outlines in the plane, from files of several kinds.

use vide::mesh_io::{Cell, Mesh, PlanarGraph};

/// Whether a mesh is of the plane: there is something in it, all of it at z = 0 and nothing with a volume.
pub(crate) fn is_flat(mesh: &Mesh) -> bool {
    let flat = mesh.points.iter().all(|&[_, _, z]| z == 0.0);
    let mut kinds = mesh.cells.kinds().iter();
    flat && !mesh.cells.is_empty() && kinds.all(|kind| kind.dimension() < 3)
}

/// The outline of triangles: their edges that no other triangle shares.
pub(crate) fn outline_of(mesh: &Mesh) -> PlanarGraph {
    let mut edges = Vec::new();
    for cell in mesh.cells.iter() {
        if let Cell::Triangle([a, b, c]) = cell {
            edges.extend([[a, b], [b, c], [c, a]].map(|[a, b]| [a.min(b), a.max(b)]));
        }
    }
    edges.sort_unstable();
    let single = edges.chunk_by(|e, f| e == f).filter(|same| same.len() == 1);
    PlanarGraph {
        points: mesh.points.iter().map(|&[x, y, _]| [x, y]).collect(),
        segments: single.map(|same| same[0]).collect(),
        ..PlanarGraph::default()
    }
}
