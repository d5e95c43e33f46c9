//! Reading a file in the format that its path names.
//!
//! Devices and pipes are read like files, up to [`LONGEST_STREAM`] bytes; beyond stands a [`ReadProblem::TooLong`].

use std::fs::File;
use std::io::Read as _;
use std::path::Path;

use crate::blocks::StructuredBlocks;
use crate::circles::CirclesDomain;
use crate::error::{ReadError, ReadProblem};
use crate::format::Format;
use crate::mesh::Mesh;
use crate::numbers::Encoding;
use crate::piecewise_complex::PiecewiseComplex;
use crate::planar_graph::PlanarGraph;
use crate::points::Coordinates;
use crate::{
    circles_toml, connectivity_map, geojson, medit, msh, obj, off, plot3d, ply, stl, svg_outline,
    tetgen, triangle, vtk, vtu, xy,
};

/// Bytes read at most from a device or a pipe, which may never end.
const LONGEST_STREAM: u64 = 1 << 30;

/// The mesh in a file of any format that holds one.
///
/// Points alone (`.xy`, `.xyz`, `.node`) make a mesh without cells; a `.poly` or a `.geojson` makes one of segments; structured blocks make one of
/// quads; a `.smesh` or a `.poly` of space makes one of triangles, if all its facets are. An `.ele` needs the `.node` beside it. Raw numbers are read as points only, see [`read_points`](crate::read_points).
///
/// # Errors
/// A [`ReadError`] that names the file, and the line and element where one is to blame. O(file).
pub fn read_mesh(path: &Path) -> Result<Mesh, ReadError> {
    named(path, |format, bytes| mesh_of(path, format, bytes))
}

/// The mesh in the bytes of the file at `path`.
pub(crate) fn mesh_of(path: &Path, format: Format, bytes: &[u8]) -> Result<Mesh, ReadError> {
    match format {
        Format::Xy => Ok(points_alone(Coordinates::Plane(xy::parse(bytes)?))),
        Format::Xyz => Ok(points_alone(Coordinates::Space(xy::parse(bytes)?))),
        Format::Off => off::parse(bytes),
        Format::Ply => ply::parse_mesh(bytes),
        Format::Stl => stl::parse(bytes),
        Format::Obj => obj::parse(bytes),
        Format::Msh => msh::parse(bytes).map(|file| file.mesh),
        Format::Medit => medit::parse(bytes),
        Format::TriangleNode => triangle::parse_node(bytes).map(Mesh::from),
        Format::TriangleEle => triangle::parse_ele(bytes, nodes_beside(path)?),
        Format::TetgenSmesh => Ok(complex_of(path, format, bytes)?.into_mesh()?),
        Format::TrianglePoly if tetgen::is_of_space(bytes) => {
            Ok(complex_of(path, format, bytes)?.into_mesh()?)
        }
        Format::TrianglePoly => Ok(triangle::parse_poly(bytes, || nodes_beside(path))?.as_mesh()),
        Format::GeoJson => Ok(geojson::parse(bytes)?.as_mesh()),
        Format::Vtu => vtu::parse(bytes),
        Format::Vtk => vtk::parse(bytes),
        Format::Plot3dAscii | Format::Plot3dBinary => {
            Ok(blocks_of(path, format, bytes)?.to_mesh()?)
        }
        _ => Err(unsupported(format, "a mesh")),
    }
}

fn points_alone(points: Coordinates) -> Mesh {
    Mesh {
        points: points.into_space(),
        ..Mesh::default()
    }
}

/// The blocks in a Plot3D file, with names and connections from the `.map` beside it, where there is one.
///
/// # Errors
/// A [`ReadError`] that names the file, and the line or byte and the element where one is to blame. O(file).
pub fn read_blocks(path: &Path) -> Result<StructuredBlocks, ReadError> {
    named(path, |format, bytes| blocks_of(path, format, bytes))
}

/// The circles in a `DOMAIN.toml`, whatever the file is called.
///
/// # Errors
/// A [`ReadError`] that names the file and line. O(file).
pub fn read_circles(path: &Path) -> Result<CirclesDomain, ReadError> {
    let parsed = || circles_toml::parse(&bytes_of(path, LONGEST_STREAM)?);
    parsed().map_err(|error: ReadError| error.in_file(path))
}

/// The planar straight-line graph in a `.poly`, with its points from the `.node` beside it when the file has none; of the rings and
/// lines of a `.geojson` or `.json`; of the shapes in an `.svg` ([`svg_outline`]); or of the outline of the faces in an `.off`
/// ([`off::parse_outline`]).
///
/// # Errors
/// A [`ReadError`] that names the file, and the line and element where one is to blame. O(file).
pub fn read_planar_graph(path: &Path) -> Result<PlanarGraph, ReadError> {
    named(path, |format, bytes| match format {
        Format::TrianglePoly => triangle::parse_poly(bytes, || nodes_beside(path)),
        Format::Svg => svg_outline::parse(bytes),
        Format::GeoJson => geojson::parse(bytes),
        Format::Off => off::parse_outline(bytes),
        _ => Err(unsupported(format, "a planar graph")),
    })
}

/// The piecewise linear complex in a `.smesh` or in a `.poly` of space, with its points from the `.node` beside it when the file has none.
///
/// # Errors
/// A [`ReadError`] that names the file, and the line and element where one is to blame. O(file).
pub fn read_piecewise_complex(path: &Path) -> Result<PiecewiseComplex, ReadError> {
    named(path, |format, bytes| complex_of(path, format, bytes))
}

fn complex_of(path: &Path, format: Format, bytes: &[u8]) -> Result<PiecewiseComplex, ReadError> {
    match format {
        Format::TrianglePoly => tetgen::parse_poly(bytes, || nodes_beside(path)),
        Format::TetgenSmesh => tetgen::parse_smesh(bytes, || nodes_beside(path)),
        _ => Err(unsupported(format, "a piecewise linear complex")),
    }
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
    let connected = || connectivity_map::parse(&bytes_of(&map, LONGEST_STREAM)?, grids);
    connected().map_err(|error: ReadError| error.in_file(&map))
}

fn nodes_beside(path: &Path) -> Result<triangle::Nodes, ReadError> {
    named(&path.with_extension("node"), |_, bytes| {
        triangle::parse_node(bytes)
    })
}

fn unsupported(format: Format, what: &str) -> ReadError {
    ReadProblem::Unsupported(format!("reading {what} from {format}")).into()
}

/// Parses the bytes of a file by its format; every error names the file.
pub(crate) fn named<T>(
    path: &Path,
    parse: impl FnOnce(Format, &[u8]) -> Result<T, ReadError>,
) -> Result<T, ReadError> {
    let parsed = || {
        parse(
            Format::from_path(path).ok_or(ReadProblem::UnknownFormat)?,
            &bytes_of(path, LONGEST_STREAM)?,
        )
    };
    parsed().map_err(|error: ReadError| error.in_file(path))
}

/// All bytes of a file, or of a stream of at most `longest` bytes.
fn bytes_of(path: &Path, longest: u64) -> Result<Vec<u8>, ReadError> {
    let mut file = File::open(path)?;
    let mut bytes = Vec::new();
    if file.metadata()?.is_file() {
        file.read_to_end(&mut bytes)?;
        return Ok(bytes);
    }
    file.take(longest.saturating_add(1))
        .read_to_end(&mut bytes)?;
    if bytes.len() as u64 > longest {
        return Err(ReadProblem::TooLong { limit: longest }.into());
    }
    Ok(bytes)
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;

    #[test]
    fn a_stream_that_does_not_end_is_given_up() {
        let read = |path: &str| bytes_of(Path::new(path), 1000);
        insta::assert_snapshot!(read("/dev/zero").unwrap_err(), @"a device or pipe that gives more than 1000 bytes");
        assert!(read("/dev/null").unwrap().is_empty());
    }

    #[test]
    fn a_folder_is_an_error_of_one_line_that_names_it() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("folder.vtu");
        std::fs::create_dir(&path).unwrap();
        let message = read_mesh(&path).unwrap_err().to_string();
        assert!(
            message.starts_with(&path.display().to_string()),
            "{message}"
        );
        assert_eq!(message.lines().count(), 1);
    }

    #[test]
    fn an_empty_file_is_an_error_or_no_points_in_every_format() {
        let folder = tempfile::tempdir().unwrap();
        for extension in Format::EXTENSIONS.split(' ') {
            let path = folder.path().join(format!("empty{extension}"));
            std::fs::write(&path, "").unwrap();
            match read_mesh(&path) {
                Ok(mesh) => {
                    assert!(mesh.points.is_empty() && [".xy", ".xyz", ".obj"].contains(&extension));
                }
                // The points of an `.ele` are looked for first.
                Err(error) => {
                    let named = error.path.unwrap();
                    assert!(named == path || extension == ".ele" && named.ends_with("empty.node"));
                }
            }
        }
    }
}
