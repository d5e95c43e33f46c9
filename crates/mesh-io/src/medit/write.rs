//! Writes a file section by section.

use std::io::Write;

use super::sections::CELLS;
use crate::cell::CellKind;
use crate::error::WriteError;
use crate::format::Format;
use crate::mesh::Mesh;
use crate::write_as::unsupported;

/// Writes a mesh, its cells kind by kind: of the plane when every `z` is zero and no cell has a volume, else of space. Data are left
/// out. O(mesh).
///
/// # Errors
/// [`WriteProblem::Unsupported`](crate::WriteProblem::Unsupported) when there are vertices among the cells.
pub fn write(out: &mut impl Write, mesh: &Mesh) -> Result<(), WriteError> {
    mesh.check()?;
    let kinds = mesh.cells.kinds();
    if let Some(index) = kinds.iter().position(|&kind| kind == CellKind::Vertex) {
        return Err(unsupported(
            Format::Medit,
            &format!("cell {index}, a vertex"),
        ));
    }
    let flat = mesh.points.iter().all(|[_, _, z]| *z == 0.0)
        && kinds.iter().all(|kind| kind.dimension() < 3);
    let dimension = if flat { 2 } else { 3 };
    writeln!(out, "MeshVersionFormatted 2\nDimension {dimension}")?;
    write_vertices(out, mesh, flat)?;
    for (section, kind) in CELLS {
        write_cells(out, mesh, section, kind)?;
    }
    Ok(writeln!(out, "End")?)
}

fn write_vertices(out: &mut impl Write, mesh: &Mesh, flat: bool) -> std::io::Result<()> {
    let markers = mesh.point_markers.as_deref();
    writeln!(out, "Vertices\n{}", mesh.points.len())?;
    for (index, [x, y, z]) in mesh.points.iter().enumerate() {
        write!(out, "{x:?} {y:?}")?;
        if !flat {
            write!(out, " {z:?}")?;
        }
        writeln!(out, " {}", reference(markers, index))?;
    }
    Ok(())
}

/// Writes the section of the cells of a kind, if there are some.
fn write_cells(
    out: &mut impl Write,
    mesh: &Mesh,
    section: &str,
    kind: CellKind,
) -> std::io::Result<()> {
    let is_of_kind = |&&found: &&CellKind| found == kind;
    let count = mesh.cells.kinds().iter().filter(is_of_kind).count();
    if count == 0 {
        return Ok(());
    }
    writeln!(out, "{section}\n{count}")?;
    let markers = mesh.cell_markers.as_deref();
    let cells = mesh.cells.iter().enumerate();
    for (index, cell) in cells.filter(|(_, cell)| cell.kind() == kind) {
        for &corner in cell.corners() {
            write!(out, "{} ", u64::from(corner) + 1)?;
        }
        writeln!(out, "{}", reference(markers, index))?;
    }
    Ok(())
}

fn reference(markers: Option<&[i32]>, index: usize) -> i32 {
    let marker = markers.and_then(|markers| markers.get(index));
    marker.copied().unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cell::{Cell, Cells};

    #[test]
    fn a_planar_mesh_is_of_dimension_2_and_vertices_are_refused() {
        let points = vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 0.1, 0.0]];
        let cells = Cells::from_iter([Cell::Triangle([0, 1, 2]), Cell::Segment([0, 1])]);
        let mut mesh = Mesh::new(points, cells);
        mesh.cell_markers = Some(vec![4, -5]);
        let mut file = Vec::new();
        write(&mut file, &mesh).unwrap();
        insta::assert_snapshot!(String::from_utf8(file).unwrap(), @r"
        MeshVersionFormatted 2
        Dimension 2
        Vertices
        3
        0.0 0.0 0
        1.0 0.0 0
        0.0 0.1 0
        Edges
        1
        1 2 -5
        Triangles
        1
        1 2 3 4
        End
        ");
        let vertex = Mesh::new(vec![[0.0; 3]], Cells::from_iter([Cell::Vertex([0])]));
        insta::assert_snapshot!(write(&mut Vec::new(), &vertex).unwrap_err(), @"Medit cannot hold cell 0, a vertex");
    }
}
