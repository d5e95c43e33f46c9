//! Whether a model is what every mesher must accept, after its points are merged by place.

use std::path::Path;

use glam::DVec3;
use mesh_io::{Cell, read_mesh};

use crate::solids::check::{defect, defect_but_intersection};
use crate::solids::skin::Skin;

/// What is said of a model.
pub(super) struct Verdict {
    /// Triangles, those without area left out when two corners are at one place.
    pub(super) triangles: usize,
    /// Whether it is closed, without degenerate triangles, and without intersections.
    pub(super) is_valid: bool,
    /// `valid`, the first defect, or why it was not read.
    pub(super) text: String,
}

/// Reads and judges a model; quads are split between their first and third corners. Beyond 400,000 triangles, intersections are not
/// looked for, and the model not called valid.
pub(super) fn judged(path: &Path) -> Verdict {
    const MOST: usize = 400_000;
    let mesh = match read_mesh(path) {
        Ok(mesh) => mesh,
        Err(error) => {
            let text = format!("not read: {error}");
            // The path is in the list already.
            let text = text
                .replace(&path.display().to_string(), "")
                .replace(['\t', '\n'], " ");
            return Verdict {
                triangles: 0,
                is_valid: false,
                text,
            };
        }
    };
    let mut skin = Skin::default();
    let mut add = |corners: [u32; 3]| {
        skin.triangle(corners.map(|v| DVec3::from(mesh.points[v as usize])));
    };
    for cell in mesh.cells.iter() {
        match cell {
            Cell::Triangle(corners) => add(corners),
            Cell::Quad([a, b, c, d]) => {
                add([a, b, c]);
                add([a, c, d]);
            }
            _ => {}
        }
    }
    let solid = skin.into_solid("model");
    let triangles = solid.triangles.len();
    let found = if triangles <= MOST {
        defect(&solid)
    } else {
        defect_but_intersection(&solid)
    };
    let text = match found {
        // All that is wrong can take several lines.
        Some(defect) => defect.replace('\n', " "),
        None if triangles > MOST => "closed, not searched for intersections".to_owned(),
        None => "valid".to_owned(),
    };
    Verdict {
        triangles,
        is_valid: text == "valid",
        text,
    }
}
