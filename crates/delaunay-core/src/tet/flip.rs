//! Flips: few tetrahedra give way to others with the same corners and boundary.
//!
//! ```text
//!   2-3: facet abc <-> edge de :3-2            4-4: edge ab -> edge ce, seen along ab
//!
//!        e                e                        c                   c
//!       / \              /|\                     / | \               / | \
//!      /   \            / | \                   /  |  \             /  |  \
//!     a-----c          a  |  c                 d--ab---f           d   |   f
//!      \ b /            \ b /                   \  |  /             \  |  /
//!       \ /              \|/                     \ | /               \ | /
//!        d                d                        e                   e
//! ```
//!
//! With ghosts the same surgery works at the hull: a 4-4 flip of a hull edge whose ring holds two
//! tetrahedra and two ghosts exchanges the diagonal of two hull facets, the 2-2 flip.
//!
//! A [`Flip`] is a plan: what goes and what comes. The caller may ask whether it is
//! [legal](Flip::is_legal) in space and judge the tetrahedra to [come](Flip::made), then
//! [carry it out](TetMesh::flip).

use super::mesh::TetMesh;
use crate::ids::{FacetId, TetId, VertexId};
use geo_predicates::{Sign, orient3d};
use glam::DVec3;
use thiserror::Error;

/// Why a flip is not possible; the mesh is as before.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum FlipError {
    /// There is no such facet.
    #[error("there is no facet {facet}")]
    NoSuchFacet {
        /// The facet in question.
        facet: FacetId,
    },
    /// The tetrahedron does not exist or has no such edge.
    #[error("there is no edge from {} to {} in {tet}", .ends[0], .ends[1])]
    NoSuchEdge {
        /// The tetrahedron in question.
        tet: TetId,
        /// The ends of the edge.
        ends: [VertexId; 2],
    },
    /// The edge has another number of tetrahedra round it than the flip replaces.
    #[error("the edge from {} to {} has {} tetrahedra round it instead of {wanted}", .ends[0], .ends[1], count_text(*.found, *.wanted))]
    RingSize {
        /// The ends of the edge.
        ends: [VertexId; 2],
        /// Tetrahedra round the edge; one more than wanted when there are more.
        found: usize,
        /// Tetrahedra that the flip replaces.
        wanted: usize,
    },
    /// The vertex from which the new edge of a 4-4 flip should start is not in the ring.
    #[error("{vertex} is not in the ring of the edge from {} to {}", .ends[0], .ends[1])]
    NotInRing {
        /// The vertex in question.
        vertex: VertexId,
        /// The ends of the edge.
        ends: [VertexId; 2],
    },
    /// The new edge would join vertices that an edge joins already, or a vertex with itself.
    #[error("{} and {} are joined already", .ends[0], .ends[1])]
    EdgeExists {
        /// The ends of the edge.
        ends: [VertexId; 2],
    },
    /// The new facet of a 3-2 flip is a facet already.
    #[error("{}, {} and {} are the corners of a facet already", .corners[0], .corners[1], .corners[2])]
    FacetExists {
        /// The corners of the facet.
        corners: [VertexId; 3],
    },
    /// The mesh has changed since the flip was planned.
    #[error("{tet} has changed since the flip was planned")]
    Outdated {
        /// A tetrahedron that the flip would replace.
        tet: TetId,
    },
    /// There are no ids for more tetrahedra.
    #[error("there is no room for one more than {limit} tetrahedra")]
    TooManyTets {
        /// Tetrahedra possible.
        limit: usize,
    },
}

fn count_text(found: usize, wanted: usize) -> String {
    match found > wanted {
        true => format!("more than {wanted}"),
        false => found.to_string(),
    }
}

/// A planned flip of `GONE` tetrahedra into `MADE` others, good until the mesh changes there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Flip<const GONE: usize, const MADE: usize> {
    gone: [(TetId, [VertexId; 4]); GONE],
    made: [[VertexId; 4]; MADE],
    comes: Arrival,
}

/// What a flip makes that was not there before.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Arrival {
    Edge([VertexId; 2]),
    Facet([VertexId; 3]),
}

impl<const GONE: usize, const MADE: usize> Flip<GONE, MADE> {
    /// The tetrahedra that the flip replaces.
    #[must_use]
    pub fn gone(&self) -> [TetId; GONE] {
        self.gone.map(|(t, _)| t)
    }

    /// The corners of the tetrahedra that it makes, right-handed where the flip is legal; the ghost is
    /// corner 3.
    #[must_use]
    pub fn made(&self) -> [[VertexId; 4]; MADE] {
        self.made
    }

    /// The ends of the edge that it makes; `None` when it makes a facet.
    #[must_use]
    pub fn new_edge(&self) -> Option<[VertexId; 2]> {
        match self.comes {
            Arrival::Edge(ends) => Some(ends),
            Arrival::Facet(_) => None,
        }
    }

    /// Whether the flip leaves space filled as it was, with the vertices at `place`; exact.
    ///
    /// All real tetrahedra made must be right-handed. If there are ghosts among them, the hull must stay
    /// where it is: the real corners of all ghosts made lie on one plane.
    ///
    /// The tetrahedra that go are taken to be right-handed. `place` is not asked about the ghost.
    pub fn is_legal(&self, place: impl Fn(VertexId) -> DVec3) -> bool {
        let orientation = |corners: [VertexId; 4]| {
            let [a, b, c, d] = corners.map(&place);
            orient3d(a, b, c, d)
        };
        let (ghosts, real): (Vec<[VertexId; 4]>, Vec<_>) =
            self.made.iter().partition(|made| made[3].is_ghost());
        let flat = |&[a, b, c, _]: &[VertexId; 4]| {
            let corners = ghosts.iter().flat_map(|ghost| &ghost[..3]);
            let mut apexes = corners.filter(|v| ![a, b, c].contains(v));
            apexes.all(|&d| orientation([a, b, c, d]) == Sign::Zero)
        };
        real.into_iter()
            .all(|made| orientation(made) == Sign::Positive)
            && ghosts.first().is_none_or(flat)
    }
}

impl TetMesh {
    /// The flip that replaces the facet `f` and the two tetrahedra at it by the edge between their other
    /// corners and three tetrahedra round it.
    ///
    /// # Errors
    /// [`FlipError::NoSuchFacet`].
    ///
    /// ```
    /// # use delaunay_core::{Delaunay3, VertexId};
    /// # use glam::DVec3;
    /// let points = [[0., 0., 0.], [2., 0., 0.], [0., 2., 0.], [0.5, 0.5, 9.], [0.5, 0.5, -9.]];
    /// let delaunay = Delaunay3::build(&points.map(DVec3::from))?;
    /// assert_eq!(delaunay.tets().count(), 2);
    /// let mut mesh = delaunay.mesh().clone();
    /// let facet = mesh.find_facet([0, 1, 2].map(VertexId::new)).unwrap();
    /// let flip = mesh.two_to_three(facet)?;
    /// assert!(flip.is_legal(|v| delaunay.point(v)));
    /// mesh.flip(&flip)?;
    /// assert_eq!(mesh.check(), Ok(()));
    /// assert_eq!(mesh.tet_count(), 9); // six of them ghosts
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn two_to_three(&self, f: FacetId) -> Result<Flip<2, 3>, FlipError> {
        if !self.contains_tet(f.tet()) {
            return Err(FlipError::NoSuchFacet { facet: f });
        }
        let twin = self.twin(f);
        let [a, b, c] = self.facet_vertices(f);
        // `[d, a, b, c]` is right-handed, and so is `[d, a, b, e]` when the new edge leaves through the facet.
        let (d, e) = (self.apex(f), self.apex(twin));
        Ok(Flip {
            gone: [f, twin].map(|f| self.remembered(f.tet())),
            made: [[a, b], [b, c], [c, a]].map(|[a, b]| ghost_last([d, a, b, e])),
            comes: Arrival::Edge([d, e]),
        })
    }

    /// The flip that replaces the edge `ends` of `tet` and the three tetrahedra round it by the facet
    /// between their other corners and two tetrahedra.
    ///
    /// # Errors
    /// [`FlipError::NoSuchEdge`], or [`FlipError::RingSize`] when not three tetrahedra are round the edge.
    pub fn three_to_two(&self, tet: TetId, ends: [VertexId; 2]) -> Result<Flip<3, 2>, FlipError> {
        let (gone, [u, v, w]) = self.ring_of::<3>(tet, ends)?;
        let [a, b] = ends;
        Ok(Flip {
            gone: gone.map(|t| self.remembered(t)),
            made: [[a, u, v, w], [u, v, w, b]].map(ghost_last),
            comes: Arrival::Facet([u, v, w]),
        })
    }

    /// The flip that replaces the edge `ends` of `tet` and the four tetrahedra round it by the edge from
    /// `start` to the corner opposite in the ring and four tetrahedra round that.
    ///
    /// `start` is one of the four vertices that close the ring; the two opposite each other give the
    /// same edge.
    ///
    /// # Errors
    /// [`FlipError::NoSuchEdge`], [`FlipError::RingSize`] when not four tetrahedra are round the edge,
    /// or [`FlipError::NotInRing`].
    pub fn four_to_four(
        &self,
        tet: TetId,
        ends: [VertexId; 2],
        start: VertexId,
    ) -> Result<Flip<4, 4>, FlipError> {
        let (gone, mut ring) = self.ring_of::<4>(tet, ends)?;
        let first = ring.iter().position(|&v| v == start);
        ring.rotate_left(first.ok_or(FlipError::NotInRing {
            vertex: start,
            ends,
        })?);
        let ([u, v, w, x], [a, b]) = (ring, ends);
        let made = [[a, u, v, w], [a, w, x, u], [u, v, w, b], [w, x, u, b]];
        Ok(Flip {
            gone: gone.map(|t| self.remembered(t)),
            made: made.map(ghost_last),
            comes: Arrival::Edge([u, w]),
        })
    }

    /// Carries out a planned flip.
    ///
    /// Gives the ids of the tetrahedra in the order of [`Flip::made`]: those of the tetrahedra that go,
    /// then vacant ones, then new ones; an id left over is vacated. Takes time proportional to the
    /// number of tetrahedra round one vertex of the flip, to see that the new edge or facet is new.
    ///
    /// # Errors
    /// [`FlipError::EdgeExists`] or [`FlipError::FacetExists`] when the result would not be a complex,
    /// [`FlipError::Outdated`], or [`FlipError::TooManyTets`].
    pub fn flip<const GONE: usize, const MADE: usize>(
        &mut self,
        flip: &Flip<GONE, MADE>,
    ) -> Result<[TetId; MADE], FlipError> {
        let outdated = |&&(tet, corners): &&(TetId, [VertexId; 4])| {
            !self.contains_tet(tet) || self.tet_vertices(tet) != corners
        };
        if let Some(&(tet, _)) = flip.gone.iter().find(outdated) {
            return Err(FlipError::Outdated { tet });
        }
        self.check_arrival(flip.comes)?;
        let gone = flip.gone();
        let twins = gone
            .into_iter()
            .flat_map(TetId::facets)
            .map(|f| self.twin(f));
        let outer: Vec<FacetId> = twins.filter(|f| !gone.contains(&f.tet())).collect();
        let made = self.exchange(&gone, &outer, &flip.made);
        let limit = TetId::LIMIT;
        let made = made.ok_or(FlipError::TooManyTets { limit })?;
        <[TetId; MADE]>::try_from(made).map_err(|_| FlipError::TooManyTets { limit })
    }

    fn check_arrival(&self, comes: Arrival) -> Result<(), FlipError> {
        match comes {
            Arrival::Edge(ends) => {
                let [a, b] = ends;
                let (from, to) = if a.is_ghost() { (b, a) } else { (a, b) };
                match a == b || self.find_edge(from, to).is_some() {
                    true => Err(FlipError::EdgeExists { ends }),
                    false => Ok(()),
                }
            }
            Arrival::Facet(corners) => {
                let from = corners.iter().position(|v| !v.is_ghost()).unwrap_or(0);
                let [a, b, c] = [0, 1, 2].map(|i| corners[(from + i) % 3]);
                match self.find_facet([a, b, c]).is_some() {
                    true => Err(FlipError::FacetExists { corners }),
                    false => Ok(()),
                }
            }
        }
    }

    fn remembered(&self, t: TetId) -> (TetId, [VertexId; 4]) {
        (t, self.tet_vertices(t))
    }

    /// The `N` tetrahedra round the edge from `a` to `b`, counterclockwise seen from `b`, and for each the
    /// vertex of the ring that comes before it.
    fn ring_of<const N: usize>(
        &self,
        tet: TetId,
        ends: [VertexId; 2],
    ) -> Result<([TetId; N], [VertexId; N]), FlipError> {
        if !self.contains_tet(tet) {
            return Err(FlipError::NoSuchEdge { tet, ends });
        }
        let ring = self.ring(tet, ends[0], ends[1]).take(N + 1);
        let before = |t| Some((t, self.leading_vertex(t, ends)?));
        let ring: Vec<(TetId, VertexId)> = ring.filter_map(before).collect();
        let found = ring.len();
        if found == 0 {
            return Err(FlipError::NoSuchEdge { tet, ends });
        }
        let ring = <[(TetId, VertexId); N]>::try_from(ring);
        let ring = ring.map_err(|_| FlipError::RingSize {
            ends,
            found,
            wanted: N,
        })?;
        Ok((ring.map(|(t, _)| t), ring.map(|(_, v)| v)))
    }
}

/// The same corners in an even permutation, with the ghost as corner 3 if it is one of them.
fn ghost_last([a, b, c, d]: [VertexId; 4]) -> [VertexId; 4] {
    if a.is_ghost() {
        [d, c, b, a]
    } else if b.is_ghost() {
        [c, d, a, b]
    } else if c.is_ghost() {
        [b, a, d, c]
    } else {
        [a, b, c, d]
    }
}
