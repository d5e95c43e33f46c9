//! `OpenFOAM`'s `blockMeshDict`: what `blockMesh` needs to make the mesh of structured blocks, one cell thick.
//!
//! Corners of blocks become vertices, merged where sides are connected, once at `z = 0` and once at `z` = thickness. Every block is a `hex`
//! whose first four vertices turn counterclockwise, with its cell counts and `simpleGrading (1 1 1)`. Every curve between two vertices that
//! is not divided evenly along a straight line is a `polyLine` through its nodes, front and back. Sides with a patch name are in
//! a `wall` of that name, with characters that `OpenFOAM` does not allow replaced by `_`; sides that meet through a shift are in pairs of `cyclic`
//! patches, `periodic1_low` and `periodic1_high` and so on, one pair for every shift; front and back are `frontAndBack`, which is `empty`.
//!
//! `blockMesh` names a curve by its two ends. Where two curves have the same ends, or a curve ends where it starts, the blocks along it
//! are cut in two or three, so there may be more blocks in the file than were given; cells and nodes stay what they are.
//!
//! # Limits
//!
//! `blockMesh` divides a `polyLine` evenly by its length and fills blocks from their edges by its own transfinite rule. Nodes on curves come back
//! where they were as far as they were evenly spaced along their polygon; other spacing is lost. Nodes inside come back up to the
//! difference between the two rules. The blocks must lie in the plane `z = 0`. Nothing reads the format here.
//!
//! The format: `OpenFOAM` User Guide, section "Mesh generation with the blockMesh utility".

mod curves;
mod patches;
mod split;
mod unsupported;
mod vertices;
mod write;

pub use write::{Thickness, write};
