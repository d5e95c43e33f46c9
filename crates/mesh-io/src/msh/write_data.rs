//! Writes names of physical groups, and data of points and cells, which are alike in all versions.

use std::io::Write;

use super::sink::Sink;
use super::{POINT_MARKERS, PhysicalName};
use crate::error::WriteError;
use crate::format::Format;
use crate::mesh::{DataArray, Mesh};
use crate::write_as;

/// Writes names of physical groups, where there are some.
pub(super) fn write_names<W: Write>(
    out: &mut Sink<'_, W>,
    names: &[PhysicalName],
) -> Result<(), WriteError> {
    if names.is_empty() {
        return Ok(());
    }
    out.line(format_args!("$PhysicalNames\n{}", names.len()))?;
    for PhysicalName {
        dimension,
        marker,
        name,
    } in names
    {
        check_name("a physical name", name)?;
        out.line(format_args!("{dimension} {marker} \"{name}\""))?;
    }
    Ok(out.line(format_args!("$EndPhysicalNames"))?)
}

/// Writes point markers, and data of points and cells.
pub(super) fn write_all_data<W: Write>(
    out: &mut Sink<'_, W>,
    mesh: &Mesh,
) -> Result<(), WriteError> {
    if let Some(markers) = &mesh.point_markers {
        let values = markers.iter().map(|&marker| marker.into()).collect();
        write_data(out, "NodeData", &DataArray::scalar(POINT_MARKERS, values))?;
    }
    mesh.point_data
        .iter()
        .try_for_each(|array| write_data(out, "NodeData", array))?;
    mesh.cell_data
        .iter()
        .try_for_each(|array| write_data(out, "ElementData", array))
}

fn write_data<W: Write>(
    out: &mut Sink<'_, W>,
    section: &str,
    array: &DataArray,
) -> Result<(), WriteError> {
    let DataArray {
        name,
        components,
        values,
    } = array;
    check_name("data", name)?;
    if ![1, 3, 9].contains(components) {
        return Err(unsupported(&format!(
            "data `{name}` of {components} components, only of 1, 3 or 9"
        )));
    }
    let rows = values.len() / components;
    if i32::try_from(rows).is_err() {
        return Err(unsupported(&format!(
            "data `{name}` of {rows} rows, which 32-bit tags cannot name"
        )));
    }
    // One string, the name; one real, the time; three integers: the time step, components and rows.
    out.line(format_args!(
        "${section}\n1\n\"{name}\"\n1\n0\n3\n0\n{components}\n{rows}"
    ))?;
    for (tag, row) in (1..).zip(values.chunks_exact(*components)) {
        out.int(tag)?;
        row.iter().try_for_each(|&value| out.real(value))?;
        out.end_row()?;
    }
    Ok(out.end_section(section)?)
}

fn check_name(what: &str, name: &str) -> Result<(), WriteError> {
    if name.contains(['"', '\n', '\r']) {
        return Err(unsupported(&format!(
            "{what} with a quotation mark or a line break: {name:?}"
        )));
    }
    Ok(())
}

fn unsupported(what: &str) -> WriteError {
    write_as::unsupported(Format::Msh, what)
}
