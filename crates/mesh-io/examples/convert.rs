//! Converts a mesh from one format to another: `cargo run -p mesh-io --example convert -- surface.off surface.vtu`.
//!
//! Without arguments it writes and reads a pair of triangles in the folder for temporary files.

#![allow(clippy::print_stdout, reason = "an example may print")]

use std::error::Error;
use std::path::{Path, PathBuf};

use mesh_io::{Cell, Cells, Mesh, read_mesh, write_mesh};

fn main() -> Result<(), Box<dyn Error>> {
    let paths: Vec<PathBuf> = std::env::args_os().skip(1).map(PathBuf::from).collect();
    match paths.as_slice() {
        [] => {
            let folder = std::env::temp_dir();
            let (from, to) = (
                folder.join("two_triangles.off"),
                folder.join("two_triangles.vtu"),
            );
            write_mesh(&from, &two_triangles())?;
            convert(&from, &to)
        }
        [from, to] => convert(from, to),
        _ => Err("give a file to read and a file to write".into()),
    }
}

fn convert(from: &Path, to: &Path) -> Result<(), Box<dyn Error>> {
    let mesh = read_mesh(from)?;
    write_mesh(to, &mesh)?;
    println!(
        "{} points and {} cells from {} in {}",
        mesh.points.len(),
        mesh.cells.len(),
        from.display(),
        to.display()
    );
    Ok(())
}

fn two_triangles() -> Mesh {
    let points = vec![
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [1.0, 1.0, 0.0],
        [0.0, 1.0, 0.0],
    ];
    Mesh::new(
        points,
        Cells::from_iter([Cell::Triangle([0, 1, 2]), Cell::Triangle([0, 2, 3])]),
    )
}
