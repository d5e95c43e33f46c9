//! Other numbers for vertices and triangles, so that what is near is near in memory.
//!
//! Vertices that came in no order of place, a million of them, make every step from one to the next wait for memory. Along the
//! curve of Hilbert most steps are short.

use super::complex::Complex2;
use super::mesh::TriMesh;
use crate::hilbert::{MAX_BITS_IN_PLANE, places_in_plane};
use crate::ids::{FaceId, VertexId};
use glam::DVec2;

impl Complex2 {
    /// The same triangles with other numbers for inner vertices and faces, and by vertex index which vertex it was before.
    ///
    /// Vertices on the boundary, and ids without a vertex, keep their numbers. Takes n log n time.
    #[must_use]
    pub fn renumbered(&self) -> (Self, Vec<VertexId>) {
        let order = along_curve(self);
        let ids = (0..self.points().len()).map(VertexId::new);
        let mut before: Vec<VertexId> = ids.clone().collect();
        let inner = order.iter().copied().filter(|&v| self.is_inner(v));
        for (new, old) in self.inner_vertices().zip(inner) {
            before[new.index()] = old;
        }
        let mut after = before.clone();
        for (new, &old) in ids.zip(&before) {
            after[old.index()] = new;
        }
        let coords = before.iter().map(|&old| self.point(old));
        let ghost = self.place_of(VertexId::GHOST);
        let coords: Vec<DVec2> = std::iter::once(ghost).chain(coords).collect();
        let mesh = renumbered(self.mesh(), &order, &after);
        let renumbered = Self::in_boundary(coords, mesh, self.vacant().to_vec());
        (renumbered, before)
    }
}

/// The vertices that have triangles along the curve of Hilbert.
fn along_curve(complex: &Complex2) -> Vec<VertexId> {
    let ids = (0..complex.points().len()).map(VertexId::new);
    let used: Vec<VertexId> = ids
        .filter(|&v| complex.mesh().outgoing(v).is_some())
        .collect();
    let places = used.iter().map(|&v| complex.point(v));
    let low = places.clone().fold(DVec2::INFINITY, DVec2::min);
    let high = places.fold(-DVec2::INFINITY, DVec2::max);
    let cells = f64::from((1_u32 << MAX_BITS_IN_PLANE) - 1);
    let scale = cells / (high - low).max_element();
    let key = |v: VertexId| {
        // Casts saturate, so what is not a number is in the first cell.
        let [x, y] = ((complex.point(v) - low) * scale).to_array();
        let [place] = places_in_plane([x as u32], [y as u32], MAX_BITS_IN_PLANE);
        (place, v)
    };
    let mut keys: Vec<(u32, VertexId)> = used.into_iter().map(key).collect();
    keys.sort_unstable();
    keys.into_iter().map(|(_, v)| v).collect()
}

/// A mesh whose faces come in the order of their first vertices in `order`, with new names for vertices by index.
fn renumbered(mesh: &TriMesh, order: &[VertexId], names: &[VertexId]) -> TriMesh {
    let name = |v: VertexId| if v.is_ghost() { v } else { names[v.index()] };
    let mut numbers: Vec<Option<FaceId>> = vec![None; mesh.face_count()];
    let mut faces = Vec::with_capacity(mesh.face_count());
    for f in order.iter().flat_map(|&v| mesh.star(v)) {
        if numbers[f.index()].is_none() {
            numbers[f.index()] = Some(FaceId::new(faces.len()));
            faces.push(f);
        }
    }
    let mut new = TriMesh::default();
    for &f in &faces {
        new.push_face(mesh.face_vertices(f).map(name));
    }
    for (here, &f) in (0..).map(FaceId::new).zip(&faces) {
        for (corner, h) in f.half_edges().into_iter().enumerate() {
            let twin = mesh.twin(h);
            if let Some(beyond) = numbers[twin.face().index()] {
                new.set_twin(here.half_edge(corner), beyond.half_edge(twin.corner()));
            }
        }
    }
    new.index_vertices(names.len() + 1);
    new
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Delaunay2, Subcomplex2};

    #[test]
    fn triangles_stay_and_the_boundary_keeps_its_numbers() {
        // A grid, its nodes in no order.
        let node = |k: usize| DVec2::new((k * 7 % 40) as f64, (k * 7 % 1600 / 40) as f64);
        let points: Vec<DVec2> = (0..1600).map(node).collect();
        let whole = Subcomplex2::of(&Delaunay2::build(&points).unwrap(), |_| true);
        let complex = Complex2::of(whole);
        let (new, before) = complex.renumbered();
        assert_eq!(new.check(), Ok(()));
        for v in (0..1600).map(VertexId::new) {
            assert_eq!(new.point(v), complex.point(before[v.index()]));
            assert_eq!(new.is_inner(v), complex.is_inner(v));
            assert!(new.is_inner(v) || before[v.index()] == v);
        }
        let triangles = |complex: &Complex2| {
            let triangle = |f| {
                let mut corners = complex.triangle(f).map(|p| [p.x as i32, p.y as i32]);
                corners.sort_unstable();
                corners
            };
            let mut triangles: Vec<_> = complex.faces().map(triangle).collect();
            triangles.sort_unstable();
            triangles
        };
        assert_eq!(triangles(&new), triangles(&complex));
        // Neighbours are closer than they were.
        let reach = |complex: &Complex2| {
            let mesh = complex.mesh();
            let apart = |h| mesh.origin(h).index().abs_diff(mesh.target(h).index());
            let inner = |&h: &crate::HalfEdgeId| {
                [mesh.origin(h), mesh.target(h)]
                    .iter()
                    .all(|&v| complex.is_inner(v))
            };
            mesh.half_edges().filter(inner).map(apart).sum::<usize>()
        };
        assert!(4 * reach(&new) < reach(&complex));
    }
}
