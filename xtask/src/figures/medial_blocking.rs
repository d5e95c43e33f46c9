//! Guoy & Erickson, *Automatic blocking scheme for structured meshing in 2D multiphase flow simulation*.

use super::Figure;

/// Figures 2 to 9 and 12 to 14.
pub const FIGURES: &[Figure] = &[];
