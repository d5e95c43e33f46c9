//! Reading a file section by section.

use super::data::{read_data, with_point_markers};
use super::entities::PhysicalTags;
use super::format_line::{Version, read_format};
use super::nodes::Nodes;
use super::parts::Parts;
use super::section::{decimal, end_section, next_section, quoted_text, skip_section};
use super::{MshFile, PhysicalName, read_v2, read_v41};
use crate::error::{ReadError, ReadProblem};
use crate::numbers::{Encoding, Numbers};

/// The mesh and the physical names of an MSH file: version 4.1 or 2, in ASCII or binary.
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
            (b"Nodes", _) => read_nodes(&mut file, version, &mut parts)?,
            (b"Elements", Version::V41) => read_v41::read_elements(&mut file, &mut parts)?,
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
    let MshFile { mesh, names } = parts.finish(&file)?;
    let mesh = with_point_markers(mesh);
    mesh.check()?;
    Ok(MshFile { mesh, names })
}

fn read_nodes(
    file: &mut Numbers<'_>,
    version: Version,
    parts: &mut Parts,
) -> Result<(), ReadError> {
    if parts.nodes.is_some() {
        let problem = ReadProblem::Unsupported("a second section `$Nodes`".into());
        return Err(file.problem(file.at(), problem));
    }
    let nodes = match version {
        Version::V41 => Nodes::read(file)?,
        Version::V2 => read_v2::read_nodes(file)?,
    };
    parts.set_nodes(file, nodes)
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
