//! Beyond the paper: graded meshes without a poor triangle.
//!
//! The paper inserts nodes at centroids, which leaves a mesh of many small crystals whose walls no forces can heal. Here nodes are
//! placed in front of what is finished already, so that few walls arise; forces even out their places, and then the
//! shapes themselves are optimized, the worst foremost.
//!
//! | step | file |
//! |---|---|
//! | how large triangles should be where | `size.rs` |
//! | nodes in front of finished triangles | `place.rs` |
//! | forces between neighbours | `relax.rs` |
//! | what poor shapes cost | `energy.rs` |
//! | moves and flips that lower the cost | `optimize.rs`, `smooth.rs` |
//! | changes of connectivity round the worst triangles | `search/` |
//! | the whole, step by step | `mesh.rs`, `params.rs` |

mod energy;
mod mesh;
mod optimize;
mod params;
mod place;
mod relax;
mod search;
mod size;
mod smooth;

pub use mesh::{GradedMesh, mesh, mesh_sized};
pub use params::{GradedError, GradedParams, Stop};
pub use size::Sizing;
