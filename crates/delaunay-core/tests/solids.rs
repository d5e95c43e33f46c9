//! What a surface encloses: the solids of the sink paper, and surfaces made of tetrahedra that are known.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

mod clouds;

use clouds::space::{lattice, rng, sphere, uniform};
use delaunay_core::progress::silent;
use delaunay_core::{
    BuildOptions, Delaunay3, Solid, SolidError, Surface, SurfaceError, TetId, VertexId,
};
use fixtures::surfaces::{self, Triangles};
use glam::DVec3;
use proptest::prelude::*;
use rand::RngExt;
use std::collections::BTreeSet;

fn solid(surface: &Surface) -> Result<Solid, SolidError> {
    surface.solid(BuildOptions::default(), &mut silent)
}

fn surface_of(set: Triangles) -> Surface {
    let named = set
        .triangles
        .into_iter()
        .map(|corners| corners.map(VertexId::new));
    Surface::new(set.points, named.collect()).unwrap()
}

/// The volume within a surface whose triangles are counterclockwise seen from outside.
fn enclosed_volume(surface: &Surface) -> f64 {
    let cone = |corners: &[VertexId; 3]| {
        let [a, b, c] = corners.map(|v| surface.points()[v.index()]);
        a.cross(b).dot(c) / 6.0
    };
    surface.triangles().iter().map(cone).sum()
}

fn volume_inside(solid: &Solid) -> f64 {
    let volume = |t: TetId| {
        let [a, b, c, d] = solid.delaunay().tetrahedron(t);
        (b - a).cross(c - a).dot(d - a) / 6.0
    };
    solid.tets().map(volume).sum()
}

fn assert_close(found: f64, expected: f64) {
    assert!(
        (found - expected).abs() <= 1e-9 * expected.abs(),
        "{found} is not {expected}"
    );
}

#[test]
fn the_solids_of_the_sink_paper_have_the_tetrahedra_of_their_reconstruction() {
    for (name, set, count) in [
        ("cuboctahedron", surfaces::cuboctahedron(), 14_658),
        ("paraboloid", surfaces::paraboloid(), 10_316),
        ("star", surfaces::star(), 79_153),
        ("head", surfaces::head(), 100_825),
    ] {
        let surface = surface_of(set);
        let solid = solid(&surface).unwrap();
        assert_eq!(solid.tets().count(), count, "{name}");
        assert_close(volume_inside(&solid), enclosed_volume(&surface));
    }
}

#[test]
fn the_star_fills_the_bore_of_the_head() {
    let [head, star] =
        [surfaces::head(), surfaces::star()].map(|set| solid(&surface_of(set)).unwrap());
    // A cylinder of radius 2 and length 4, in 154 flat sides.
    let side = std::f64::consts::TAU / 154.0;
    let cylinder = 4.0 * 154.0 * 2.0 * side.sin();
    assert_close(volume_inside(&head) + volume_inside(&star), cylinder);
}

/// The surface round the tetrahedra that are kept; none when there are none.
fn surface_round(delaunay: &Delaunay3, keep: impl Fn(TetId) -> bool) -> Option<Surface> {
    let mesh = delaunay.mesh();
    let kept = |t: TetId| !mesh.is_ghost_tet(t) && keep(t);
    let outer = mesh
        .facets()
        .filter(|&f| kept(f.tet()) && !kept(mesh.twin(f).tet()));
    let triangles = outer.map(|f| mesh.facet_vertices(f)).collect();
    Surface::new(delaunay.points().to_vec(), triangles).ok()
}

/// The corners of tetrahedra, whatever their numbers.
fn corners_of(delaunay: &Delaunay3, tets: impl Iterator<Item = TetId>) -> BTreeSet<[VertexId; 4]> {
    let sorted = |t: TetId| {
        let mut corners = delaunay.mesh().tet_vertices(t);
        corners.sort_unstable();
        corners
    };
    tets.map(sorted).collect()
}

/// By tetrahedron a random choice, in which every vertex has one.
fn random_choice(delaunay: &Delaunay3, seed: u64) -> Vec<bool> {
    let mut random = rng(seed);
    let mesh = delaunay.mesh();
    let mut keep: Vec<bool> = (0..mesh.tet_slots()).map(|_| random.random()).collect();
    for v in delaunay.vertices() {
        let mut real = mesh.star(v).filter(|&t| !mesh.is_ghost_tet(t));
        if !real.clone().any(|t| keep[t.index()]) {
            real.next().into_iter().for_each(|t| keep[t.index()] = true);
        }
    }
    keep
}

#[test]
fn a_cube_with_a_cubic_void_is_hollow() {
    let delaunay = Delaunay3::build(&lattice([4, 4, 4])).unwrap();
    let in_void = |t: TetId| {
        let center = delaunay.tetrahedron(t).into_iter().sum::<DVec3>() / 4.0;
        (center - DVec3::splat(1.5)).abs().max_element() < 0.5
    };
    let hollow = surface_round(&delaunay, |t| !in_void(t)).unwrap();
    let solid = solid(&hollow).unwrap();
    assert_close(volume_inside(&solid), 26.0);
    assert_close(enclosed_volume(&hollow), 26.0);
    assert!(solid.delaunay().tets().any(|t| !solid.is_inside(t)));
}

#[test]
fn a_box_without_lid_is_open() {
    let corners = lattice([2, 2, 2]);
    let delaunay = Delaunay3::build(&corners).unwrap();
    let closed = surface_round(&delaunay, |_| true).unwrap();
    let is_lid = |triangle: &&[VertexId; 3]| triangle.iter().all(|v| corners[v.index()].z == 1.0);
    let open = closed
        .triangles()
        .iter()
        .filter(|triangle| !is_lid(triangle));
    let error = Surface::new(corners.clone(), open.copied().collect()).unwrap_err();
    assert!(
        matches!(
            error,
            SurfaceError::Open {
                triangles: 1,
                open_edges: 4,
                ..
            }
        ),
        "{error}"
    );
}

/// A surface round the origin: the hull of directions, each pulled in or out; counterclockwise seen from outside.
fn star_shaped(seed: u64, count: usize, roughness: f64) -> Surface {
    let axes = [
        DVec3::X,
        DVec3::Y,
        DVec3::Z,
        DVec3::NEG_X,
        DVec3::NEG_Y,
        DVec3::NEG_Z,
    ];
    let directions = [axes.to_vec(), sphere(count, seed)].concat();
    let delaunay = Delaunay3::build(&directions).unwrap();
    let hull = surface_round(&delaunay, |_| true).unwrap();
    let mut random = rng(!seed);
    let points = directions
        .iter()
        .map(|p| p * (1.0 + roughness * random.random::<f64>()));
    Surface::new(points.collect(), hull.triangles().to_vec()).unwrap()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// Bodies that touch at corners and along edges, voids, and what else chance makes.
    #[test]
    fn the_boundary_of_any_tetrahedra_gives_them_back(seed in any::<u64>(), count in 5_u32..30, on_lattice: bool) {
        let points = if on_lattice { lattice([2, 3, count / 5 + 1]) } else { uniform(count as usize, seed) };
        let delaunay = Delaunay3::build(&points).unwrap();
        let keep = random_choice(&delaunay, seed);
        let surface = surface_round(&delaunay, |t| keep[t.index()]);
        // None when a vertex has nothing but kept tetrahedra round it.
        prop_assume!(surface.is_some());
        let solid = solid(&surface.unwrap()).unwrap();
        let kept = corners_of(&delaunay, delaunay.tets().filter(|t| keep[t.index()]));
        prop_assert_eq!(corners_of(solid.delaunay(), solid.tets()), kept);
    }

    #[test]
    fn a_convex_surface_encloses_its_volume(seed in any::<u64>(), count in 0_usize..60) {
        let surface = star_shaped(seed, count, 0.0);
        let solid = solid(&surface).unwrap();
        assert_close(volume_inside(&solid), enclosed_volume(&surface));
    }

    #[test]
    fn a_star_shaped_surface_encloses_its_volume_unless_triangles_are_missing(
        seed in any::<u64>(),
        count in 0_usize..60,
        roughness in 0.0..1.0,
    ) {
        let surface = star_shaped(seed, count, roughness);
        match solid(&surface) {
            Ok(solid) => assert_close(volume_inside(&solid), enclosed_volume(&surface)),
            Err(SolidError::MissingTriangles { triangles }) => prop_assert!(!triangles.is_empty()),
            Err(error) => prop_assert!(false, "{error}"),
        }
    }

    /// Two bodies of one volume that overlap: neither is within the other, so their surfaces meet.
    #[test]
    fn a_surface_and_its_copy_near_by_intersect(seed in any::<u64>(), count in 0_usize..40, roughness in 0.0..1.0) {
        let one = star_shaped(seed, count, roughness);
        let step = DVec3::new(0.1, 0.2, 0.05);
        let points = [one.points().to_vec(), one.points().iter().map(|p| p + step).collect()].concat();
        let shift = |v: VertexId| VertexId::new(v.index() + one.points().len());
        let copy = one.triangles().iter().map(|corners| corners.map(shift)).collect();
        let both = Surface::new(points, [one.triangles().to_vec(), copy].concat()).unwrap();
        match solid(&both) {
            Err(SolidError::SelfIntersection { first, second }) => {
                prop_assert!(first < one.triangles().len() && second >= one.triangles().len());
            }
            other => prop_assert!(false, "{other:?}"),
        }
    }
}
