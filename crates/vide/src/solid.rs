//! The solid that a plain mesh describes: by a closed surface of triangles, or by tetrahedra.

use std::ops::ControlFlow;

use delaunay_core::progress::Progress;
use delaunay_core::{
    BuildOptions, SolidError, Subcomplex3, Surface, SurfaceError, TetBoundary, TetsError, VertexId,
};
use glam::DVec3;
use mesh_io::{Cell, CellKind, Mesh};

/// A solid as it was given.
#[derive(Clone, Debug, PartialEq)]
pub enum GivenSolid {
    /// By its surface.
    Surface(Surface),
    /// By tetrahedra, of which the bounding facets and all vertices are kept.
    Tetrahedra(TetBoundary),
}

/// Why a mesh describes no solid. Triangles and tetrahedra are counted among their kind.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum GivenSolidError {
    /// A cell that is too much for a surface or for tetrahedra.
    #[error("cell {cell} is a {}, but only triangles or tetrahedra make a solid", .kind.name())]
    Cell {
        /// Index of the cell.
        cell: usize,
        /// What it is.
        kind: CellKind,
    },
    /// Nothing that could bound or fill.
    #[error("there are no triangles and no tetrahedra")]
    NoCells,
    /// The triangles are no closed surface.
    #[error(transparent)]
    Surface(#[from] SurfaceError),
    /// The tetrahedra are no mesh.
    #[error(transparent)]
    Tetrahedra(#[from] TetsError),
    /// The surface bounds no tetrahedra of the Delaunay triangulation of the vertices.
    #[error(transparent)]
    Solid(SolidError),
    /// The same of the surface of given tetrahedra: two facets intersect.
    #[error("boundary facets of tetrahedra {first} and {second} intersect")]
    FacetsIntersect {
        /// The tetrahedron with the first facet.
        first: usize,
        /// The tetrahedron with the other.
        second: usize,
    },
    /// The same of the surface of given tetrahedra: facets are not Delaunay.
    #[error("{}", missing_text(*.tet, *.facets))]
    MissingFacets {
        /// The first tetrahedron with such a facet.
        tet: usize,
        /// How many such facets there are.
        facets: usize,
    },
}

impl GivenSolid {
    /// The solid that a mesh describes: by its tetrahedra if it has some, else by its triangles.
    ///
    /// Cells of lower dimension, which mark edges and sides in files, are passed over. O(n log n).
    ///
    /// # Errors
    /// Other cells, and what [`Surface::new`] and [`Surface::round_tets`] find.
    pub fn of(mesh: &Mesh) -> Result<Self, GivenSolidError> {
        let kinds = mesh.cells.kinds();
        let dimension = kinds.iter().map(|kind| kind.dimension()).max();
        let wanted = match dimension {
            Some(3) => CellKind::Tetrahedron,
            Some(2) => CellKind::Triangle,
            _ => return Err(GivenSolidError::NoCells),
        };
        let unfit = |kind: CellKind| kind != wanted && Some(kind.dimension()) == dimension;
        if let Some(cell) = kinds.iter().position(|&kind| unfit(kind)) {
            let kind = kinds[cell];
            return Err(GivenSolidError::Cell { cell, kind });
        }
        let points = mesh.points.iter().copied().map(DVec3::from).collect();
        Ok(if wanted == CellKind::Triangle {
            Self::Surface(Surface::new(points, triangles(mesh))?)
        } else {
            Self::Tetrahedra(Surface::round_tets(points, &tetrahedra(mesh))?)
        })
    }

    /// The tetrahedra of the Delaunay triangulation of all vertices that are inside.
    ///
    /// # Errors
    /// What [`Surface::solid`] finds.
    pub fn tetrahedralize(
        &self,
        options: BuildOptions,
        report: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Subcomplex3, GivenSolidError> {
        let surface = match self {
            Self::Surface(surface) => surface,
            Self::Tetrahedra(boundary) => &boundary.surface,
        };
        let solid = surface.solid(options, report);
        let solid = solid.map_err(|error| self.named(error))?;
        Ok(Subcomplex3::of(solid.delaunay(), |t| solid.is_inside(t)))
    }

    /// The error in words of what was given.
    fn named(&self, error: SolidError) -> GivenSolidError {
        let Self::Tetrahedra(boundary) = self else {
            return GivenSolidError::Solid(error);
        };
        match error {
            SolidError::SelfIntersection { first, second } => GivenSolidError::FacetsIntersect {
                first: boundary.tets[first],
                second: boundary.tets[second],
            },
            SolidError::MissingTriangles { triangles } => GivenSolidError::MissingFacets {
                tet: triangles.first().map_or(0, |&first| boundary.tets[first]),
                facets: triangles.len(),
            },
            error => GivenSolidError::Solid(error),
        }
    }
}

fn triangles(mesh: &Mesh) -> Vec<[VertexId; 3]> {
    let corners = |cell| match cell {
        Cell::Triangle(corners) => Some(corners.map(vertex)),
        _ => None,
    };
    mesh.cells.iter().filter_map(corners).collect()
}

fn tetrahedra(mesh: &Mesh) -> Vec<[VertexId; 4]> {
    let corners = |cell| match cell {
        Cell::Tetrahedron(corners) => Some(corners.map(vertex)),
        _ => None,
    };
    mesh.cells.iter().filter_map(corners).collect()
}

/// A corner beyond all ids is beyond all points too.
fn vertex(corner: u32) -> VertexId {
    VertexId::new(corner as usize)
}

fn missing_text(tet: usize, facets: usize) -> String {
    let others = match facets {
        0 | 1 => String::new(),
        2 => " and 1 other".to_owned(),
        _ => format!(" and {} others", facets - 1),
    };
    let are = if facets > 1 { "are" } else { "is" };
    format!(
        "a boundary facet of tetrahedron {tet}{others} {are} not in the Delaunay triangulation of the vertices"
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use delaunay_core::progress::silent;

    fn mesh(points: &[[i32; 3]], cells: &[Cell]) -> Mesh {
        let points = points.iter().map(|p| p.map(f64::from)).collect();
        Mesh::new(points, cells.iter().copied().collect())
    }

    fn tetrahedralize(mesh: &Mesh) -> Result<Subcomplex3, GivenSolidError> {
        GivenSolid::of(mesh)?.tetrahedralize(BuildOptions::default(), &mut silent)
    }

    const CORNERS: [[i32; 3]; 5] = [[0, 0, 0], [9, 0, 0], [0, 9, 0], [0, 0, 9], [1, 1, 1]];
    const FACETS: [Cell; 4] = [
        Cell::Triangle([1, 2, 3]),
        Cell::Triangle([2, 0, 3]),
        Cell::Triangle([0, 1, 3]),
        Cell::Triangle([2, 1, 0]),
    ];

    #[test]
    fn cells_of_lower_dimension_are_passed_over() {
        let marked = [
            FACETS.as_slice(),
            &[Cell::Segment([0, 1]), Cell::Vertex([2])],
        ]
        .concat();
        let solid = tetrahedralize(&mesh(&CORNERS[..4], &marked)).unwrap();
        assert_eq!(solid.tets().count(), 1);
        let inside = [[0, 1, 2, 4], [1, 0, 3, 4], [0, 2, 3, 4], [2, 1, 3, 4]];
        let cells = [FACETS.as_slice(), &inside.map(Cell::Tetrahedron)].concat();
        let solid = tetrahedralize(&mesh(&CORNERS, &cells)).unwrap();
        assert_eq!((solid.tets().count(), solid.vertex_count()), (4, 5));
    }

    #[test]
    fn what_is_no_solid_is_said() {
        let error = |cells: &[Cell]| tetrahedralize(&mesh(&CORNERS, cells)).unwrap_err();
        insta::assert_snapshot!(error(&[Cell::Segment([0, 1])]), @"there are no triangles and no tetrahedra");
        insta::assert_snapshot!(error(&[FACETS[0], Cell::Quad([0, 1, 2, 3])]), @"cell 1 is a quad, but only triangles or tetrahedra make a solid");
        insta::assert_snapshot!(error(&[Cell::Tetrahedron([0, 1, 2, 3]), Cell::Pyramid([0, 1, 2, 3, 4])]), @"cell 1 is a pyramid, but only triangles or tetrahedra make a solid");
        insta::assert_snapshot!(error(&FACETS), @"v4 is a corner of no triangle");
    }

    /// A tetrahedron close below the large facet of another, and one that pierces it.
    #[test]
    fn facets_of_tetrahedra_that_are_not_there_are_named_by_the_tetrahedron() {
        let two = |tip: i32| {
            let above = [[-90, -90, 0], [90, -90, 0], [0, 90, 0], [0, 0, 90]];
            let below = [[0, 0, tip], [0, 10, -10], [10, 0, -10], [-10, -10, -10]];
            let tets = [[0, 1, 2, 3], [4, 5, 6, 7]].map(Cell::Tetrahedron);
            tetrahedralize(&mesh(&[above, below].concat(), &tets)).unwrap_err()
        };
        insta::assert_snapshot!(two(-1), @"a boundary facet of tetrahedron 0 is not in the Delaunay triangulation of the vertices");
        insta::assert_snapshot!(two(1), @"boundary facets of tetrahedra 0 and 1 intersect");
        insta::assert_snapshot!(missing_text(7, 2), @"a boundary facet of tetrahedron 7 and 1 other are not in the Delaunay triangulation of the vertices");
        insta::assert_snapshot!(missing_text(7, 3), @"a boundary facet of tetrahedron 7 and 2 others are not in the Delaunay triangulation of the vertices");
    }
}
