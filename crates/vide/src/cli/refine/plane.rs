//! Outlines and triangles of the plane.

use vide::mesh_io::Mesh;

use super::{RefineArgs, Refined};
use crate::cli::failure::Failure;

/// Whether a mesh is of the plane: there is something in it, all of it at z = 0 and nothing with a volume.
pub(super) fn holds(mesh: &Mesh) -> bool {
    let flat = mesh.points.iter().all(|&[_, _, z]| z == 0.0);
    let mut kinds = mesh.cells.kinds().iter();
    flat && !mesh.cells.is_empty() && kinds.all(|kind| kind.dimension() < 3)
}

pub(super) fn refine(args: &RefineArgs) -> Result<Refined, Failure> {
    Err(Failure::input(
        &args.input,
        "refinement in the plane is not available yet",
    ))
}
