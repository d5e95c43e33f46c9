//! Chores of the workspace: `cargo xtask figures`.

#![expect(clippy::print_stderr, reason = "a program for the terminal")]

use std::process::ExitCode;

use clap::{Parser, Subcommand};
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
}

fn main() -> ExitCode {
    let Chore::Figures(args) = Cli::parse().chore;
    match update::figures(&args) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}
