//! Reads a file section by section.

use super::sections::{kind_of, words_each};
use super::tokens::Tokens;
use crate::cell::{Cell, CellKind};
use crate::error::{ReadError, ReadProblem};
use crate::mesh::{Axis, Mesh, MeshDefect};
use crate::triangle::rows::point_index;

/// The mesh of a Medit file, of the plane (`z = 0`) or of space.
///
/// # Errors
/// Words out of place, counts that do not hold, corners that do not exist or stand before the vertices, numbers that are none or not
/// finite; each with its line. O(file).
pub fn parse(bytes: &[u8]) -> Result<Mesh, ReadError> {
    let mut tokens = Tokens::new(bytes)?;
    tokens.keyword_due("MeshVersionFormatted")?;
    let _version: i32 = tokens.number(format_args!("the version of the format"))?;
    tokens.keyword_due("Dimension")?;
    let dimension = tokens.number(format_args!("the dimension"))?;
    if !(2..=3).contains(&dimension) {
        let what = format!("dimension {dimension}");
        return Err(tokens.problem(ReadProblem::Unsupported(what)));
    }
    let mut parts = Parts::default();
    while let Some(section) = tokens.keyword()? {
        match (section, kind_of(section), words_each(section, dimension)) {
            ("End", ..) => {
                tokens.end()?;
                break;
            }
            ("Vertices", ..) => parts.vertices(&mut tokens, dimension)?,
            (_, Some(kind), _) => parts.cells(&mut tokens, section, kind)?,
            (_, _, Some(words)) => pass(&mut tokens, section, words)?,
            // Others begin with a count, a single number or a name in quotation marks.
            _ => tokens.pass_to_keyword(),
        }
    }
    Ok(parts.finish())
}

/// What has been read so far.
#[derive(Default)]
struct Parts {
    mesh: Mesh,
    has_vertices: bool,
    point_references: Vec<i32>,
    cell_references: Vec<i32>,
}

impl Parts {
    fn vertices(&mut self, tokens: &mut Tokens<'_>, dimension: usize) -> Result<(), ReadError> {
        if self.has_vertices {
            let what = "a second section Vertices".to_owned();
            return Err(tokens.problem(ReadProblem::Unsupported(what)));
        }
        self.has_vertices = true;
        let count = tokens.number(format_args!("the number of vertices"))?;
        if u32::try_from(count).is_err() {
            return Err(tokens.problem(MeshDefect::TooManyPoints(count)));
        }
        self.mesh.points.reserve(tokens.room_for(count));
        for index in 0..count {
            let mut point = [0.0; 3];
            for (coordinate, axis) in point.iter_mut().zip(Axis::ALL).take(dimension) {
                *coordinate = tokens.number(format_args!("coordinate {axis} of point {index}"))?;
            }
            tokens.finite(index, &point)?;
            let reference = tokens.number(format_args!("the reference of point {index}"))?;
            self.mesh.points.push(point);
            self.point_references.push(reference);
        }
        Ok(())
    }

    fn cells(
        &mut self,
        tokens: &mut Tokens<'_>,
        section: &str,
        kind: CellKind,
    ) -> Result<(), ReadError> {
        if !self.has_vertices {
            let problem = ReadProblem::Expected {
                expected: "the section Vertices first".to_owned(),
                found: section.to_owned(),
            };
            return Err(tokens.problem(problem));
        }
        let name = kind.name();
        let points = self.mesh.points.len();
        let count: usize = tokens.number(format_args!("the number of elements in {section}"))?;
        for index in 0..count {
            let mut corners = [0; 8];
            let corners = corners.get_mut(..kind.corner_count()).unwrap_or_default();
            for (corner, point) in corners.iter_mut().enumerate() {
                let line = tokens.line(format_args!("point {corner} of {name} {index}"))?;
                *point = point_index(line, (name, index), corner, (1, points))?;
            }
            let reference = tokens.number(format_args!("the reference of {name} {index}"))?;
            if let Some(cell) = Cell::new(kind, corners) {
                self.mesh.cells.push(cell);
                self.cell_references.push(reference);
            }
        }
        Ok(())
    }

    fn finish(self) -> Mesh {
        Mesh {
            point_markers: markers(self.point_references),
            cell_markers: markers(self.cell_references),
            ..self.mesh
        }
    }
}

/// The references, if any of them says something.
fn markers(references: Vec<i32>) -> Option<Vec<i32>> {
    let says = references.iter().any(|&reference| reference != 0);
    says.then_some(references)
}

/// Passes over a section with so many words for each element.
fn pass(tokens: &mut Tokens<'_>, section: &str, words: usize) -> Result<(), ReadError> {
    let count: usize = tokens.number(format_args!("the number of elements in {section}"))?;
    for index in 0..count {
        for _ in 0..words {
            let expected = format_args!("element {index} of {count} in {section}");
            let _passed: f64 = tokens.number(expected)?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// As remeshers write it, with their blank lines, comments and sections.
    const CUBE_CORNER: &str = "MeshVersionFormatted 2\n\nDimension 3\n\n# by hand\nVertices\n4\n\
        0 0 0 1\n1 0 0 1\n0 1 0 2\n0 0 1 0\n\n\
        Corners\n2\n1\n2\n\nRidges\n1\n1\n\nRequiredVertices 1 4\n\
        Normals\n1\n0 nan 1\nNormalAtVertices\n1\n1 1\n\
        Triangles\n2\n1 3 2 10\n1 2\n 4 11\n\nEdges\n1\n1 2 3\n\nTetrahedra\n1\n1 2 3 4 7\n\
        AngleOfCornerBound 10\nGeometry \"a.geo\"\nEnd\n";

    #[test]
    fn references_are_markers_and_other_sections_are_passed_over() {
        let mesh = parse(CUBE_CORNER.as_bytes()).unwrap();
        assert_eq!(mesh.points[3], [0.0, 0.0, 1.0]);
        assert_eq!(mesh.point_markers, Some(vec![1, 1, 2, 0]));
        let cells = [
            Cell::Triangle([0, 2, 1]),
            Cell::Triangle([0, 1, 3]),
            Cell::Segment([0, 1]),
            Cell::Tetrahedron([0, 1, 2, 3]),
        ];
        assert!(mesh.cells.iter().eq(cells));
        assert_eq!(mesh.cell_markers, Some(vec![10, 11, 3, 7]));
    }

    #[test]
    fn points_of_the_plane_have_two_coordinates_and_references_of_0_say_nothing() {
        let text = "MeshVersionFormatted 0\nDimension\n2\nVertices 3\n0 0 0\n1 0.5 0\n0 1 0\nTriangles 1\n1 2 3 0";
        let mesh = parse(text.as_bytes()).unwrap();
        assert_eq!(mesh.points[1], [1.0, 0.5, 0.0]);
        assert_eq!((mesh.cells.len(), mesh.point_markers), (1, None));
        assert_eq!(mesh.cell_markers, None);
    }

    #[test]
    fn errors_name_line_and_element() {
        let error = |from: &str, to: &str| {
            assert!(CUBE_CORNER.contains(from), "{from}");
            parse(CUBE_CORNER.replacen(from, to, 1).as_bytes()).unwrap_err()
        };
        insta::assert_snapshot!(parse(b"").unwrap_err(), @"line 1: the file ends where the word MeshVersionFormatted should follow");
        insta::assert_snapshot!(parse(b"\x01\0\0\0").unwrap_err(), @"line 1: expected the word MeshVersionFormatted, found `\u{fffd}\u{fffd}\u{fffd}\u{fffd}`");
        insta::assert_snapshot!(error("Dimension 3", "Dimension 4"), @"line 3: dimension 4 is not supported");
        insta::assert_snapshot!(error("Vertices\n4", "Vertices\n-4"), @"line 7: expected the number of vertices, found `-4`");
        insta::assert_snapshot!(error("1 0 0 1", "1 inf 0 1"), @"line 9: point 1: y is inf, which is not a finite number");
        insta::assert_snapshot!(error("1 0 0 1", "1 0 0 1.5"), @"line 9: expected the reference of point 1, found `1.5`");
        insta::assert_snapshot!(error("Vertices\n4", "Vertices\n5"), @"line 13: expected coordinate x of point 4, found `Corners`");
        insta::assert_snapshot!(error("Vertices\n4", "Vertices\n3"), @"line 11: expected the name of a section, found `0`");
        insta::assert_snapshot!(error(" 4 11", " 5 11"), @"line 33: triangle 1: there is no point 5");
        insta::assert_snapshot!(error(" 4 11", " 0 11"), @"line 33: triangle 1: there is no point 0");
        insta::assert_snapshot!(error("Corners", "Vertices"), @"line 13: a second section Vertices is not supported");
        insta::assert_snapshot!(error("# by hand", "Edges 0"), @"line 5: expected the section Vertices first, found Edges");
        insta::assert_snapshot!(error("End\n", "End\n7"), @"line 45: expected the end of the file, found `7`");
        insta::assert_snapshot!(error("Corners\n2", "Corners\n99999999999999"), @"line 18: expected element 2 of 99999999999999 in Corners, found `Ridges`");
        insta::assert_snapshot!(error("Edges\n1", "Edges\n99999999999999"), @"line 39: expected point 0 of segment 1, found `Tetrahedra`");
    }
}
