//! The sizes of regions, kept by element while elements come and go.

use crate::error::RefineError;
use crate::sizing::RegionLimit;

/// The size of the region that each element is in, by the index of the element; infinite where none is asked for.
///
/// A cavity never crosses a boundary, so new elements inherit from those in whose place they are. The entry of an element
/// that is gone keeps its value until another one has its id.
#[derive(Clone, Debug, Default)]
pub(crate) struct RegionSizes {
    /// Shorter than there are elements where those at the end are in regions without a size.
    sizes: Vec<f64>,
}

impl RegionSizes {
    /// The regions of `limits`, each found from the element that `at` gives for its seed, over the `neighbors` of elements.
    ///
    /// # Errors
    /// [`RefineError::RegionSize`], [`RefineError::RegionOutside`].
    pub(crate) fn find<V: Copy, N: IntoIterator<Item = usize>>(
        limits: &[RegionLimit<V>],
        at: impl Fn(V) -> Option<usize>,
        neighbors: impl Fn(usize) -> N,
    ) -> Result<Self, RefineError> {
        let mut regions = Self::default();
        for (region, &RegionLimit { seed, size }) in limits.iter().enumerate() {
            if size.is_nan() || size <= 0.0 {
                return Err(RefineError::RegionSize { region, size });
            }
            if size < f64::INFINITY {
                let seed = at(seed).ok_or(RefineError::RegionOutside { region })?;
                regions.limit(seed, size, &neighbors);
            }
        }
        Ok(regions)
    }

    pub(crate) fn of(&self, element: usize) -> f64 {
        self.sizes.get(element).copied().unwrap_or(f64::INFINITY)
    }

    pub(crate) fn set(&mut self, element: usize, size: f64) {
        if let Some(entry) = self.sizes.get_mut(element) {
            *entry = size;
        } else if size < f64::INFINITY {
            self.sizes.resize(element, f64::INFINITY);
            self.sizes.push(size);
        }
    }

    /// Limits the region that contains `seed`: all elements that `neighbors` leads to from there. Linear in their number.
    ///
    /// All of a region have one size, so the search does not enter a region again, nor one with a smaller size.
    fn limit<N: IntoIterator<Item = usize>>(
        &mut self,
        seed: usize,
        size: f64,
        neighbors: impl Fn(usize) -> N,
    ) {
        let mut pending = vec![seed];
        while let Some(here) = pending.pop() {
            if self.of(here) > size {
                self.set(here, size);
                pending.extend(neighbors(here));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_region_has_the_least_of_its_sizes() {
        // Two rows: 0 1 2 and 3 4 5.
        let neighbors = |i: usize| [(i / 3) * 3 + (i + 1) % 3, (i / 3) * 3 + (i + 2) % 3];
        let mut sizes = RegionSizes::default();
        for (seed, size) in [(4, 2.0), (3, 1.0), (5, 3.0)] {
            sizes.limit(seed, size, neighbors);
        }
        let all: Vec<f64> = (0..7).map(|i| sizes.of(i)).collect();
        let none = f64::INFINITY;
        assert_eq!(all, [none, none, none, 1.0, 1.0, 1.0, none]);
    }

    #[test]
    fn an_id_given_out_again_has_the_size_of_its_new_element() {
        let mut sizes = RegionSizes::default();
        sizes.set(2, f64::INFINITY);
        sizes.set(1, 0.5);
        sizes.set(1, f64::INFINITY);
        sizes.set(3, 0.25);
        let all: Vec<f64> = (0..5).map(|i| sizes.of(i)).collect();
        let none = f64::INFINITY;
        assert_eq!(all, [none, none, none, 0.25, none]);
    }
}
