//! A segment becomes an edge (Shewchuk and Brown 2015 compare the ways to do it).
//!
//! The triangles that it crosses are taken out, and the polygons on its two sides are triangulated each for itself. Where
//! a vertex lies on the segment it is divided there, exactly.

use super::ahead::{Ahead, Turn, between};
use super::corridor::{Corridor, End};
use super::pocket::{Pocket, Wall};
use super::triangulation::Constrained2;
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::tri::mesh::Face;

/// An edge with a segment on it in the way of another segment.
#[derive(Clone, Debug)]
pub(super) struct Crossed {
    /// The vertices that have been laid from the first end on, and those to the second end.
    pub(super) before: Vec<VertexId>,
    pub(super) after: Vec<VertexId>,
    /// The ends of the edge. More segments may be laid before it is asked about, so its half-edges are not noted: they
    /// get other numbers then.
    pub(super) edge: [VertexId; 2],
    /// The segment on the edge.
    pub(super) segment: usize,
}

impl Crossed {
    /// The part of the way that is not laid yet.
    pub(super) fn way(&self) -> [VertexId; 2] {
        let [before, after] = [self.before.last(), self.after.first()];
        [before, after].map(|v| v.copied().unwrap_or(VertexId::GHOST))
    }

    /// What has been laid and the way between.
    pub(super) fn path(&self) -> Vec<VertexId> {
        [self.before.as_slice(), &self.after].concat()
    }
}

impl Constrained2 {
    /// Makes the straight way between two vertices edges with label `label`, up to an edge that a segment lies on.
    ///
    /// What has been laid when the way is blocked stays: all from either end up to the first edge in the way. Where the way
    /// leads over one that has been divided, that one is taken as it is.
    pub(super) fn lay(
        &mut self,
        ends: [VertexId; 2],
        label: u32,
        depth: usize,
    ) -> Result<(), Crossed> {
        let [mut before, mut after] = ends.map(|end| vec![end]);
        while let (Some(&a), Some(&b)) = (before.last(), after.last())
            && a != b
        {
            let sight_from = |v: VertexId| self.sight(v);
            let Some((way, ahead)) = between(&self.mesh, sight_from, [a, b]) else {
                debug_assert!(false, "{a} and {b} are vertices");
                break;
            };
            match self.lay_ahead(way, ahead, label, depth) {
                Ok(vertex) if way[0] == a => before.push(vertex),
                Ok(vertex) => after.push(vertex),
                Err(_) => return self.lay_to_barriers(before, after, label, depth),
            }
        }
        if before.len() + after.len() > 3 {
            after.reverse();
            self.paths.note([before, after].concat());
        }
        Ok(())
    }

    /// Makes a way that is blocked edges from both ends up to the barriers. So what is laid and which edge is named depends on
    /// the segments there are, not on the end from which the way was found to be blocked.
    fn lay_to_barriers(
        &mut self,
        mut before: Vec<VertexId>,
        mut after: Vec<VertexId>,
        label: u32,
        depth: usize,
    ) -> Result<(), Crossed> {
        let barrier = self.lay_on(&mut before, &after, label, depth);
        let crossed = barrier.map(|h| {
            let edge = [self.mesh.origin(h), self.mesh.target(h)];
            (edge, self.labels[h.index()] as usize - 1)
        });
        self.lay_on(&mut after, &before, label, depth);
        after.reverse();
        match crossed {
            Some((edge, segment)) => Err(Crossed {
                before,
                after,
                edge,
                segment,
            }),
            None => Ok(()),
        }
    }

    /// Lays the way from the last vertex of `from` towards the last of `to` up to the edge in the way, and gives that.
    fn lay_on(
        &mut self,
        from: &mut Vec<VertexId>,
        to: &[VertexId],
        label: u32,
        depth: usize,
    ) -> Option<HalfEdgeId> {
        while let (Some(&a), Some(&b)) = (from.last(), to.last())
            && a != b
        {
            let ahead = Turn::new(&self.mesh, self.sight(b), a).find()?;
            match self.lay_ahead([a, b], ahead, label, depth) {
                Ok(vertex) => from.push(vertex),
                Err(barrier) => return Some(barrier),
            }
        }
        None
    }

    /// Makes the way from a vertex to the next one on the way an edge; or gives the edge in the way.
    fn lay_ahead(
        &mut self,
        way: [VertexId; 2],
        ahead: Ahead,
        label: u32,
        depth: usize,
    ) -> Result<VertexId, HalfEdgeId> {
        match ahead {
            Ahead::Along(h) => {
                let end = self.mesh.target(h);
                if !self.paths.lead_over_others([way[0], end]) {
                    self.put_label(h, label);
                }
                Ok(end)
            }
            Ahead::Across(first) => self.cross(way, first, label, depth),
        }
    }

    /// The label of the edge of `h`: the least of those given.
    pub(super) fn put_label(&mut self, h: HalfEdgeId, label: u32) {
        let known = self.labels[h.index()];
        let least = if known == 0 { label } else { known.min(label) };
        for side in [h, self.mesh.twin(h)] {
            self.labels[side.index()] = least;
        }
    }

    /// Makes the way from a vertex to the next one on the way an edge, out of a triangle across `first`; or gives the edge in
    /// the way.
    fn cross(
        &mut self,
        [start, end]: [VertexId; 2],
        first: HalfEdgeId,
        label: u32,
        depth: usize,
    ) -> Result<VertexId, HalfEdgeId> {
        let mut corridor = std::mem::take(&mut self.corridor);
        let is_barrier = |h: HalfEdgeId| self.is_constrained(h);
        let met = corridor.dig(&self.mesh, &self.sight(end), start, first, is_barrier);
        let result = match met {
            End::Barrier(barrier) => Err(barrier),
            End::Vertex(reached) => {
                if !self.paths.lead_over_others([start, reached]) {
                    self.fill_corridor(&corridor, label, depth);
                }
                Ok(reached)
            }
        };
        self.corridor = corridor;
        result
    }

    /// Triangulates both sides of a corridor anew.
    fn fill_corridor(&mut self, corridor: &Corridor, label: u32, depth: usize) {
        let mut pockets = std::mem::take(&mut self.pockets);
        for (pocket, walls) in pockets.iter_mut().zip([&corridor.right, &corridor.left]) {
            self.survey(walls, pocket);
        }
        let (right, left) = corridor.faces.split_at(pockets[0].walls.len() - 1);
        let insides = self.insides([&pockets[0], &pockets[1]], depth);
        let bases = [
            self.fill(&pockets[0], right, insides[0].as_ref()),
            self.fill(&pockets[1], left, insides[1].as_ref()),
        ];
        self.mesh.glue(bases[0], bases[1]);
        self.labels[bases[0].index()] = 0;
        self.put_label(bases[0], label);
        self.pockets = pockets;
    }

    /// Notes the corners of a polygon and what is beyond its walls, while the old faces are still there.
    fn survey(&mut self, walls: &[HalfEdgeId], pocket: &mut Pocket) {
        pocket.clear();
        for &inner in walls {
            pocket.corners.push(self.mesh.origin(inner));
            pocket.walls.push(Wall {
                outer: self.mesh.twin(inner),
                segment: self.labels[inner.index()],
                spike: None,
            });
        }
        pocket
            .corners
            .extend(walls.last().map(|&inner| self.mesh.target(inner)));
        // The outside is told the number of each wall; a wall that is told one itself is the other side of that wall.
        for (number, wall) in pocket.walls.iter().enumerate() {
            self.mesh.set_twin(wall.outer, HalfEdgeId::numbered(number));
        }
        for (wall, &inner) in pocket.walls.iter_mut().zip(walls) {
            wall.spike = self.mesh.twin(inner).number();
            pocket.has_spikes |= wall.spike.is_some();
        }
    }

    /// Fills a polygon with triangles in `slots`, one less than it has walls, and gives the base, which is not glued yet.
    pub(super) fn fill_pocket(&mut self, pocket: &Pocket, slots: &[FaceId]) -> HalfEdgeId {
        let mut walls = vec![HalfEdgeId::NONE; pocket.walls.len()];
        let mut slots = slots.iter();
        let mut base = HalfEdgeId::NONE;
        let mut pending = vec![([0, pocket.walls.len()], HalfEdgeId::NONE)];
        while let Some(([low, high], above)) = pending.pop() {
            let Some(&f) = slots.next() else { break };
            let apex = pocket.apex(&self.coords, [low, high]);
            let sides = f.half_edges();
            self.put_face(
                f,
                Face {
                    origin: [low, apex, high].map(|corner| pocket.corners[corner]),
                    twin: sides,
                },
            );
            match above == HalfEdgeId::NONE {
                true => base = sides[2],
                false => self.mesh.glue(sides[2], above),
            }
            for (side, part) in [(sides[0], [low, apex]), (sides[1], [apex, high])] {
                match part[1] - part[0] == 1 {
                    true => walls[part[0]] = side,
                    false => pending.push((part, side)),
                }
            }
        }
        self.glue_walls(pocket, &walls);
        base
    }

    /// Stores a face in the slot of one that is gone, without labels.
    pub(super) fn put_face(&mut self, f: FaceId, face: Face) {
        self.mesh.faces[f.index()] = face;
        for h in f.half_edges() {
            self.labels[h.index()] = 0;
            self.mesh.set_outgoing(h);
        }
    }

    /// Glues the new inner sides of the walls to what is beyond them.
    pub(super) fn glue_walls(&mut self, pocket: &Pocket, inner: &[HalfEdgeId]) {
        for (wall, &here) in pocket.walls.iter().zip(inner) {
            self.labels[here.index()] = wall.segment;
            match wall.spike {
                Some(other) => self.mesh.set_twin(here, inner[other]),
                None => self.mesh.glue(here, wall.outer),
            }
        }
    }
}
