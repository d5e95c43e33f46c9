//! Writing version 4.1.

use std::collections::BTreeMap;
use std::io::{self, Write};

use super::PhysicalName;
use super::element_type::element_type;
use super::sink::Sink;
use super::write_data::{write_all_data, write_names};
use crate::cell::CellKind;
use crate::error::WriteError;
use crate::mesh::Mesh;
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
    let mut out = Sink::new(out, encoding);
    out.format("4.1")?;
    write_names(&mut out, names)?;
    entities.write_entities(&mut out)?;
    write_nodes(&mut out, mesh, entities.home_of_nodes())?;
    entities.write_elements(&mut out, mesh)?;
    write_all_data(&mut out, mesh)
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
