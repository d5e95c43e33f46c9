//! The vertices of the closed prestars chosen in a round of the parallel schedule (§4.5).

use delaunay_core::VertexId;

/// Vertices, each of which is in one closed prestar at most.
#[derive(Debug)]
pub(crate) struct Taken {
    /// By vertex.
    taken: Vec<bool>,
}

impl Taken {
    pub(crate) fn none(vertices: usize) -> Self {
        let taken = vec![false; vertices];
        Self { taken }
    }

    pub(crate) fn is_free(&self, vertices: impl IntoIterator<Item = VertexId>) -> bool {
        vertices.into_iter().all(|v| !self.taken[v.index()])
    }

    /// Takes the vertices of a closed prestar, unless one is taken already; tells whether it did.
    pub(crate) fn take(&mut self, vertices: impl Iterator<Item = VertexId> + Clone) -> bool {
        let free = self.is_free(vertices.clone());
        if free {
            vertices.for_each(|v| self.taken[v.index()] = true);
        }
        free
    }
}
