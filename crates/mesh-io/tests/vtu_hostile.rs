//! VTU made to waste memory or time, and the corners of XML: an answer at once, whatever the file claims.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use std::fmt::Write as _;
use std::time::{Duration, Instant};

use mesh_io::{Mesh, ReadError, vtu};

/// A triangle: `file` may say more about the whole, `data` about its points, `end` what follows the grid.
fn triangle(file: &str, data: &str, end: &str) -> String {
    format!(
        r#"<VTKFile type="UnstructuredGrid" {file}><UnstructuredGrid><Piece NumberOfPoints="3" NumberOfCells="1">
<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">0 0 0 1 0 0 0 1 0</DataArray></Points>
<Cells><DataArray type="Int32" Name="connectivity" format="ascii">0 1 2</DataArray>
<DataArray type="Int32" Name="offsets" format="ascii">3</DataArray>
<DataArray type="UInt8" Name="types" format="ascii">5</DataArray></Cells>
<PointData>{data}</PointData></Piece></UnstructuredGrid>{end}</VTKFile>"#
    )
}

/// Parses within a time that only a quadratic reader exceeds.
fn parse_soon(file: &str) -> Result<Mesh, ReadError> {
    let start = Instant::now();
    let parsed = vtu::parse(file.as_bytes());
    let took = start.elapsed();
    assert!(took < Duration::from_secs(10), "{took:?}");
    parsed
}

fn ascii(name: &str, values: &str) -> String {
    format!(r#"<DataArray type="Float64" Name="{name}" format="ascii">{values}</DataArray>"#)
}

#[test]
fn many_arrays_at_one_place_of_the_appended_data_are_refused() {
    let array = r#"<DataArray type="UInt8" Name="a" format="appended" offset="0"/>"#;
    let bytes = "A".repeat(1 << 16);
    let size = String::from_utf8(vec![b'A'; 4]).unwrap();
    let appended = format!(r#"<AppendedData encoding="raw">_{size}{bytes}</AppendedData>"#);
    // "AAAA" is a header too, and claims more than there is; a small one needs a byte that is no letter.
    let small = appended.replacen("_AAAA", "_\0\0\u{1}\0", 1);
    let error = parse_soon(&triangle("", &array.repeat(20_000), &small)).unwrap_err();
    let problem = error.problem.to_string();
    assert!(
        problem.starts_with("the arrays unpack to more than "),
        "{problem}"
    );
}

#[test]
fn a_hundred_thousand_names_take_no_more_than_linear_time() {
    let mut data = String::new();
    for index in 0..100_000 {
        write!(data, "{}", ascii(&format!("field {index}"), "1 2 3")).unwrap();
    }
    let mesh = parse_soon(&triangle("", &data, "")).unwrap();
    assert_eq!(mesh.point_data.len(), 100_000);
}

#[test]
fn nesting_as_deep_as_the_file_is_long_is_walked() {
    let deep = "<a>".repeat(200_000) + &"</a>".repeat(200_000);
    assert!(parse_soon(&triangle("", &deep, "")).is_ok());
    let open = triangle("", &"<a>".repeat(200_000), "");
    assert!(parse_soon(&open).is_err());
}

#[test]
fn entities_are_not_expanded() {
    let bomb = r#"<!DOCTYPE lolz [<!ENTITY a "1 1 1 1"><!ENTITY b "&a;&a;&a;&a;">]>"#;
    let file = bomb.to_owned() + &triangle("", &ascii("f", "&b;"), "");
    insta::assert_snapshot!(parse_soon(&file).unwrap_err(), @"line 6: expected a number, found `&b;`");
    let file = triangle("", &ascii("f", "1 2&#48; 3"), "");
    insta::assert_snapshot!(parse_soon(&file).unwrap_err(), @"line 6: expected a number, found `&#48;`");
}

#[test]
fn numbers_in_character_data_are_read() {
    let mesh = parse_soon(&triangle("", &ascii("f", "1 <![CDATA[2 ]]>3"), "")).unwrap();
    assert_eq!(mesh.point_data[0].values, [1.0, 2.0, 3.0]);
}

#[test]
fn data_keep_the_order_of_the_file() {
    let data = ascii("a", "1 1 1") + &ascii("b", "2 2 2") + &ascii("c", "3 3 3");
    let mesh = parse_soon(&triangle("", &data, "")).unwrap();
    let names: Vec<_> = mesh.point_data.iter().map(|array| &array.name).collect();
    assert_eq!(names, ["a", "b", "c"]);
}

#[test]
fn marks_of_byte_order_and_lines_of_other_systems_are_no_matter() {
    let file = triangle("", &ascii("f", "1 2\n3"), "");
    let windows = format!("\u{feff}{}", file.replace('\n', "\r\n"));
    assert_eq!(parse_soon(&windows).unwrap(), parse_soon(&file).unwrap());
}
