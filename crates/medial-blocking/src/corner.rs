//! Corners of triangles: boundary samples moved by whole periods.

use glam::DVec2;

use crate::domain::Domain;
use crate::sample::{SampleId, Samples};
use crate::wall::{Shift, WallImage};

/// A corner: a sample moved by whole periods.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Corner {
    /// The sample.
    pub sample: SampleId,
    /// The periods by which it is moved; zero in a bounded domain.
    pub shift: Shift,
}

impl Corner {
    pub(crate) fn moved(self, by: Shift) -> Self {
        Self {
            shift: self.shift + by,
            ..self
        }
    }

    pub(crate) fn key(self) -> (SampleId, [i32; 2]) {
        (self.sample, self.shift.to_array())
    }
}

/// The image of the wall on which a corner lies.
pub(crate) fn wall_image(samples: &Samples, corner: Corner) -> WallImage {
    WallImage {
        wall: samples.wall(corner.sample),
        shift: corner.shift,
    }
}

/// Where a corner lies.
#[must_use]
pub fn corner_point(domain: &Domain, samples: &Samples, corner: Corner) -> DVec2 {
    samples.points()[corner.sample.index()] + domain.translation(corner.shift)
}
