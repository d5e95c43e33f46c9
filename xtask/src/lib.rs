//! Chores of the workspace: the figures of the papers, with our numbers beside theirs.

#![expect(clippy::print_stdout, reason = "a program for the terminal")]

pub mod figures;
pub mod gallery;
pub mod update;
