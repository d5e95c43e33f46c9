//! Insertion of one point (Bowyer 1981, Watson 1981): locate, cavity, star.

use super::delaunay::Delaunay3;
use super::locate::Location3;
use crate::error::InsertError;
use crate::ids::{TetId, VertexId};
use crate::tri::Inserted;
use glam::DVec3;

impl Delaunay3 {
    /// Makes `p` a vertex.
    ///
    /// It gets the id of the vertex removed last and not yet replaced, or else the next new id. The
    /// tetrahedra of its [`cavity`](Self::cavity) give way to its star, which takes their ids, then
    /// vacant and new ones; all other tetrahedra keep their ids, so data beside the mesh need an update
    /// there only.
    ///
    /// Expected time log n to locate, then the size of the cavity, about twenty in random order. The
    /// cavity may be all of the triangulation in a hostile order; [`build`](Self::build) brings points in
    /// random order.
    ///
    /// # Errors
    /// [`InsertError`] when a coordinate of `p` is not accepted or ids are used up; nothing has changed
    /// then.
    ///
    /// ```
    /// # use delaunay_core::{Delaunay3, Inserted, VertexId};
    /// # use glam::DVec3;
    /// let corners = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
    /// let mut delaunay = Delaunay3::build(&corners)?;
    /// let inserted = delaunay.insert(DVec3::splat(0.125))?;
    /// assert_eq!(inserted, Inserted::New(VertexId::new(4)));
    /// assert_eq!(delaunay.insert(corners[1])?, Inserted::Duplicate(VertexId::new(1)));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn insert(&mut self, p: DVec3) -> Result<Inserted, InsertError> {
        let location = self.locate(p)?;
        self.insert_at(p, location)
    }

    /// Makes `p` a vertex, located by a walk from `hint`, a vertex near it.
    ///
    /// As [`insert`](Self::insert) otherwise, and when `hint` is not in the triangulation.
    ///
    /// # Errors
    /// As [`insert`](Self::insert).
    pub fn insert_near(&mut self, p: DVec3, hint: VertexId) -> Result<Inserted, InsertError> {
        let location = self.locate_near(p, hint)?;
        self.insert_at(p, location)
    }

    /// The tetrahedra that the last insertion made: the star of its vertex.
    ///
    /// Empty before the first insertion, and stale after a removal.
    #[must_use]
    pub fn last_star(&self) -> &[TetId] {
        self.cavity.tets()
    }

    fn insert_at(&mut self, p: DVec3, location: Location3) -> Result<Inserted, InsertError> {
        let seed = match self.seed(location) {
            Ok(seed) => seed,
            Err(vertex) => return Ok(Inserted::Duplicate(vertex)),
        };
        let v = self.next_vertex()?;
        let mut cavity = std::mem::take(&mut self.cavity);
        self.dig(p, seed, &mut cavity);
        let filled = self.mesh.fill(&mut cavity, v);
        self.cavity = cavity;
        if !filled {
            let limit = TetId::LIMIT;
            return Err(InsertError::TooManyTets { limit });
        }
        self.place_vertex(v, p);
        Ok(Inserted::New(v))
    }

    /// The id for a new vertex: the one vacated last, or a new one.
    fn next_vertex(&self) -> Result<VertexId, InsertError> {
        let limit = Self::MAX_POINTS;
        match self.vacant.last() {
            Some(&v) => Ok(v),
            None if self.points().len() < limit => Ok(VertexId::new(self.points().len())),
            None => Err(InsertError::TooManyPoints { limit }),
        }
    }

    /// Gives the vertex that [`next_vertex`](Self::next_vertex) has named its place.
    fn place_vertex(&mut self, v: VertexId, p: DVec3) {
        // Adding zero turns -0.0 into 0.0.
        let p = p + DVec3::ZERO;
        match self.vacant.pop() {
            Some(_) => self.coords[v.slot()] = p,
            None => self.coords.push(p),
        }
        self.vertex_count += 1;
        self.guide.note_change();
    }
}
