//! Triangles in a fixed boundary that need not be Delaunay: what local improvement works on.
//!
//! Every change is refused that would leave a triangle flat or turned over, by exact signs. The boundary never changes; edges
//! of the boundary are not flipped and its vertices do not move.

use super::cavity::{Cavity, RimEdge};
use super::check::Violation;
use super::delaunay::Delaunay2;
use super::mesh::TriMesh;
use super::remove::Refilled;
use super::subcomplex::Subcomplex2;
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::measure::triangle::radius_ratio;
use geo_predicates::{Sign, check_point2, in_circle_perturbed, orient2d};
use glam::DVec2;

/// Triangles within a boundary that does not change.
///
/// ```
/// use delaunay_core::{Complex2, Delaunay2, Subcomplex2, VertexId};
/// use glam::DVec2;
///
/// let corners = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [1.0, 2.0]].map(DVec2::from);
/// let square = Subcomplex2::of(&Delaunay2::build(&corners)?, |_| true);
/// let mut square = Complex2::of(square);
/// let inner = VertexId::new(4);
/// assert!(square.move_vertex(inner, DVec2::new(2.0, 2.0)));
/// assert!(!square.move_vertex(inner, DVec2::new(4.0, 2.0)));
/// assert!(square.remove(inner).is_some());
/// assert_eq!((square.faces().count(), square.check()), (2, Ok(())));
/// # Ok::<(), delaunay_core::BuildError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Complex2 {
    /// By vertex slot: the ghost in front, with coordinates that are not numbers.
    coords: Vec<DVec2>,
    mesh: TriMesh,
    /// By vertex slot: whether it is on the boundary, or no vertex.
    fixed: Vec<bool>,
    /// Ids of removed vertices, the last removed on top.
    vacant: Vec<VertexId>,
}

/// Read access.
impl Complex2 {
    /// The triangles of a subcomplex, which are Delaunay to begin with. Linear time.
    #[must_use]
    pub fn of(subcomplex: Subcomplex2) -> Self {
        let (coords, mesh, vacant) = subcomplex.into_parts();
        Self::in_boundary(coords, mesh, vacant)
    }

    /// Triangles with ghosts on their boundary.
    pub(super) fn in_boundary(coords: Vec<DVec2>, mesh: TriMesh, vacant: Vec<VertexId>) -> Self {
        let mut fixed = vec![true; coords.len()];
        for h in mesh.half_edges() {
            fixed[mesh.origin(h).slot()] = false;
        }
        for h in mesh.half_edges().filter(|&h| mesh.is_ghost_face(h.face())) {
            fixed[mesh.origin(h).slot()] = true;
        }
        Self {
            coords,
            mesh,
            fixed,
            vacant,
        }
    }

    /// The points by vertex index. The entry of a removed vertex keeps its last value until an insertion takes the id again.
    #[must_use]
    pub fn points(&self) -> &[DVec2] {
        &self.coords[1..]
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

    /// The vertices inside, which may move, by id.
    pub fn inner_vertices(&self) -> impl Iterator<Item = VertexId> + Clone + '_ {
        let slots = (1..self.coords.len()).filter(|&slot| !self.fixed[slot]);
        slots.map(VertexId::from_slot)
    }

    /// Whether `v` is a vertex inside, which may move.
    #[must_use]
    #[inline]
    pub fn is_inner(&self, v: VertexId) -> bool {
        self.fixed.get(v.slot()).is_some_and(|fixed| !fixed)
    }

    /// Whether one side of `h` is outside.
    ///
    /// # Panics
    /// When there is no half-edge `h`.
    #[must_use]
    #[inline]
    pub fn is_boundary(&self, h: HalfEdgeId) -> bool {
        self.mesh.is_ghost_face(h.face()) || self.mesh.is_ghost_face(self.mesh.twin(h).face())
    }

    /// Checks the mesh, but that the infinite vertex may have several rings, and that all triangles turn counterclockwise.
    ///
    /// # Errors
    /// The first [`Violation`].
    pub fn check(&self) -> Result<(), Violation> {
        self.mesh.check_inside()?;
        let mut faces = self.faces();
        match faces.find(|&f| !self.is_counterclockwise(self.triangle(f))) {
            Some(face) => Err(Violation::Orientation { face }),
            None => Ok(()),
        }
    }

    /// The place of any vertex, no numbers for the ghost.
    pub(super) fn place_of(&self, v: VertexId) -> DVec2 {
        self.coords[v.slot()]
    }

    /// Ids of removed vertices, the last removed last.
    pub(super) fn vacant(&self) -> &[VertexId] {
        &self.vacant
    }

    pub(super) fn mesh_mut(&mut self) -> &mut TriMesh {
        &mut self.mesh
    }

    /// Puts a vertex somewhere; whether its triangles stay what they are is not asked.
    pub(super) fn put(&mut self, v: VertexId, p: DVec2) {
        self.coords[v.slot()] = p;
    }

    fn is_counterclockwise(&self, [a, b, c]: [DVec2; 3]) -> bool {
        orient2d(a, b, c) == Sign::Positive
    }
}

/// Changes.
impl Complex2 {
    /// Moves `v` when it is inside and all its triangles stay counterclockwise; tells whether it did. Takes time proportional to its
    /// degree.
    pub fn move_vertex(&mut self, v: VertexId, p: DVec2) -> bool {
        self.is_inner(v) && self.move_boundary_vertex(v, p)
    }

    /// Moves `v` when all its triangles stay counterclockwise, also when it is on the boundary, which changes then; tells whether it
    /// did. Whether parts of the boundary meet outside is not asked. Takes time proportional to its degree.
    pub fn move_boundary_vertex(&mut self, v: VertexId, p: DVec2) -> bool {
        if self.mesh.outgoing(v).is_none() || check_point2(0, p).is_err() {
            return false;
        }
        let fits = |h: HalfEdgeId| {
            let ends = [self.mesh.origin(h), self.mesh.target(h)];
            let [a, b] = ends.map(|v| self.coords[v.slot()]);
            ends.contains(&VertexId::GHOST) || self.is_counterclockwise([p, a, b])
        };
        let moves = !v.is_ghost() && self.mesh.link(v).all(fits);
        if moves {
            self.coords[v.slot()] = p + DVec2::ZERO;
        }
        moves
    }

    /// Moves many vertices at once when all are inside and all triangles stay counterclockwise; tells whether it did, nothing
    /// has changed else. Places are by vertex, in the same order. Linear time.
    pub fn move_vertices(&mut self, vertices: &[VertexId], places: &[DVec2]) -> bool {
        let may_move =
            |(&v, &p): (&VertexId, &DVec2)| self.is_inner(v) && check_point2(0, p).is_ok();
        if vertices.len() != places.len() || !vertices.iter().zip(places).all(may_move) {
            return false;
        }
        let before: Vec<DVec2> = vertices.iter().map(|&v| self.point(v)).collect();
        self.put_all(vertices, places);
        let moved = self
            .faces()
            .all(|f| self.is_counterclockwise(self.triangle(f)));
        if !moved {
            self.put_all(vertices, &before);
        }
        moved
    }

    fn put_all(&mut self, vertices: &[VertexId], places: &[DVec2]) {
        for (v, &p) in vertices.iter().zip(places) {
            self.coords[v.slot()] = p + DVec2::ZERO;
        }
    }

    /// Turns the edge of `h` into the other diagonal of its quadrilateral when it is inside and the quadrilateral is strictly
    /// convex; gives the sides of the quadrilateral then, from inside. The two triangles keep their ids.
    ///
    /// # Panics
    /// When there is no half-edge `h`.
    pub fn flip(&mut self, h: HalfEdgeId) -> Option<[HalfEdgeId; 4]> {
        let t = self.mesh.twin(h);
        let corners = [
            self.mesh.origin(h),
            self.mesh.target(h),
            self.mesh.apex(h),
            self.mesh.apex(t),
        ];
        if corners.iter().any(|v| v.is_ghost()) {
            return None;
        }
        let [a, b, c, d] = corners.map(|v| self.point(v));
        let is_convex = self.is_counterclockwise([a, d, c]) && self.is_counterclockwise([d, b, c]);
        is_convex.then(|| self.mesh.flip(h))
    }

    /// Makes `p` a vertex when it is strictly inside the triangle `f`, which gives way to three. `None`, with nothing changed,
    /// when it is not or ids run out.
    ///
    /// # Panics
    /// When there is no face `f`.
    pub fn insert(&mut self, p: DVec2, f: FaceId) -> Option<VertexId> {
        let has_room = self.mesh.face_count() + 2 <= FaceId::LIMIT
            && self.coords.len() <= Delaunay2::MAX_POINTS;
        if !has_room || self.mesh.is_ghost_face(f) || check_point2(0, p).is_err() {
            return None;
        }
        let [a, b, c] = self.triangle(f);
        let is_inside = [[a, b, p], [b, c, p], [c, a, p]];
        if !is_inside
            .into_iter()
            .all(|corners| self.is_counterclockwise(corners))
        {
            return None;
        }
        let rim = f.half_edges().map(|h| RimEdge {
            origin: self.mesh.origin(h),
            outer: self.mesh.twin(h),
        });
        let mut cavity = Cavity::default();
        cavity.assign(&[f], &rim);
        let v = self.name_vertex(p + DVec2::ZERO);
        self.mesh.fill(&mut cavity, v);
        self.mesh.point_at_star(cavity.faces());
        Some(v)
    }

    /// An id for a new inner vertex at `p`.
    pub(super) fn name_vertex(&mut self, p: DVec2) -> VertexId {
        if let Some(v) = self.vacant.pop() {
            self.coords[v.slot()] = p;
            self.fixed[v.slot()] = false;
            return v;
        }
        self.coords.push(p);
        self.fixed.push(false);
        VertexId::from_slot(self.coords.len() - 1)
    }

    /// Removes a vertex inside: its edges are flipped away, those first that cut off the best triangles, until three are left.
    ///
    /// `None`, with nothing changed, when `v` is not inside. Faces move as in [`Refilled`]. Takes time proportional to the square of
    /// the degree of `v`.
    ///
    /// There is always an edge to flip. The link has three convex corners at least, and of four corners or more two of these are
    /// not neighbours. The angles at `v` between the two neighbours of each do not overlap, so one of them is half a turn at
    /// most, and less with five corners or more, which leave a part of the turn over.
    pub fn remove(&mut self, v: VertexId) -> Option<Refilled> {
        if !self.is_inner(v) {
            return None;
        }
        while self.mesh.around(v).nth(3).is_some() {
            let ear = self.best_ear(v);
            debug_assert!(ear.is_some(), "{v} sees all of its link from inside");
            let _ = self.mesh.flip(ear?);
        }
        Some(self.close_triangle(v))
    }

    /// Of the edges at `v` that can be flipped one whose flip cuts off the best triangle. With four left, the two that stay
    /// may be in line.
    fn best_ear(&self, v: VertexId) -> Option<HalfEdgeId> {
        let degree = self.mesh.around(v).count();
        let center = self.point(v);
        let quality = |h: HalfEdgeId| {
            let [before, tip, after] = [
                self.mesh.apex(self.mesh.twin(h)),
                self.mesh.target(h),
                self.mesh.apex(h),
            ]
            .map(|v| self.point(v));
            let rest = orient2d(before, after, center);
            let stays = rest == Sign::Positive || (degree == 4 && rest == Sign::Zero);
            let is_ear = stays && self.is_counterclockwise([before, tip, after]);
            is_ear.then(|| (radius_ratio([before, tip, after]), h))
        };
        let ears = self.mesh.around(v).filter_map(quality);
        ears.max_by(|(q, _), (r, _)| q.total_cmp(r)).map(|(_, h)| h)
    }

    /// Replaces the three triangles round `v` by one.
    fn close_triangle(&mut self, v: VertexId) -> Refilled {
        let link: Vec<HalfEdgeId> = self.mesh.link(v).collect();
        let corners = [link[0], link[1], link[2]].map(|h| self.mesh.origin(h));
        let outer = [link[0], link[1], link[2]].map(|h| self.mesh.twin(h));
        let slots = [link[0], link[1], link[2]].map(HalfEdgeId::face);
        self.mesh.faces[slots[0].index()].origin = corners;
        for (side, outer) in slots[0].half_edges().into_iter().zip(outer) {
            self.mesh.glue(side, outer);
            self.mesh.set_outgoing(side);
        }
        self.forget(v);
        let mut refilled = Refilled {
            made: vec![slots[0]],
            moved: Vec::new(),
        };
        let mut left_over = [slots[1], slots[2]];
        left_over.sort_unstable();
        for f in left_over.into_iter().rev() {
            refilled.note_move(FaceId::new(self.mesh.face_count() - 1), f);
            self.mesh.swap_remove_face(f);
        }
        refilled
    }

    pub(super) fn forget(&mut self, v: VertexId) {
        self.mesh.forget_vertex(v);
        self.fixed[v.slot()] = true;
        self.vacant.push(v);
    }

    /// Flips edges inside whose circles are not empty, ties broken, until there are none: all triangles are Delaunay then, as far as
    /// can be seen within the boundary. Takes linear time and that of the flips.
    pub fn restore_delaunay(&mut self) {
        let mut suspects: Vec<HalfEdgeId> = Vec::new();
        for h in self.mesh.half_edges() {
            if h < self.mesh.twin(h) && self.is_in_circle(h) {
                suspects.push(h);
            }
        }
        // Each flip lowers the surface that the triangles have over the paraboloid, so no edge comes back.
        while let Some(h) = suspects.pop() {
            if self.is_in_circle(h) {
                suspects.extend(self.mesh.flip(h));
            }
        }
    }

    fn is_in_circle(&self, h: HalfEdgeId) -> bool {
        let corners = [
            self.mesh.origin(h),
            self.mesh.target(h),
            self.mesh.apex(h),
            self.mesh.apex(self.mesh.twin(h)),
        ];
        let [a, b, c, d] = corners.map(|v| self.coords[v.slot()]);
        !corners.iter().any(|v| v.is_ghost()) && in_circle_perturbed(a, b, c, d)
    }
}
