//! From curves to meshes.

use bubble_mesh::curve::{Curve, Piece, Sampling, sample_all};
use bubble_mesh::graded::{GradedParams, Stop, mesh};
use bubble_mesh::{Domain, radius_ratio};
use delaunay_core::BuildOptions;
use delaunay_core::progress::silent;
use glam::DVec2;

/// The number of triangles and the least radius ratio of the region that the curves bound.
fn meshed(curves: &[Curve], sampling: &Sampling) -> (usize, f64) {
    let sampled = sample_all(curves, sampling).expect("enough nodes");
    let outline = sampled.outline().expect("closed curves");
    let domain = Domain::new(&outline, BuildOptions::default(), &mut silent).expect("a region");
    let mesh = mesh(&domain, &GradedParams::default(), &mut silent).expect("good parameters");
    assert_eq!((mesh.stop, mesh.complex.check()), (Stop::Done, Ok(())));
    let ratios = mesh
        .complex
        .faces()
        .map(|f| radius_ratio(mesh.complex.triangle(f)));
    (ratios.clone().count(), ratios.fold(1.0, f64::min))
}

/// A plate with a spline for its outline; found are 0.914, 0.910, 0.917 and 0.921.
#[test]
fn a_plate_with_a_hole_has_no_poor_triangle() {
    let points = [
        [0.0, 0.0],
        [3.0, -0.5],
        [6.0, 0.0],
        [6.5, 2.0],
        [4.0, 3.0],
        [1.5, 4.5],
        [-0.5, 2.5],
    ];
    let outline = Curve::closed_spline(&points.map(DVec2::from)).expect("a spline");
    let hole = Curve::circle(DVec2::new(1.5, 2.2), 0.6).expect("a circle");
    let curves = [outline, hole];
    for size in [0.6, 0.4, 0.2, 0.1] {
        let (count, least) = meshed(&curves, &Sampling::new(size));
        assert!(
            count > 300 && least > 0.9,
            "{size}: {count} triangles, {least}"
        );
    }
}

/// Corners of a right angle, arcs that meet lines smoothly, holes of several sizes, two of them close to each other; found are 0.825 and 0.914.
#[test]
fn a_bracket_with_narrow_gaps_has_no_bad_triangle() {
    let p = |x: f64, y: f64| DVec2::new(x, y);
    let line = |a, b| Piece::line(a, b).expect("a line");
    let arc = |a, via, b| Piece::arc_through(a, via, b).expect("an arc");
    let s = 0.5_f64.sqrt();
    let outline = Curve::closed(vec![
        line(p(0.0, 0.0), p(5.0, 0.0)),
        arc(p(5.0, 0.0), p(6.0, 1.0), p(5.0, 2.0)),
        line(p(5.0, 2.0), p(3.0, 2.0)),
        arc(p(3.0, 2.0), p(3.0 - s, 3.0 - s), p(2.0, 3.0)),
        line(p(2.0, 3.0), p(2.0, 5.0)),
        line(p(2.0, 5.0), p(0.0, 5.0)),
        line(p(0.0, 5.0), p(0.0, 0.0)),
    ]);
    let circle = |x, y, r| Curve::circle(p(x, y), r).expect("a circle");
    let holes = [
        circle(5.0, 1.0, 0.4),
        circle(1.0, 4.0, 0.4),
        circle(1.0, 1.0, 0.5),
        circle(1.8, 1.0, 0.1),
    ];
    let curves = [vec![outline.expect("a chain")], holes.to_vec()].concat();
    for size in [0.4, 0.2] {
        let (count, least) = meshed(&curves, &Sampling::new(size));
        assert!(least > 0.8, "{size}: {count} triangles, {least}");
    }
}
