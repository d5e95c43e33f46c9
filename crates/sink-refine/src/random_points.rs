//! Random points of simplices: the same ones whenever an element comes.

use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::iter::Sum;
use std::ops::Mul;

/// Random points that depend on an element alone.
#[derive(Debug)]
pub(crate) struct RandomPoints(ChaCha8Rng);

impl RandomPoints {
    /// Those of the element with these coordinates, in any order of its corners.
    pub(crate) fn of(coordinates: impl Iterator<Item = f64>) -> Self {
        let mixed = coordinates.map(|x| {
            x.to_bits()
                .wrapping_mul(0x9e37_79b9_7f4a_7c15)
                .rotate_left(31)
        });
        Self(ChaCha8Rng::seed_from_u64(mixed.fold(0, u64::wrapping_add)))
    }

    /// The next point, strictly inside the simplex of these corners up to rounding.
    pub(crate) fn next_in<V, const N: usize>(&mut self, corners: [V; N]) -> V
    where
        V: Mul<f64, Output = V> + Sum,
    {
        let shares: [f64; N] = std::array::from_fn(|_| self.0.random_range(0.01..1.0));
        let total: f64 = shares.iter().sum();
        let weighted = corners.into_iter().zip(shares);
        weighted
            .map(|(corner, share)| corner * (share / total))
            .sum()
    }
}
