//! Cavity and star where vertices may be swallowed.
//!
//! The cavity of a weighted point may hold vertices inside, round which all faces are in conflict. So its
//! faces do not hang together like a tree, as those of a Delaunay cavity do, and are marked instead.

use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::tri::mesh::{Face, TriMesh};
use rustc_hash::FxHashMap;

/// The faces in conflict with a point and the edges that bound them.
#[derive(Default)]
pub(super) struct WideCavity {
    faces: Vec<FaceId>,
    /// The half-edges round the cavity, each by its outer side.
    outer: Vec<HalfEdgeId>,
    tested: FxHashMap<FaceId, bool>,
    /// By the vertex where an edge of the boundary starts, the new face on it.
    starts: FxHashMap<VertexId, FaceId>,
}

impl WideCavity {
    /// Fills the cavity with all that `conflicts` says of faces connected with `seed`.
    pub(super) fn dig(&mut self, mesh: &TriMesh, seed: FaceId, conflicts: impl Fn(FaceId) -> bool) {
        self.faces.clear();
        self.outer.clear();
        self.tested.clear();
        self.faces.push(seed);
        self.tested.insert(seed, true);
        let mut next = 0;
        while let Some(&f) = self.faces.get(next) {
            next += 1;
            for outer in f.half_edges().map(|h| mesh.twin(h)) {
                let across = outer.face();
                let known = self.tested.get(&across).copied();
                let inside = known.unwrap_or_else(|| {
                    let inside = conflicts(across);
                    self.tested.insert(across, inside);
                    if inside {
                        self.faces.push(across);
                    }
                    inside
                });
                if !inside {
                    self.outer.push(outer);
                }
            }
        }
    }
}

impl TriMesh {
    /// Replaces the faces of the cavity by the star of `v`; vertices inside are forgotten.
    ///
    /// Face ids left over go to the last faces, as in [`swap_remove_face`](Self::swap_remove_face).
    pub(super) fn fill_wide(&mut self, cavity: &mut WideCavity, v: VertexId) {
        for f in &cavity.faces {
            for corner in self.face_vertices(*f) {
                self.forget_vertex(corner);
            }
        }
        cavity.starts.clear();
        for (place, &outer) in cavity.outer.iter().enumerate() {
            let corners = [v, self.target(outer), self.origin(outer)];
            let face = self.put_or_push(cavity.faces.get(place).copied(), corners);
            cavity.starts.insert(corners[1], face);
            self.glue(face.half_edge(1), outer);
        }
        for &outer in &cavity.outer {
            let face = self.twin(outer).face();
            if let Some(after) = cavity.starts.get(&self.origin(outer)) {
                self.glue(face.half_edge(2), after.half_edge(0));
            }
            self.set_outgoing(face.half_edge(0));
            self.set_outgoing(face.half_edge(1));
        }
        let mut left_over: Vec<FaceId> = cavity
            .faces
            .split_off(cavity.outer.len().min(cavity.faces.len()));
        left_over.sort_unstable();
        for f in left_over.into_iter().rev() {
            self.swap_remove_face(f);
        }
    }

    /// Stores a face in the slot `f`, or in a new one; it is not glued to anything yet.
    fn put_or_push(&mut self, f: Option<FaceId>, origin: [VertexId; 3]) -> FaceId {
        let Some(f) = f else {
            return self.push_face(origin);
        };
        let twin = f.half_edges();
        self.faces[f.index()] = Face { origin, twin };
        f
    }
}
