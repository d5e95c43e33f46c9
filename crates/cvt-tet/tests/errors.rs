//! Bad input is refused with the point, and every way to stop leaves valid points.

use std::ops::ControlFlow;

use cvt_tet::{GeneratorError, Generators, Params, Stop, lloyd, lloyd_with};
use delaunay_core::ConvexPolygon;
use delaunay_core::progress::silent;
use glam::DVec2;

const CORNERS: [[f64; 2]; 4] = [[0.2, 0.2], [0.8, 0.1], [0.7, 0.9], [0.1, 0.6]];

fn rectangle(width: f64, height: f64) -> ConvexPolygon {
    ConvexPolygon::rectangle(DVec2::ZERO, DVec2::new(width, height)).expect("a rectangle")
}

fn in_square(points: &[[f64; 2]]) -> Result<Generators, GeneratorError> {
    let points: Vec<DVec2> = points.iter().copied().map(DVec2::from).collect();
    Generators::new(rectangle(1.0, 1.0), &points)
}

#[test]
fn refusals_name_the_point() {
    let text = |points: &[[f64; 2]]| in_square(points).unwrap_err().to_string();
    insta::assert_snapshot!(text(&[[0.0, 0.0], [1.0, 0.0], [0.5, 1.5]]), @"point 2 lies outside the region");
    insta::assert_snapshot!(
        text(&[[0.0, 0.0], [1.0, 0.0], [0.5, 0.5], [1.0, 0.0]]),
        @"points 1 and 3 are in the same place"
    );
    insta::assert_snapshot!(text(&[]), @"there are no points");
    insta::assert_snapshot!(
        text(&[[0.0, 0.0], [0.5, 0.5], [1.0, 1.0]]),
        @"the 3 distinct points lie on one line, from v0 to v2"
    );
    insta::assert_snapshot!(
        text(&[[0.0, 0.0], [0.5, f64::NAN], [1.0, 1.0]]),
        @"point 1 has y = NaN, which is neither zero nor of magnitude 2^-142 to 2^201 (about 1.8e-43 to 3.2e60)"
    );
    let empty = Generators::new(ConvexPolygon::default(), &[DVec2::ZERO]);
    insta::assert_snapshot!(empty.unwrap_err(), @"the region is empty");
}

#[test]
fn a_bad_density_is_refused_with_its_place() {
    let run = |value: f64| {
        lloyd_with(
            in_square(&CORNERS).unwrap(),
            |_| value,
            &Params::default(),
            &mut silent,
        )
    };
    insta::assert_snapshot!(run(-2.0).unwrap_err().to_string().split(" is ").last().unwrap(), @"-2, not a positive number");
    assert!(run(f64::NAN).is_err() && run(f64::INFINITY).is_err() && run(0.0).is_err());
}

#[test]
fn no_iterations_leave_the_points_and_tell_the_cost() {
    let generators = in_square(&CORNERS).unwrap();
    let params = Params {
        iterations: 0,
        ..Params::default()
    };
    let outcome = lloyd(generators.clone(), &params, &mut silent);
    assert_eq!(
        (outcome.stop, outcome.costs.len()),
        (Stop::OutOfIterations, 1)
    );
    assert_eq!(outcome.generators.points(), generators.points());
}

#[test]
fn a_report_that_breaks_cancels_before_the_first_move() {
    let generators = in_square(&CORNERS).unwrap();
    let outcome = lloyd(generators.clone(), &Params::default(), &mut |_| {
        ControlFlow::Break(())
    });
    assert_eq!((outcome.stop, outcome.costs.len()), (Stop::Cancelled, 0));
    assert_eq!(outcome.generators.points(), generators.points());
}

#[test]
fn an_endless_budget_can_be_cancelled() {
    let params = Params {
        iterations: usize::MAX,
        tolerance: f64::NAN,
    };
    let mut reports = 0;
    let outcome = lloyd(in_square(&CORNERS).unwrap(), &params, &mut |progress| {
        reports += 1;
        assert_eq!(progress.stage, "lloyd");
        if progress.done > 10_000 {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    });
    assert_eq!((outcome.stop, reports), (Stop::Cancelled, 4));
}

#[test]
fn points_that_would_line_up_stop_before() {
    let points = [[1.0, 0.5], [5.0, 0.5], [9.0, 0.75]].map(DVec2::from);
    let generators = Generators::new(rectangle(10.0, 1.0), &points).unwrap();
    let params = Params {
        iterations: 10_000,
        tolerance: -1.0,
    };
    let outcome = lloyd(generators, &params, &mut silent);
    assert_eq!(outcome.stop, Stop::OnOneLine);
    assert_eq!(outcome.generators.points().len(), 3);
}

#[test]
fn regions_at_the_ends_of_the_accepted_range_are_served() {
    for size in [2f64.powi(-100), 2f64.powi(190)] {
        let points = CORNERS.map(|corner| DVec2::from(corner) * size);
        let generators = Generators::new(rectangle(size, size), &points).unwrap();
        let outcome = lloyd(generators, &Params::default(), &mut silent);
        assert_eq!(outcome.stop, Stop::Converged);
        assert!((outcome.costs.last().unwrap() / size.powi(4) - 1.0 / 24.0).abs() < 1e-5);
    }
}

#[test]
fn points_that_the_boundary_would_line_up_are_refused() {
    let points = [[1.0, 0.6], [5.0, 0.4], [9.0, 0.6]].map(DVec2::from);
    let generators = Generators::new(rectangle(10.0, 1.0), &points).unwrap();
    insta::assert_snapshot!(
        generators.attached().unwrap_err(),
        @"on the boundary all points would lie on one line"
    );
}
