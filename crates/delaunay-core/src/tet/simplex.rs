//! The first tetrahedron, or what the points are when there is none.

use super::mesh::TetMesh;
use super::sight::Places;
use crate::ids::VertexId;
use crate::tri::Extent;
use geo_predicates::{Sign, orient2d, orient3d};
use glam::{DVec2, DVec3};

/// The first vertices that span a tetrahedron, right-handed. Slots are `0..slots`, the ghost in front.
///
/// # Errors
/// What the points span instead. For a plane also three points that span it.
pub(super) fn first_simplex(places: impl Places, slots: usize) -> Result<[VertexId; 4], FlatCause> {
    let a = 1;
    if slots <= a {
        return Err(FlatCause::extent(Extent::Empty));
    }
    let at = |slot: usize| places.place(VertexId::from_slot(slot));
    let origin = at(a);
    let first =
        |from: usize, found: &dyn Fn(DVec3) -> bool| (from..slots).find(|&slot| found(at(slot)));
    let Some(b) = first(a + 1, &|p| p != origin) else {
        return Err(FlatCause::extent(Extent::Point));
    };
    let Some(c) = first(b + 1, &|p| !collinear(origin, at(b), p)) else {
        return Err(FlatCause::extent(Extent::Line));
    };
    let side = |p| orient3d(origin, at(b), at(c), p);
    let [va, vb, vc] = [a, b, c].map(VertexId::from_slot);
    // Points before `c` lie on the line of the first two.
    match first(c + 1, &|p| side(p) != Sign::Zero) {
        None => Err(FlatCause {
            extent: Extent::Plane,
            triangle: [origin, at(b), at(c)],
        }),
        Some(d) if side(at(d)) == Sign::Positive => Ok([va, vb, vc, VertexId::from_slot(d)]),
        Some(d) => Ok([vb, va, vc, VertexId::from_slot(d)]),
    }
}

/// What points without a tetrahedron span.
pub(super) struct FlatCause {
    pub(super) extent: Extent,
    /// Three points that span the plane, if it is one.
    pub(super) triangle: [DVec3; 3],
}

impl FlatCause {
    fn extent(extent: Extent) -> Self {
        Self {
            extent,
            triangle: [DVec3::ZERO; 3],
        }
    }
}

/// Whether three points lie on one line: all three projections along an axis do.
pub(super) fn collinear(a: DVec3, b: DVec3, c: DVec3) -> bool {
    let flat =
        |project: fn(DVec3) -> DVec2| orient2d(project(a), project(b), project(c)) == Sign::Zero;
    flat(|p| DVec2::new(p.x, p.y))
        && flat(|p| DVec2::new(p.y, p.z))
        && flat(|p| DVec2::new(p.z, p.x))
}

/// One tetrahedron and the four ghosts round it, in an empty mesh.
pub(super) fn glue_simplex(mesh: &mut TetMesh, corners: [VertexId; 4]) {
    let tet = mesh.push_tet(corners);
    let ghosts = tet.facets().map(|f| {
        let [a, b, c] = mesh.facet_vertices(f);
        let ghost = mesh.push_tet([a, b, c, VertexId::GHOST]);
        mesh.glue(f, ghost.facet(3));
        ghost
    });
    for (i, ghost) in ghosts.into_iter().enumerate() {
        for (j, other) in ghosts.into_iter().enumerate().filter(|&(j, _)| j != i) {
            // Two ghosts share all corners but those opposite each other in the tetrahedron.
            let side = |ghost, apart: usize| {
                mesh.corner_of(ghost, corners[apart])
                    .map(|corner| ghost.facet(corner))
            };
            if let (Some(f), Some(g)) = (side(ghost, j), side(other, i)) {
                mesh.glue(f, g);
            }
        }
    }
}
