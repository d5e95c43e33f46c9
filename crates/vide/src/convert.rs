//! From the plain data of files to the types of the methods, and back.

use delaunay_core::Delaunay2;
use glam::DVec2;
use medial_blocking::{Block, BlockGrid, BlockMesh, Circle, Domain, DomainError, WallName};
use mesh_io::{
    BlockSide, Cell, Cells, CirclesDomain, Connection, Frame, Mesh, StructuredBlock,
    StructuredBlocks,
};

/// The domain that circles from a file describe.
///
/// # Errors
/// Everything that is wrong with the circles.
pub fn domain_of(circles: &CirclesDomain) -> Result<Domain, DomainError> {
    let holes: Vec<Circle> = circles
        .holes
        .iter()
        .map(|hole| Circle::new(hole.centre.into(), hole.radius))
        .collect();
    match circles.frame {
        Frame::Circle { centre, radius } => {
            Domain::in_circle(Circle::new(centre.into(), radius), &holes)
        }
        Frame::Periodic { period } => Domain::periodic(period.into(), &holes),
    }
}

/// The blocks of a block mesh as plain structured blocks: `i` runs with ξ from the medial arc to
/// the wall, `j` with η along the arc.
///
/// Blocks are named `block_0`, `block_1`, …, patches `hole_0`, … and `bounding`. O(nodes).
#[must_use]
pub fn structured_blocks(mesh: &BlockMesh) -> StructuredBlocks {
    let blocks = mesh.blocks().enumerate();
    StructuredBlocks {
        blocks: blocks
            .map(|(index, (block, grid))| structured_block(mesh, index, block, grid))
            .collect(),
    }
}

fn structured_block(
    mesh: &BlockMesh,
    index: usize,
    block: &Block,
    grid: &BlockGrid,
) -> StructuredBlock {
    let domain = mesh.blocking().domain();
    let (mate, shift) = block.neighbours.xi0;
    let shift = domain.translation(shift);
    let medial = Connection::Block {
        block: mate.index(),
        side: BlockSide::IMin,
        reversed: true,
        shift: [shift.x, shift.y, 0.0],
    };
    let round_wall = |neighbour: medial_blocking::BlockId, side| Connection::Block {
        block: neighbour.index(),
        side,
        reversed: false,
        shift: [0.0; 3],
    };
    StructuredBlock {
        name: format!("block_{index}"),
        ni: grid.cells_across() + 1,
        nj: grid.cells_along() + 1,
        points: grid.nodes().iter().copied().map(flat).collect(),
        sides: [
            medial,
            Connection::Patch(patch_name(domain.name(block.wall))),
            round_wall(block.neighbours.eta0, BlockSide::JMax),
            round_wall(block.neighbours.eta1, BlockSide::JMin),
        ],
    }
}

/// What boundary patches are called in files.
#[must_use]
pub fn patch_name(wall: WallName) -> String {
    match wall {
        WallName::Hole(index) => format!("hole_{index}"),
        WallName::Bounding => "bounding".to_owned(),
    }
}

/// A triangulation as a plain mesh: every point given, duplicates too, and the triangles.
#[must_use]
pub fn triangle_mesh(delaunay: &Delaunay2) -> Mesh {
    let mut cells = Cells::default();
    for face in delaunay.faces() {
        let corners = delaunay.mesh().face_vertices(face);
        cells.push(Cell::Triangle(corners.map(|vertex| vertex.index() as u32)));
    }
    Mesh::new(delaunay.points().iter().copied().map(flat).collect(), cells)
}

/// The points of a file as points of the plane.
///
/// # Errors
/// The index and height of the first point that does not lie in the plane z = 0.
pub fn planar_points(points: &[[f64; 3]]) -> Result<Vec<DVec2>, NotPlanar> {
    let planar = |(index, &[x, y, z]): (usize, &[f64; 3])| {
        if z == 0.0 {
            Ok(DVec2::new(x, y))
        } else {
            Err(NotPlanar { index, z })
        }
    };
    points.iter().enumerate().map(planar).collect()
}

/// A point of space where a point of the plane is needed.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("point {index} lies at z = {z}, points of the plane are needed")]
pub struct NotPlanar {
    /// The point, counted from 0.
    pub index: usize,
    /// Its height.
    pub z: f64,
}

fn flat(p: DVec2) -> [f64; 3] {
    [p.x, p.y, 0.0]
}

#[cfg(test)]
mod tests {
    use super::*;
    use medial_blocking::{CellCounts, Params, mesh};

    #[test]
    fn structured_blocks_of_bounded_and_periodic_domains_agree_with_themselves() {
        let hole = |x, y| Circle::new(DVec2::new(x, y), 0.2);
        let bounded = Domain::in_circle(
            Circle::new(DVec2::ZERO, 2.0),
            &[hole(-1.0, 0.0), hole(1.0, 0.1)],
        )
        .unwrap();
        let periodic = Domain::periodic(DVec2::new(1.0, 0.9), &[hole(0.3, 0.3)]).unwrap();
        for domain in [bounded, periodic] {
            let params = Params {
                cells: CellCounts::PerBlock(4),
                ..Params::default()
            };
            let blocks = structured_blocks(&mesh(&domain, &params).unwrap());
            assert_eq!(blocks.check(), Ok(()));
            let merged = blocks.to_mesh().unwrap();
            assert_eq!(merged.cells.kinds().len(), 16 * blocks.blocks.len());
        }
    }

    #[test]
    fn points_off_the_plane_are_named() {
        assert_eq!(
            planar_points(&[[0.0; 3], [1.0, 2.0, -3.0]]),
            Err(NotPlanar { index: 1, z: -3.0 })
        );
    }
}
