//! Each stage is counted where it decides.
#![cfg(feature = "statistics")]

use geo_predicates::statistics::{Predicate, Stage, count, reset};
use geo_predicates::{DVec2, in_circle_perturbed, orient2d};

#[test]
fn every_stage_counts_its_decisions() {
    reset();
    let far = |x: f64| orient2d(DVec2::ZERO, DVec2::splat(x), DVec2::splat(3.0 * x + 1.0));
    let _ = orient2d(DVec2::ZERO, DVec2::X, DVec2::Y);
    let _ = (far(1.0), far(1e-30));
    let [a, b, c] = [DVec2::ZERO, DVec2::X, DVec2::ONE];
    let _ = in_circle_perturbed(a, b, c, DVec2::Y);
    let counts = Stage::ALL.map(|stage| count(Predicate::Orient2d, stage));
    assert_eq!(
        counts,
        [2, 1, 1, 0],
        "one filtered above, one asked by the tie"
    );
    let counts = Stage::ALL.map(|stage| count(Predicate::InCircle, stage));
    assert_eq!(counts, [0, 1, 0, 1]);
    reset();
    assert_eq!(count(Predicate::Orient2d, Stage::Filter), 0);
}
