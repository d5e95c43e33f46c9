//! Writing version 4.1.

use std::collections::BTreeMap;
use std::io::{self, Write};

use super::element_type::element_type;
use super::{POINT_MARKERS, PhysicalName};
use crate::cell::CellKind;
use crate::error::{WriteError, WriteProblem};
use crate::format::Format;
use crate::mesh::{DataArray, Mesh};
use crate::numbers::Encoding;

/// Writes a mesh as version 4.1, with names for some or all of its markers. O(size of the mesh).
///
/// # Errors
/// A mesh that contradicts itself, data of other than 1, 3 or 9 components, a name with a quotation mark or a line break, and what `out`
/// refuses.
pub fn write(
    out: &mut impl Write,
    mesh: &Mesh,
    names: &[PhysicalName],
    encoding: Encoding,
) -> Result<(), WriteError> {
    mesh.check()?;
    let entities = Entities::of(mesh);
    let mut out = Sink {
        out,
        encoding,
        line_started: false,
    };
    out.write_format()?;
    write_names(&mut out, names)?;
    entities.write_entities(&mut out)?;
    write_nodes(&mut out, mesh, entities.home_of_nodes())?;
    entities.write_elements(&mut out, mesh)?;
    write_all_data(&mut out, mesh)
}

/// Numbers to a stream, in either encoding.
struct Sink<'w, W> {
    out: &'w mut W,
    encoding: Encoding,
    line_started: bool,
}

impl<W: Write> Sink<'_, W> {
    fn int(&mut self, value: i32) -> io::Result<()> {
        self.integer(value, &value.to_le_bytes())
    }

    fn size(&mut self, value: usize) -> io::Result<()> {
        let value = value as u64;
        self.integer(value, &value.to_le_bytes())
    }

    fn integer(&mut self, value: impl itoa::Integer, bytes: &[u8]) -> io::Result<()> {
        if self.encoding == Encoding::Binary {
            return self.out.write_all(bytes);
        }
        self.separate()?;
        // Nearly all of a file are integers: with the formatter of the standard library it takes a third longer.
        self.out
            .write_all(itoa::Buffer::new().format(value).as_bytes())
    }

    /// The debug form is the shortest that reads back to the same double, with an exponent where it is long.
    fn real(&mut self, value: f64) -> io::Result<()> {
        if self.encoding == Encoding::Binary {
            return self.out.write_all(&value.to_le_bytes());
        }
        self.separate()?;
        write!(self.out, "{value:?}")
    }

    /// A blank between the numbers of a line.
    fn separate(&mut self) -> io::Result<()> {
        if std::mem::replace(&mut self.line_started, true) {
            self.out.write_all(b" ")?;
        }
        Ok(())
    }

    /// Ends a line of numbers, which binary does not have.
    fn end_row(&mut self) -> io::Result<()> {
        self.line_started = false;
        match self.encoding {
            Encoding::Ascii => self.out.write_all(b"\n"),
            Encoding::Binary => Ok(()),
        }
    }

    /// A line of text in either encoding.
    fn line(&mut self, text: std::fmt::Arguments<'_>) -> io::Result<()> {
        self.out.write_fmt(text)?;
        self.out.write_all(b"\n")
    }

    /// `$EndName`, on a line of its own after binary numbers too.
    fn end_section(&mut self, name: &str) -> io::Result<()> {
        if self.encoding == Encoding::Binary {
            self.out.write_all(b"\n")?;
        }
        self.line(format_args!("$End{name}"))
    }

    fn write_format(&mut self) -> io::Result<()> {
        self.line(format_args!("$MeshFormat"))?;
        match self.encoding {
            Encoding::Ascii => self.line(format_args!("4.1 0 8\n$EndMeshFormat")),
            Encoding::Binary => {
                self.line(format_args!("4.1 1 8"))?;
                self.int(1)?;
                self.end_section("MeshFormat")
            }
        }
    }
}

fn write_names<W: Write>(out: &mut Sink<'_, W>, names: &[PhysicalName]) -> Result<(), WriteError> {
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

/// Cells by dimension, marker and kind: what MSH calls an entity, and its blocks of elements.
struct Entities {
    blocks: BTreeMap<(usize, Option<i32>), BTreeMap<CellKind, Vec<ElementAt>>>,
}

/// A cell's position, and that of its first corner in the list of all corners.
struct ElementAt {
    cell: usize,
    first_corner: usize,
}

impl Entities {
    fn of(mesh: &Mesh) -> Self {
        let mut blocks = BTreeMap::<_, BTreeMap<_, Vec<_>>>::new();
        let mut first_corner = 0;
        let markers = mesh.cell_markers.as_deref();
        for (cell, &kind) in mesh.cells.kinds().iter().enumerate() {
            let marker = markers.and_then(|markers| markers.get(cell)).copied();
            let entity = blocks.entry((kind.dimension(), marker)).or_default();
            entity
                .entry(kind)
                .or_default()
                .push(ElementAt { cell, first_corner });
            first_corner += kind.corner_count();
        }
        Self { blocks }
    }

    /// Dimension, tag and marker of every entity. A mesh without cells gets a point, since nodes must lie somewhere.
    fn list(&self) -> Vec<(usize, i32, Option<i32>)> {
        if self.blocks.is_empty() {
            return vec![(0, 1, None)];
        }
        let tagged = (1..).zip(self.blocks.keys());
        tagged
            .map(|(tag, &(dimension, marker))| (dimension, tag, marker))
            .collect()
    }

    /// The first entity of the greatest dimension.
    fn home_of_nodes(&self) -> (usize, i32) {
        let list = self.list();
        let greatest = list.iter().map(|&(dimension, ..)| dimension).max();
        let home = list
            .iter()
            .find(|&&(dimension, ..)| Some(dimension) == greatest);
        home.map_or((0, 1), |&(dimension, tag, _)| (dimension, tag))
    }

    fn write_entities<W: Write>(&self, out: &mut Sink<'_, W>) -> io::Result<()> {
        let list = self.list();
        out.line(format_args!("$Entities"))?;
        for dimension in 0..4 {
            out.size(
                list.iter()
                    .filter(|&&(found, ..)| found == dimension)
                    .count(),
            )?;
        }
        out.end_row()?;
        for (dimension, tag, marker) in list {
            out.int(tag)?;
            // Nothing is known about geometry, and Gmsh computes bounding boxes anew.
            for _ in 0..if dimension == 0 { 3 } else { 6 } {
                out.real(0.0)?;
            }
            out.size(marker.iter().len())?;
            marker.map_or(Ok(()), |marker| out.int(marker))?;
            if dimension > 0 {
                out.size(0)?;
            }
            out.end_row()?;
        }
        out.end_section("Entities")
    }

    fn write_elements<W: Write>(&self, out: &mut Sink<'_, W>, mesh: &Mesh) -> io::Result<()> {
        let count = mesh.cells.len();
        out.line(format_args!("$Elements"))?;
        out.size(self.blocks.values().map(BTreeMap::len).sum())?;
        write_range(out, count)?;
        for (tag, (&(dimension, _), kinds)) in (1..).zip(&self.blocks) {
            for (&kind, elements) in kinds {
                out.int(dimension as i32)?;
                out.int(tag)?;
                out.int(element_type(kind))?;
                out.size(elements.len())?;
                out.end_row()?;
                for &ElementAt { cell, first_corner } in elements {
                    out.size(cell + 1)?;
                    for &point in mesh
                        .cells
                        .corners()
                        .iter()
                        .skip(first_corner)
                        .take(kind.corner_count())
                    {
                        out.size(point as usize + 1)?;
                    }
                    out.end_row()?;
                }
            }
        }
        out.end_section("Elements")
    }
}

/// Number of elements of a section, its smallest and its greatest tag.
fn write_range<W: Write>(out: &mut Sink<'_, W>, count: usize) -> io::Result<()> {
    out.size(count)?;
    out.size(usize::from(count > 0))?;
    out.size(count)?;
    out.end_row()
}

fn write_nodes<W: Write>(
    out: &mut Sink<'_, W>,
    mesh: &Mesh,
    (dimension, entity): (usize, i32),
) -> io::Result<()> {
    let count = mesh.points.len();
    out.line(format_args!("$Nodes"))?;
    out.size(1)?;
    write_range(out, count)?;
    out.int(dimension as i32)?;
    out.int(entity)?;
    out.int(0)?;
    out.size(count)?;
    out.end_row()?;
    for tag in 1..=count {
        out.size(tag)?;
        out.end_row()?;
    }
    for point in &mesh.points {
        for &coordinate in point {
            out.real(coordinate)?;
        }
        out.end_row()?;
    }
    out.end_section("Nodes")
}

fn write_all_data<W: Write>(out: &mut Sink<'_, W>, mesh: &Mesh) -> Result<(), WriteError> {
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
        return Err(unsupported(format!(
            "data `{name}` of {components} components, only of 1, 3 or 9"
        )));
    }
    let rows = values.len() / components;
    if i32::try_from(rows).is_err() {
        return Err(unsupported(format!(
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
        return Err(unsupported(format!(
            "{what} with a quotation mark or a line break: {name:?}"
        )));
    }
    Ok(())
}

fn unsupported(what: String) -> WriteError {
    WriteProblem::Unsupported {
        format: Format::Msh,
        what,
    }
    .into()
}
