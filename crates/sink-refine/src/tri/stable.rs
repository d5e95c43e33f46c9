//! The maximal stable subcomplex (§5.1).

use super::flow::flows_through;
use delaunay_core::{Delaunay2, FaceId, HalfEdgeId};

/// Which triangles of those that `within` names are in their maximal stable subcomplex, by face.
///
/// A boundary edge is unstable when the circumcenter of the triangle inside lies strictly beyond it. That triangle
/// goes, its other edges become boundary, and so on; the order does not matter. No flow leaves what stays, so it ends in
/// sinks inside. Exact, linear time.
///
/// Departs from §5.1, where every circumcenter has to be inside the subcomplex: a center far off may leave through an
/// edge that is not of its own triangle. The boundary test guards against that where points are inserted.
pub fn stable_faces(delaunay: &Delaunay2, mut within: impl FnMut(FaceId) -> bool) -> Vec<bool> {
    let mesh = delaunay.mesh();
    let mut stays = vec![false; mesh.face_count()];
    for f in delaunay.faces() {
        stays[f.index()] = within(f);
    }
    let inside: Vec<FaceId> = delaunay.faces().filter(|f| stays[f.index()]).collect();
    let half_edges = inside.into_iter().flat_map(FaceId::half_edges);
    let mut boundary: Vec<HalfEdgeId> = half_edges
        .filter(|&h| !stays[mesh.twin(h).face().index()])
        .collect();
    while let Some(h) = boundary.pop() {
        if stays[h.face().index()] && flows_through(delaunay, h) {
            stays[h.face().index()] = false;
            let beyond = h.face().half_edges().map(|g| mesh.twin(g));
            boundary.extend(beyond.into_iter().filter(|g| stays[g.face().index()]));
        }
    }
    stays
}
