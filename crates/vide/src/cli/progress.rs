//! A progress bar on the terminal's standard error for work that takes longer than a second, and
//! the time of each stage.

use std::collections::BTreeMap;
use std::io::IsTerminal;
use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressFinish, ProgressStyle};
use vide::delaunay_core::progress::Progress;

/// Work that is done sooner shows no bar.
const PATIENCE: Duration = Duration::from_secs(1);

/// Hears of the progress of all stages.
pub(crate) struct Watch {
    visible: bool,
    start: Instant,
    bar: Option<ProgressBar>,
    stages: Vec<(String, f64)>,
}

impl Watch {
    /// A watch that shows its bar on a terminal unless it is to be quiet.
    pub(crate) fn new(quiet: bool) -> Self {
        let visible = !quiet && std::io::stderr().is_terminal();
        Self {
            visible,
            start: Instant::now(),
            bar: None,
            stages: Vec::new(),
        }
    }

    /// Runs one stage of the work and notes how long it takes.
    pub(crate) fn stage<T>(&mut self, name: &str, work: impl FnOnce(&mut Self) -> T) -> T {
        self.show(name, "{msg}");
        let start = Instant::now();
        let result = work(self);
        self.stages
            .push((name.to_owned(), start.elapsed().as_secs_f64()));
        result
    }

    /// Takes a progress report; never stops the work.
    pub(crate) fn report(&mut self, progress: Progress) -> ControlFlow<()> {
        // How much there is to do is not always known.
        let template = match progress.total {
            0 => "{msg:14} {human_pos}",
            _ => "{msg:14} {bar:40} {percent:>3} % {eta:>4}",
        };
        if let Some(bar) = self.show(progress.stage, template) {
            bar.set_length(progress.total as u64);
            bar.set_position(progress.done as u64);
        }
        ControlFlow::Continue(())
    }

    /// Hears of how many sites there are Voronoi cells.
    pub(crate) fn voronoi(&mut self, done: usize, total: usize) {
        let stage = "voronoi";
        // Nothing here can stop the work.
        let _ = self.report(Progress { stage, done, total });
    }

    /// Hears how many bytes are written; how many there will be is not known.
    pub(crate) fn written(&mut self, bytes: u64) {
        if let Some(bar) = self.show("write", "{msg:14} {decimal_bytes}") {
            bar.set_position(bytes);
        }
    }

    /// The bar, in this style, where there is one by now.
    fn show(&mut self, stage: &str, template: &str) -> Option<&ProgressBar> {
        if !self.visible || self.start.elapsed() < PATIENCE {
            return None;
        }
        let bar = self.bar.get_or_insert_with(bar);
        bar.set_style(style(template));
        bar.set_message(stage.to_owned());
        Some(bar)
    }

    /// Every stage so far with its seconds.
    pub(crate) fn seconds(&self) -> BTreeMap<String, f64> {
        self.stages.iter().cloned().collect()
    }
}

/// A bar that is gone when the watch is, however the work ends.
fn bar() -> ProgressBar {
    ProgressBar::new(0).with_finish(ProgressFinish::AndClear)
}

fn style(template: &str) -> ProgressStyle {
    ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar())
}
