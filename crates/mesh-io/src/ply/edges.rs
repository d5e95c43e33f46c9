//! The edges of a PLY: pairs of vertices.

use super::body::Body;
use super::header::{Element, Kind};
use super::pass;
use crate::cell::{Cell, Cells};
use crate::error::{ReadError, ReadProblem};

const ENDS: [&str; 2] = ["vertex1", "vertex2"];

/// Reads both ends of every edge and passes over what else is stored of it. Edges without ends are passed over.
pub(super) fn edges(
    body: &mut Body<'_>,
    element: &Element,
    cells: &mut Cells,
) -> Result<(), ReadError> {
    let places = ENDS.map(|end| {
        let mut properties = element.properties.iter();
        properties.position(|property| property.name == end)
    });
    let [Some(first), Some(second)] = places else {
        return pass(body, element);
    };
    for (index, _) in (0..element.count).enumerate() {
        let mut ends = [0; 2];
        for (place, property) in element.properties.iter().enumerate() {
            let end = usize::from(place == second);
            match (ends.get_mut(end), property.kind) {
                (Some(point), Kind::Scalar(number)) if place == first || place == second => {
                    let at = body.at();
                    let named = body.whole(number, format_args!("end {end} of edge {index}"))?;
                    *point = u32::try_from(named)
                        .map_err(|_| body.problem(at, no_such_point(index, named)))?;
                }
                _ => body.pass(property, "edge")?,
            }
        }
        cells.push(Cell::Segment(ends));
    }
    Ok(())
}

fn no_such_point(index: usize, named: u64) -> ReadProblem {
    ReadProblem::NoSuch {
        element: "edge",
        index,
        names: "point",
        found: i64::try_from(named).unwrap_or(i64::MAX),
    }
}

#[cfg(test)]
mod tests {
    use crate::ply::parse_mesh;
    use crate::{Cell, ReadError};

    fn parse(properties: &str, edge: &str) -> Result<Vec<Cell>, ReadError> {
        let points = "element vertex 2\nproperty int x\nproperty int y\n";
        let header =
            format!("ply\nformat ascii 1.0\n{points}element edge 1\n{properties}end_header\n");
        let mesh = parse_mesh(format!("{header}0 0\n1 0\n{edge}\n").as_bytes())?;
        Ok(mesh.cells.iter().collect())
    }

    #[test]
    fn edges_with_ends_are_segments() {
        let ends = "property int vertex1\nproperty uchar red\nproperty int vertex2\n";
        assert_eq!(parse(ends, "1 255 0").unwrap(), [Cell::Segment([1, 0])]);
        assert_eq!(parse("property int length\n", "7").unwrap(), []);
        insta::assert_snapshot!(parse(ends, "1 255").unwrap_err(), @"line 14: the file ends where end 1 of edge 0 should follow");
        insta::assert_snapshot!(parse(ends, "1 255 -1").unwrap_err(), @"line 13: expected end 1 of edge 0, found `-1`");
        insta::assert_snapshot!(parse(ends, "9999999999 255 0").unwrap_err(), @"line 13: edge 0: there is no point 9999999999");
        insta::assert_snapshot!(parse(ends, "1 255 2").unwrap_err(), @"cell 0: corner 1 is point 2, but there are 2 points");
    }
}
