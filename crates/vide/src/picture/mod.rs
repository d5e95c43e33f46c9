//! Pictures of meshes, composed with [`mesh_io::svg`].
//!
//! A block mesh is shown twice, side by side: as the paper draws it, with a thick medial axis and dotted η-curves over thin mesh
//! lines, and with its cells coloured by quality. Both panels can be had alone.
//!
//! ```
//! use medial_blocking::{Circle, Domain, Params, mesh};
//! use glam::DVec2;
//!
//! let holes = [Circle::new(DVec2::new(-1.0, 0.0), 0.5), Circle::new(DVec2::new(1.0, 0.2), 0.4)];
//! let domain = Domain::in_circle(Circle::new(DVec2::ZERO, 2.5), &holes)?;
//! let svg = vide::picture::block_picture(&mesh(&domain, &Params::default())?, "Two particles").to_svg()?;
//! assert!(svg.contains("data-layer=\"medial axis\""));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod blocks;
mod quality;
mod triangles;

pub use blocks::{block_panel, draw_mesh_lines, draw_scheme, draw_walls, keyed, window_of};
pub use quality::{CellQuality, quality_panel};
pub use triangles::triangle_picture;

use medial_blocking::BlockMesh;
use mesh_io::svg::Picture;

/// The picture of a block mesh: its blocks on the left, the smallest angle of its cells on the right.
///
/// O(cells), and so is the length of the document: some 30 bytes for each node and cell.
#[must_use]
pub fn block_picture(mesh: &BlockMesh, title: &str) -> Picture {
    let picture = Picture::new(title)
        .panel(block_panel(mesh).caption("blocks"))
        .panel(
            quality_panel(mesh, CellQuality::SmallestAngle)
                .caption("cells by their smallest angle"),
        );
    keyed(picture)
}
