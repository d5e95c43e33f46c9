//! The triangles of a plain mesh, to be judged as a surface.

use delaunay_core::VertexId;
use glam::DVec3;
use mesh_io::{Cell, CellKind, Mesh};

/// The points of a mesh and its triangles, whatever they form.
#[derive(Clone, Debug, PartialEq)]
pub struct Triangles {
    /// All points.
    pub points: Vec<DVec3>,
    /// The corners of the triangles, in the order of the mesh.
    pub triangles: Vec<[VertexId; 3]>,
    /// A marker for each triangle, where the mesh has markers.
    pub markers: Option<Vec<i32>>,
}

/// A mesh is no surface of triangles.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("cell {cell} is a {}, but a surface has triangles", .kind.name())]
pub struct NoTriangle {
    /// Index of the cell.
    pub cell: usize,
    /// What it is.
    pub kind: CellKind,
}

impl Triangles {
    /// The triangles of a mesh; vertices and segments, which mark in files, are passed over. Linear.
    ///
    /// # Errors
    /// The first other cell.
    pub fn of(mesh: &Mesh) -> Result<Self, NoTriangle> {
        let mut triangles = Vec::new();
        let mut markers = mesh.cell_markers.as_ref().map(|_| Vec::new());
        for (cell, shape) in mesh.cells.iter().enumerate() {
            if let Cell::Triangle(corners) = shape {
                triangles.push(corners.map(vertex));
                if let (Some(kept), Some(given)) = (&mut markers, &mesh.cell_markers) {
                    kept.extend(given.get(cell));
                }
            } else if shape.kind().dimension() > 1 {
                let kind = shape.kind();
                return Err(NoTriangle { cell, kind });
            }
        }
        Ok(Self {
            points: mesh.points.iter().copied().map(DVec3::from).collect(),
            triangles,
            markers,
        })
    }
}

/// The one index that is beyond all ids is that of the ghost, which is no point either.
fn vertex(corner: u32) -> VertexId {
    let index = Some(corner as usize).filter(|&index| index < VertexId::LIMIT);
    index.map_or(VertexId::GHOST, VertexId::new)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn triangles_keep_their_markers_and_other_cells_are_named() {
        let cells = [
            Cell::Segment([0, 1]),
            Cell::Triangle([0, 1, 2]),
            Cell::Vertex([3]),
            Cell::Triangle([2, 1, 3]),
        ];
        let points = vec![[0.0; 3]; 4];
        let mut mesh = Mesh::new(points.clone(), cells.iter().copied().collect());
        assert_eq!(Triangles::of(&mesh).unwrap().markers, None);
        mesh.cell_markers = Some(vec![5, 6, 7, 8]);
        let given = Triangles::of(&mesh).unwrap();
        assert_eq!(given.markers, Some(vec![6, 8]));
        assert_eq!(given.triangles[1], [2, 1, 3].map(VertexId::new));
        let quad = [cells[1], Cell::Quad([0, 1, 2, 3])];
        let mesh = Mesh::new(points, quad.iter().copied().collect());
        insta::assert_snapshot!(Triangles::of(&mesh).unwrap_err(), @"cell 1 is a quad, but a surface has triangles");
    }
}
