//! `$Nodes`: points, and which of them a tag means.

use super::section::end_section;
use super::tag_index::TagIndex;
use crate::error::{ReadError, ReadProblem};
use crate::mesh::first_not_finite;
use crate::numbers::Numbers;

/// The points of a file and the tags by which elements name them.
#[derive(Debug, Default)]
pub(super) struct Nodes {
    pub(super) points: Vec<[f64; 3]>,
    tags: Vec<u64>,
}

impl Nodes {
    /// Reads the section of version 4.1, whose first line has been read.
    pub(super) fn read(file: &mut Numbers<'_>) -> Result<Self, ReadError> {
        let start = file.at();
        let blocks = file.size(format_args!("the number of blocks in $Nodes"))?;
        let announced = file.size(format_args!("the number of nodes"))?;
        file.size(format_args!("the smallest node tag"))?;
        file.size(format_args!("the greatest node tag"))?;
        let mut nodes = Self::with_room(file, announced);
        for block in 0..blocks {
            nodes.read_block(file, block)?;
        }
        nodes.check_count(file, start, announced)?;
        end_section(file, "Nodes")?;
        Ok(nodes)
    }

    /// Room for the nodes announced, as far as the file can hold them.
    pub(super) fn with_room(file: &Numbers<'_>, announced: u64) -> Self {
        let room = file.room_for(announced, 8);
        Self {
            points: Vec::with_capacity(room),
            tags: Vec::with_capacity(room),
        }
    }

    /// Appends a node.
    pub(super) fn push(&mut self, tag: u64, point: [f64; 3]) {
        self.tags.push(tag);
        self.points.push(point);
    }

    /// Reads three coordinates and sees that they are finite.
    pub(super) fn read_point(file: &mut Numbers<'_>, index: usize) -> Result<[f64; 3], ReadError> {
        file.skip_blanks_in_text();
        let start = file.at();
        let mut point = [0.0; 3];
        for (coordinate, axis) in point.iter_mut().zip(['x', 'y', 'z']) {
            *coordinate = file.real(format_args!("{axis} of node {index}"))?;
        }
        match first_not_finite(&point) {
            None => Ok(point),
            Some((axis, value)) => Err(file.problem(
                start,
                ReadProblem::NotFinite {
                    element: "node",
                    index,
                    axis,
                    value,
                },
            )),
        }
    }

    fn read_block(&mut self, file: &mut Numbers<'_>, block: u64) -> Result<(), ReadError> {
        let dimension = file.int(format_args!("the dimension of node block {block}"))?;
        file.int(format_args!("the entity of node block {block}"))?;
        let parametric = file.int(format_args!("whether node block {block} is parametric"))?;
        let count = file.size(format_args!("the number of nodes in block {block}"))?;
        for index in 0..count {
            self.tags
                .push(file.size(format_args!("the tag of node {index} in block {block}"))?);
        }
        for _ in 0..count {
            let index = self.points.len();
            self.points.push(Self::read_point(file, index)?);
            for _ in 0..if parametric == 0 { 0 } else { dimension } {
                file.real(format_args!("a parameter of node {index}"))?;
            }
        }
        Ok(())
    }

    /// Whether as many nodes were found as announced.
    pub(super) fn check_count(
        &self,
        file: &Numbers<'_>,
        start: usize,
        claimed: u64,
    ) -> Result<(), ReadError> {
        let found = self.points.len() as u64;
        if claimed != found {
            return Err(file.problem(
                start,
                ReadProblem::Count {
                    what: "nodes".into(),
                    claimed,
                    found,
                },
            ));
        }
        Ok(())
    }

    /// The points, and how to find them by tag.
    pub(super) fn index(self, file: &Numbers<'_>) -> Result<(Vec<[f64; 3]>, TagIndex), ReadError> {
        let index = TagIndex::of(&self.tags).map_err(|twice| {
            let found = format!(
                "tag {} for nodes {} and {}",
                twice.tag, twice.first, twice.second
            );
            file.problem(
                file.at(),
                ReadProblem::Expected {
                    expected: "one node of every tag".into(),
                    found,
                },
            )
        })?;
        Ok((self.points, index))
    }
}
