//! Chores of the workspace: the figures of the papers, with our numbers beside theirs; surfaces that are hard to mesh,
//! made and fetched.

#![expect(clippy::print_stdout, reason = "a program for the terminal")]

pub mod figures;
pub mod gallery;
pub mod models;
pub mod solids;
pub mod update;
