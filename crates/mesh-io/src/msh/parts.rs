//! A mesh while its file is read.

use std::fmt::Arguments;

use super::entities::PhysicalTags;
use super::nodes::Nodes;
use super::tag_index::TagIndex;
use super::{MshFile, PhysicalName};
use crate::cell::{Cell, CellKind, Cells};
use crate::error::{ReadError, ReadProblem};
use crate::mesh::Mesh;
use crate::numbers::Numbers;

/// What has been read so far.
#[derive(Default)]
pub(super) struct Parts {
    pub(super) names: Vec<PhysicalName>,
    pub(super) physical: PhysicalTags,
    pub(super) nodes: Option<TagIndex>,
    pub(super) mesh: Mesh,
    /// Tag of every cell, in order.
    pub(super) cell_tags: Vec<u64>,
    /// Marker of every cell, in order; 0 where there is none.
    markers: Vec<i32>,
    has_markers: bool,
}

impl Parts {
    pub(super) fn set_nodes(&mut self, file: &Numbers<'_>, nodes: Nodes) -> Result<(), ReadError> {
        let (points, index) = nodes.index(file)?;
        self.mesh.points = points;
        self.nodes = Some(index);
        Ok(())
    }

    /// Reads the corners of a cell, each by `read_tag`, and appends it.
    pub(super) fn read_cell<'f>(
        &mut self,
        file: &mut Numbers<'f>,
        kind: CellKind,
        tag: u64,
        marker: Option<i32>,
        read_tag: fn(&mut Numbers<'f>, Arguments<'_>) -> Result<u64, ReadError>,
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
            let node = read_tag(file, format_args!("corner {k} of element {index}"))?;
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

    /// The mesh, its cells in the order of their tags.
    pub(super) fn finish(mut self, file: &Numbers<'_>) -> Result<MshFile, ReadError> {
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
        Ok(MshFile {
            mesh: self.mesh,
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
