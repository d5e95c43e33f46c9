//! The numbers of the paper, and how long to work.

use crate::error::OptimizeError;

/// What the method of the paper depends on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Params {
    /// At most this many nodes, those of the boundary included.
    pub nodes: usize,
    /// How much larger the node bubbles are in the optimization than in the generation (§3.1): 1.7, so that neighbors
    /// overlap. Above 0 and up to 100.
    pub amplification: f64,
    /// α, how far a force moves a node (eq. 7): 0.1. From 0 to 1; above 0.3 nodes start to swing.
    pub step: f64,
    /// How often positions and sizes are adjusted (§3.6, steps b and c). The paper does not say; after 200 times the mean
    /// radius ratio of its examples has about a hundredth to gain.
    pub iterations: usize,
}

impl Params {
    /// The numbers of the paper, 200 iterations and a million nodes.
    #[must_use]
    pub const fn paper() -> Self {
        Self {
            nodes: 1_000_000,
            amplification: 1.7,
            step: 0.1,
            iterations: 200,
        }
    }

    /// Whether the optimization can work with these numbers.
    pub(super) fn check(&self) -> Result<(), OptimizeError> {
        let Self {
            amplification,
            step,
            ..
        } = *self;
        if !(amplification > 0.0 && amplification <= 100.0) {
            return Err(OptimizeError::Amplification { amplification });
        }
        if !(0.0..=1.0).contains(&step) {
            return Err(OptimizeError::Step { step });
        }
        Ok(())
    }
}

impl Default for Params {
    /// [`Params::paper`].
    fn default() -> Self {
        Self::paper()
    }
}
