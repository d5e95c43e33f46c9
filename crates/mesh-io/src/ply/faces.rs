//! The faces of a PLY: lists of vertices.

use super::body::Body;
use super::header::{Element, Kind, Property};
use super::missing;
use crate::cell::{Cell, Cells};
use crate::error::{ReadError, ReadProblem};

/// Reads the corners of every face and passes over what else is stored of it.
pub(super) fn faces(
    body: &mut Body<'_>,
    element: &Element,
    cells: &mut Cells,
) -> Result<(), ReadError> {
    let lists = element.properties.iter().filter(|list| is_corners(list));
    match lists.count() {
        0 => return Err(missing("a list vertex_indices of its faces")),
        1 => {}
        _ => {
            let what = "a PLY with two lists of corners of a face";
            return Err(ReadProblem::Unsupported(what.into()).into());
        }
    }
    for (index, _) in (0..element.count).enumerate() {
        for property in &element.properties {
            if is_corners(property) {
                cells.push(face(body, property, index)?);
            } else {
                body.pass(property, "face")?;
            }
        }
    }
    Ok(())
}

/// Both names are in use.
fn is_corners(property: &Property) -> bool {
    let named = matches!(property.name.as_str(), "vertex_indices" | "vertex_index");
    named && matches!(property.kind, Kind::List { .. })
}

fn face(body: &mut Body<'_>, property: &Property, index: usize) -> Result<Cell, ReadError> {
    let Kind::List { count, item } = property.kind else {
        return Err(missing("a list vertex_indices of its faces"));
    };
    let start = body.at();
    let length = body.whole(count, format_args!("the number of corners of face {index}"))?;
    let mut corners = [0; 4];
    for (corner, point) in (0..length).zip(&mut corners) {
        let expected = format_args!("corner {corner} of face {index}");
        let at = body.at();
        let named = body.whole(item, expected)?;
        *point = u32::try_from(named).map_err(|_| {
            let problem = ReadProblem::NoSuch {
                element: "face",
                index,
                names: "point",
                found: i64::try_from(named).unwrap_or(i64::MAX),
            };
            body.problem(at, problem)
        })?;
    }
    let [a, b, c, d] = corners;
    match length {
        1 => Ok(Cell::Vertex([a])),
        2 => Ok(Cell::Segment([a, b])),
        3 => Ok(Cell::Triangle([a, b, c])),
        4 => Ok(Cell::Quad([a, b, c, d])),
        _ => {
            let problem = ReadProblem::Unsupported(format!("face {index} of {length} corners"));
            Err(body.problem(start, problem))
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::ply::parse_mesh;
    use crate::{Cell, Cells};

    const POINTS: &str =
        "element vertex 3\nproperty double x\nproperty double y\nproperty double z\n";

    /// A text file of three points and of faces, vertices in front or behind.
    fn text(properties: &str, faces: &[&str], vertices_first: bool) -> Vec<u8> {
        let header = format!("element face {}\n{properties}", faces.len());
        let points = "0 0 0\n1 0 0\n0 1 2\n";
        let faces: String = faces.iter().map(|face| format!("{face}\n")).collect();
        let file = if vertices_first {
            format!("ply\nformat ascii 1.0\n{POINTS}{header}end_header\n{points}{faces}")
        } else {
            format!("ply\nformat ascii 1.0\n{header}{POINTS}end_header\n{faces}{points}")
        };
        file.into_bytes()
    }

    #[test]
    fn faces_are_read_whatever_they_are_called_and_wherever_they_stand() {
        let wanted = Cells::from_iter([
            Cell::Triangle([0, 1, 2]),
            Cell::Segment([2, 0]),
            Cell::Quad([0, 1, 2, 1]),
        ]);
        for (name, first) in [("vertex_indices", true), ("vertex_index", false)] {
            let properties = format!("property list uchar int {name}\nproperty int red\n");
            let file = text(&properties, &["3 0 1 2 7", "2 2 0 8", "4 0 1 2 1 9"], first);
            let mesh = parse_mesh(&file).unwrap();
            assert_eq!(mesh.cells, wanted);
            assert_eq!(mesh.points, [[0., 0., 0.], [1., 0., 0.], [0., 1., 2.]]);
        }
    }

    #[test]
    fn the_points_may_be_in_the_plane() {
        let file = "ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\nproperty int y\nend_header\n3 4\n";
        assert_eq!(
            parse_mesh(file.as_bytes()).unwrap().points,
            [[3.0, 4.0, 0.0]]
        );
    }

    #[test]
    fn errors_name_the_face() {
        let list = "property list int int vertex_indices\n";
        let error = |face: &str| parse_mesh(&text(list, &[face], true)).unwrap_err();
        insta::assert_snapshot!(error("3 0 1"), @"line 14: the file ends where corner 2 of face 0 should follow");
        insta::assert_snapshot!(error("3 0 1 -1"), @"line 13: expected corner 2 of face 0, found `-1`");
        insta::assert_snapshot!(error("3 0 1 1.5"), @"line 13: expected corner 2 of face 0, found `1.5`");
        insta::assert_snapshot!(error("3 0 1 3"), @"cell 0: corner 2 is point 3, but there are 3 points");
        insta::assert_snapshot!(error("-3 0 1 2"), @"line 13: expected the number of corners of face 0, found `-3`");
        insta::assert_snapshot!(error("5 0 1 2 0 1"), @"line 13: face 0 of 5 corners is not supported");
        insta::assert_snapshot!(error("0"), @"line 13: face 0 of 0 corners is not supported");
        let properties = |properties| parse_mesh(&text(properties, &[], true)).unwrap_err();
        insta::assert_snapshot!(properties("property int vertex_indices\n"), @"a PLY without a list vertex_indices of its faces is not supported");
        insta::assert_snapshot!(properties(list.repeat(2).as_str()), @"a PLY with two lists of corners of a face is not supported");
    }
}
