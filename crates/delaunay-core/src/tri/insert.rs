//! Insertion of one point (Bowyer 1981, Watson 1981): locate, cavity, star.

use super::delaunay::Delaunay2;
use super::locate::Location;
use crate::error::InsertError;
use crate::ids::{FaceId, VertexId};
use glam::DVec2;

/// What an insertion did.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[must_use]
pub enum Inserted {
    /// The point is a new vertex.
    New(VertexId),
    /// The point is where this vertex is already; nothing changed.
    Duplicate(VertexId),
}

impl Inserted {
    /// The vertex at the point, new or old.
    #[must_use]
    pub fn vertex(self) -> VertexId {
        match self {
            Self::New(v) | Self::Duplicate(v) => v,
        }
    }
}

impl Delaunay2 {
    /// Makes `p` a vertex.
    ///
    /// It gets the id of the vertex removed last and not yet replaced, or else the next new id. The
    /// faces of its [`cavity`](Self::cavity) give way to its star, which takes their ids and two new
    /// ones; all other faces keep their ids, so data beside the mesh need an update there only.
    ///
    /// Expected time log n to locate, then the size of the cavity, six on average in random order.
    /// The cavity may be all n faces in a hostile order, say points of a line and of a parabola in turn;
    /// [`build`](Self::build) brings them in random order.
    ///
    /// # Errors
    /// [`InsertError`] when a coordinate of `p` is not accepted or the ids are used up; nothing has
    /// changed then.
    ///
    /// ```
    /// # use delaunay_core::{Delaunay2, Inserted, VertexId};
    /// # use glam::DVec2;
    /// let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]].map(DVec2::from);
    /// let mut delaunay = Delaunay2::build(&corners)?;
    /// let inserted = delaunay.insert(DVec2::new(0.25, 0.25))?;
    /// assert_eq!(inserted, Inserted::New(VertexId::new(3)));
    /// assert_eq!(delaunay.insert(corners[1])?, Inserted::Duplicate(VertexId::new(1)));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn insert(&mut self, p: DVec2) -> Result<Inserted, InsertError> {
        let location = self.locate(p)?;
        self.insert_at(p, location)
    }

    /// Makes `p` a vertex, located by a walk from `hint`, a vertex near it.
    ///
    /// As [`insert`](Self::insert) otherwise, and when `hint` is not in the triangulation.
    ///
    /// # Errors
    /// As [`insert`](Self::insert).
    pub fn insert_near(&mut self, p: DVec2, hint: VertexId) -> Result<Inserted, InsertError> {
        let location = self.locate_near(p, hint)?;
        self.insert_at(p, location)
    }

    fn insert_at(&mut self, p: DVec2, location: Location) -> Result<Inserted, InsertError> {
        let seed = match self.seed(location) {
            Ok(seed) => seed,
            Err(vertex) => return Ok(Inserted::Duplicate(vertex)),
        };
        let v = self.name_vertex(p)?;
        let mut cavity = std::mem::take(&mut self.cavity);
        self.dig(p, seed, &mut cavity);
        self.guide.note_change();
        self.mesh.fill(&mut cavity, v);
        self.mesh.point_at_star(cavity.faces());
        self.cavity = cavity;
        Ok(Inserted::New(v))
    }

    /// A face in the cavity of a point at `location`, or the vertex that is there already.
    pub(super) fn seed(&self, location: Location) -> Result<FaceId, VertexId> {
        match location {
            Location::Face(f) => Ok(f),
            Location::Edge(h) => Ok(h.face()),
            Location::Outside(h) => Ok(self.mesh.twin(h).face()),
            Location::Vertex(v) => Err(v),
        }
    }

    /// An id for a new vertex at `p`: the one vacated last, or a new one.
    fn name_vertex(&mut self, p: DVec2) -> Result<VertexId, InsertError> {
        let full = self.vertex_count() >= Self::MAX_POINTS;
        if full || (self.vacant.is_empty() && self.points().len() >= VertexId::LIMIT) {
            return Err(InsertError::TooManyPoints {
                limit: Self::MAX_POINTS,
            });
        }
        // Adding zero turns -0.0 into 0.0.
        let p = p + DVec2::ZERO;
        if let Some(v) = self.vacant.pop() {
            self.coords[v.slot()] = p;
            return Ok(v);
        }
        self.coords.push(p);
        Ok(VertexId::new(self.points().len() - 1))
    }
}
