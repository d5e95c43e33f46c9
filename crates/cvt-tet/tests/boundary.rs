//! Meshes that cover their region: points on the boundary stay there and the cost still falls.

use cvt_tet::{Generators, Params, Place, lloyd};
use delaunay_core::ConvexPolygon;
use delaunay_core::measure::triangle;
use delaunay_core::progress::silent;
use glam::DVec2;
use proptest::prelude::*;

const PARAMS: Params = Params {
    iterations: 40,
    tolerance: -1.0,
};

fn points() -> impl Strategy<Value = Vec<DVec2>> {
    let point = prop::array::uniform2(0.1..0.9f64).prop_map(DVec2::from);
    prop::collection::vec(point, 30..60)
}

/// A square or a slanted quadrilateral around the points, whose edges no number hits exactly.
fn regions() -> [ConvexPolygon; 2] {
    let square = ConvexPolygon::rectangle(DVec2::ZERO, DVec2::ONE).expect("a rectangle");
    let slanted = [[0.1, -0.3], [1.3, 0.2], [0.9, 1.4], [-0.3, 0.8]].map(DVec2::from);
    [
        square,
        ConvexPolygon::new(slanted.to_vec()).expect("four left turns"),
    ]
}

/// Free first, then attached to the boundary.
fn attached(region: &ConvexPolygon, points: &[DVec2]) -> Option<Generators> {
    let start = Generators::new(region.clone(), points).ok()?;
    lloyd(start, &PARAMS, &mut silent)
        .generators
        .attached()
        .ok()
}

fn mesh_area(generators: &Generators) -> f64 {
    let triangles = generators
        .triangles()
        .map(|f| generators.delaunay().triangle(f));
    triangles.map(triangle::signed_area).sum()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn the_mesh_covers_the_region(points in points()) {
        for region in regions() {
            let Some(start) = attached(&region, &points) else { return Ok(()) };
            let outcome = lloyd(start, &PARAMS, &mut silent);
            prop_assert!((mesh_area(&outcome.generators) - region.area()).abs() < 1e-9);
            prop_assert_eq!(outcome.generators.delaunay().vertex_count(), points.len());
        }
    }

    #[test]
    fn the_cost_never_rises_with_points_bound_to_the_boundary(points in points()) {
        for region in regions() {
            let Some(start) = attached(&region, &points) else { return Ok(()) };
            let outcome = lloyd(start, &PARAMS, &mut silent);
            for pair in outcome.costs.windows(2) {
                prop_assert!(pair[1] <= pair[0] * (1.0 + 1e-13));
            }
        }
    }

    #[test]
    fn bound_points_keep_to_their_places(points in points()) {
        let [square, _] = regions();
        let Some(start) = attached(&square, &points) else { return Ok(()) };
        let outcome = lloyd(start.clone(), &PARAMS, &mut silent);
        prop_assert_eq!(start.places(), outcome.generators.places());
        for (point, place) in outcome.generators.points().iter().zip(outcome.generators.places()) {
            match place {
                Place::Inside => prop_assert!(point.cmpgt(DVec2::ZERO).all() && point.cmplt(DVec2::ONE).all()),
                Place::Edge(0) => prop_assert_eq!(point.y, 0.0),
                Place::Edge(1) => prop_assert_eq!(point.x, 1.0),
                Place::Edge(2) => prop_assert_eq!(point.y, 1.0),
                Place::Edge(_) => prop_assert_eq!(point.x, 0.0),
                Place::Corner(corner) => prop_assert_eq!(*point, square.corners()[*corner]),
            }
        }
        let corners = start.places().iter().filter(|place| matches!(place, Place::Corner(_)));
        prop_assert_eq!(corners.count(), 4);
    }
}

#[test]
fn three_points_in_a_square_take_three_corners() {
    let [square, _] = regions();
    let points = [[0.2, 0.3], [0.8, 0.2], [0.5, 0.8]].map(DVec2::from);
    let attached = Generators::new(square, &points)
        .unwrap()
        .attached()
        .unwrap();
    let corners = attached
        .places()
        .iter()
        .filter(|place| matches!(place, Place::Corner(_)));
    assert_eq!(corners.count(), 3);
}
