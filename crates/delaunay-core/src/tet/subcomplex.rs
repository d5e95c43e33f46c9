//! Part of a Delaunay triangulation, closed by a boundary that no insertion inside changes.
//!
//! ```text
//!      ghost │ tetrahedra      Each boundary facet carries a ghost, as each hull facet of a whole triangulation
//!       ─────┼────·            does. Round a boundary edge the ghosts are glued in the order of the facets
//!            │   / \           outside: across a notch of the domain, not through it. A cavity stops at ghosts,
//!       ·────┼──·   ·          so what lies outside is neither asked nor changed.
//! ```
//!
//! The sink paper (§5.1) works on such a subcomplex: where no vertex is inside the diametral sphere of a boundary facet,
//! what is outside is as if it were not there.

use super::cavity::Cavity3;
use super::delaunay::Delaunay3;
use super::mesh::TetMesh;
use super::sight::Sight3;
use crate::ids::{FacetId, TetId, VertexId};
use geo_predicates::filter::Filter3;
use geo_predicates::{Sign, in_diametral_ball};
use glam::DVec3;
use rustc_hash::FxHashMap;

/// Tetrahedra of a Delaunay triangulation within a boundary.
///
/// Vertices have the ids that they have in the triangulation. All tetrahedra have positive volume, exactly. The
/// boundary changes by [`dig_on`](Self::dig_on) alone. They stay Delaunay as long as no point is inserted inside the diametral sphere of a boundary
/// facet that it sees; near such a facet, and near points put on the boundary, a cavity that ends there may leave tetrahedra
/// whose spheres contain a neighbour's vertex.
///
/// ```
/// use delaunay_core::{Cavity3, Delaunay3, Subcomplex3};
/// use glam::DVec3;
///
/// let cube: Vec<DVec3> = (0..8).map(|i| DVec3::new((i & 1) as f64, (i >> 1 & 1) as f64, (i >> 2) as f64)).collect();
/// let mut solid = Subcomplex3::of(&Delaunay3::build(&cube)?, |_| true);
/// let mut cavity = Cavity3::default();
/// let center = DVec3::splat(0.5);
/// let seed = solid.tets().next().unwrap();
/// assert!(solid.dig(center, seed, &mut cavity));
/// solid.fill(center, &mut cavity).unwrap();
/// assert_eq!((solid.tets().count(), solid.boundary().count()), (12, 12));
/// # Ok::<(), delaunay_core::BuildError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Subcomplex3 {
    /// By vertex slot: the ghost in front, with coordinates that are not numbers.
    pub(super) coords: Vec<DVec3>,
    pub(super) mesh: TetMesh,
    pub(super) filter: Filter3,
    /// Ids of removed vertices, the last removed on top.
    pub(super) vacant: Vec<VertexId>,
    pub(super) vertex_count: usize,
}

impl Subcomplex3 {
    /// The real tetrahedra of a triangulation that `keep` keeps. Takes linear time.
    ///
    /// `keep` is asked about real tetrahedra only.
    #[must_use]
    pub fn of(delaunay: &Delaunay3, mut keep: impl FnMut(TetId) -> bool) -> Self {
        let old = delaunay.mesh();
        let mut renamed = vec![TetId::NONE; old.tet_slots()];
        let mut mesh = TetMesh::default();
        for t in delaunay.tets().filter(|&t| keep(t)) {
            renamed[t.index()] = mesh.push_tet(old.tet_vertices(t));
        }
        let kept = mesh.tet_slots();
        let inside = |t: TetId| renamed[t.index()] != TetId::NONE;
        // The ghost on each boundary facet, by the facet's old id.
        let mut ghosts = Vec::new();
        for t in delaunay.tets().filter(|&t| inside(t)) {
            for f in t.facets() {
                let (twin, facet) = (old.twin(f), renamed[t.index()].facet(f.corner()));
                if inside(twin.tet()) {
                    mesh.set_twin(facet, renamed[twin.tet().index()].facet(twin.corner()));
                } else {
                    let [a, b, c] = old.facet_vertices(f);
                    let ghost = mesh.push_tet([a, b, c, VertexId::GHOST]);
                    mesh.glue(facet, ghost.facet(3));
                    ghosts.push((f, ghost));
                }
            }
        }
        let ghost_on: FxHashMap<FacetId, TetId> = ghosts.iter().copied().collect();
        for (f, ghost) in ghosts {
            let [a, b, c] = old.facet_vertices(f);
            for (corner, edge) in [[b, c], [c, a], [a, b]].into_iter().enumerate() {
                let across = across_outside(old, f, edge, inside);
                let other = ghost_on[&across];
                let apex = old.facet_vertices(across).map(|v| edge.contains(&v));
                let opposite = apex.iter().position(|&on_edge| !on_edge).unwrap_or(0);
                mesh.set_twin(ghost.facet(corner), other.facet(opposite));
            }
        }
        mesh.index_vertices(delaunay.coords.len());
        let vertices = mesh.homes.iter().skip(1);
        let vertex_count = vertices.filter(|&&home| home != TetId::NONE).count();
        debug_assert!(mesh.tets().take(kept).all(|t| !mesh.is_ghost_tet(t)));
        Self {
            coords: delaunay.coords.clone(),
            mesh,
            filter: delaunay.filter,
            vacant: Vec::new(),
            vertex_count,
        }
    }

    /// The points by vertex index: those of the triangulation, then those inserted. The entry of a removed vertex
    /// keeps its last value until an insertion takes the id again.
    #[must_use]
    pub fn points(&self) -> &[DVec3] {
        &self.coords[1..]
    }

    /// The number of vertices with a tetrahedron.
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
    pub fn point(&self, v: VertexId) -> DVec3 {
        self.coords[v.slot()]
    }

    /// The corners of a real tetrahedron, right-handed.
    ///
    /// # Panics
    /// When `t` is beyond all tetrahedra.
    #[must_use]
    #[inline]
    pub fn tetrahedron(&self, t: TetId) -> [DVec3; 4] {
        self.mesh.tet_vertices(t).map(|v| self.coords[v.slot()])
    }

    /// The corners of a facet, counterclockwise seen from outside its tetrahedron.
    #[must_use]
    #[inline]
    pub fn triangle(&self, f: FacetId) -> [DVec3; 3] {
        self.mesh.facet_vertices(f).map(|v| self.coords[v.slot()])
    }

    /// Tetrahedra and how they are glued, ghosts included.
    #[must_use]
    pub fn mesh(&self) -> &TetMesh {
        &self.mesh
    }

    /// The real tetrahedra, by id.
    #[must_use]
    pub fn tets(&self) -> impl DoubleEndedIterator<Item = TetId> + Clone + '_ {
        self.mesh.tets().filter(|&t| !self.mesh.is_ghost_tet(t))
    }

    /// The facets that bound the subcomplex, from inside, by id.
    pub fn boundary(&self) -> impl Iterator<Item = FacetId> + Clone + '_ {
        let facets = self.tets().flat_map(TetId::facets);
        facets.filter(|&f| self.is_boundary(f))
    }

    /// Whether one side of `f` is outside.
    #[must_use]
    #[inline]
    pub fn is_boundary(&self, f: FacetId) -> bool {
        self.mesh.is_ghost_tet(self.mesh.twin(f).tet())
    }

    /// The boundary facet of a ghost, from inside.
    ///
    /// # Panics
    /// When there is no tetrahedron `ghost`.
    #[must_use]
    #[inline]
    pub fn facet_under(&self, ghost: TetId) -> FacetId {
        self.mesh.twin(ghost.facet(3))
    }

    /// The edges of the boundary facet `f`, each with the boundary facet that follows round it through what is outside.
    ///
    /// # Panics
    /// When there is no facet `f`.
    pub fn across_edges(&self, f: FacetId) -> impl Iterator<Item = ([VertexId; 2], FacetId)> {
        let mesh = &self.mesh;
        let sides = mesh.twin(f).tet().facets().into_iter().take(3);
        sides.map(|side| {
            let corners = mesh.facet_vertices(side).into_iter();
            let mut ends = corners.filter(|v| !v.is_ghost());
            let edge = [(); 2].map(|()| ends.next().unwrap_or(VertexId::GHOST));
            (edge, self.facet_under(mesh.twin(side).tet()))
        })
    }

    /// Whether the circumcenter of a tetrahedron lies strictly beyond its facet `f`. Exact.
    ///
    /// So the flow of the sink paper (§3.3) leaves the tetrahedron there.
    #[must_use]
    #[inline]
    pub fn flows_through(&self, f: FacetId) -> bool {
        let [a, b, c] = self.triangle(f);
        in_diametral_ball(a, b, c, self.point(self.mesh.apex(f))) == Sign::Positive
    }

    /// Whether `p` is strictly inside the circumsphere of a real tetrahedron, ties broken. Exact.
    #[must_use]
    #[inline]
    pub fn in_conflict(&self, p: DVec3, t: TetId) -> bool {
        let sight = Sight3::new(self.coords.as_slice(), self.filter, p);
        sight.in_real_conflict(self.mesh.tet_vertices(t))
    }

    /// Fills `cavity` with the tetrahedra in conflict with `p` that are connected with `seed`, across no boundary.
    /// `p` must be an accepted point.
    ///
    /// Answers whether `p` can be inserted there: it is in conflict with `seed` and sees every facet round the cavity
    /// strictly from inside, so that the star has positive volumes. It can not when it is a vertex, on the boundary or
    /// beyond it. Exact. Takes time proportional to the size of the cavity.
    #[must_use]
    pub fn dig(&self, p: DVec3, seed: TetId, cavity: &mut Cavity3) -> bool {
        self.dig_within(p, seed, cavity, |_| true) == Some(true)
    }

    /// As [`dig`](Self::dig), but gives up with `None` at the first tetrahedron of the cavity that is not `open`.
    #[must_use]
    pub fn dig_within(
        &self,
        p: DVec3,
        seed: TetId,
        cavity: &mut Cavity3,
        open: impl Fn([VertexId; 4]) -> bool,
    ) -> Option<bool> {
        let sight = Sight3::new(self.coords.as_slice(), self.filter, p);
        let mesh = &self.mesh;
        let mut all_open = true;
        let mut conflicts = |t| {
            let corners = mesh.tet_vertices(t);
            let conflicts = all_open && !corners[3].is_ghost() && sight.in_real_conflict(corners);
            all_open &= !conflicts || open(corners);
            conflicts
        };
        if !conflicts(seed) {
            return Some(false);
        }
        cavity.dig(mesh, &self.coords, seed, conflicts);
        if !all_open {
            return None;
        }
        let mut outer = cavity.boundary().iter();
        Some(outer.all(|&f| sight.side(mesh.facet_vertices(f)) == Sign::Positive))
    }

    /// Makes `p` a vertex in the cavity that [`dig`](Self::dig) has found for it, and the cavity the star of the new
    /// vertex: [`Cavity3::tets`] are its tetrahedra then, with the vertex as corner 0.
    ///
    /// `None`, with nothing changed, when ids run out.
    pub fn fill(&mut self, p: DVec3, cavity: &mut Cavity3) -> Option<VertexId> {
        let v = match self.vacant.last() {
            Some(&v) => v,
            None if self.coords.len() <= Delaunay3::MAX_POINTS => {
                VertexId::from_slot(self.coords.len())
            }
            None => return None,
        };
        if !self.mesh.fill(cavity, v) {
            return None;
        }
        let p = p + DVec3::ZERO;
        match self.vacant.pop() {
            Some(_) => self.coords[v.slot()] = p,
            None => self.coords.push(p),
        }
        self.vertex_count += 1;
        Some(v)
    }

    /// Takes note that a vertex is gone.
    pub(super) fn forget(&mut self, v: VertexId) {
        self.mesh.forget_vertex(v);
        self.vacant.push(v);
        self.vertex_count -= 1;
    }
}

/// The boundary facet that follows the boundary facet `f` on the way round `edge` through what is outside.
fn across_outside(
    mesh: &TetMesh,
    f: FacetId,
    edge: [VertexId; 2],
    inside: impl Fn(TetId) -> bool,
) -> FacetId {
    let mut here = f;
    loop {
        let entered = mesh.twin(here);
        if inside(entered.tet()) {
            return entered;
        }
        // Of the two facets on the edge, the one that was not entered by: opposite the corner that is neither on the
        // edge nor opposite the facet entered.
        let corners = mesh.tet_vertices(entered.tet());
        let third = (0..4).find(|&i| i != entered.corner() && !edge.contains(&corners[i]));
        here = entered.tet().facet(third.unwrap_or(0));
    }
}
