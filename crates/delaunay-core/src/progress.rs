//! Progress reports and cancellation, the same for every long loop.
//!
//! The caller passes a closure; the loop calls it now and then with a [`Progress`] and stops when
//! it answers [`ControlFlow::Break`]. [`Meter`] keeps the calls rare, so that counting costs
//! nothing in a hot loop.
//!
//! ```
//! use delaunay_core::progress::{Meter, Progress};
//! use std::ops::ControlFlow;
//!
//! let mut seen = Vec::new();
//! let mut report = |progress: Progress| {
//!     seen.push(progress.done);
//!     if progress.done >= 8192 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
//! };
//! let mut meter = Meter::start(&mut report, "insert", 1_000_000)?;
//! let stopped = (0..1_000_000).try_for_each(|_| meter.advance());
//! assert_eq!(stopped.unwrap_err().done, 8192);
//! assert_eq!(seen, [0, 4096, 8192]);
//! # Ok::<(), delaunay_core::progress::Cancelled>(())
//! ```

use std::fmt;
use std::ops::ControlFlow;

/// Steps between two reports.
const STRIDE: usize = 4096;

/// How far a loop has come.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Progress {
    /// What the loop does, one or two words for a progress bar.
    pub stage: &'static str,
    /// Steps taken.
    pub done: usize,
    /// Steps in all, as far as known.
    pub total: usize,
}

/// A loop was stopped by its report closure.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("cancelled in stage '{stage}' after {done} of {total} steps")]
pub struct Cancelled {
    /// What the loop did.
    pub stage: &'static str,
    /// Steps taken.
    pub done: usize,
    /// Steps in all.
    pub total: usize,
}

/// The report closure that says nothing and never stops.
pub fn silent(_: Progress) -> ControlFlow<()> {
    ControlFlow::Continue(())
}

/// Counts the steps of one loop and reports every 4096th.
pub struct Meter<'a> {
    report: &'a mut dyn FnMut(Progress) -> ControlFlow<()>,
    progress: Progress,
}

impl<'a> Meter<'a> {
    /// A meter at 0 of `total` steps, which it reports.
    ///
    /// # Errors
    /// [`Cancelled`] when the closure stops the loop before its first step.
    pub fn start(
        report: &'a mut dyn FnMut(Progress) -> ControlFlow<()>,
        stage: &'static str,
        total: usize,
    ) -> Result<Self, Cancelled> {
        let progress = Progress {
            stage,
            done: 0,
            total,
        };
        let mut meter = Self { report, progress };
        meter.tell()?;
        Ok(meter)
    }

    /// Counts one step.
    ///
    /// # Errors
    /// [`Cancelled`] when a report is due and the closure stops the loop.
    #[inline]
    pub fn advance(&mut self) -> Result<(), Cancelled> {
        self.progress.done += 1;
        if self.progress.done.is_multiple_of(STRIDE) {
            return self.tell();
        }
        Ok(())
    }

    /// Takes note of steps that turn out to be needed beyond those known of.
    pub fn expect(&mut self, more: usize) {
        self.progress.total += more;
    }

    /// Counts all steps up to `done`, however many they are, and reports.
    ///
    /// # Errors
    /// [`Cancelled`] when the closure stops the loop.
    pub fn reach(&mut self, done: usize) -> Result<(), Cancelled> {
        self.progress.done = done;
        self.tell()
    }

    #[cold]
    fn tell(&mut self) -> Result<(), Cancelled> {
        let Progress { stage, done, total } = self.progress;
        match (self.report)(self.progress) {
            ControlFlow::Continue(()) => Ok(()),
            ControlFlow::Break(()) => Err(Cancelled { stage, done, total }),
        }
    }
}

impl fmt::Debug for Meter<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Meter").field(&self.progress).finish()
    }
}
