//! What points of space that span no tetrahedron are instead, and what can be done with them.

use vide::delaunay_core::{BuildError, Flat, TriMesh};
use vide::glam::DVec3;

pub(super) fn flat_text(flat: Flat, points: &[DVec3]) -> String {
    let through = flat.plane.as_ref().and_then(through_first);
    let is_plane = flat.plane.is_some() && points.iter().all(|point| point.z == 0.0);
    let what = BuildError::Flat(Box::new(flat));
    let through = through.unwrap_or_default();
    let hint = if is_plane {
        "; --dim 2 triangulates the plane"
    } else {
        ""
    };
    format!("{what}{through}, and span no tetrahedron{hint}")
}

/// Three vertices that fix the plane: the corners of the first triangle on it.
fn through_first(plane: &TriMesh) -> Option<String> {
    let real = plane.faces().filter(|&face| !plane.is_ghost_face(face));
    let mut corners: Vec<_> = real.map(|face| plane.face_vertices(face)).collect();
    corners
        .iter_mut()
        .for_each(|corners| corners.sort_unstable());
    let [a, b, c] = corners.into_iter().min()?;
    Some(format!(", that through {a}, {b} and {c}"))
}
