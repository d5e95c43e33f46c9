//! Where the flow ends: sinks and the triangles that run into them (§3.2, §3.3).
//!
//! In the plane every triangle has one end, so the sets of ancestors are disjoint: the watersheds of the
//! sinks, and one of what lies outside. Together they are all triangles.

use delaunay_core::FaceId;
use delaunay_core::measure::triangle::circumcenter;
use glam::DVec2;

use super::flow::{Successor, Triangles, successor};

/// Where the flow from a triangle ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum End {
    /// In this triangle, which contains its circumcenter: a sink.
    Sink(FaceId),
    /// Outside: beyond the convex hull, or across the boundary of a subcomplex.
    Outside,
}

/// The ends of all flows of a triangulation or subcomplex, and the ancestors of every end.
///
/// Valid as long as the triangles do not change.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sinks {
    /// By face index, `None` for ghosts.
    ends: Vec<Option<End>>,
    /// All triangles, by end and then by id.
    watersheds: Vec<FaceId>,
}

impl Sinks {
    /// The ends of all `triangles`. Every triangle is passed once: O(n), then sorted by end.
    #[must_use]
    pub fn of(triangles: &impl Triangles) -> Self {
        let mesh = triangles.mesh();
        let real = || mesh.faces().filter(|&f| !mesh.is_ghost_face(f));
        let mut ends = vec![None; mesh.face_count()];
        let mut path = Vec::new();
        for f in real() {
            let end = follow(triangles, &ends, f, &mut path);
            path.drain(..)
                .for_each(|passed: FaceId| ends[passed.index()] = Some(end));
        }
        let mut watersheds: Vec<FaceId> = real().collect();
        watersheds.sort_by_key(|f| ends[f.index()]);
        Self { ends, watersheds }
    }

    /// Where the flow from the triangle `f` ends; `None` for a ghost or no face of the triangulation. O(1).
    #[must_use]
    pub fn end(&self, f: FaceId) -> Option<End> {
        self.ends.get(f.index()).copied().flatten()
    }

    /// The sink triangles, by id. They contain their circumcenters, some on an edge.
    ///
    /// Two that share such an edge have the same center.
    pub fn triangles(&self) -> impl Iterator<Item = FaceId> + '_ {
        self.watersheds().filter_map(|(end, _)| match end {
            End::Sink(f) => Some(f),
            End::Outside => None,
        })
    }

    /// The triangles whose flow ends in `end`, by id; a sink triangle is its own ancestor. O(log n).
    ///
    /// Empty when `end` is no sink triangle, or when no flow leaves.
    #[must_use]
    pub fn ancestors(&self, end: End) -> &[FaceId] {
        let ends_before = |limit: Option<End>| move |f: &FaceId| self.end(*f) < limit;
        let first = self.watersheds.partition_point(ends_before(Some(end)));
        let rest = &self.watersheds[first..];
        &rest[..rest.partition_point(|&f| self.end(f) == Some(end))]
    }

    /// Every end with its ancestors: the sinks by id, then what flows outside. Together all triangles, once.
    pub fn watersheds(&self) -> impl Iterator<Item = (End, &[FaceId])> + '_ {
        let same_end = |f: &FaceId, g: &FaceId| self.end(*f) == self.end(*g);
        let groups = self.watersheds.chunk_by(same_end);
        groups.filter_map(|group| Some((self.end(*group.first()?)?, group)))
    }
}

/// The sink of a sink triangle `f`: its circumcenter, rounded.
///
/// As it lies in the triangle, rounding moves it by a few units in the last place of the corners' coordinates
/// only. For other triangles the circumcenter may be far off and less accurate.
///
/// # Panics
/// When there is no face `f` or it is a ghost.
#[must_use]
pub fn sink(triangles: &impl Triangles, f: FaceId) -> DVec2 {
    let corners = triangles.mesh().face_vertices(f);
    circumcenter(corners.map(|v| triangles.point(v)))
}

/// The end of the flow from `f`; leaves in `path` the triangles passed whose end was not known yet.
fn follow(
    triangles: &impl Triangles,
    ends: &[Option<End>],
    mut f: FaceId,
    path: &mut Vec<FaceId>,
) -> End {
    loop {
        if let Some(end) = ends[f.index()] {
            return end;
        }
        path.push(f);
        match successor(triangles, f) {
            Successor::None => return End::Sink(f),
            Successor::Outside => return End::Outside,
            Successor::Triangle(next) => f = next,
        }
    }
}
