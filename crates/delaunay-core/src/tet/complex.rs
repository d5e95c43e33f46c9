//! Tetrahedra in a fixed boundary that need not be Delaunay: what local improvement works on.
//!
//! ```text
//!       ·───·───·                ·───·───·       Some tetrahedra give way to others with the same boundary. If the new
//!       │\ gone │     replace    │ made /│       ones are right-handed, they fill the same space, each place once: as
//!       │  \    │    ────────>   │    /  │       chains, old and new ones have the same boundary, and there are no
//!       │    \  │                │  /    │       other chains with that boundary in space.
//!       ·───·───·                ·───·───·
//! ```
//!
//! So two exact tests are enough for any exchange, and nothing else can change the mesh. Ghosts on the boundary are never
//! exchanged; they are glued as in a [`Subcomplex3`].

use super::delaunay::Delaunay3;
use super::mesh::TetMesh;
use super::subcomplex::Subcomplex3;
use crate::ids::{FacetId, TetId, VertexId};
use geo_predicates::{CoordinateError, Sign, check_point3, orient3d};
use glam::DVec3;
use thiserror::Error;

/// Why tetrahedra are not exchanged, or a vertex not moved; nothing has changed then.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum ComplexError {
    /// A coordinate is not accepted.
    #[error(transparent)]
    Coordinate(#[from] CoordinateError),
    /// What should go is no tetrahedron inside, or comes twice.
    #[error("{tet} is no tetrahedron inside, or is given twice")]
    NoSuchTet {
        /// The tetrahedron in question.
        tet: TetId,
    },
    /// The vertex is not in the mesh.
    #[error("there is no vertex {vertex}")]
    NoSuchVertex {
        /// The vertex in question.
        vertex: VertexId,
    },
    /// The vertex is on the boundary, which does not change.
    #[error("{vertex} is on the boundary")]
    OnBoundary {
        /// The vertex in question.
        vertex: VertexId,
    },
    /// A tetrahedron would be flat or left-handed.
    #[error("{}, {}, {} and {} are not right-handed", .corners[0], .corners[1], .corners[2], .corners[3])]
    NotRightHanded {
        /// The corners of the tetrahedron.
        corners: [VertexId; 4],
    },
    /// What should come does not have the boundary of what should go.
    #[error("the new tetrahedra do not have the boundary of the old ones")]
    OtherBoundary,
    /// There are no ids for more vertices.
    #[error("there is no room for one more than {limit} vertices")]
    TooManyVertices {
        /// Vertices possible.
        limit: usize,
    },
    /// There are no ids for more tetrahedra.
    #[error("there is no room for one more than {limit} tetrahedra")]
    TooManyTets {
        /// Tetrahedra possible.
        limit: usize,
    },
}

/// Tetrahedra of positive volume that share a fixed boundary, Delaunay or not.
///
/// Every change is tested exactly before it is made, so that the tetrahedra always fill the same space, face to face, and
/// the facets and vertices of the boundary are always those given. Vertices keep their ids and places on the boundary;
/// inside they may move, come and go.
///
/// ```
/// use delaunay_core::{Complex3, Delaunay3, Subcomplex3};
/// use glam::DVec3;
///
/// let cube: Vec<DVec3> = (0..8).map(|i| DVec3::new((i & 1) as f64, (i >> 1 & 1) as f64, (i >> 2) as f64)).collect();
/// let mut solid = Complex3::from(Subcomplex3::of(&Delaunay3::build(&cube)?, |_| true));
/// let all: Vec<_> = solid.tets().collect();
/// let (center, star) = solid.insert(&all, DVec3::splat(0.4))?;
/// solid.move_vertex(center, DVec3::splat(0.5))?;
/// assert_eq!((star.len(), solid.boundary().count()), (12, 12));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Complex3 {
    /// By vertex slot: the ghost in front, with coordinates that are not numbers.
    coords: Vec<DVec3>,
    mesh: TetMesh,
    /// Ids of removed vertices, the last removed on top.
    vacant: Vec<VertexId>,
    vertex_count: usize,
}

impl From<Subcomplex3> for Complex3 {
    fn from(subcomplex: Subcomplex3) -> Self {
        let Subcomplex3 {
            coords,
            mesh,
            vacant,
            vertex_count,
            ..
        } = subcomplex;
        Self {
            coords,
            mesh,
            vacant,
            vertex_count,
        }
    }
}

impl Complex3 {
    /// The points by vertex index. The entry of a removed vertex keeps its last value until an insertion takes the id
    /// again.
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

    /// Tetrahedra and how they are glued, ghosts on the boundary included.
    #[must_use]
    pub fn mesh(&self) -> &TetMesh {
        &self.mesh
    }

    /// The real tetrahedra, by id.
    #[must_use]
    pub fn tets(&self) -> impl DoubleEndedIterator<Item = TetId> + Clone + '_ {
        self.mesh.tets().filter(|&t| !self.mesh.is_ghost_tet(t))
    }

    /// The facets of the boundary, from inside, by id.
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

    /// Replaces the tetrahedra `gone` by some with the corners `made`.
    ///
    /// Gives the ids of the new ones, in the order of `made`: first those of `gone`, then vacant ones, then new ones. A
    /// vertex that is left without a tetrahedron is removed; on the boundary there is none. Takes n log n time for n
    /// tetrahedra.
    ///
    /// # Errors
    /// [`ComplexError`] unless `gone` are different tetrahedra inside, `made` are right-handed tetrahedra between vertices
    /// of the mesh, and both have the same boundary.
    pub fn replace(
        &mut self,
        gone: &[TetId],
        made: &[[VertexId; 4]],
    ) -> Result<Vec<TetId>, ComplexError> {
        let sorted = self.sorted(gone)?;
        for &vertex in made.as_flattened() {
            if vertex.is_ghost() || self.mesh.home(vertex).is_none() {
                return Err(ComplexError::NoSuchVertex { vertex });
            }
        }
        for &corners in made {
            require_right_handed(corners, |v| self.point(v))?;
        }
        self.exchange(gone, &sorted, made)
    }

    /// Replaces the tetrahedra `gone` by those between a new vertex at `p` and their boundary.
    ///
    /// Gives the vertex and its star, of which it is corner 0. Ids of tetrahedra, vertices without a tetrahedron and the time
    /// are as for [`replace`](Self::replace). The vertex has the id vacated last, or a new one.
    ///
    /// # Errors
    /// [`ComplexError`] unless `p` has accepted coordinates, `gone` are different tetrahedra inside, and `p` sees their
    /// whole boundary strictly from inside.
    pub fn insert(
        &mut self,
        gone: &[TetId],
        p: DVec3,
    ) -> Result<(VertexId, Vec<TetId>), ComplexError> {
        check_point3(0, p)?;
        let sorted = self.sorted(gone)?;
        let vertex = self.next_vertex()?;
        // Adding zero turns -0.0 into 0.0.
        let p = p + DVec3::ZERO;
        let place = |v: VertexId| if v == vertex { p } else { self.point(v) };
        let star = self.rim(&sorted).map(|f| {
            let [a, b, c] = self.mesh.facet_vertices(f);
            [vertex, a, b, c]
        });
        let star: Vec<[VertexId; 4]> = star.collect();
        for &corners in &star {
            require_right_handed(corners, place)?;
        }
        let taken = self.vacant.pop();
        let made = self.exchange(gone, &sorted, &star);
        if made.is_err() {
            self.vacant.extend(taken);
        } else {
            self.vertex_count += 1;
            match taken {
                Some(_) => self.coords[vertex.slot()] = p,
                None => self.coords.push(p),
            }
        }
        Ok((vertex, made?))
    }

    /// Moves the vertex `v` inside to `p`. Takes time proportional to its star.
    ///
    /// # Errors
    /// [`ComplexError`] unless `p` has accepted coordinates, `v` is a vertex that is not on the boundary, and its star stays
    /// right-handed.
    pub fn move_vertex(&mut self, v: VertexId, p: DVec3) -> Result<(), ComplexError> {
        check_point3(0, p)?;
        if v.is_ghost() || self.mesh.home(v).is_none() {
            return Err(ComplexError::NoSuchVertex { vertex: v });
        }
        let p = p + DVec3::ZERO;
        let place = |w: VertexId| if w == v { p } else { self.point(w) };
        for t in self.mesh.star(v) {
            if self.mesh.is_ghost_tet(t) {
                return Err(ComplexError::OnBoundary { vertex: v });
            }
            require_right_handed(self.mesh.tet_vertices(t), place)?;
        }
        self.coords[v.slot()] = p;
        Ok(())
    }

    /// Tetrahedra inside, by id.
    fn sorted(&self, tets: &[TetId]) -> Result<Vec<TetId>, ComplexError> {
        let mut sorted = tets.to_vec();
        sorted.sort_unstable();
        let twice = sorted.windows(2).find(|pair| pair[0] == pair[1]);
        if let Some(&[tet, _]) = twice {
            return Err(ComplexError::NoSuchTet { tet });
        }
        let inside = |&t: &TetId| self.mesh.contains_tet(t) && !self.mesh.is_ghost_tet(t);
        match sorted.iter().find(|t| !inside(t)) {
            Some(&tet) => Err(ComplexError::NoSuchTet { tet }),
            None => Ok(sorted),
        }
    }

    /// The facets between some tetrahedra, in order of their ids, and all others, from inside.
    fn rim<'a>(&'a self, sorted: &'a [TetId]) -> impl Iterator<Item = FacetId> + 'a {
        let facets = sorted.iter().flat_map(|t| t.facets());
        facets.filter(|&f| sorted.binary_search(&self.mesh.twin(f).tet()).is_err())
    }

    fn next_vertex(&self) -> Result<VertexId, ComplexError> {
        let limit = Delaunay3::MAX_POINTS;
        match self.vacant.last() {
            Some(&v) => Ok(v),
            None if self.points().len() < limit => Ok(VertexId::new(self.points().len())),
            None => Err(ComplexError::TooManyVertices { limit }),
        }
    }

    /// Replaces tetrahedra by right-handed ones if both have the same boundary; vertices without a tetrahedron go.
    fn exchange(
        &mut self,
        gone: &[TetId],
        sorted: &[TetId],
        made: &[[VertexId; 4]],
    ) -> Result<Vec<TetId>, ComplexError> {
        let limit = TetId::LIMIT;
        if self.mesh.tet_count() + made.len() > limit + gone.len() {
            return Err(ComplexError::TooManyTets { limit });
        }
        let kept = corners_of(made.iter().copied());
        let mut lost = corners_of(gone.iter().map(|&t| self.mesh.tet_vertices(t)));
        // All corners of the common boundary are corners of what is made: these have no other tetrahedra.
        lost.retain(|v| kept.binary_search(v).is_err());
        let outer: Vec<FacetId> = self.rim(sorted).map(|f| self.mesh.twin(f)).collect();
        let exchanged = self.mesh.exchange(gone, &outer, made);
        let new = exchanged.ok_or(ComplexError::OtherBoundary)?;
        self.vertex_count -= lost.len();
        for &v in &lost {
            self.mesh.forget_vertex(v);
        }
        self.vacant.extend(lost);
        Ok(new)
    }
}

/// The corners of some tetrahedra, each once, in order.
fn corners_of(tets: impl Iterator<Item = [VertexId; 4]>) -> Vec<VertexId> {
    let mut corners: Vec<VertexId> = tets.flatten().collect();
    corners.sort_unstable();
    corners.dedup();
    corners
}

fn require_right_handed(
    corners: [VertexId; 4],
    place: impl Fn(VertexId) -> DVec3,
) -> Result<(), ComplexError> {
    let [a, b, c, d] = corners.map(place);
    match orient3d(a, b, c, d) {
        Sign::Positive => Ok(()),
        _ => Err(ComplexError::NotRightHanded { corners }),
    }
}
