//! The `vide` program from outside: files in, files out, exit codes and error lines.

mod folder;

use std::path::Path;
use std::process::Command;

use folder::{Folder, text};
use proptest::prelude::*;
use vide::mesh_io::{CellKind, read_mesh};

const TWO_HOLES: &str = r#"
[domain]
kind = "circle"
centre = [0.0, 0.0]
radius = 2.0

[[hole]]
centre = [-1.0, 0.0]
radius = 0.4

[[hole]]
centre = [1.0, 0.1]
radius = 0.5
"#;

/// Bytes that mean something in a domain file, and some that mean nothing.
const SPOILT: std::ops::RangeInclusive<u8> = b' '..=b'~';

const PERIODIC: &str = r#"
[domain]
kind = "periodic"
period = [1.0, 0.8]

[[hole]]
centre = [0.3, 0.3]
radius = 0.2

[[hole]]
centre = [0.85, 0.6]
radius = 0.15
"#;

fn quads(path: &Path) -> usize {
    let mesh = read_mesh(path).unwrap_or_else(|error| panic!("{error}"));
    mesh.cells
        .kinds()
        .iter()
        .filter(|&&kind| kind == CellKind::Quad)
        .count()
}

#[test]
fn every_output_of_a_bounded_domain_holds_the_same_cells() {
    let folder = Folder::with(&[("two.toml", TWO_HOLES)]);
    let arguments = "block two.toml --cells 5 -o a.vtu -o a.msh -o a.p3d -o a.p3b -o a.off \
                     -o blockMeshDict --svg a.svg --report a.json --quiet";
    let output = folder.vide(&arguments.split_whitespace().collect::<Vec<_>>());
    assert!(output.status.success(), "{}", text(&output.stderr));
    assert!(output.stdout.is_empty());
    for name in ["a.vtu", "a.msh", "a.p3d", "a.p3b", "a.off"] {
        assert_eq!(quads(&folder.path(name)), 6 * 25, "{name}");
    }
    let dict = std::fs::read_to_string(folder.path("blockMeshDict")).unwrap();
    for word in ["hole_0", "hole_1", "bounding", "polyLine", "frontAndBack"] {
        assert!(dict.contains(word), "{word}");
    }
    let report = std::fs::read(folder.path("a.json")).unwrap();
    let report: serde_json::Value = serde_json::from_slice(&report).unwrap();
    assert_eq!(report["blocks"], 6);
    assert_eq!(report["elements"], 150);
    assert_eq!(report["stop"], "finished");
    let angle = |name: &str| report["angle"][name].as_f64().unwrap_or_default();
    assert!(0.0 < angle("min") && angle("min") < angle("mean_smallest"));
    assert!(angle("mean_largest") < angle("max") && angle("max") < 180.0);
    assert!(report["quality"]["quad.scaled_jacobian"]["p01"].is_f64());
}

#[test]
fn a_periodic_domain_is_written_with_its_periodic_sides() {
    let folder = Folder::with(&[("periodic.toml", PERIODIC)]);
    let arguments = "block periodic.toml -o a.vtu -o blockMeshDict --size 0.05";
    let output = folder.vide(&arguments.split(' ').collect::<Vec<_>>());
    assert!(output.status.success(), "{}", text(&output.stderr));
    let first = text(&output.stdout);
    assert!(
        first.starts_with("12 blocks, 4 medial vertices, 6 medial arcs"),
        "{first}"
    );
    let dict = std::fs::read_to_string(folder.path("blockMeshDict")).unwrap();
    assert!(dict.contains("cyclic"));
}

#[test]
fn the_result_does_not_depend_on_the_number_of_threads() {
    let folder = Folder::with(&[("two.toml", TWO_HOLES)]);
    for threads in ["1", "2", "3"] {
        let output = format!("{threads}.vtu");
        let arguments = ["block", "two.toml", "--threads", threads, "-o", &output];
        assert!(folder.vide(&arguments).status.success());
    }
    let bytes = |name: &str| std::fs::read(folder.path(name)).unwrap();
    assert!(bytes("1.vtu") == bytes("2.vtu") && bytes("1.vtu") == bytes("3.vtu"));
}

#[test]
fn what_makes_no_sense_is_said_in_one_line_with_file_line_and_element() {
    let overlapping = TWO_HOLES.replace("radius = 0.5", "radius = 1.9");
    let not_a_number = TWO_HOLES.replace("[1.0, 0.1]", "[nan, 0.1]");
    let negative = PERIODIC.replace("radius = 0.15", "radius = -0.15");
    let unknown = PERIODIC.replace("radius = 0.2", "radius = 0.2\ncolour = 3");
    let empty = TWO_HOLES.split("[[hole]]").next().unwrap_or_default();
    let truncated = &TWO_HOLES[..TWO_HOLES.len() - 8];
    let folder = Folder::with(&[
        ("two.toml", TWO_HOLES),
        ("overlapping.toml", &overlapping),
        ("nan.toml", &not_a_number),
        ("negative.toml", &negative),
        ("unknown.toml", &unknown),
        ("empty.toml", empty),
        ("nothing.toml", ""),
        ("truncated.toml", truncated),
        ("line.xy", "0 0\n1 1\n2 2\n"),
        ("nan.xy", "0 0\n1 nan\n2 0\n"),
        ("none.xy", ""),
        ("space.xyz", "0 0 0\n1 0 1\n0 1 0\n"),
    ]);
    let errors = [
        "block overlapping.toml -o out.vtu",
        "block nan.toml -o out.vtu",
        "block negative.toml -o out.vtu",
        "block unknown.toml -o out.vtu",
        "block empty.toml -o out.vtu",
        "block nothing.toml -o out.vtu",
        "block truncated.toml -o out.vtu",
        "block two.toml --cells 0 -o out.vtu",
        "block two.toml --cells 1 -o out.vtu",
        "block two.toml --cells 1000000000 -o out.vtu",
        "block two.toml --cells 10000000000000 -o out.vtu",
        "block two.toml --size nan -o out.vtu",
        "block two.toml --size 1e-9 -o out.vtu",
        "block two.toml -o out.stl",
        "block two.toml -o out.poly",
        "block two.toml -o out.vtu -o out.vtu",
        "block two.toml -o out.vtu -o ./out.vtu",
        "block two.toml -o out.vtu --report out.vtu",
        "block two.toml --svg out.svg --report out.svg",
        "block two.toml --svg two.toml",
        "block two.toml --report ./two.toml",
        "block missing.toml -o out.vtu",
        "quality line.xy --report line.xy",
        "block two.toml -o nowhere/out.vtu",
        "delaunay line.xy -o out.vtu",
        "delaunay nan.xy -o out.vtu",
        "delaunay none.xy -o out.vtu",
        "delaunay space.xyz -o out.vtu",
        "quality line.xy",
        "quality two.toml",
    ];
    let said = errors.map(|arguments| {
        let error = folder.error(&arguments.split(' ').collect::<Vec<_>>());
        format!("$ vide {arguments}\n{error}")
    });
    insta::assert_snapshot!(said.concat());
}

#[test]
fn any_number_of_threads_is_as_many_as_there_are() {
    let folder = Folder::with(&[("two.toml", TWO_HOLES)]);
    for threads in ["1000000", "18446744073709551615"] {
        let output = folder.vide(&["block", "two.toml", "--threads", threads]);
        assert!(output.status.success(), "{}", text(&output.stderr));
    }
}

#[test]
fn a_reader_that_has_gone_away_is_no_error() {
    let folder = Folder::with(&[("two.toml", TWO_HOLES)]);
    let mut child = Command::new(env!("CARGO_BIN_EXE_vide"))
        .current_dir(folder.path(""))
        .args(["block", "two.toml", "-o", "a.vtu"])
        .stdout(std::process::Stdio::piped())
        .spawn()
        .expect("the program can be started");
    drop(child.stdout.take());
    assert!(child.wait().expect("the program ends").success());
    assert!(folder.path("a.vtu").exists());
}

#[test]
fn a_result_that_cannot_be_written_leaves_what_was_there() {
    let folder = Folder::with(&[("two.toml", TWO_HOLES), ("a.vtu", "mine"), ("b.json", "")]);
    std::fs::create_dir(folder.path("a.svg")).expect("a folder can be made");
    folder.error(&["block", "two.toml", "-o", "a.vtu", "--svg", "a.svg"]);
    folder.error(&[
        "block",
        "two.toml",
        "-o",
        "a.vtu",
        "--report",
        "b.json/c.json",
    ]);
    assert_eq!(std::fs::read(folder.path("a.vtu")).unwrap(), b"mine");
}

#[test]
fn odd_file_names_are_taken_as_they_are() {
    let name = "zwei Löcher\u{1f573} 'x' --cells.toml";
    let folder = Folder::with(&[(name, TWO_HOLES)]);
    let said = folder.vide(&["block", name, "-o", "ä b.vtu", "--svg", "ä & <b>.svg"]);
    assert!(said.status.success(), "{}", text(&said.stderr));
    assert_eq!(quads(&folder.path("ä b.vtu")), 6 * 256);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// A file in which some bytes are others: the program says so in a line, or makes a mesh of it.
    #[test]
    fn no_spoiled_domain_file_makes_it_panic(
        periodic in any::<bool>(),
        edits in prop::collection::vec((any::<prop::sample::Index>(), SPOILT), 1..4),
        keep in any::<prop::sample::Index>(),
    ) {
        let mut domain = if periodic { PERIODIC } else { TWO_HOLES }.as_bytes().to_vec();
        for (at, byte) in edits {
            let at = at.index(domain.len());
            domain[at] = byte;
        }
        // Every second file is cut short as well.
        let cut = keep.index(2 * domain.len());
        domain.truncate(cut);
        let folder = Folder::with::<&str>(&[]);
        std::fs::write(folder.path("spoilt.toml"), &domain).unwrap();
        let output = folder.vide(&["block", "spoilt.toml", "--cells", "4", "-o", "a.off"]);
        match output.status.code() {
            Some(0) => prop_assert!(folder.path("a.off").exists()),
            Some(1) => {
                prop_assert_eq!(text(&output.stderr).lines().count(), 1);
                prop_assert_eq!(folder.names(), ["spoilt.toml"]);
            }
            other => prop_assert!(false, "{:?}: {}", other, text(&output.stderr)),
        }
    }
}

#[test]
fn wrong_usage_has_exit_code_2() {
    let folder = Folder::with(&[("two.toml", TWO_HOLES)]);
    for arguments in [
        "block",
        "block two.toml --cells 3 --size 0.1",
        "block two.toml --threads 0",
        "block two.toml --cells -1",
        "nonsense",
    ] {
        let output = folder.vide(&arguments.split(' ').collect::<Vec<_>>());
        assert_eq!(output.status.code(), Some(2), "{arguments}");
    }
}
