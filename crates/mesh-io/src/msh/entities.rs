//! `$Entities`: the physical group of every entity, by which elements get their marker.

use std::collections::BTreeMap;

use super::section::end_section;
use crate::error::ReadError;
use crate::numbers::Numbers;

/// First physical tag of the entities that have one, by dimension and tag.
#[derive(Debug, Default)]
pub(super) struct PhysicalTags(BTreeMap<(i32, i32), i32>);

impl PhysicalTags {
    /// The marker of the elements of an entity; `None` when it is in no physical group.
    pub(super) fn marker(&self, dimension: i32, entity: i32) -> Option<i32> {
        self.0.get(&(dimension, entity)).copied()
    }

    /// Reads the section, whose first line has been read.
    pub(super) fn read(file: &mut Numbers<'_>) -> Result<Self, ReadError> {
        const NAMES: [&str; 4] = ["points", "curves", "surfaces", "volumes"];
        let mut counts = [0; 4];
        for (count, name) in counts.iter_mut().zip(NAMES) {
            *count = file.size(format_args!("the number of {name} in $Entities"))?;
        }
        let mut tags = Self::default();
        for (dimension, count) in (0..).zip(counts) {
            for index in 0..count {
                tags.read_entity(file, dimension, index)?;
            }
        }
        end_section(file, "Entities")?;
        Ok(tags)
    }

    fn read_entity(
        &mut self,
        file: &mut Numbers<'_>,
        dimension: i32,
        index: u64,
    ) -> Result<(), ReadError> {
        let entity = format_args!("{index} of dimension {dimension}");
        let tag = file.int(format_args!("the tag of entity {entity}"))?;
        // A point has its place here, everything else the corners of its bounding box.
        for _ in 0..if dimension == 0 { 3 } else { 6 } {
            file.real(format_args!("the bounds of entity {entity}"))?;
        }
        let groups = file.size(format_args!(
            "the number of physical tags of entity {entity}"
        ))?;
        for group in 0..groups {
            let physical = file.int(format_args!("a physical tag of entity {entity}"))?;
            if group == 0 {
                self.0.insert((dimension, tag), physical);
            }
        }
        if dimension > 0 {
            for _ in 0..file.size(format_args!(
                "the number of bounding entities of entity {entity}"
            ))? {
                file.int(format_args!("a bounding entity of entity {entity}"))?;
            }
        }
        Ok(())
    }
}
