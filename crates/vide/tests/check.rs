//! `vide check` from outside: surfaces that are valid, and what is said of others.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

mod folder;

use folder::{Folder, text};
use serde_json::Value;

const CUBOCTAHEDRON: &[u8] = include_bytes!("../../../fixtures/data/cuboctahedron.off");

/// A tetrahedron with outward triangles but for the last.
const TETRAHEDRON: &str =
    "OFF\n4 4 0\n0 0 0\n4 0 0\n0 4 0\n0 0 4\n3 1 2 3\n3 2 0 3\n3 0 1 3\n3 2 0 1\n";

/// The same with a corner given twice and a point that is no corner.
const APART: &str =
    "OFF\n6 4 0\n0 0 0\n4 0 0\n0 4 0\n0 0 4\n4 0 0\n1 1 1\n3 1 2 3\n3 2 0 3\n3 0 4 3\n3 2 0 1\n";

/// Two tetrahedra that run through each other, one of them open.
const CROSSING: &str = "OFF\n8 7 0\n0 0 0\n4 0 0\n0 4 0\n0 0 4\n1 1 -1\n5 1 -1\n1 5 -1\n1 1 0.5\n\
    3 1 2 3\n3 2 0 3\n3 0 1 3\n3 2 1 0\n3 5 6 7\n3 6 4 7\n3 4 5 7\n";

/// Exit code and what is said on standard output and standard error.
fn run(folder: &Folder, arguments: &str) -> (Option<i32>, String, String) {
    let output = folder.vide(&arguments.split(' ').collect::<Vec<_>>());
    (
        output.status.code(),
        text(&output.stdout),
        text(&output.stderr),
    )
}

fn json(folder: &Folder, name: &str) -> Value {
    serde_json::from_slice(&std::fs::read(folder.path(name)).unwrap()).unwrap()
}

#[test]
fn a_valid_surface_is_measured() {
    let folder = Folder::with(&[("cuboctahedron.off", CUBOCTAHEDRON)]);
    let (code, said, error) = run(&folder, "check cuboctahedron.off --report check.json");
    assert_eq!((code, error.as_str()), (Some(0), ""));
    assert!(said.starts_with("7496 triangles, 3750 vertices\nvalid: 1 body, 0 voids, volume "));
    assert!(said.ends_with("nothing to repair\n"), "{said}");
    let report = json(&folder, "check.json");
    assert_eq!(report["check"]["valid"], true);
    assert_eq!(report["check"]["solid"]["bodies"]["count"], 1);
}

#[test]
fn what_has_to_be_repaired_is_said() {
    let folder = Folder::with(&[("one.off", TETRAHEDRON), ("apart.off", APART)]);
    let (code, said, _) = run(&folder, "check one.off --report one.json");
    assert_eq!(code, Some(0));
    insta::assert_snapshot!(said);
    assert_eq!(
        json(&folder, "one.json")["check"]["repairs"]["turned"],
        Value::from([3])
    );
    let repaired = "check apart.off --weld --drop-unused --report apart.json";
    let (code, said, _) = run(&folder, repaired);
    assert_eq!(code, Some(0));
    insta::assert_snapshot!(said);
    let report = json(&folder, "apart.json");
    assert_eq!(report["check"]["repairs"]["dropped"], Value::from([5]));
    assert_eq!(report["check"]["solid"]["vertices"], 4);
    let (code, said, error) = run(&folder, "check apart.off");
    assert_eq!(code, Some(1));
    insta::assert_snapshot!(said + &error);
}

#[test]
fn all_defects_are_listed_and_in_the_report_with_places() {
    let folder = Folder::with(&[("crossing.off", CROSSING)]);
    let (code, said, error) = run(&folder, "check crossing.off --report check.json");
    assert_eq!(code, Some(1));
    insta::assert_snapshot!(said + &error);
    let check = &json(&folder, "check.json")["check"];
    assert_eq!(check["valid"], false);
    assert_eq!(check["holes"].as_array().unwrap().len(), 1);
    assert_eq!(check["defects"]["open_edge"].as_array().unwrap().len(), 3);
    assert_eq!(check["defects"]["open_edge"][0]["places"][0][2], -1.0);
    assert!(check["defects"]["intersection"].is_array());
    let (code, said, error) = run(&folder, "check crossing.off -q --most-intersections 1");
    assert_eq!((code, said.as_str()), (Some(1), ""));
    assert!(
        error.ends_with("at least 2 pairs of triangles that intersect\n"),
        "{error}"
    );
}

#[test]
fn of_many_defects_of_a_kind_the_first_are_listed() {
    // A row of triangles, each alone.
    let count = 30;
    let corners = |i: i32| format!("{i} 0 0\n{i} 1 0\n{i} 0 1\n");
    let points: String = (0..count).map(corners).collect();
    let corners = |i: i32| format!("3 {} {} {}\n", 3 * i, 3 * i + 1, 3 * i + 2);
    let triangles: String = (0..count).map(corners).collect();
    let row = format!("OFF\n{} {count} 0\n{points}{triangles}", 3 * count);
    let folder = Folder::with(&[("row.off", row)]);
    let (code, said, _) = run(&folder, "check row.off --report row.json");
    assert_eq!(code, Some(1));
    assert!(said.contains("90 open edges round 30 holes\n"), "{said}");
    assert!(said.ends_with("  and 70 more\n"), "{said}");
    let report = json(&folder, "row.json");
    assert_eq!(
        report["check"]["defects"]["open_edge"]
            .as_array()
            .unwrap()
            .len(),
        90
    );
    let (code, said, _) = run(&folder, "check row.off --interfaces --dangling");
    assert_eq!(code, Some(0));
    assert!(
        said.contains("valid: 30 parts between regions, area 15\n"),
        "{said}"
    );
}

#[test]
fn what_is_no_surface_is_said_in_one_line() {
    let quad = "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n";
    let none = "OFF\n1 0 0\n0 0 0\n";
    let folder = Folder::with(&[("quad.off", quad), ("none.off", none)]);
    insta::assert_snapshot!(folder.error(&["check", "quad.off"]), @"vide: quad.off: cell 0 is a quad, but a surface has triangles");
    insta::assert_snapshot!(folder.error(&["check", "none.off"]), @"vide: none.off: the surface has no triangles");
    assert!(
        folder
            .error(&["check", "missing.off"])
            .contains("missing.off")
    );
}
