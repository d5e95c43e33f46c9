//! What segments separate: parts of the plane that hang together across edges without segments.
//!
//! ```text
//!    0   +-----------+      Part 0 is outside. The depth of a part is the least number of segments between it and
//!        | 1  +---+  |      the outside: 1 for part 1 and for part 3 beside it, 2 for part 2. With closed outlines,
//!        |    | 2 |  +--+   odd depths are inside and even ones are holes.
//!        |    +---+  |3 |
//!        +-----------+--+
//! ```

use super::triangulation::Constrained2;
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::progress::{Cancelled, Meter, Progress};
use crate::tri::locate::Location;
use geo_predicates::{CoordinateError, check_point2};
use glam::DVec2;
use std::ops::ControlFlow;
use thiserror::Error;

/// By face, which part of the plane it is in.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Components {
    /// By face.
    of: Vec<u32>,
    /// By part.
    depths: Vec<u32>,
}

/// Why a seed does not name a part.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum SeedError {
    /// A coordinate is not accepted.
    #[error(transparent)]
    Coordinate(#[from] CoordinateError),
    /// The seed is on a segment, or at a vertex between two parts.
    #[error("seed {seed} at ({}, {}) is on segment {segment}", .place.x, .place.y)]
    OnSegment {
        /// Index of the seed.
        seed: usize,
        /// Where it is.
        place: DVec2,
        /// A segment there.
        segment: usize,
    },
    /// The seed is outside all segments.
    #[error("seed {seed} at ({}, {}) is outside", .place.x, .place.y)]
    Outside {
        /// Index of the seed.
        seed: usize,
        /// Where it is.
        place: DVec2,
    },
}

impl Components {
    /// The part that a face is in; part 0 is outside, where the ghosts are.
    ///
    /// # Panics
    /// When there is no face `f`.
    #[must_use]
    pub fn of(&self, f: FaceId) -> usize {
        self.of[f.index()] as usize
    }

    /// The number of parts, the outside included.
    #[must_use]
    pub fn count(&self) -> usize {
        self.depths.len()
    }

    /// The least number of segments between a part and the outside.
    ///
    /// # Panics
    /// When there is no such part.
    #[must_use]
    pub fn depth(&self, part: usize) -> usize {
        self.depths[part] as usize
    }

    /// Whether the depth of a face's part is odd: with closed outlines, whether it is inside.
    ///
    /// # Panics
    /// When there is no face `f`.
    #[must_use]
    pub fn is_odd(&self, f: FaceId) -> bool {
        self.depths[self.of(f)] % 2 == 1
    }
}

impl Constrained2 {
    /// The parts that the segments separate. Takes linear time.
    ///
    /// # Errors
    /// [`Cancelled`] when `report` stops the work.
    pub fn components(
        &self,
        report: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Components, Cancelled> {
        let meter = Meter::start(report, "find parts", self.mesh.face_count())?;
        let mut spread = Spread {
            of: vec![UNKNOWN; self.mesh.face_count()],
            beyond: Vec::new(),
            meter,
        };
        let mut depths = vec![0];
        for ghost in self.mesh.star(VertexId::GHOST) {
            spread.flood(self, ghost, 0)?;
        }
        for depth in 1.. {
            let seeds = std::mem::take(&mut spread.beyond);
            if seeds.is_empty() {
                break;
            }
            for f in seeds {
                let part = depths.len() as u32;
                if spread.flood(self, f, part)? {
                    depths.push(depth);
                }
            }
        }
        Ok(Components {
            of: spread.of,
            depths,
        })
    }

    /// The parts that hold the seeds, one for each.
    ///
    /// Takes for each seed the time of a walk, √n on average.
    ///
    /// # Errors
    /// The first [`SeedError`].
    pub fn parts_at(
        &self,
        components: &Components,
        seeds: &[DVec2],
    ) -> Result<Vec<usize>, SeedError> {
        let mut near = VertexId::GHOST;
        let numbered = seeds.iter().enumerate();
        let part = |(seed, &place): (usize, &DVec2)| {
            check_point2(seed, place)?;
            let location = self.locate_near(place, near)?;
            let face = self.face_at(location, seed, place)?;
            near = self.mesh.face_vertices(face)[0];
            match components.of(face) {
                0 => Err(SeedError::Outside { seed, place }),
                part => Ok(part),
            }
        };
        numbered.map(part).collect()
    }

    /// A face round a location that is in the only part there.
    fn face_at(&self, location: Location, seed: usize, place: DVec2) -> Result<FaceId, SeedError> {
        let on = |h: HalfEdgeId| self.segment_of(h);
        let (face, segment) = match location {
            Location::Face(f) => (f, None),
            Location::Edge(h) => (h.face(), on(h)),
            Location::Outside(h) => (self.mesh.twin(h).face(), None),
            Location::Vertex(v) => {
                let face = self
                    .mesh
                    .outgoing(v)
                    .map_or(FaceId::new(0), HalfEdgeId::face);
                (face, self.mesh.around(v).find_map(on))
            }
        };
        match segment {
            Some(segment) => Err(SeedError::OnSegment {
                seed,
                place,
                segment,
            }),
            None => Ok(face),
        }
    }
}

const UNKNOWN: u32 = u32::MAX;

/// Parts while they are found.
struct Spread<'a> {
    of: Vec<u32>,
    /// Faces across segments from those found.
    beyond: Vec<FaceId>,
    meter: Meter<'a>,
}

impl Spread<'_> {
    /// Gives `part` to all faces that hang together with `first`; `false` when it has one already.
    fn flood(
        &mut self,
        constrained: &Constrained2,
        first: FaceId,
        part: u32,
    ) -> Result<bool, Cancelled> {
        if self.of[first.index()] != UNKNOWN {
            return Ok(false);
        }
        self.of[first.index()] = part;
        let mut pending = vec![first];
        while let Some(f) = pending.pop() {
            self.meter.advance()?;
            for h in f.half_edges() {
                let across = constrained.mesh.twin(h).face();
                if self.of[across.index()] != UNKNOWN {
                    continue;
                }
                if constrained.is_constrained(h) {
                    self.beyond.push(across);
                } else {
                    self.of[across.index()] = part;
                    pending.push(across);
                }
            }
        }
        Ok(true)
    }
}
