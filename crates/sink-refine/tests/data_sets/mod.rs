//! The data sets of the paper, triangulated.

use delaunay_core::progress::silent;
use delaunay_core::{BuildOptions, Outline, Subcomplex2, Subcomplex3, Surface, VertexId};
use fixtures::surfaces::Triangles;
use glam::DVec2;

/// The outline of the planar data set (§5.2).
#[allow(dead_code, reason = "each test program uses its part")]
pub(crate) fn usa() -> Subcomplex2 {
    let usa = fixtures::outlines::usa();
    let points = usa.points.iter().copied().map(DVec2::from).collect();
    let segments = usa.segments.iter();
    let segments = segments.map(|ends| ends.map(|v| VertexId::new(v as usize)));
    let outline = Outline::new(points, segments.collect()).unwrap();
    let region = outline
        .region(BuildOptions::default(), &mut silent)
        .unwrap();
    region.subcomplex()
}

/// What a surface encloses.
#[allow(dead_code, reason = "each test program uses its part")]
pub(crate) fn solid(set: Triangles) -> Subcomplex3 {
    let triangles = set.triangles.iter().map(|t| t.map(VertexId::new));
    let surface = Surface::new(set.points, triangles.collect()).unwrap();
    let solid = surface.solid(BuildOptions::default(), &mut silent).unwrap();
    Subcomplex3::of(solid.delaunay(), |t| solid.is_inside(t))
}
