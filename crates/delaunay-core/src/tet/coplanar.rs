//! Points of space on one plane: their Delaunay triangulation, without leaving exact arithmetic.
//!
//! A projection would distort circles. Instead an apex is put beside the plane: a sphere through three
//! points of the plane and the apex meets the plane in the circle through the three, so the
//! tetrahedra on the apex stand on the Delaunay triangles of the plane, and its link, closed by the
//! ghost, is their half-edge mesh.

use super::delaunay::Delaunay3;
use super::mesh::TetMesh;
use super::simplex::FlatCause;
use crate::error::BuildError;
use crate::ids::{HalfEdgeId, VertexId};
use crate::options::BuildOptions;
use crate::progress::Meter;
use crate::tri::{Extent, Flat, TriMesh};
use geo_predicates::{Sign, orient3d};
use glam::DVec3;
use rustc_hash::FxHashMap;

/// What points without a tetrahedron are.
pub(super) fn describe(
    points: &[DVec3],
    cause: &FlatCause,
    meter: &mut Meter<'_>,
) -> Result<Flat, BuildError> {
    let flat = Flat::sorted_by(points.len(), |i| (points[i] + DVec3::ZERO).to_array());
    with_plane(flat, points, cause, |raised| {
        let delaunay = Delaunay3::grow(raised, BuildOptions::default(), meter)?;
        Ok(delaunay.into_mesh())
    })
}

/// `flat` with the triangulation of its vertices in their plane, if they span one.
///
/// `triangulate` gets the places of the vertices of `flat`, then that of an apex beside the plane.
pub(super) fn with_plane(
    mut flat: Flat,
    points: &[DVec3],
    cause: &FlatCause,
    triangulate: impl FnOnce(&[DVec3]) -> Result<TetMesh, BuildError>,
) -> Result<Flat, BuildError> {
    if cause.extent != Extent::Plane {
        return Ok(flat);
    }
    let Some(apex) = apex_beside(points, cause.triangle) else {
        return Ok(flat);
    };
    let mut raised: Vec<DVec3> = flat.vertices.iter().map(|v| points[v.index()]).collect();
    raised.push(apex.place);
    let mesh = triangulate(&raised)?;
    let link = mesh.link(VertexId::new(raised.len() - 1));
    let name = |v: VertexId| flat.vertices.get(v.index()).copied();
    let faces = link.map(|facet| {
        let [a, b, c] = mesh.facet_vertices(facet);
        let seen_from_above = if apex.above { [a, c, b] } else { [a, b, c] };
        seen_from_above.map(|v| name(v).unwrap_or(VertexId::GHOST))
    });
    flat.plane = Some(glued(faces, points.len() + 1));
    Ok(flat)
}

/// A point off a plane.
struct Apex {
    place: DVec3,
    /// Whether it is on the side of the plane to which the axis leads.
    above: bool,
}

/// An accepted point off the plane of `triangle`, along the first axis that is not parallel to the plane
/// and about as far from it as the points from the origin.
fn apex_beside(points: &[DVec3], [a, b, c]: [DVec3; 3]) -> Option<Apex> {
    let reach = points
        .iter()
        .map(|p| p.abs().max_element())
        .fold(0.0, f64::max);
    let off = |apex: &Apex| {
        geo_predicates::check_point3(0, apex.place).is_ok()
            && orient3d(a, b, c, apex.place) != Sign::Zero
    };
    // A step towards the origin stays in range.
    let steps = DVec3::AXES.into_iter().flat_map(|axis| {
        let above = a.dot(axis) <= 0.0;
        let direction = if above { axis } else { -axis };
        [0.5, 1.0].map(|length| Apex {
            place: a + direction * (length * reach),
            above,
        })
    });
    steps.into_iter().find(off)
}

/// The faces glued along their common edges.
fn glued(faces: impl Iterator<Item = [VertexId; 3]>, slots: usize) -> TriMesh {
    let mut mesh = TriMesh::default();
    let mut edges: FxHashMap<(VertexId, VertexId), HalfEdgeId> = FxHashMap::default();
    for corners in faces {
        for h in mesh.push_face(corners).half_edges() {
            let (origin, target) = (mesh.origin(h), mesh.target(h));
            edges.insert((origin, target), h);
            if let Some(&twin) = edges.get(&(target, origin)) {
                mesh.glue(h, twin);
            }
        }
    }
    mesh.index_vertices(slots);
    mesh
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plane_of(points: &[[f64; 3]]) -> Flat {
        let points: Vec<DVec3> = points.iter().copied().map(DVec3::from).collect();
        match Delaunay3::build(&points) {
            Err(BuildError::Flat(flat)) => *flat,
            other => panic!("{other:?}"),
        }
    }

    /// A slanted rhombus with unequal diagonals: its projection along z is a square, whose diagonals
    /// would tie, but in its own plane only the short diagonal is Delaunay.
    #[test]
    fn circles_are_those_of_the_plane_and_not_of_a_projection() {
        let flat = plane_of(&[
            [1.0, 0.0, 5.0],
            [0.0, 1.0, 0.0],
            [-1.0, 0.0, -5.0],
            [0.0, -1.0, 0.0],
        ]);
        assert_eq!(flat.extent(), Extent::Plane);
        let mesh = flat.plane.unwrap();
        assert_eq!(mesh.check(), Ok(()));
        let real = mesh.faces().filter(|&f| !mesh.is_ghost_face(f)).count();
        assert_eq!((real, mesh.face_count()), (2, 6));
        let [short, long] = [[1, 3], [0, 2]].map(|ends| ends.map(VertexId::new));
        assert!(mesh.find_half_edge(short[0], short[1]).is_some());
        assert!(mesh.find_half_edge(long[0], long[1]).is_none());
    }

    #[test]
    fn duplicates_on_a_plane_are_reported() {
        let flat = plane_of(&[
            [0.0, 2.0, 0.0],
            [1.0, 2.0, 0.0],
            [0.0, 2.0, 1.0],
            [1.0, 2.0, 0.0],
        ]);
        assert_eq!(flat.duplicates.len(), 1);
        assert_eq!(flat.vertices.len(), 3);
        assert_eq!(flat.plane.unwrap().face_count(), 4);
    }
}
