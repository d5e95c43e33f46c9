//! Reading a file in the format that its path names.

use std::path::Path;

use crate::blocks::StructuredBlocks;
use crate::circles::CirclesDomain;
use crate::error::{ReadError, ReadProblem};
use crate::format::Format;
use crate::mesh::Mesh;
use crate::numbers::Encoding;
use crate::planar_graph::PlanarGraph;
use crate::{circles_toml, connectivity_map, msh, off, plot3d, triangle, vtu, xy};

/// The mesh in a file of any format that holds one.
///
/// Points alone (`.xy`, `.xyz`, `.node`) make a mesh without cells; a `.poly` makes one of segments; structured blocks make one of
/// quads. An `.ele` needs the `.node` beside it.
///
/// # Errors
/// A [`ReadError`] that names the file, and the line and element where one is to blame. O(file).
pub fn read_mesh(path: &Path) -> Result<Mesh, ReadError> {
    named(path, |format, bytes| match format {
        Format::Xy => Ok(Mesh {
            points: xy::parse(bytes)?.into_iter().map(flat).collect(),
            ..Mesh::default()
        }),
        Format::Xyz => Ok(Mesh {
            points: xy::parse(bytes)?,
            ..Mesh::default()
        }),
        Format::Off => off::parse(bytes),
        Format::Msh => msh::parse(bytes).map(|file| file.mesh),
        Format::TriangleNode => triangle::parse_node(bytes).map(Mesh::from),
        Format::TriangleEle => triangle::parse_ele(bytes, nodes_beside(path)?),
        Format::TrianglePoly => Ok(triangle::parse_poly(bytes, || nodes_beside(path))?.as_mesh()),
        Format::Vtu => vtu::parse(bytes),
        Format::Plot3dAscii | Format::Plot3dBinary => {
            Ok(blocks_of(path, format, bytes)?.to_mesh()?)
        }
        _ => Err(unsupported(format, "a mesh")),
    })
}

/// The blocks in a Plot3D file, with names and connections from the `.map` beside it, where there is one.
///
/// # Errors
/// A [`ReadError`] that names the file, and the line or byte and the element where one is to blame. O(file).
pub fn read_blocks(path: &Path) -> Result<StructuredBlocks, ReadError> {
    named(path, |format, bytes| blocks_of(path, format, bytes))
}

/// The points in a file of any format that holds some; planar ones have `z = 0`.
///
/// # Errors
/// A [`ReadError`] that names the file, and the line and element where one is to blame. O(file).
pub fn read_points(path: &Path) -> Result<Vec<[f64; 3]>, ReadError> {
    read_mesh(path).map(|mesh| mesh.points)
}

/// The circles in a `DOMAIN.toml`, whatever the file is called.
///
/// # Errors
/// A [`ReadError`] that names the file and line. O(file).
pub fn read_circles(path: &Path) -> Result<CirclesDomain, ReadError> {
    let parsed = || circles_toml::parse(&std::fs::read(path)?);
    parsed().map_err(|error: ReadError| error.in_file(path))
}

/// The planar straight-line graph in a `.poly`, with its points from the `.node` beside it when the file has none.
///
/// # Errors
/// A [`ReadError`] that names the file, and the line and element where one is to blame. O(file).
pub fn read_planar_graph(path: &Path) -> Result<PlanarGraph, ReadError> {
    named(path, |format, bytes| match format {
        Format::TrianglePoly => triangle::parse_poly(bytes, || nodes_beside(path)),
        _ => Err(unsupported(format, "a planar graph")),
    })
}

fn blocks_of(path: &Path, format: Format, bytes: &[u8]) -> Result<StructuredBlocks, ReadError> {
    let encoding = match format {
        Format::Plot3dAscii => Encoding::Ascii,
        Format::Plot3dBinary => Encoding::Binary,
        _ => return Err(unsupported(format, "structured blocks")),
    };
    let grids = plot3d::parse(bytes, encoding)?;
    let map = connectivity_map::path_beside(path);
    if !map.exists() {
        return Ok(grids);
    }
    let connected = || connectivity_map::parse(&std::fs::read(&map)?, grids);
    connected().map_err(|error: ReadError| error.in_file(&map))
}

fn nodes_beside(path: &Path) -> Result<triangle::Nodes, ReadError> {
    named(&path.with_extension("node"), |_, bytes| {
        triangle::parse_node(bytes)
    })
}

fn flat([x, y]: [f64; 2]) -> [f64; 3] {
    [x, y, 0.0]
}

fn unsupported(format: Format, what: &str) -> ReadError {
    ReadProblem::Unsupported(format!("reading {what} from {format}")).into()
}

/// Parses the bytes of a file by its format; every error names the file.
fn named<T>(
    path: &Path,
    parse: impl FnOnce(Format, &[u8]) -> Result<T, ReadError>,
) -> Result<T, ReadError> {
    let parsed = || {
        parse(
            Format::from_path(path).ok_or(ReadProblem::UnknownFormat)?,
            &std::fs::read(path)?,
        )
    };
    parsed().map_err(|error: ReadError| error.in_file(path))
}
