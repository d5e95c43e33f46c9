//! The first three points, with which a build begins.

use super::super::mesh::TriMesh;
use super::arena::Arena;
use crate::ids::{FaceId, VertexId};
use geo_predicates::{Sign, orient2d};
use glam::DVec2;

/// Moves the first points that span a triangle to the front, counterclockwise, behind the ghost; false when
/// all are on a line.
pub(in super::super) fn bring_triangle_to_front(coords: &mut [DVec2], order: &mut [u32]) -> bool {
    let mut bring = |slot: usize, to: usize, coords: &mut [DVec2]| {
        coords[to..=slot].rotate_right(1);
        order[to - 1..slot].rotate_right(1);
    };
    let [_, a, rest @ ..] = &*coords else {
        return false;
    };
    let Some(second) = rest.iter().position(|b| b != a) else {
        return false;
    };
    bring(second + 2, 2, coords);
    let [_, a, b, rest @ ..] = &*coords else {
        return false;
    };
    let Some(third) = rest.iter().position(|&c| orient2d(*a, *b, c) != Sign::Zero) else {
        return false;
    };
    let clockwise = orient2d(*a, *b, rest[third]) == Sign::Negative;
    bring(third + 3, if clockwise { 2 } else { 3 }, coords);
    true
}

/// Writes the triangle of the first three vertices, counterclockwise, and the ghosts round it: the first four faces.
pub(super) fn put_triangle(arena: &Arena<'_>) {
    let mut mesh = TriMesh::default();
    glue_triangle(&mut mesh, [1, 2, 3].map(VertexId::from_slot));
    for (index, face) in mesh.faces.into_iter().enumerate() {
        // SAFETY: there is room for the faces of three vertices or more, and nobody else has the arena.
        unsafe { arena.put(FaceId::new(index), face) };
    }
}

/// One triangle and the three ghosts round it, in an empty mesh.
fn glue_triangle(mesh: &mut TriMesh, [a, b, c]: [VertexId; 3]) {
    let face = mesh.push_face([a, b, c]);
    let ghosts = [[b, a], [c, b], [a, c]].map(|[u, w]| mesh.push_face([u, w, VertexId::GHOST]));
    for (i, ghost) in ghosts.into_iter().enumerate() {
        mesh.glue(face.half_edge(i), ghost.half_edge(0));
        // Ghost i ends where ghost i + 1 starts: (b, a), (c, b), (a, c).
        mesh.glue(ghosts[(i + 1) % 3].half_edge(1), ghost.half_edge(2));
    }
}
