//! What is written, and how it is compared.

use mesh_io::{Mesh, WriteError};

/// What a writer puts into a file.
pub(crate) fn file(write: impl FnOnce(&mut Vec<u8>) -> Result<(), WriteError>) -> Vec<u8> {
    let mut out = Vec::new();
    write(&mut out).expect("memory takes what is written");
    out
}

/// Tells `-0.0` from `0.0`, which `==` does not.
pub(crate) fn bits(mesh: &Mesh) -> String {
    format!("{mesh:?}")
}
