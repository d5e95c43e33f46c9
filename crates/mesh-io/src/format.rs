//! Which format a path names.

use std::fmt;
use std::path::Path;

/// A file format.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Format {
    /// VTK XML unstructured grid, `.vtu`.
    Vtu,
    /// Legacy VTK, `.vtk`.
    Vtk,
    /// Gmsh MSH, `.msh`.
    Msh,
    /// Medit in ASCII, `.mesh`.
    Medit,
    /// Plot3D multi-block in ASCII, `.p3d`.
    Plot3dAscii,
    /// Plot3D multi-block in binary, `.p3b`.
    Plot3dBinary,
    /// `OpenFOAM` block description: a file called `blockMeshDict`, or with that extension.
    BlockMeshDict,
    /// Points of Triangle, `.node`.
    TriangleNode,
    /// Triangles of Triangle, `.ele`, with their points in a `.node` beside it.
    TriangleEle,
    /// Planar straight-line graph of Triangle, or piecewise linear complex of `TetGen`, `.poly`.
    TrianglePoly,
    /// Piecewise linear complex of `TetGen` whose facets are polygons, `.smesh`.
    TetgenSmesh,
    /// Object File Format, `.off`.
    Off,
    /// Scalable Vector Graphics, `.svg`.
    Svg,
    /// Two coordinates a line, `.xy`.
    Xy,
    /// Three coordinates a line, `.xyz`.
    Xyz,
    /// Raw little-endian doubles, `.f64`.
    Raw,
    /// Polygon File Format, `.ply`.
    Ply,
    /// Triangles of stereolithography, `.stl`.
    Stl,
    /// Object file of Wavefront, `.obj`.
    Obj,
    /// Outlines of geography, `.geojson` or `.json`.
    GeoJson,
}

impl Format {
    /// Every name that [`Format::from_path`] knows, for messages.
    pub const EXTENSIONS: &'static str = ".vtu .vtk .msh .mesh .p3d .p3b blockMeshDict .node .ele .poly .smesh .off .svg .xy .xyz .f64 .ply .stl .obj .geojson .json";

    /// The format that a path names by its file name or extension (in any case); `None` when it names none.
    #[must_use]
    pub fn from_path(path: &Path) -> Option<Self> {
        let extension = path.extension().or_else(|| path.file_name())?.to_str()?;
        Some(match extension.to_ascii_lowercase().as_str() {
            "vtu" => Self::Vtu,
            "vtk" => Self::Vtk,
            "msh" => Self::Msh,
            "mesh" => Self::Medit,
            "p3d" => Self::Plot3dAscii,
            "p3b" => Self::Plot3dBinary,
            "blockmeshdict" => Self::BlockMeshDict,
            "node" => Self::TriangleNode,
            "ele" => Self::TriangleEle,
            "poly" => Self::TrianglePoly,
            "smesh" => Self::TetgenSmesh,
            "off" => Self::Off,
            "svg" => Self::Svg,
            "xy" => Self::Xy,
            "xyz" => Self::Xyz,
            "f64" => Self::Raw,
            "ply" => Self::Ply,
            "stl" => Self::Stl,
            "obj" => Self::Obj,
            "geojson" | "json" => Self::GeoJson,
            _ => return None,
        })
    }

    /// Whether it holds structured blocks as such, not only their cells.
    #[must_use]
    pub const fn holds_blocks(self) -> bool {
        matches!(
            self,
            Self::Plot3dAscii | Self::Plot3dBinary | Self::BlockMeshDict
        )
    }
}

impl fmt::Display for Format {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(match self {
            Self::Vtu => "VTU",
            Self::Vtk => "VTK",
            Self::Msh => "MSH",
            Self::Medit => "Medit",
            Self::Plot3dAscii => "Plot3D ASCII",
            Self::Plot3dBinary => "Plot3D binary",
            Self::BlockMeshDict => "blockMeshDict",
            Self::TriangleNode => "Triangle .node",
            Self::TriangleEle => "Triangle .ele",
            Self::TrianglePoly => "Triangle .poly",
            Self::TetgenSmesh => "TetGen .smesh",
            Self::Off => "OFF",
            Self::Svg => "SVG",
            Self::Xy => "xy text",
            Self::Xyz => "xyz text",
            Self::Raw => "raw f64",
            Self::Ply => "PLY",
            Self::Stl => "STL",
            Self::Obj => "OBJ",
            Self::GeoJson => "GeoJSON",
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_names_its_format_by_extension_or_by_name() {
        let format = |path: &str| Format::from_path(Path::new(path));
        assert_eq!(format("a/b.VTU"), Some(Format::Vtu));
        assert_eq!(format("system/blockMeshDict"), Some(Format::BlockMeshDict));
        assert_eq!(format("fine.blockMeshDict"), Some(Format::BlockMeshDict));
        assert_eq!(format("a.tar.node"), Some(Format::TriangleNode));
        assert_eq!(format("a.geo.json"), Some(Format::GeoJson));
        assert_eq!(
            (format("noextension"), format("a.step"), format("")),
            (None, None, None)
        );
    }
}
