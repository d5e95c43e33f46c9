//! What makes an element one of low quality: its ratio r/l (§4.3), and beyond the paper its size.

/// Ratio and size of an element.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Quality {
    /// (r/l)².
    pub(crate) squared_ratio: f64,
    /// The square of r over the largest that is allowed: 0 where no size is asked for, not a number where the size is unusable.
    pub(crate) squared_size: f64,
}

impl Quality {
    /// That of no element.
    pub(crate) const NONE: Self = Self {
        squared_ratio: 0.0,
        squared_size: 0.0,
    };

    /// Whether r/l exceeds `bound`, or the element is too large.
    pub(crate) fn is_low(self, bound: f64) -> bool {
        self.squared_ratio > bound * bound || self.is_too_large()
    }

    /// Whether the element is too large.
    pub(crate) fn is_too_large(self) -> bool {
        self.squared_size > 1.0
    }

    /// The squared ratio; of an element that is worse for its size than for its ratio, the squared ratio that would be
    /// as bad.
    pub(crate) fn badness(self, bound: f64) -> f64 {
        self.squared_ratio.max(bound * bound * self.squared_size)
    }

    /// By how much the badness exceeds that of the bound, as a logarithm.
    pub(crate) fn excess(self, bound: f64) -> f64 {
        let of_ratio = (self.squared_ratio / (bound * bound)).ln();
        of_ratio.max(self.squared_size.ln())
    }

    pub(crate) fn ratio(self) -> f64 {
        self.squared_ratio.sqrt()
    }

    /// r over the largest that is allowed; 0 where no size is asked for, or an unusable one.
    pub(crate) fn size(self) -> f64 {
        self.squared_size.max(0.0).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(ratio: f64, size: f64) -> Quality {
        Quality {
            squared_ratio: ratio * ratio,
            squared_size: size * size,
        }
    }

    #[test]
    fn without_a_size_badness_is_the_squared_ratio() {
        for unsized_ in [of(3.0, 0.0), of(3.0, f64::NAN)] {
            assert_eq!(unsized_.badness(2.0), 9.0);
            assert_eq!(unsized_.excess(2.0), (9.0_f64 / 4.0).ln());
            assert_eq!(unsized_.size(), 0.0);
            assert!(unsized_.is_low(2.0) && !unsized_.is_low(3.0));
        }
    }

    #[test]
    fn twice_too_large_is_as_bad_as_twice_the_ratio() {
        let [large, skinny] = [of(0.6, 2.0), of(4.0, 0.1)];
        assert!(large.is_low(2.0) && skinny.is_low(2.0));
        assert_eq!(large.badness(2.0), skinny.badness(2.0));
        assert_eq!(large.excess(2.0), skinny.excess(2.0));
    }

    #[test]
    fn sizes_count_without_a_bound_on_the_ratio_too() {
        assert!(of(1e3, 1.5).is_low(f64::MAX));
        assert!(!of(1e3, 0.5).is_low(f64::MAX));
        assert!(of(1e3, 1.5).excess(f64::MAX) > 0.0);
    }
}
