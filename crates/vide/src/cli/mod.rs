//! Parse, dispatch, and tell how it went: exit code 0, 1 for an error in one line, 2 for wrong
//! usage.

mod block;
mod bubble;
mod check;
mod delaunay;
mod failure;
mod number;
mod outline;
mod output;
mod progress;
mod quality;
mod refine;
mod report;

use std::io::Write;
use std::num::NonZeroUsize;
use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Args, Parser, Subcommand};
use rayon::ThreadPoolBuilder;
use vide::delaunay_core::BuildOptions;

use failure::Failure;

/// Meshes a solver can run on, from circles, points and surfaces.
#[derive(Parser)]
#[command(name = "vide", version, about, max_term_width = 100)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Multiblock structured quads around the circles of a DOMAIN.toml
    Block(block::BlockArgs),
    /// Delaunay triangulation of the points of a file
    Delaunay(delaunay::DelaunayArgs),
    /// Whether a surface of triangles bounds bodies, and all that is wrong with it
    ///
    /// Exit code 0 when it does, else 1; of each kind of defect the first 20 are listed, and all of them in the report. Nothing is
    /// changed: what would have to be repaired is said.
    Check(check::CheckArgs),
    /// Quality of the cells of a mesh file
    Quality(quality::QualityArgs),
    /// Graded triangles within a planar outline, as large as its edges ask for and none of them poor
    ///
    /// The outline stays as it is. By default nodes are placed layer by layer and the shapes of the triangles are optimized; with
    /// --paper they are placed at centroids and pushed apart by bubbles.
    Bubble(bubble::BubbleArgs),
    /// Better tetrahedra for a solid, by points inserted within a boundary that stays as it is
    ///
    /// Points are inserted until no tetrahedron has a circumradius of more than R times its shortest edge, or no point may be
    /// inserted; with --size also until none is too large. Of given tetrahedra the triangles of the boundary and all vertices
    /// are kept; the tetrahedra themselves are made anew: those of the Delaunay triangulation of the vertices that are inside.
    Refine(refine::RefineArgs),
}

/// Options that all subcommands share.
#[derive(Args)]
struct Common {
    /// Say nothing but errors
    #[arg(short, long)]
    quiet: bool,
    /// Most threads to use, at most one for each core; the result is the same for every number
    #[arg(long, value_name = "N")]
    threads: Option<NonZeroUsize>,
    /// Write what was made, its quality and how long it took as JSON
    #[arg(long, value_name = "FILE.json")]
    report: Option<PathBuf>,
}

/// Runs the program on the arguments of the process.
pub(crate) fn run() -> ExitCode {
    let outcome = match Cli::parse().command {
        Command::Block(args) => args.common.on_threads(|| block::run(&args)),
        Command::Delaunay(args) => args.common.on_threads(|| delaunay::run(&args)),
        Command::Check(args) => args.common.on_threads(|| check::run(&args)),
        Command::Quality(args) => args.common.on_threads(|| quality::run(&args)),
        Command::Bubble(args) => {
            args.check().unwrap_or_else(|usage| usage.exit());
            args.common.on_threads(|| bubble::run(&args))
        }
        Command::Refine(args) => {
            let method = args.method().unwrap_or_else(|usage| usage.exit());
            args.common.on_threads(|| refine::run(&args, method))
        }
    };
    let outcome = outcome.and_then(|outcome| outcome);
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            // With a closed standard error there is nobody left to tell.
            let _ = writeln!(
                std::io::stderr(),
                "vide: {}",
                one_line(&failure.to_string())
            );
            ExitCode::FAILURE
        }
    }
}

impl Common {
    /// Says something on standard output unless told to be quiet; a reader that has gone away is no
    /// error.
    fn say(&self, text: &str) {
        if !self.quiet {
            let _ = std::io::stdout().write_all(text.as_bytes());
        }
    }

    /// How the kernels of triangulation run on the threads at hand.
    fn build_options() -> BuildOptions {
        BuildOptions::on_threads(rayon::current_num_threads())
    }

    /// Runs `work` on the number of threads asked for.
    fn on_threads<T: Send>(&self, work: impl FnOnce() -> T + Send) -> Result<T, Failure> {
        let available = std::thread::available_parallelism().map_or(1, NonZeroUsize::get);
        let threads = self
            .threads
            .map_or(available, NonZeroUsize::get)
            .min(available);
        let pool = ThreadPoolBuilder::new().num_threads(threads).build()?;
        Ok(pool.install(work))
    }
}

/// Messages of parsers can have line breaks; an error is one line.
fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}
