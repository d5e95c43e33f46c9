//! From the plain data of files to the types of the methods, and back.

use delaunay_core::{
    Complex2, Complex3, FaceId, Subcomplex2, Subcomplex3, TetId, TetMesh, TriMesh, VertexId,
};
use glam::{DVec2, DVec3};
use medial_blocking::{Block, BlockGrid, BlockMesh, Circle, Domain, DomainError, WallName};
use mesh_io::{
    BlockSide, Cells, CirclesDomain, Connection, Frame, Mesh, StructuredBlock, StructuredBlocks,
};
use rayon::prelude::*;

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

/// A triangulation as a plain mesh: every point given, also those that are no vertices, and the triangles.
///
/// The triangles are in canonical order: each from its smallest corner on, sorted by their corners. So the
/// mesh depends on the triangulation alone, not on the numbers of its faces. O(n log n).
#[must_use]
pub fn triangle_mesh(points: &[DVec2], mesh: &TriMesh) -> Mesh {
    let real = mesh.faces().filter(|&face| !mesh.is_ghost_face(face));
    let corners = |face| from_smallest(mesh.face_vertices(face).map(number));
    let mut triangles: Vec<[u32; 3]> = real.map(corners).collect();
    triangles.par_sort_unstable();
    let points = points.iter().copied().map(flat).collect();
    Mesh::new(points, Cells::of_triangles(triangles))
}

/// A triangulation as a plain mesh: every point given, also those that are no vertices, and the tetrahedra.
///
/// The tetrahedra are in canonical order: the corners of each ascending, but for the first two where
/// that would turn it inside out, sorted by their corners. So the mesh depends on the triangulation alone,
/// not on the numbers of its tetrahedra. O(n log n).
#[must_use]
pub fn tetrahedron_mesh(points: &[DVec3], mesh: &TetMesh) -> Mesh {
    let real = mesh.tets().filter(|&tet| !mesh.is_ghost_tet(tet));
    let corners = |tet| ascending(mesh.tet_vertices(tet).map(number));
    let mut tetrahedra: Vec<[u32; 4]> = real.map(corners).collect();
    tetrahedra.par_sort_unstable();
    let points = points.iter().map(DVec3::to_array).collect();
    Mesh::new(points, Cells::of_tetrahedra(tetrahedra))
}

/// A solid as a plain mesh, and which tetrahedron each of its cells is.
///
/// Vertices keep their order and are numbered without gaps; those without a tetrahedron, removed ones, are left out. The
/// cells are in canonical order, as of [`tetrahedron_mesh`]. O(n log n).
#[must_use]
pub fn solid_mesh(solid: &Subcomplex3) -> (Mesh, Vec<TetId>) {
    mesh_without_gaps(solid.points(), solid.mesh())
}

/// Tetrahedra that need not be Delaunay as a plain mesh, as [`solid_mesh`] does.
#[must_use]
pub fn complex_mesh(complex: &Complex3) -> Mesh {
    mesh_without_gaps(complex.points(), complex.mesh()).0
}

fn mesh_without_gaps(places: &[DVec3], mesh: &TetMesh) -> (Mesh, Vec<TetId>) {
    let mut numbers = vec![0; places.len()];
    let mut points = Vec::new();
    for (v, place) in (0..).map(VertexId::new).zip(places) {
        if mesh.home(v).is_some() {
            numbers[v.index()] = points.len() as u32;
            points.push(place.to_array());
        }
    }
    let corners = |t| mesh.tet_vertices(t).map(|v| numbers[v.index()]);
    let real = mesh.tets().filter(|&t| !mesh.is_ghost_tet(t));
    let mut tetrahedra: Vec<_> = real.map(|t| (ascending(corners(t)), t)).collect();
    tetrahedra.par_sort_unstable();
    let (tetrahedra, ids) = tetrahedra.into_iter().unzip();
    (Mesh::new(points, Cells::of_tetrahedra(tetrahedra)), ids)
}

/// A region of the plane as a plain mesh, and which face each of its cells is.
///
/// Vertices keep their order and are numbered without gaps; those without a triangle, removed ones, are left out. The
/// cells are in canonical order, as of [`triangle_mesh`]. O(n log n).
#[must_use]
pub fn region_mesh(region: &Subcomplex2) -> (Mesh, Vec<FaceId>) {
    plain_triangles(region.mesh(), region.points())
}

/// As [`region_mesh`], of triangles that need not be Delaunay.
#[must_use]
pub fn triangles_mesh(complex: &Complex2) -> (Mesh, Vec<FaceId>) {
    plain_triangles(complex.mesh(), complex.points())
}

/// The real triangles of a mesh whose vertices have these places.
fn plain_triangles(mesh: &TriMesh, places: &[DVec2]) -> (Mesh, Vec<FaceId>) {
    let mut numbers = vec![0; places.len()];
    let mut points = Vec::with_capacity(places.len());
    for (v, &place) in (0..).map(VertexId::new).zip(places) {
        if mesh.outgoing(v).is_some() {
            numbers[v.index()] = points.len() as u32;
            points.push(flat(place));
        }
    }
    let corners = |f| mesh.face_vertices(f).map(|v| numbers[v.index()]);
    let faces = mesh.faces().filter(|&f| !mesh.is_ghost_face(f));
    let mut triangles: Vec<_> = faces.map(|f| (from_smallest(corners(f)), f)).collect();
    triangles.par_sort_unstable();
    let (triangles, ids) = triangles.into_iter().unzip();
    (Mesh::new(points, Cells::of_triangles(triangles)), ids)
}

/// Vertex ids are 32 bits wide.
fn number(vertex: VertexId) -> u32 {
    vertex.index() as u32
}

/// The same cyclic order from the smallest on.
fn from_smallest([a, b, c]: [u32; 3]) -> [u32; 3] {
    if b < a && b < c {
        [b, c, a]
    } else if c < a && c < b {
        [c, a, b]
    } else {
        [a, b, c]
    }
}

/// An even permutation into ascending order, but for the first two where it takes an odd one.
fn ascending(mut corners: [u32; 4]) -> [u32; 4] {
    let mut odd = false;
    for [i, j] in [[0, 1], [2, 3], [0, 2], [1, 3], [1, 2]] {
        if corners[i] > corners[j] {
            corners.swap(i, j);
            odd = !odd;
        }
    }
    if odd {
        corners.swap(0, 1);
    }
    corners
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
    fn canonical_corners_are_an_even_permutation() {
        let even = |order: &[usize]| {
            let pairs = (0..order.len()).flat_map(|i| (i + 1..order.len()).map(move |j| (i, j)));
            pairs.filter(|&(i, j)| order[i] > order[j]).count() % 2 == 0
        };
        let permutations = (0..256u32).map(|code| [0, 2, 4, 6].map(|shift| code >> shift & 3));
        for corners in permutations.filter(|p| (0..4).all(|k| p.contains(&k))) {
            let sorted = ascending(corners);
            assert_eq!(sorted[2..], [2, 3]);
            assert_eq!(
                even(&sorted.map(|k| k as usize)),
                even(&corners.map(|k| k as usize))
            );
        }
        for cyclic in [[0, 5, 3], [5, 3, 0], [3, 0, 5]] {
            assert_eq!(from_smallest(cyclic), [0, 5, 3]);
        }
    }
}
