//! What every defect and every error says.

use std::ops::ControlFlow;

use glam::DVec2;
use medial_blocking::{
    BlockingError, CellCounts, Circle, Defect, Domain, DomainError, Params, mesh, mesh_with,
};

fn circle(x: f64, y: f64, radius: f64) -> Circle {
    Circle::new(DVec2::new(x, y), radius)
}

fn in_circle(holes: &[Circle]) -> DomainError {
    Domain::in_circle(circle(0.0, 0.0, 4.0), holes).expect_err("something is wrong")
}

fn periodic(x: f64, y: f64, holes: &[Circle]) -> DomainError {
    Domain::periodic(DVec2::new(x, y), holes).expect_err("something is wrong")
}

fn two_holes() -> Domain {
    let holes = [circle(-1.0, 0.0, 0.4), circle(1.0, 0.1, 0.5)];
    Domain::in_circle(circle(0.0, 0.0, 2.0), &holes).expect("the holes are disjoint")
}

fn refused(cells: CellCounts) -> BlockingError {
    let params = Params {
        cells,
        ..Params::default()
    };
    mesh(&two_holes(), &params).expect_err("no such mesh can be made")
}

fn each(along_arc: &[u32], across_wall: &[u32]) -> CellCounts {
    CellCounts::Each {
        along_arc: along_arc.to_vec(),
        across_wall: across_wall.to_vec(),
    }
}

#[test]
fn a_defect_names_its_circles_and_values() {
    let unit = circle(0.0, 0.0, 1.0);
    let defects = [
        in_circle(&[]),
        in_circle(&[circle(0.0, f64::NAN, 1.0)]),
        in_circle(&[circle(f64::INFINITY, 1e300, 1.0)]),
        in_circle(&[unit, circle(2.5, 0.0, 0.0)]),
        in_circle(&[circle(0.0, 0.0, -1.0), circle(2.5, 0.0, f64::NAN)]),
        in_circle(&[unit, circle(2.5, 0.0, 1e-11)]),
        in_circle(&[unit, unit]),
        in_circle(&[unit, circle(1.5, 0.0, 1.0)]),
        in_circle(&[unit, circle(2.0, 0.0, 1.0)]),
        in_circle(&[circle(3.5, 0.0, 1.0), circle(-9.0, 0.0, 1.0)]),
        in_circle(&[circle(1.0, 0.0, 3.0)]),
        Domain::in_circle(circle(f64::NAN, 0.0, -2.0), &[unit]).unwrap_err(),
        periodic(0.0, f64::NAN, &[unit]),
        periodic(-3.0, f64::INFINITY, &[unit]),
        periodic(2.0, 4.0, &[unit]),
        periodic(3.0, 3.0, &[circle(0.5, 0.5, 1.0), circle(2.6, 2.7, 0.5)]),
        periodic(1.0, 1.0, &[circle(1e9, 0.0, 0.1)]),
        periodic(3.0, 3.0, &[]),
    ];
    let said: Vec<String> = defects.iter().map(ToString::to_string).collect();
    insta::assert_snapshot!(said.join("\n"));
}

#[test]
fn a_long_list_of_defects_is_cut_in_the_text_but_not_in_the_error() {
    let holes: Vec<Circle> = (0..8).map(|_| circle(0.0, 0.0, 1.0)).collect();
    let error = in_circle(&holes);
    assert_eq!(error.defects().len(), 28);
    assert!(error.to_string().ends_with("; and 23 more"), "{error}");
    let holes: Vec<Circle> = (0..1000).map(|_| circle(0.0, 0.0, 1.0)).collect();
    let error = in_circle(&holes);
    assert_eq!(error.defects().len(), medial_blocking::MAX_LISTED_DEFECTS);
    assert!(error.to_string().contains("; and at least "), "{error}");
}

#[test]
fn a_touching_pair_is_told_with_its_gap_and_image() {
    let error = periodic(3.0, 3.0, &[circle(0.5, 1.5, 0.5), circle(2.5, 1.5, 0.5)]);
    let Defect::Gap { shift, gap, .. } = error.defects()[0] else {
        panic!("{error}");
    };
    assert_eq!((shift, gap), ([-1, 0], 0.0));
}

#[test]
fn an_error_of_a_mesh_names_the_count_at_fault() {
    let errors = [
        refused(CellCounts::PerBlock(0)),
        refused(each(&[4, 4, 0], &[4, 4, 4])),
        refused(each(&[4, 4, 4], &[4, 0, 4])),
        refused(each(&[4, 4, 4], &[4, 4, 0])),
        refused(each(&[4, 4], &[4, 4, 4])),
        refused(each(&[4, 4, 4], &[4; 7])),
        refused(CellCounts::PerBlock(1)),
        refused(CellCounts::PerBlock(u32::MAX)),
        refused(CellCounts::Size(0.0)),
        refused(CellCounts::Size(-0.1)),
        refused(CellCounts::Size(f64::NAN)),
        refused(CellCounts::Size(f64::INFINITY)),
        refused(CellCounts::Size(1e-300)),
        BlockingError::Unresolved,
        BlockingError::TooManySamples { limit: 1 << 26 },
        in_circle(&[]).into(),
        mesh_with(&two_holes(), &Params::default(), &mut |_| {
            ControlFlow::Break(())
        })
        .unwrap_err(),
    ];
    let said: Vec<String> = errors.iter().map(ToString::to_string).collect();
    insta::assert_snapshot!(said.join("\n"));
}
