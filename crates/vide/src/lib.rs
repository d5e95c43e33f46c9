//! The vide command line, and every Sphère Vide crate behind one dependency.

pub mod picture;
