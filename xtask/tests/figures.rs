//! Every figure against its golden in `docs/figures`.

use std::panic::catch_unwind;

use xtask::figures::golden::{assert_picture, assert_summary, orphans};
use xtask::figures::{self, Figure};
use xtask::gallery::readme_is_fresh;

fn agrees(figure: &Figure) -> bool {
    let rendered = (figure.render)().unwrap_or_else(|error| panic!("{}: {error}", figure.name));
    let held = [assert_picture, assert_summary]
        .map(|hold| catch_unwind(|| hold(figure, &rendered)).is_ok());
    held == [true, true]
}

/// All are compared before the test fails, so one review sees every change.
#[test]
fn every_figure_is_what_its_golden_shows() {
    let changed: Vec<&str> = figures::all()
        .filter(|figure| !agrees(figure))
        .map(|figure| figure.name)
        .collect();
    assert!(
        changed.is_empty(),
        "review with `cargo insta review` or accept with `cargo xtask figures`: {changed:?}"
    );
}

#[test]
fn every_golden_belongs_to_a_figure() {
    assert_eq!(orphans().unwrap(), Vec::<std::path::PathBuf>::new());
}

#[test]
fn the_gallery_page_is_up_to_date() {
    assert!(readme_is_fresh(), "run `cargo xtask figures`");
}
