//! A vertex moves: where its star stays as it is, only the coordinates change.
//!
//! The star stays as it is when every tetrahedron of it is right-handed with the vertex in the new
//! place, and every facet of it is locally Delaunay. Then all of the mesh is: the other facets have
//! not changed, and locally Delaunay everywhere is Delaunay. Both tests are exact, with the ties of the
//! whole triangulation. A vertex on the hull always goes the other way: it is removed and inserted.

use super::delaunay::Delaunay3;
use super::locate::Location3;
use super::sight::Sight3;
use crate::error::{MoveError, RemoveError};
use crate::ids::{FacetId, TetId, VertexId};
use geo_predicates::{Sign, orient3d};
use glam::DVec3;

impl Delaunay3 {
    /// Moves the vertex `v` to `p`; afterwards this is the Delaunay triangulation of the new places.
    ///
    /// A short move inside the hull that changes no tetrahedron takes about two tests for each of its
    /// star. Any other move costs a [removal](Self::remove) and an [insertion](Self::insert); then the
    /// ids of tetrahedra change as there. Input points that were duplicates of `v` are forgotten, unless
    /// `p` is where `v` is.
    ///
    /// # Errors
    /// [`MoveError`] when a coordinate of `p` is not accepted, `v` is no vertex, another vertex is at
    /// `p`, all vertices would lie on one plane, or ids run out. The triangulation is as before then, but
    /// for ids of tetrahedra in the last case.
    ///
    /// ```
    /// # use delaunay_core::{Delaunay3, MoveError, VertexId};
    /// # use glam::DVec3;
    /// let points = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z, DVec3::splat(0.2)];
    /// let mut delaunay = Delaunay3::build(&points)?;
    /// let v = VertexId::new(4);
    /// delaunay.move_vertex(v, DVec3::new(0.1, 0.2, 0.3))?;
    /// assert_eq!(delaunay.point(v), DVec3::new(0.1, 0.2, 0.3));
    /// let other = VertexId::new(1);
    /// assert_eq!(delaunay.move_vertex(v, DVec3::X), Err(MoveError::Occupied { vertex: v, other }));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn move_vertex(&mut self, v: VertexId, p: DVec3) -> Result<(), MoveError> {
        geo_predicates::check_point3(0, p)?;
        if !self.contains_vertex(v) {
            return Err(RemoveError::NoSuchVertex { vertex: v }.into());
        }
        // Adding zero turns -0.0 into 0.0.
        let p = p + DVec3::ZERO;
        if p == self.point(v) {
            return Ok(());
        }
        if self.star_may_follow(v, p) {
            self.duplicates.forget(v);
            self.coords[v.slot()] = p;
            self.guide.note_change();
            return Ok(());
        }
        match self.locate_near(p, v)? {
            Location3::Vertex(other) => Err(MoveError::Occupied { vertex: v, other }),
            _ => self.take_elsewhere(v, p),
        }
    }

    /// Whether the star of `v`, inside the hull, is a part of the triangulation with `v` at `p` as well.
    fn star_may_follow(&self, v: VertexId, p: DVec3) -> bool {
        let star: Vec<TetId> = self.mesh.star(v).collect();
        let sight = Sight3::new(self.coords.as_slice(), self.filter, p);
        let right_handed = |&t: &TetId| match self.mesh.corner_of(t, v) {
            Some(corner) => sight.side(self.mesh.facet_vertices(t.facet(corner))) == Sign::Negative,
            None => false,
        };
        let inside = star.iter().all(|&t| !self.mesh.is_ghost_tet(t));
        let mut facets = star.iter().flat_map(|t| t.facets());
        inside && star.iter().all(right_handed) && facets.all(|f| self.stays_delaunay(f, v, &sight))
    }

    /// Whether the facet `f` of the star of `v` is locally Delaunay with `v` at the point of `sight`.
    fn stays_delaunay(&self, f: FacetId, v: VertexId, sight: &Sight3<&[DVec3]>) -> bool {
        let twin = self.mesh.twin(f);
        let beyond = self.mesh.apex(twin);
        if self.mesh.apex(f) == v {
            return beyond.is_ghost()
                || !sight.in_real_conflict(self.mesh.tet_vertices(twin.tet()));
        }
        // Both sides have the corner `v`; from either side the answer is the same.
        f > twin || !self.is_inside_with(beyond, f.tet(), v, sight.from())
    }

    /// Whether `vertex` is inside the circumsphere of `t` with the corner `moved` at `p`.
    fn is_inside_with(&self, vertex: VertexId, t: TetId, moved: VertexId, p: DVec3) -> bool {
        let corners = self.mesh.tet_vertices(t);
        let [a, b, c, d] = corners.map(|w| if w == moved { p } else { self.point_of(w) });
        geo_predicates::in_sphere_perturbed(a, b, c, d, self.point_of(vertex))
    }

    /// Removes `v` and inserts it at the free place `p`.
    fn take_elsewhere(&mut self, v: VertexId, p: DVec3) -> Result<(), MoveError> {
        let hint = self.mesh.neighbors(v).find(|w| !w.is_ghost());
        let old = self.point(v);
        match self.remove(v) {
            Ok(()) => {}
            Err(RemoveError::RestIsFlat { .. }) => return self.swing(v, p),
            Err(other) => return Err(other.into()),
        }
        let hint = hint.unwrap_or(v);
        match self.insert_near(p, hint) {
            Ok(_) => Ok(()),
            Err(error) => {
                // What was there before fits again.
                let _ = self.insert_near(old, hint);
                Err(error.into())
            }
        }
    }

    /// Moves `v`, without which the rest is flat: the new place is taken before the old one is left.
    fn swing(&mut self, v: VertexId, p: DVec3) -> Result<(), MoveError> {
        let base = self.mesh.star(v).find(|&t| !self.mesh.is_ghost_tet(t));
        let facet = base.and_then(|t| Some(t.facet(self.mesh.corner_of(t, v)?)));
        let plane = facet.map(|f| self.mesh.facet_vertices(f).map(|w| self.point_of(w)));
        let held_up = plane.is_some_and(|[a, b, c]| orient3d(a, b, c, p) != Sign::Zero);
        if !held_up {
            return Err(RemoveError::RestIsFlat { vertex: v }.into());
        }
        let slots = self.coords.len();
        let stand_in = self.insert_near(p, v)?.vertex();
        let removed = self.remove(v);
        match removed {
            Ok(()) => self.rename(stand_in, v),
            Err(_) => self.remove(stand_in)?,
        }
        if self.coords.len() > slots {
            self.coords.truncate(slots);
            self.mesh.homes.truncate(slots);
            self.vacant.pop();
        }
        Ok(removed?)
    }

    /// Gives `vertex` the id `name`, which was vacated last, and vacates its own.
    fn rename(&mut self, vertex: VertexId, name: VertexId) {
        let star: Vec<TetId> = self.mesh.star(vertex).collect();
        for t in star {
            let corners = self.mesh.tet_vertices(t);
            self.mesh.tets[t.index()].vertex = corners.map(|w| if w == vertex { name } else { w });
            self.mesh.settle(t);
        }
        self.mesh.forget_vertex(vertex);
        self.coords[name.slot()] = self.coords[vertex.slot()];
        self.vacant.pop();
        self.vacant.push(vertex);
    }
}
