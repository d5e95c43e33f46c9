//! What `blockMesh` cannot make.

use crate::error::{WriteError, WriteProblem};
use crate::format::Format;

pub(super) fn unsupported(what: String) -> WriteError {
    WriteProblem::Unsupported {
        format: Format::BlockMeshDict,
        what,
    }
    .into()
}
