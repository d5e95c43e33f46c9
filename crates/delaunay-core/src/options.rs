//! How a bulk build runs.

use std::num::NonZeroUsize;

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
}

impl Default for BuildOptions {
    /// On one thread, in large pages.
    fn default() -> Self {
        Self::on_threads(1)
    }
}
