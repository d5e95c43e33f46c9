//! Reading version 4.1, section by section.

use super::data::{read_data, with_point_markers};
use super::element_type::cell_kind;
use super::entities::PhysicalTags;
use super::format_line::{Version, read_format};
use super::nodes::Nodes;
use super::section::{decimal, end_section, next_section, quoted_text, skip_section};
use super::tag_index::TagIndex;
use super::{MshFile, PhysicalName, read_v2};
use crate::cell::{Cell, CellKind, Cells};
use crate::error::{ReadError, ReadProblem};
use crate::mesh::Mesh;
use crate::numbers::{Encoding, Numbers};

/// The mesh and the physical names of an MSH file: version 4.1 in ASCII or binary, or 2 in ASCII.
///
/// Linear in the size of the file when tags grow, otherwise O(n log n).
///
/// # Errors
/// The first thing that is not MSH, is not supported, or names something that is not there, with its line (ASCII) or byte (binary).
pub fn parse(bytes: &[u8]) -> Result<MshFile, ReadError> {
    let mut file = Numbers::new(bytes, Encoding::Ascii);
    let version = read_format(&mut file)?;
    let mut parts = Parts::default();
    while let Some(name) = next_section(&mut file)? {
        match (name, version) {
            (b"PhysicalNames", _) => parts.names = read_names(&mut file)?,
            (b"Entities", Version::V41) => parts.physical = PhysicalTags::read(&mut file)?,
            (b"Nodes", _) => parts.set_nodes(&mut file, version)?,
            (b"Elements", Version::V41) => parts.read_elements(&mut file)?,
            (b"Elements", Version::V2) => read_v2::read_elements(&mut file, &mut parts)?,
            (b"NodeData", _) => read_data(&mut file, "NodeData", &mut parts)?,
            (b"ElementData", _) => read_data(&mut file, "ElementData", &mut parts)?,
            (b"PartitionedEntities", _) => {
                return Err(file.problem(
                    file.at(),
                    ReadProblem::Unsupported("a partitioned MSH mesh".into()),
                ));
            }
            _ => skip_section(&mut file, name)?,
        }
    }
    parts.finish(&file)
}

/// What has been read so far.
#[derive(Default)]
pub(super) struct Parts {
    names: Vec<PhysicalName>,
    physical: PhysicalTags,
    pub(super) nodes: Option<TagIndex>,
    pub(super) mesh: Mesh,
    /// Tag of every cell, in order.
    pub(super) cell_tags: Vec<u64>,
    /// Marker of every cell, in order; 0 where there is none.
    markers: Vec<i32>,
    has_markers: bool,
}

impl Parts {
    fn set_nodes(&mut self, file: &mut Numbers<'_>, version: Version) -> Result<(), ReadError> {
        if self.nodes.is_some() {
            return Err(file.problem(
                file.at(),
                ReadProblem::Unsupported("a second section `$Nodes`".into()),
            ));
        }
        let nodes = match version {
            Version::V41 => Nodes::read(file)?,
            Version::V2 => read_v2::read_nodes(file)?,
        };
        let (points, index) = nodes.index(file)?;
        self.mesh.points = points;
        self.nodes = Some(index);
        Ok(())
    }

    fn read_elements(&mut self, file: &mut Numbers<'_>) -> Result<(), ReadError> {
        let start = file.at();
        let before = self.cell_tags.len();
        let blocks = file.size(format_args!("the number of blocks in $Elements"))?;
        let claimed = file.size(format_args!("the number of elements"))?;
        file.size(format_args!("the smallest element tag"))?;
        file.size(format_args!("the greatest element tag"))?;
        for block in 0..blocks {
            self.read_block(file, block)?;
        }
        let found = (self.cell_tags.len() - before) as u64;
        if claimed != found {
            return Err(file.problem(
                start,
                ReadProblem::Count {
                    what: "elements".into(),
                    claimed,
                    found,
                },
            ));
        }
        end_section(file, "Elements")
    }

    fn read_block(&mut self, file: &mut Numbers<'_>, block: u64) -> Result<(), ReadError> {
        let dimension = file.int(format_args!("the dimension of element block {block}"))?;
        let entity = file.int(format_args!("the entity of element block {block}"))?;
        file.skip_blanks_in_text();
        let start = file.at();
        let number = file.int(format_args!("the element type of block {block}"))?;
        let kind = cell_kind(number).ok_or_else(|| unsupported_type(file, start, number))?;
        let count = file.size(format_args!("the number of elements in block {block}"))?;
        let marker = self.physical.marker(dimension, entity);
        for _ in 0..count {
            let index = self.cell_tags.len();
            let tag = file.size(format_args!("the tag of element {index}"))?;
            self.read_cell(file, kind, tag, marker)?;
        }
        Ok(())
    }

    /// Reads the corners of a cell and appends it.
    pub(super) fn read_cell(
        &mut self,
        file: &mut Numbers<'_>,
        kind: CellKind,
        tag: u64,
        marker: Option<i32>,
    ) -> Result<(), ReadError> {
        let index = self.cell_tags.len();
        let Some(nodes) = &self.nodes else {
            let problem = ReadProblem::Expected {
                expected: "`$Nodes`".into(),
                found: "`$Elements`".into(),
            };
            return Err(file.problem(file.at(), problem));
        };
        let mut corners = [0; 8];
        for (k, corner) in corners.iter_mut().enumerate().take(kind.corner_count()) {
            file.skip_blanks_in_text();
            let start = file.at();
            let node = file.size(format_args!("corner {k} of element {index}"))?;
            *corner = nodes
                .position(node)
                .ok_or_else(|| no_such_node(file, start, index, node))?;
        }
        if let Some(cell) = corners
            .get(..kind.corner_count())
            .and_then(|corners| Cell::new(kind, corners))
        {
            self.mesh.cells.push(cell);
            self.cell_tags.push(tag);
            self.markers.push(marker.unwrap_or(0));
            self.has_markers |= marker.is_some();
        }
        Ok(())
    }

    fn finish(mut self, file: &Numbers<'_>) -> Result<MshFile, ReadError> {
        if self.nodes.is_none() {
            return Err(file.problem(
                file.at(),
                ReadProblem::Truncated {
                    expected: "`$Nodes`".into(),
                },
            ));
        }
        if !self.cell_tags.is_sorted() {
            self.sort_cells();
        }
        if self.has_markers {
            self.mesh.cell_markers = Some(self.markers);
        }
        let mesh = with_point_markers(self.mesh);
        mesh.check()?;
        Ok(MshFile {
            mesh,
            names: self.names,
        })
    }

    /// Puts cells, their markers and their data in the order of their tags.
    fn sort_cells(&mut self) {
        let cells: Vec<Cell> = self.mesh.cells.iter().collect();
        let mut order: Vec<usize> = (0..cells.len()).collect();
        order.sort_by_key(|&cell| self.cell_tags[cell]);
        self.mesh.cells = order.iter().map(|&cell| cells[cell]).collect::<Cells>();
        self.markers = order.iter().map(|&cell| self.markers[cell]).collect();
        for array in &mut self.mesh.cell_data {
            let rows = |&cell: &usize| {
                array
                    .values
                    .get(cell * array.components..(cell + 1) * array.components)
            };
            array.values = order.iter().filter_map(rows).flatten().copied().collect();
        }
    }
}

fn read_names(file: &mut Numbers<'_>) -> Result<Vec<PhysicalName>, ReadError> {
    let count: u64 = decimal(file, "the number of physical names")?;
    let mut names = Vec::new();
    for _ in 0..count {
        let dimension = decimal(file, "the dimension of a physical name")?;
        let marker = decimal(file, "the tag of a physical name")?;
        names.push(PhysicalName {
            dimension,
            marker,
            name: quoted_text(file, "a physical name in quotation marks")?,
        });
    }
    end_section(file, "PhysicalNames")?;
    Ok(names)
}

pub(super) fn unsupported_type(file: &Numbers<'_>, start: usize, number: i32) -> ReadError {
    file.problem(
        start,
        ReadProblem::Unsupported(format!("MSH element type {number}")),
    )
}

fn no_such_node(file: &Numbers<'_>, start: usize, index: usize, node: u64) -> ReadError {
    let found = i64::try_from(node).unwrap_or(i64::MAX);
    file.problem(
        start,
        ReadProblem::NoSuch {
            element: "element",
            index,
            names: "node",
            found,
        },
    )
}
