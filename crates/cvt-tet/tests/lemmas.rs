//! What the paper says of centroidal Voronoi tessellations, on random points of random convex regions.

use cvt_tet::{Generators, Moments, Params, Stop, cost, cost_with, lloyd, lloyd_with};
use delaunay_core::ConvexPolygon;
use delaunay_core::progress::silent;
use glam::DVec2;
use proptest::prelude::*;

/// Five points of the unit circle, one in each fifth of it.
fn region() -> impl Strategy<Value = ConvexPolygon> {
    prop::array::uniform5(0.0..1.0f64).prop_map(|jitter| {
        let corners = jitter.iter().zip(0..).map(|(jitter, i)| {
            let angle = (f64::from(i) + 0.8 * jitter) * std::f64::consts::TAU / 5.0;
            DVec2::from_angle(angle)
        });
        ConvexPolygon::new(corners.collect()).expect("points of a circle in order")
    })
}

/// Points near the center, which every region contains.
fn points(max: usize) -> impl Strategy<Value = Vec<DVec2>> {
    let coordinate =
        || prop_oneof![4 => -0.2..0.2f64, 1 => (-3..=3).prop_map(|i| f64::from(i) / 16.0)];
    prop::collection::vec((coordinate(), coordinate()).prop_map(DVec2::from), 3..max)
}

fn generators(max: usize) -> impl Strategy<Value = Generators> {
    (region(), points(max)).prop_filter_map("points without tessellation", |(region, points)| {
        Generators::new(region, &points).ok()
    })
}

fn iterations(iterations: usize) -> Params {
    Params {
        iterations,
        tolerance: -1.0,
    }
}

fn moments(generators: &Generators) -> Vec<Moments> {
    let points = generators.points().iter().enumerate();
    points
        .map(|(i, &z)| Moments::uniform(&generators.cell(i), z))
        .collect()
}

/// A density that varies by a factor of about 50 over the unit disk.
fn bump(p: DVec2) -> f64 {
    0.1 + 5.0 * (-4.0 * p.distance_squared(DVec2::new(0.3, 0.1))).exp()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn cells_tile_the_region(generators in generators(40)) {
        let area: f64 = moments(&generators).iter().map(|moments| moments.mass).sum();
        prop_assert!((area - generators.region().area()).abs() < 1e-12);
    }

    #[test]
    fn the_cost_falls_by_the_moved_mass_at_least(generators in generators(40)) {
        // F(V, z) - F(V, c) = sum of m |z - c|², and the Voronoi cells of c are cheaper still.
        let gain: f64 = moments(&generators)
            .iter()
            .map(|moments| moments.first.length_squared() / moments.mass.max(f64::MIN_POSITIVE))
            .sum();
        let before = cost(&generators);
        let after = lloyd(generators, &iterations(1), &mut silent);
        prop_assert!(cost(&after.generators) <= before - gain + 1e-13);
    }

    #[test]
    fn the_cost_never_rises(generators in generators(30)) {
        let outcome = lloyd(generators, &iterations(20), &mut silent);
        prop_assert_eq!(outcome.costs.last(), Some(&cost(&outcome.generators)));
        for pair in outcome.costs.windows(2) {
            prop_assert!(pair[1] <= pair[0] * (1.0 + 1e-14));
        }
    }

    #[test]
    fn the_cost_of_a_density_does_not_rise_beyond_the_error_of_quadrature(generators in generators(30)) {
        let outcome = lloyd_with(generators, bump, &iterations(10), &mut silent).unwrap();
        prop_assert_eq!(outcome.costs.last(), Some(&cost_with(&outcome.generators, bump).unwrap()));
        for pair in outcome.costs.windows(2) {
            prop_assert!(pair[1] <= pair[0] * (1.0 + 1e-2));
        }
    }

    #[test]
    fn points_stay_in_the_region_and_keep_their_count(generators in generators(30)) {
        let (region, count) = (generators.region().clone(), generators.points().len());
        let outcome = lloyd(generators, &iterations(5), &mut silent);
        prop_assert_eq!(outcome.generators.points().len(), count);
        prop_assert!(Generators::new(region, outcome.generators.points()).is_ok());
    }

    #[test]
    fn the_gradient_of_the_cost_is_twice_the_mass_times_the_way_from_the_center(generators in generators(12)) {
        let (first, at) = (moments(&generators)[0], generators.points()[0]);
        let step = 1e-5;
        for axis in [DVec2::X, DVec2::Y] {
            let cost_at = |z: DVec2| {
                let mut points = generators.points().to_vec();
                points[0] = z;
                Generators::new(generators.region().clone(), &points).map(|moved| cost(&moved))
            };
            let (Ok(ahead), Ok(behind)) = (cost_at(at + step * axis), cost_at(at - step * axis)) else {
                return Ok(());
            };
            let slope = (ahead - behind) / (2.0 * step);
            prop_assert!((slope + 2.0 * first.first.dot(axis)).abs() < 1e-3, "{} {:?}", slope, first);
        }
    }

    #[test]
    fn the_cost_is_the_integral_of_the_squared_distance_to_the_nearest_point(
        points in prop::collection::vec(prop::array::uniform2(0.0..1.0f64).prop_map(DVec2::from), 3..10),
    ) {
        let square = ConvexPolygon::rectangle(DVec2::ZERO, DVec2::ONE).unwrap();
        let Ok(generators) = Generators::new(square, &points) else { return Ok(()) };
        let samples = (0..10_000).map(|i| DVec2::new(f64::from(i % 100) + 0.5, f64::from(i / 100) + 0.5) / 100.0);
        let nearest = |x: DVec2| points.iter().map(|z| z.distance_squared(x)).fold(f64::MAX, f64::min);
        let sum: f64 = samples.map(nearest).sum::<f64>() / 10_000.0;
        prop_assert!((cost(&generators) - sum).abs() < 1e-3 * sum.max(0.1));
    }

    #[test]
    fn same_input_gives_the_same_bits(generators in generators(30)) {
        let once = lloyd(generators.clone(), &iterations(5), &mut silent);
        let again = lloyd(generators, &iterations(5), &mut silent);
        prop_assert_eq!(once.generators.points(), again.generators.points());
        prop_assert_eq!(once.costs, again.costs);
    }
}

#[test]
fn at_convergence_every_point_is_the_center_of_its_cell() {
    let square = ConvexPolygon::rectangle(DVec2::ZERO, DVec2::ONE).unwrap();
    let start = (1..=25).map(|i| DVec2::new(f64::from(i * 7 % 26), f64::from(i)) / 27.0);
    let generators = Generators::new(square, &start.collect::<Vec<_>>()).unwrap();
    let params = Params {
        iterations: 5000,
        tolerance: 1e-12,
    };
    let outcome = lloyd(generators, &params, &mut silent);
    assert_eq!(outcome.stop, Stop::Converged);
    for moments in moments(&outcome.generators) {
        assert!((moments.first / moments.mass).length() < 1e-5);
    }
}

#[test]
fn cells_are_smaller_where_the_density_is_greater() {
    // ρ grows from 1 to 16 along the strip, so that the area of a cell should shrink to 1/4: ρ^(-1/2).
    let strip = ConvexPolygon::rectangle(DVec2::ZERO, DVec2::new(3.0, 1.0)).unwrap();
    let density = |p: DVec2| (1.0 + p.x).powi(2);
    let start = (0..75).map(|i| DVec2::new(f64::from(i) / 25.1, f64::from(i * 29 % 75) / 75.1));
    let start: Vec<DVec2> = start.collect();
    let generators = Generators::new(strip, &start).unwrap();
    let params = Params {
        iterations: 3000,
        tolerance: 1e-12,
    };
    let outcome = lloyd_with(generators, density, &params, &mut silent).unwrap();
    let mean_area = |low: f64, high: f64| {
        let inside = outcome
            .generators
            .points()
            .iter()
            .enumerate()
            .filter(|(_, p)| low < p.x && p.x < high);
        let areas: Vec<f64> = inside
            .map(|(i, _)| outcome.generators.cell(i).area())
            .collect();
        areas.iter().sum::<f64>() / areas.len() as f64
    };
    // Mean of 1 / area ~ (1 + x) over [0, 1] and over [2, 3]: 3/2 and 7/2.
    let ratio = mean_area(0.0, 1.0) / mean_area(2.0, 3.0);
    assert!((ratio / (7.0 / 3.0) - 1.0).abs() < 0.15, "{ratio}");
}
