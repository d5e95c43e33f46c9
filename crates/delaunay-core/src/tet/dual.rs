//! The Voronoi diagram, dual of the Delaunay triangulation: vertices, edges, facets, clipped cells.
//!
//! Cells are carved out of a window by the bisectors between a vertex and its Delaunay neighbours. No Voronoi
//! vertex is needed for that, so slivers and flat tetrahedra on the hull, whose centers are far away,
//! do no harm.
//!
//! A cell of uniform points takes 5.6 µs among 10,000 and 8.6 µs among 100,000, with its moments 6.2 and 9.3 µs
//! (one thread of a shared machine, vertices in random order, clipped to a cube; `benches/voronoi3.rs`). Beyond
//! a few MB of tetrahedra the growth is waiting for memory.

use super::carve::CellCarver;
use super::delaunay::Delaunay3;
use super::polyhedron::ConvexPolyhedron;
use crate::ids::{FacetId, TetId, VertexId};
use crate::measure::{facet::normal, tetrahedron::circumcenter};
use glam::DVec3;
use rustc_hash::FxHashSet;

/// The Voronoi diagram of the vertices, see [`Delaunay3::voronoi`].
#[derive(Clone, Copy, Debug)]
pub struct Voronoi3<'a> {
    delaunay: &'a Delaunay3,
}

/// The Voronoi edge across a Delaunay facet: the points nearest to the three corners of that facet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum VoronoiEdge3 {
    /// Between two Voronoi vertices. Both are the same point when five vertices are on one sphere.
    Segment {
        /// Center of the tetrahedron that the facet bounds.
        from: DVec3,
        /// Center of the tetrahedron on the other side.
        to: DVec3,
    },
    /// From a Voronoi vertex to infinity, across a hull facet.
    Ray {
        /// Center of the tetrahedron on the hull facet.
        from: DVec3,
        /// Away from the hull, at a right angle to the facet, of unit length.
        direction: DVec3,
    },
}

/// The Voronoi facet across a Delaunay edge: the points nearest to the two ends of that edge.
#[derive(Clone, Debug, PartialEq)]
pub struct VoronoiFacet3 {
    /// The ends of the Delaunay edge, the smaller id first.
    pub edge: [VertexId; 2],
    /// Voronoi vertices, counterclockwise seen from the second end. Neighbours are the same point when five
    /// vertices are on one sphere.
    pub corners: Vec<DVec3>,
    /// For an edge on the hull, where the facet is unbounded: the directions in which it goes to infinity
    /// from its first corner and from its last, of unit length.
    pub rays: Option<[DVec3; 2]>,
}

impl Delaunay3 {
    /// The Voronoi diagram of the vertices. Nothing is computed before it is asked for.
    ///
    /// ```
    /// # use delaunay_core::{ConvexPolyhedron, Delaunay3, VertexId};
    /// # use glam::DVec3;
    /// let mut points: Vec<DVec3> = (0..8)
    ///     .map(|i| DVec3::new((i & 1) as f64, (i >> 1 & 1) as f64, (i >> 2) as f64))
    ///     .collect();
    /// points.push(DVec3::splat(0.5));
    /// let delaunay = Delaunay3::build(&points)?;
    /// let window = ConvexPolyhedron::cuboid(DVec3::ZERO, DVec3::ONE)?;
    /// let cell = delaunay.voronoi().cell(VertexId::new(8), &window);
    /// assert_eq!(cell.volume(), 0.5);
    /// assert_eq!(cell.centroid(), Some(DVec3::splat(0.5)));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn voronoi(&self) -> Voronoi3<'_> {
        Voronoi3 { delaunay: self }
    }
}

impl<'a> Voronoi3<'a> {
    /// The Voronoi vertex of the tetrahedron `t`: its circumcenter.
    ///
    /// The error is near 1e-15 of the circumradius, for slivers too; only tetrahedra thinner than the
    /// coordinates resolve may have theirs at infinity.
    ///
    /// # Panics
    /// When there is no tetrahedron `t` or it is a ghost.
    #[must_use]
    pub fn vertex(&self, t: TetId) -> DVec3 {
        circumcenter(self.delaunay.tetrahedron(t))
    }

    /// All Voronoi edges, each with the Delaunay facet that it crosses outwards, out of the tetrahedron
    /// that the facet bounds.
    ///
    /// One side of each Delaunay facet, by id; on the hull the one of the real tetrahedron.
    pub fn edges(&self) -> impl Iterator<Item = (FacetId, VoronoiEdge3)> + use<'a> {
        let voronoi = *self;
        let mesh = self.delaunay.mesh();
        mesh.facets().filter_map(move |f| {
            let twin = mesh.twin(f);
            match [f, twin].map(|side| mesh.is_ghost_tet(side.tet())) {
                [false, false] if f < twin => Some((f, voronoi.segment(f))),
                [false, true] => Some((f, voronoi.ray(f))),
                _ => None,
            }
        })
    }

    /// All Voronoi facets, one for each Delaunay edge, by the ends of the edge.
    ///
    /// Takes time proportional to what is drawn from it.
    pub fn facets(&self) -> impl Iterator<Item = VoronoiFacet3> + use<'a> {
        let voronoi = *self;
        let vertices = self.delaunay.vertices();
        vertices.flat_map(move |v| voronoi.facets_above(v))
    }

    /// The cell of `v`: the part of `window` that is nearer to `v` than to any other vertex.
    ///
    /// Empty when `v` is not a vertex or its cell lies outside the window. The cells of all vertices tile
    /// the window up to rounding. For many cells take a [`carver`](Self::carver).
    #[must_use]
    pub fn cell(&self, v: VertexId, window: &ConvexPolyhedron) -> ConvexPolyhedron {
        let mut carver = CellCarver::new(self.delaunay, window);
        carver.cell(v);
        carver.into_cell()
    }

    /// What makes one cell after the other.
    #[must_use]
    pub fn carver(&self, window: &'a ConvexPolyhedron) -> CellCarver<'a> {
        CellCarver::new(self.delaunay, window)
    }

    /// The facets between `v` and its neighbours of greater id.
    fn facets_above(&self, v: VertexId) -> Vec<VoronoiFacet3> {
        let mesh = self.delaunay.mesh();
        let mut seen = FxHashSet::default();
        let ends = mesh
            .star(v)
            .flat_map(|t| mesh.tet_vertices(t).map(|u| (u, t)));
        let mut edges: Vec<(VertexId, TetId)> =
            ends.filter(|&(u, _)| u > v && seen.insert(u)).collect();
        edges.sort_unstable();
        edges
            .into_iter()
            .map(|(u, t)| self.facet(t, [v, u]))
            .collect()
    }

    /// The facet across an edge of the tetrahedron `t`.
    fn facet(&self, t: TetId, edge: [VertexId; 2]) -> VoronoiFacet3 {
        let mesh = self.delaunay.mesh();
        let mut ring: Vec<TetId> = mesh.ring(t, edge[0], edge[1]).collect();
        let is_ghost = |t: &TetId| mesh.is_ghost_tet(*t);
        // The ghosts of an edge on the hull are neighbours in the ring: turn them to the end.
        let followers = ring.iter().cycle().skip(1);
        let is_last = |(t, follower)| is_ghost(t) && !is_ghost(follower);
        let last_ghost = ring.iter().zip(followers).position(is_last);
        ring.rotate_left(last_ghost.map_or(0, |last| last + 1));
        let bounded = ring.iter().take_while(|t| !is_ghost(t)).count();
        let (real, ghosts) = ring.split_at(bounded);
        let direction = |ghost: &TetId| self.outwards(mesh.twin(ghost.facet(3)));
        VoronoiFacet3 {
            edge,
            corners: real.iter().map(|&t| self.vertex(t)).collect(),
            rays: ghosts
                .last()
                .zip(ghosts.first())
                .map(|(first, last)| [direction(first), direction(last)]),
        }
    }

    fn segment(&self, f: FacetId) -> VoronoiEdge3 {
        let across = self.delaunay.mesh().twin(f).tet();
        VoronoiEdge3::Segment {
            from: self.vertex(f.tet()),
            to: self.vertex(across),
        }
    }

    fn ray(&self, f: FacetId) -> VoronoiEdge3 {
        VoronoiEdge3::Ray {
            from: self.vertex(f.tet()),
            direction: self.outwards(f),
        }
    }

    /// The direction at a right angle to a facet, out of the tetrahedron that it bounds.
    fn outwards(&self, f: FacetId) -> DVec3 {
        normal(
            self.delaunay
                .mesh()
                .facet_vertices(f)
                .map(|v| self.delaunay.point(v)),
        )
    }
}
