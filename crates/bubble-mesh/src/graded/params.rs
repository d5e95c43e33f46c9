//! What can be asked for, and how it ended.

use delaunay_core::progress::Cancelled;
use glam::DVec2;
use thiserror::Error;

/// How to mesh beyond the paper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GradedParams {
    /// Edges inside over those that the boundary asks for; 0.85, above 0. Smaller values make more triangles.
    pub scale: f64,
    /// Steps of the forces between neighbours; 100.
    pub relaxation: usize,
    /// At most this many sweeps of the optimization; 60.
    pub sweeps: usize,
    /// Changes of connectivity that are tried, the worst triangles first; none by default. With a thousand for a thousand nodes
    /// the mean ratio gains about three thousandths, in a tenth of a second.
    pub trials: usize,
    /// How fast sizes may grow with the distance from a boundary node; 0.5, above 0. They are means of the boundary's sizes else.
    pub grade: f64,
    /// Boundary nodes slide along the smooth curve through them where the boundary turns by at most this angle, in radians, from 0 on;
    /// without it, which is usual, all of them stay where they are.
    pub sliding: Option<f64>,
    /// At most this many nodes, those of the boundary included; a million.
    pub nodes: usize,
}

impl Default for GradedParams {
    fn default() -> Self {
        Self {
            scale: 0.85,
            relaxation: 100,
            sweeps: 60,
            trials: 0,
            grade: 0.5,
            sliding: None,
            nodes: 1_000_000,
        }
    }
}

/// Why it ended. The mesh is valid in every case.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stop {
    /// All was done.
    Done,
    /// The budget of nodes is used up; what was placed is optimized.
    OutOfNodes,
    /// The report closure stopped it.
    Cancelled,
}

impl From<Cancelled> for Stop {
    fn from(_: Cancelled) -> Self {
        Self::Cancelled
    }
}

/// Why nothing is meshed.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum GradedError {
    /// The scale is no scale.
    #[error("the scale {scale} is not a finite number above 0")]
    Scale {
        /// As given.
        scale: f64,
    },
    /// The gradation is none.
    #[error("the gradation {grade} is not a finite number above 0")]
    Grade {
        /// As given.
        grade: f64,
    },
    /// The angle up to which boundary nodes slide is none.
    #[error("the crease {crease} is not an angle from 0 on")]
    Crease {
        /// As given, in radians.
        crease: f64,
    },
    /// The caller's size is no size.
    #[error("the size at ({}, {}) is {size}, not a finite number above 0", .place.x, .place.y)]
    Size {
        /// Where.
        place: DVec2,
        /// As given.
        size: f64,
    },
}

impl GradedParams {
    pub(super) fn check(&self) -> Result<(), GradedError> {
        let is_positive = |number: f64| number > 0.0 && number < f64::INFINITY;
        let scale = self.scale;
        if !is_positive(scale) {
            return Err(GradedError::Scale { scale });
        }
        let grade = self.grade;
        if !is_positive(grade) {
            return Err(GradedError::Grade { grade });
        }
        match self.sliding {
            Some(crease) if crease.is_nan() || crease < 0.0 => Err(GradedError::Crease { crease }),
            _ => Ok(()),
        }
    }
}
