//! Polygons and polyhedra of any number of corners, such as the cells of a Voronoi diagram.

use crate::mesh::DataArray;

/// Convex or not, each cell has corners of its own: neighbours share places but no points, since places that are computed once for
/// each cell need not agree in their last bits.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Polytopes {
    points: Vec<[f64; 3]>,
    /// Of each cell, where its points end.
    ends: Vec<u64>,
    /// Of each face its number of corners and their points, before the first face of a cell the number of its faces. Empty for
    /// polygons.
    faces: Vec<u32>,
    /// Of each polyhedron, where its faces end.
    face_ends: Vec<u64>,
    /// Named numbers, one row per cell.
    pub data: Vec<DataArray>,
}

impl Polytopes {
    /// Number of cells.
    #[must_use]
    pub const fn len(&self) -> usize {
        self.ends.len()
    }

    /// Whether there are no cells.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.ends.is_empty()
    }

    /// The corners of all cells, one cell after the other.
    #[must_use]
    pub fn points(&self) -> &[[f64; 3]] {
        &self.points
    }

    /// Of each cell, where its corners end in the list of all corners.
    #[must_use]
    pub fn ends(&self) -> &[u64] {
        &self.ends
    }

    /// The faces as VTK lists them: of each polyhedron the number of its faces, of each face the number of its corners and their
    /// positions in the list of all corners. Empty for polygons.
    #[must_use]
    pub fn faces(&self) -> &[u32] {
        &self.faces
    }

    /// Of each polyhedron, where its part of [`Polytopes::faces`] ends.
    #[must_use]
    pub fn face_ends(&self) -> &[u64] {
        &self.face_ends
    }

    /// Appends a polygon, its corners in cyclic order.
    pub fn push_polygon(&mut self, corners: impl IntoIterator<Item = [f64; 3]>) {
        self.points.extend(corners);
        self.ends.push(self.points.len() as u64);
    }

    /// Appends a polyhedron: its corners, and of each face which of them are its own, in cyclic order.
    ///
    /// Cells beyond the 2^32nd corner cannot be numbered; writing refuses them.
    pub fn push_polyhedron<F: AsRef<[u32]>>(&mut self, corners: &[[f64; 3]], faces: &[F]) {
        let first = self.points.len() as u32;
        self.points.extend_from_slice(corners);
        self.ends.push(self.points.len() as u64);
        self.faces.push(faces.len() as u32);
        for face in faces.iter().map(AsRef::as_ref) {
            self.faces.push(face.len() as u32);
            let global = face.iter().map(|corner| corner.wrapping_add(first));
            self.faces.extend(global);
        }
        self.face_ends.push(self.faces.len() as u64);
    }

    /// Appends all cells of another list; rows of data are joined by position.
    pub fn append(&mut self, other: &Self) {
        let (points, faces) = (self.points.len() as u64, self.faces.len() as u64);
        self.points.extend_from_slice(&other.points);
        self.ends.extend(other.ends.iter().map(|end| end + points));
        self.face_ends
            .extend(other.face_ends.iter().map(|end| end + faces));
        self.append_faces(&other.faces, points as u32);
        for (own, others) in self.data.iter_mut().zip(&other.data) {
            own.values.extend_from_slice(&others.values);
        }
    }

    /// Appends faces whose corners are counted from `first`.
    fn append_faces(&mut self, mut rest: &[u32], first: u32) {
        while let Some((&count, faces)) = rest.split_first() {
            self.faces.push(count);
            rest = faces;
            for _ in 0..count {
                let Some((&corners, points)) = rest.split_first() else {
                    return;
                };
                let (own, after) = points.split_at((corners as usize).min(points.len()));
                self.faces.push(corners);
                self.faces
                    .extend(own.iter().map(|point| point.wrapping_add(first)));
                rest = after;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lists_are_joined_as_if_pushed_one_by_one() {
        let corners = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let faces = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]];
        let push = |cells: &mut Polytopes, times| {
            (0..times).for_each(|_| cells.push_polyhedron(&corners, &faces));
        };
        let (mut all, mut first, mut rest) = <(Polytopes, Polytopes, Polytopes)>::default();
        push(&mut all, 5);
        push(&mut first, 2);
        push(&mut rest, 3);
        first.append(&rest);
        assert_eq!(first, all);
        assert_eq!((all.len(), all.points().len()), (5, 20));
        assert_eq!(all.faces()[..5], [4, 3, 0, 2, 1]);
        assert_eq!(all.faces()[17..22], [4, 3, 4, 6, 5]);
        assert_eq!(all.face_ends()[1], 34);
    }

    #[test]
    fn polygons_have_no_faces() {
        let mut cells = Polytopes::default();
        cells.push_polygon([[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
        cells.push_polygon([[0.0; 3]; 4]);
        assert_eq!(cells.ends(), [3, 7]);
        assert!(cells.faces().is_empty() && cells.face_ends().is_empty());
    }
}
