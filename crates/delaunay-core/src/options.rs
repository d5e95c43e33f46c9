//! How a bulk build runs.

use crate::order::Order;
use std::num::NonZeroUsize;

/// Fewer points are not worth a thread.
const LEAST_POINTS: usize = 4096;

/// How a bulk build runs. What it builds is the same triangulation for all options; the numbers of its
/// simplices depend on `threads`.
///
/// ```
/// use delaunay_core::BuildOptions;
///
/// let options = BuildOptions { huge_pages: false, ..BuildOptions::on_threads(2) };
/// assert_eq!(options.threads.get(), 2);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BuildOptions {
    /// Into how many parts the work is cut that can be done at the same time. They run in the current pool of
    /// `rayon`, by default with a thread for each core; with 1, all is done on the caller's thread.
    pub threads: NonZeroUsize,
    /// Whether large arrays are asked for in large pages, which saves about a fifth of the time. Only
    /// on Linux; elsewhere the system decides.
    pub huge_pages: bool,
}

impl BuildOptions {
    /// On this many threads, at least one, in large pages.
    #[must_use]
    pub fn on_threads(threads: usize) -> Self {
        Self {
            threads: NonZeroUsize::new(threads).unwrap_or(NonZeroUsize::MIN),
            huge_pages: true,
        }
    }

    /// On as many threads as the machine can run at the same time, in large pages.
    #[must_use]
    pub fn on_all_cores() -> Self {
        Self::on_threads(std::thread::available_parallelism().map_or(1, NonZeroUsize::get))
    }

    /// These options for so many points: with no more threads than parts that the points can be cut into.
    pub(crate) fn for_points(self, count: usize) -> Self {
        let parts = (count / LEAST_POINTS + 1).min(Order::STRETCHES / 2);
        let threads = self.threads.get().min(parts);
        Self {
            threads: NonZeroUsize::new(threads).unwrap_or(NonZeroUsize::MIN),
            ..self
        }
    }
}

impl Default for BuildOptions {
    /// On one thread, in large pages.
    fn default() -> Self {
        Self::on_threads(1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::progress::silent;
    use crate::{Delaunay2, Delaunay3};
    use glam::{DVec2, DVec3};

    #[test]
    fn few_points_and_parts_take_few_threads() {
        let all = BuildOptions::on_threads(usize::MAX);
        assert_eq!(all.for_points(0).threads.get(), 1);
        assert_eq!(all.for_points(10_000).threads.get(), 3);
        assert_eq!(all.for_points(usize::MAX).threads.get(), 128);
        assert_eq!(
            BuildOptions::on_threads(2)
                .for_points(1_000_000)
                .threads
                .get(),
            2
        );
    }

    /// Numbers of threads were multiplied and added before they were compared with the points.
    #[test]
    fn any_number_of_threads_will_do() {
        let options = BuildOptions::on_threads(usize::MAX);
        let number = |i: usize, step: f64| (i as f64 * step).fract();
        let plane: Vec<DVec2> = (1..20_000)
            .map(|i| DVec2::new(number(i, 0.7548), number(i, 0.5698)))
            .collect();
        let flat = Delaunay2::build_on(&plane, options, &mut silent);
        assert_eq!(flat.map(|d| d.check()), Ok(Ok(())));
        let space: Vec<DVec3> = plane
            .iter()
            .zip(1..)
            .map(|(p, i)| p.extend(number(i, 0.8191)))
            .collect();
        let solid = Delaunay3::build_on(&space, options, &mut silent);
        assert_eq!(solid.map(|d| d.check()), Ok(Ok(())));
    }
}
