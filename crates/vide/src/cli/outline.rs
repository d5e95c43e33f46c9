//! What is given to be meshed, from files of several kinds: an outline in the plane, or a mesh in space.

use std::path::Path;

use vide::mesh_io::{Cell, Format, Mesh, PlanarGraph, ReadError, read_mesh, read_planar_graph};

/// What a file holds.
pub(crate) enum Given {
    /// Something flat, as its outline.
    Outline(PlanarGraph),
    /// Something of space.
    Mesh(Mesh),
}

/// Reads an outline, or a mesh; one at z = 0 is an outline too.
pub(crate) fn read_given(input: &Path) -> Result<Given, ReadError> {
    let format = Format::from_path(input);
    if matches!(
        format,
        Some(Format::TrianglePoly | Format::Svg | Format::GeoJson)
    ) {
        return read_planar_graph(input).map(Given::Outline);
    }
    match read_mesh(input) {
        Ok(mesh) if is_flat(&mesh) => Ok(Given::Outline(outline_of(&mesh))),
        Ok(mesh) => Ok(Given::Mesh(mesh)),
        // Faces of any number of corners are no cells, but they have an outline.
        Err(error) if format == Some(Format::Off) => read_planar_graph(input)
            .map(Given::Outline)
            .map_err(|_| error),
        Err(error) => Err(error),
    }
}

/// Whether a mesh is of the plane: there is something in it, all of it at z = 0 and nothing with a volume.
fn is_flat(mesh: &Mesh) -> bool {
    let flat = mesh.points.iter().all(|&[_, _, z]| z == 0.0);
    let mut kinds = mesh.cells.kinds().iter();
    flat && !mesh.cells.is_empty() && kinds.all(|kind| kind.dimension() < 3)
}

/// The outline of triangles and quads: their edges that no other one shares.
fn outline_of(mesh: &Mesh) -> PlanarGraph {
    let mut edges = Vec::new();
    for cell in mesh.cells.iter() {
        let corners = match &cell {
            Cell::Triangle(corners) => corners.as_slice(),
            Cell::Quad(corners) => corners.as_slice(),
            _ => continue,
        };
        let next = corners.iter().cycle().skip(1);
        edges.extend(
            corners
                .iter()
                .zip(next)
                .map(|(&a, &b)| [a.min(b), a.max(b)]),
        );
    }
    edges.sort_unstable();
    let single = edges.chunk_by(|e, f| e == f).filter(|same| same.len() == 1);
    PlanarGraph {
        points: mesh.points.iter().map(|&[x, y, _]| [x, y]).collect(),
        segments: single.map(|same| same[0]).collect(),
        ..PlanarGraph::default()
    }
}

/// The graph without the points that no segment has.
pub(crate) fn without_loose_points(graph: &PlanarGraph) -> PlanarGraph {
    let mut numbers = vec![None; graph.points.len()];
    let mut points = Vec::new();
    let mut kept = Vec::new();
    let mut number = |v: u32| {
        *numbers[v as usize].get_or_insert_with(|| {
            points.push(graph.points[v as usize]);
            kept.push(v as usize);
            points.len() as u32 - 1
        })
    };
    let segments = graph.segments.iter().map(|ends| ends.map(&mut number));
    let segments = segments.collect();
    let markers = graph.point_markers.as_ref();
    PlanarGraph {
        point_markers: markers.map(|markers| kept.iter().map(|&v| markers[v]).collect()),
        points,
        segments,
        segment_markers: graph.segment_markers.clone(),
        holes: graph.holes.clone(),
        regions: graph.regions.clone(),
        point_data: Vec::new(),
    }
}
