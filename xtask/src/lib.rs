//! Chores of the workspace: the figures of the papers, with our numbers beside theirs.

pub mod figures;
pub mod gallery;
pub mod update;
