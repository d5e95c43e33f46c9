//! Writing version 2.2 in ASCII, for programs that read no later one.

use std::collections::BTreeMap;
use std::io::{self, Write};

use super::PhysicalName;
use super::element_type::element_type;
use super::sink::Sink;
use super::write_data::{write_all_data, write_names};
use crate::error::WriteError;
use crate::mesh::Mesh;
use crate::numbers::Encoding;

/// Writes a mesh as version 2.2 in ASCII, with names for some or all of its markers. O(size of the mesh).
///
/// # Errors
/// A mesh that contradicts itself, data of other than 1, 3 or 9 components, a name with a quotation mark or a line break, and what `out`
/// refuses.
pub fn write_v2(
    out: &mut impl Write,
    mesh: &Mesh,
    names: &[PhysicalName],
) -> Result<(), WriteError> {
    mesh.check()?;
    let mut out = Sink::new(out, Encoding::Ascii);
    out.format("2.2")?;
    write_names(&mut out, names)?;
    write_nodes(&mut out, mesh)?;
    write_elements(&mut out, mesh)?;
    write_all_data(&mut out, mesh)
}

fn write_nodes<W: Write>(out: &mut Sink<'_, W>, mesh: &Mesh) -> io::Result<()> {
    out.line(format_args!("$Nodes\n{}", mesh.points.len()))?;
    for (tag, point) in (1..).zip(&mesh.points) {
        out.size(tag)?;
        for &coordinate in point {
            out.real(coordinate)?;
        }
        out.end_row()?;
    }
    out.end_section("Nodes")
}

fn write_elements<W: Write>(out: &mut Sink<'_, W>, mesh: &Mesh) -> io::Result<()> {
    out.line(format_args!("$Elements\n{}", mesh.cells.len()))?;
    let entities = entities(mesh);
    for (index, cell) in mesh.cells.iter().enumerate() {
        let marker = marker(mesh, index);
        let entity = entities.get(&(cell.kind().dimension(), marker));
        out.size(index + 1)?;
        out.int(element_type(cell.kind()))?;
        out.int(2)?;
        out.int(marker)?;
        out.size(entity.copied().unwrap_or(1))?;
        for &corner in cell.corners() {
            out.size(corner as usize + 1)?;
        }
        out.end_row()?;
    }
    out.end_section("Elements")
}

/// A geometric entity for every dimension and marker, counted from 1.
fn entities(mesh: &Mesh) -> BTreeMap<(usize, i32), usize> {
    let kinds = mesh.cells.kinds().iter().enumerate();
    let mut entities: BTreeMap<_, _> = kinds
        .map(|(index, kind)| ((kind.dimension(), marker(mesh, index)), 0))
        .collect();
    for (number, entity) in (1..).zip(entities.values_mut()) {
        *entity = number;
    }
    entities
}

/// The marker of a cell, 0 for none.
fn marker(mesh: &Mesh, cell: usize) -> i32 {
    let markers = mesh.cell_markers.as_ref();
    let marker = markers.and_then(|markers| markers.get(cell));
    marker.copied().unwrap_or(0)
}
