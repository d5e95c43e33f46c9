//! Whether a surface is what every mesher must accept: closed, without degenerate triangles and without self-intersection.

use delaunay_core::{Domain3, Surface, VertexId};

use super::Solid;

/// What is wrong with a surface, in words; `None` for a valid one. Exact.
///
/// n log n and the number of pairs of triangles whose boxes overlap, which is quadratic for needles.
#[must_use]
pub fn defect(solid: &Solid) -> Option<String> {
    let judged = Domain3::new(&solid.points, &corners(solid));
    judged.err().map(|error| error.to_string())
}

/// As [`defect`], the first that is found, but triangles may intersect. n log n.
#[must_use]
pub fn defect_but_intersection(solid: &Solid) -> Option<String> {
    let judged = Surface::new(solid.points.clone(), corners(solid));
    judged.err().map(|error| error.to_string())
}

/// The corners of the triangles. The one index beyond all ids is that of the ghost, which is no point either.
fn corners(solid: &Solid) -> Vec<[VertexId; 3]> {
    let vertex = |v: u32| match v as usize {
        index if index < VertexId::LIMIT => VertexId::new(index),
        _ => VertexId::GHOST,
    };
    let triangles = solid.triangles.iter();
    triangles.map(|corners| corners.map(vertex)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::{DVec3, dvec3};

    fn tetrahedron() -> Solid {
        Solid {
            name: String::new(),
            points: vec![DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z],
            triangles: vec![[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]],
        }
    }

    #[test]
    fn a_tetrahedron_has_no_defect_and_every_defect_is_found() {
        assert_eq!(defect(&tetrahedron()), None);
        assert_eq!(defect_but_intersection(&tetrahedron()), None);
        let broken = |said: &str, breaking: fn(&mut Solid)| {
            let mut solid = tetrahedron();
            breaking(&mut solid);
            for found in [defect(&solid), defect_but_intersection(&solid)] {
                let found = found.unwrap_or_default();
                assert!(found.contains(said), "{found}");
            }
        };
        broken("no triangles", |solid| solid.triangles.clear());
        broken("x = NaN", |solid| solid.points[0].x = f64::NAN);
        broken("triangle 1 has v3", |solid| solid.triangles[1][0] = 3);
        broken("v4", |solid| solid.triangles[1][0] = 4);
        broken("v∞", |solid| solid.triangles[1][0] = u32::MAX);
        broken("v2", |solid| solid.points[2] = dvec3(1.0, -0.0, 0.0));
        broken("v4", |solid| solid.points.push(DVec3::ONE));
        broken("triangle 0 has no area", |solid| {
            solid.points[2] = dvec3(2.0, 0.0, 0.0);
        });
        broken("from v0", |solid| solid.triangles.truncate(3));
    }

    #[test]
    fn two_tetrahedra_through_each_other_are_found() {
        let mut solid = tetrahedron();
        solid
            .points
            .extend(tetrahedron().points.iter().map(|p| *p + 0.1));
        solid.triangles.extend(
            tetrahedron()
                .triangles
                .iter()
                .map(|corners| corners.map(|v| v + 4)),
        );
        let found = defect(&solid).unwrap_or_default();
        assert!(found.contains("intersect"), "{found}");
        assert_eq!(defect_but_intersection(&solid), None);
    }
}
