//! Part of a Delaunay triangulation, closed by a boundary that no insertion inside changes.
//!
//! ```text
//!      ghost │ triangles       Each boundary edge carries a ghost, as each hull edge of a whole triangulation
//!       ─────┼────·            does. Round a boundary vertex the ghosts are glued in the order of the edges
//!            │   / \           outside: across a notch of the region, not through it. A cavity stops at ghosts,
//!       ·────┼──·   ·          so what lies outside is neither asked nor changed.
//! ```
//!
//! The sink paper (§5.1) works on such a subcomplex: where no vertex is inside the diametral circle of a boundary edge,
//! what is outside is as if it were not there.
//!
//! The boundary may be several curves, round parts that lie apart and round holes, and curves may touch at vertices. A vertex
//! where they touch has one ring of faces all the same: triangles and, across the sectors outside, ghosts. The
//! infinite vertex has as many rings as there are curves, where one that touches itself counts as
//! outside sees it; [`TriMesh::around`] follows one of them, and so [`TriMesh::check`] is content with a single
//! curve only, [`Subcomplex2::check`] with any number.
//!
//! A subcomplex may also be cut along edges with triangles on both sides, for instance where two regions meet. Such an edge is two
//! boundary edges with the same ends, each of which has its ghost; round their ends the two ghosts are neighbours, as
//! nothing lies between them.

use super::cavity::Cavity;
use super::delaunay::Delaunay2;
use super::mesh::TriMesh;
use super::remove::{Hole, Refilled};
use super::sight::Sight;
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use geo_predicates::filter::Filter2;
use geo_predicates::{Sign, in_diametral_circle};
use glam::DVec2;

/// Triangles of a Delaunay triangulation within a boundary.
///
/// Vertices have the ids that they have in the triangulation. Triangles are Delaunay in the sense that what lies
/// across the boundary does not count; all have positive area, exactly. The boundary changes by [`dig_on`](Self::dig_on)
/// alone.
///
/// ```
/// use delaunay_core::{Cavity, Delaunay2, Subcomplex2};
/// use glam::DVec2;
///
/// let square = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y];
/// let mut region = Subcomplex2::of(&Delaunay2::build(&square)?, |_| true);
/// let mut cavity = Cavity::default();
/// let center = DVec2::splat(0.5);
/// let seed = region.faces().next().unwrap();
/// assert!(region.dig(center, seed, &mut cavity));
/// region.fill(center, &mut cavity).unwrap();
/// assert_eq!((region.faces().count(), region.boundary().count()), (4, 4));
/// # Ok::<(), delaunay_core::BuildError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Subcomplex2 {
    /// By vertex slot: the ghost in front, with coordinates that are not numbers.
    coords: Vec<DVec2>,
    mesh: TriMesh,
    filter: Filter2,
    /// Ids of removed vertices, the last removed on top.
    vacant: Vec<VertexId>,
    vertex_count: usize,
}

/// What would fill the hole that a vertex leaves.
#[derive(Clone, Debug)]
pub struct Patch2 {
    vertex: VertexId,
    hole: Hole,
    /// The triangulation of the vertices round the hole.
    link: TriMesh,
    /// Its faces in the hole.
    inside: Vec<FaceId>,
    made: Vec<[VertexId; 3]>,
}

impl Patch2 {
    /// The triangles that would go: the star of the vertex.
    #[must_use]
    pub fn star(&self) -> &[FaceId] {
        &self.hole.star
    }

    /// The corners of the triangles that would come, counterclockwise.
    #[must_use]
    pub fn made(&self) -> &[[VertexId; 3]] {
        &self.made
    }
}

impl Subcomplex2 {
    /// The real triangles of a triangulation that `keep` keeps. Takes linear time, and at a boundary vertex time proportional to
    /// its degree for each part of its star.
    ///
    /// `keep` is asked about real triangles only.
    #[must_use]
    pub fn of(delaunay: &Delaunay2, keep: impl FnMut(FaceId) -> bool) -> Self {
        Self::cut_out(
            &delaunay.coords,
            delaunay.mesh(),
            delaunay.filter,
            keep,
            |_| false,
        )
    }

    /// As [`of`](Self::of), and cut apart along the edges between faces kept that `is_cut` names from both sides.
    pub(super) fn cut_out(
        coords: &[DVec2],
        old: &TriMesh,
        filter: Filter2,
        mut keep: impl FnMut(FaceId) -> bool,
        is_cut: impl Fn(HalfEdgeId) -> bool,
    ) -> Self {
        let mut renamed = vec![None; old.face_count()];
        let mut mesh = TriMesh::default();
        let real = old.faces().filter(|&f| !old.is_ghost_face(f));
        for f in real.filter(|&f| keep(f)) {
            renamed[f.index()] = Some(mesh.push_face(old.face_vertices(f)));
        }
        // The half-edge of the new mesh in the place of one of the old, when its face is inside.
        let inside = |h: HalfEdgeId| Some(renamed[h.face().index()]?.half_edge(h.corner()));
        // The ghost on each boundary half-edge, by the half-edge's old id.
        let mut ghosts = vec![None; 4 * old.face_count()];
        let mut boundary = Vec::new();
        for h in old.half_edges() {
            let Some(here) = inside(h) else { continue };
            if let Some(twin) = inside(old.twin(h)).filter(|_| !is_cut(h)) {
                mesh.set_twin(here, twin);
            } else {
                let ghost = mesh.push_face([old.target(h), old.origin(h), VertexId::GHOST]);
                mesh.glue(here, ghost.half_edge(0));
                ghosts[h.index()] = Some(ghost);
                boundary.push((h, ghost));
            }
        }
        for (h, ghost) in boundary {
            let before = across_outside(old, h, |g| inside(g).is_some());
            if let Some(other) = ghosts[before.index()] {
                mesh.glue(ghost.half_edge(1), other.half_edge(2));
            }
        }
        mesh.index_vertices(coords.len());
        let vertices = mesh.outgoing.iter().skip(1);
        let vertex_count = vertices.filter(|&&h| h != HalfEdgeId::NONE).count();
        Self {
            coords: coords.to_vec(),
            mesh,
            filter,
            vacant: Vec::new(),
            vertex_count,
        }
    }

    /// The points by vertex index: those of the triangulation, then those inserted. The entry of a removed vertex
    /// keeps its last value until an insertion takes the id again.
    #[must_use]
    pub fn points(&self) -> &[DVec2] {
        &self.coords[1..]
    }

    /// The number of vertices with a triangle.
    #[must_use]
    pub fn vertex_count(&self) -> usize {
        self.vertex_count
    }

    /// The place of a real vertex.
    ///
    /// # Panics
    /// When `v` is beyond all vertices.
    #[must_use]
    #[inline]
    pub fn point(&self, v: VertexId) -> DVec2 {
        self.coords[v.slot()]
    }

    /// The corners of a real triangle, counterclockwise.
    ///
    /// # Panics
    /// When `f` is beyond all faces.
    #[must_use]
    #[inline]
    pub fn triangle(&self, f: FaceId) -> [DVec2; 3] {
        self.mesh.face_vertices(f).map(|v| self.coords[v.slot()])
    }

    /// The ends of a half-edge between real vertices.
    ///
    /// # Panics
    /// When there is no half-edge `h`.
    #[must_use]
    #[inline]
    pub fn segment(&self, h: HalfEdgeId) -> [DVec2; 2] {
        [self.mesh.origin(h), self.mesh.target(h)].map(|v| self.coords[v.slot()])
    }

    /// Triangles and how they are glued, ghosts included.
    #[must_use]
    pub fn mesh(&self) -> &TriMesh {
        &self.mesh
    }

    /// The real triangles, by id.
    #[must_use]
    pub fn faces(&self) -> impl DoubleEndedIterator<Item = FaceId> + Clone + '_ {
        self.mesh.faces().filter(|&f| !self.mesh.is_ghost_face(f))
    }

    /// The half-edges that bound the subcomplex, from inside, by id.
    pub fn boundary(&self) -> impl Iterator<Item = HalfEdgeId> + Clone + '_ {
        let half_edges = self.faces().flat_map(FaceId::half_edges);
        half_edges.filter(|&h| self.is_boundary(h))
    }

    /// Whether one side of `h` is outside.
    #[must_use]
    #[inline]
    pub fn is_boundary(&self, h: HalfEdgeId) -> bool {
        self.mesh.is_ghost_face(self.mesh.twin(h).face())
    }

    /// Whether the circumcenter of a triangle lies strictly beyond its half-edge `h`. Exact.
    ///
    /// So the flow of the sink paper (§3.3) leaves the triangle there.
    #[must_use]
    #[inline]
    pub fn flows_through(&self, h: HalfEdgeId) -> bool {
        let [a, b] = self.segment(h);
        in_diametral_circle(a, b, self.point(self.mesh.apex(h))) == Sign::Positive
    }

    /// Whether `p` is strictly inside the circumcircle of a real triangle, ties broken. Exact.
    #[must_use]
    #[inline]
    pub fn in_conflict(&self, p: DVec2, f: FaceId) -> bool {
        self.sight(p).exact_conflict(self.mesh.face_vertices(f))
    }

    /// Fills `cavity` with the triangles in conflict with `p` that are connected with `seed`, across no boundary.
    /// `p` must be an accepted point.
    ///
    /// Answers whether `p` can be inserted there: it is in conflict with `seed` and sees every edge round the cavity
    /// strictly from inside, so that the star has positive areas. It can not when it is a vertex, on the boundary or
    /// beyond it; the cavity is of no use then. Exact. Takes time proportional to the size of the cavity.
    #[must_use]
    pub fn dig(&self, p: DVec2, seed: FaceId, cavity: &mut Cavity) -> bool {
        self.dig_within(p, seed, cavity, |_| true) == Some(true)
    }

    /// As [`dig`](Self::dig), but gives up with `None` at the first triangle of the cavity that is not `open`.
    #[must_use]
    pub fn dig_within(
        &self,
        p: DVec2,
        seed: FaceId,
        cavity: &mut Cavity,
        open: impl Fn([VertexId; 3]) -> bool,
    ) -> Option<bool> {
        if self.mesh.is_ghost_face(seed) || !self.in_conflict(p, seed) {
            return Some(false);
        }
        let sight = self.sight(p);
        let Some(home) = self.walk(&sight, seed) else {
            return Some(false);
        };
        let mut all_open = open(self.mesh.face_vertices(home));
        cavity.dig(&self.mesh, &sight, home, |corners, backwards| {
            let conflicts =
                all_open && !corners[2].vertex.is_ghost() && sight.in_conflict(corners, backwards);
            all_open &= !conflicts || open(corners.map(|seen| seen.vertex));
            conflicts
        });
        all_open.then_some(true)
    }

    /// The triangle that contains the point, reached from `seed`, which is in conflict with it; `None` where the walk comes
    /// to a boundary edge with the point on it or beyond, or to a vertex at the point.
    ///
    /// Along the walk the power of the point falls, see [`super::locate`], so all triangles passed are in conflict. And from
    /// the triangle that contains it a cavity stays star-shaped as it grows: the part of a circle beyond an edge
    /// lies between the other two lines of the triangle. So the point sees all edges round it from inside.
    fn walk(&self, sight: &Sight<'_>, seed: FaceId) -> Option<FaceId> {
        let mut here = seed;
        for _ in 0..self.mesh.face_count() {
            let [a, b, c] = self.mesh.face_vertices(here).map(|v| sight.see(v));
            let sides = [sight.side(&a, &b), sight.side(&b, &c), sight.side(&c, &a)];
            let not_inside = || {
                let sides = here.half_edges().into_iter().zip(sides);
                sides.filter(|(_, side)| *side != Sign::Positive)
            };
            if not_inside().any(|(h, _)| self.is_boundary(h)) {
                return None;
            }
            match not_inside().find(|(_, side)| *side == Sign::Negative) {
                Some((h, _)) => here = self.mesh.twin(h).face(),
                None => return (not_inside().count() < 2).then_some(here),
            }
        }
        None
    }

    /// Makes `p` a vertex in the cavity that [`dig`](Self::dig) has found for it, and the cavity the star of the new
    /// vertex: [`Cavity::faces`] are its triangles then, with the vertex as corner 0.
    ///
    /// `None`, with nothing changed, when ids run out.
    pub fn fill(&mut self, p: DVec2, cavity: &mut Cavity) -> Option<VertexId> {
        let v = match self.vacant.last() {
            Some(&v) => v,
            None if self.coords.len() <= Delaunay2::MAX_POINTS => {
                VertexId::from_slot(self.coords.len())
            }
            None => return None,
        };
        if !self.fill_with(v, cavity) {
            return None;
        }
        let p = p + DVec2::ZERO;
        match self.vacant.pop() {
            Some(_) => self.coords[v.slot()] = p,
            None => self.coords.push(p),
        }
        self.vertex_count += 1;
        Some(v)
    }

    /// Replaces a cavity by the star of `v`; `false`, with nothing changed, when ids run out.
    pub(super) fn fill_with(&mut self, v: VertexId, cavity: &mut Cavity) -> bool {
        if self.mesh.face_count() + 2 > FaceId::LIMIT {
            return false;
        }
        self.mesh.fill(cavity, v);
        self.mesh.point_at_star(cavity.faces());
        true
    }

    pub(super) fn glue(&mut self, g: HalfEdgeId, h: HalfEdgeId) {
        self.mesh.glue(g, h);
    }

    /// What would fill the hole if `v` were removed: the triangles of its neighbours. Nothing changes. Takes d log d time
    /// for a vertex of degree d.
    ///
    /// `None` when `v` is on the boundary or no vertex, or when the triangles do not fill the hole.
    #[must_use]
    pub fn patch(&self, v: VertexId) -> Option<Patch2> {
        if v.is_ghost() || self.mesh.is_on_hull(v) {
            return None;
        }
        self.mesh.outgoing(v)?;
        let hole = Hole::of(&self.mesh, v);
        let points: Vec<DVec2> = hole.real().iter().map(|&u| self.point(u)).collect();
        let link = Delaunay2::build(&points).ok()?.mesh;
        let inside = hole.faces_inside(&link);
        let fills = inside.len() + 2 == hole.star.len();
        if !fills || inside.iter().any(|&f| link.is_ghost_face(f)) {
            return None;
        }
        let made = inside.iter().map(|&f| link.face_vertices(f));
        Some(Patch2 {
            vertex: v,
            made: made.map(|corners| corners.map(|u| hole.name(u))).collect(),
            hole,
            link,
            inside,
        })
    }

    /// Removes the vertex of a patch just found. The new triangles take ids of the star, and the last two faces may move
    /// into the two ids left over.
    pub fn remove(&mut self, patch: &Patch2) -> Refilled {
        let refilled = patch.hole.close(&patch.link, &patch.inside, &mut self.mesh);
        self.mesh.forget_vertex(patch.vertex);
        self.vacant.push(patch.vertex);
        self.vertex_count -= 1;
        refilled
    }

    /// Coordinates by vertex slot, mesh and ids of removed vertices.
    pub(super) fn into_parts(self) -> (Vec<DVec2>, TriMesh, Vec<VertexId>) {
        (self.coords, self.mesh, self.vacant)
    }

    pub(super) fn sight(&self, p: DVec2) -> Sight<'_> {
        Sight::new(&self.coords, self.filter, p)
    }
}

/// The boundary half-edge into the origin of the boundary half-edge `h` that is met first on the way clockwise
/// round that vertex, through what is outside.
pub(super) fn across_outside(
    mesh: &TriMesh,
    h: HalfEdgeId,
    is_inside: impl Fn(HalfEdgeId) -> bool,
) -> HalfEdgeId {
    let mut here = mesh.twin(h);
    while !is_inside(here) {
        here = mesh.twin(here.next());
    }
    here
}
