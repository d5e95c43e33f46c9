//! Reads triangles, and finds their corners by place.

use std::collections::HashMap;

use super::HEADER;
use crate::cell::Cells;
use crate::error::{ReadError, ReadProblem};
use crate::lines::{Line, Lines};
use crate::mesh::{Mesh, MeshDefect, first_not_finite};

const FRONT: usize = HEADER + 4;

/// Bytes of a triangle in a binary file: normal, three corners, two bytes more.
const NORMAL: usize = 12;
const TRIANGLE: usize = NORMAL + 36 + 2;

/// The triangles of an STL file, and their corners as points. The solids of a text that has several are one mesh.
///
/// A file is text when it begins with the word `solid`, unless it has just the length that a binary file of its number of
/// triangles has. -0.0 becomes 0.0.
///
/// # Errors
/// Words out of place, a file that ends early or goes on, numbers that are none or not finite; each with its line or byte.
/// O(file).
pub fn parse(bytes: &[u8]) -> Result<Mesh, ReadError> {
    let announced = announced(bytes);
    let is_binary = announced.is_some_and(|count| length_of(count) == bytes.len() as u64);
    if !is_binary && bytes.trim_ascii_start().starts_with(b"solid") {
        return text(bytes);
    }
    binary(bytes, announced)
}

/// The number of triangles that a binary file announces.
fn announced(bytes: &[u8]) -> Option<u32> {
    let count = bytes.get(HEADER..)?.first_chunk()?;
    Some(u32::from_le_bytes(*count))
}

/// The length of a binary file of so many triangles.
fn length_of(count: u32) -> u64 {
    FRONT as u64 + TRIANGLE as u64 * u64::from(count)
}

fn binary(bytes: &[u8], announced: Option<u32>) -> Result<Mesh, ReadError> {
    let Some(count) = announced else {
        let expected = "the word solid, or 80 bytes and the number of triangles".to_owned();
        return Err(ReadError::at_byte(
            bytes.len(),
            ReadProblem::Truncated { expected },
        ));
    };
    let body = bytes.get(FRONT..).unwrap_or_default();
    let mut soup = Soup::default();
    let mut triangles = body.chunks_exact(TRIANGLE);
    for index in 0..count as usize {
        let Some(triangle) = triangles.next() else {
            let expected = format!("triangle {index} of {count}");
            let problem = ReadProblem::Truncated { expected };
            return Err(ReadError::at_byte(bytes.len(), problem));
        };
        let start = FRONT + index * TRIANGLE + NORMAL;
        soup.triangle(corners_of(triangle, start)?)?;
    }
    if bytes.len() as u64 > length_of(count) {
        let problem = ReadProblem::Expected {
            expected: format!("the end of the file after {count} triangles"),
            found: "more".to_owned(),
        };
        return Err(ReadError::at_byte(
            FRONT + count as usize * TRIANGLE,
            problem,
        ));
    }
    Ok(soup.into_mesh())
}

/// The corners of a triangle whose first corner stands at byte `start`.
fn corners_of(triangle: &[u8], start: usize) -> Result<[[f64; 3]; 3], ReadError> {
    let (numbers, _) = triangle.as_chunks::<4>();
    let mut numbers = numbers.iter().skip(NORMAL / 4);
    let mut corners = [[0.0; 3]; 3];
    for coordinate in corners.as_flattened_mut() {
        let number = numbers.next().copied().unwrap_or_default();
        *coordinate = f64::from(f32::from_le_bytes(number));
    }
    let index = (start - FRONT) / TRIANGLE;
    for (corner, point) in corners.iter().enumerate() {
        let at = start + 12 * corner;
        not_finite(index, point).map_or(Ok(()), |problem| Err(ReadError::at_byte(at, problem)))?;
    }
    Ok(corners)
}

fn not_finite(index: usize, point: &[f64; 3]) -> Option<ReadProblem> {
    let (axis, value) = first_not_finite(point)?;
    Some(ReadProblem::NotFinite {
        element: "a corner of triangle",
        index,
        axis,
        value,
    })
}

fn text(bytes: &[u8]) -> Result<Mesh, ReadError> {
    let mut lines = Lines::new(bytes)?;
    let mut soup = Soup::default();
    let mut index = 0;
    while let Some(mut line) = lines.next() {
        // A name may follow.
        word(&mut line, "solid", format_args!("the word solid"))?;
        while let Some(corners) = facet(&mut lines, index)? {
            soup.triangle(corners)?;
            index += 1;
        }
    }
    Ok(soup.into_mesh())
}

/// The corners of the next facet; `None` where the solid ends.
fn facet(lines: &mut Lines<'_>, index: usize) -> Result<Option<[[f64; 3]; 3]>, ReadError> {
    let expected = format_args!("facet {index} or the word endsolid");
    let mut line = lines.due(expected)?;
    match line.word() {
        Some(word) if word.eq_ignore_ascii_case("endsolid") => return Ok(None),
        // A normal may follow.
        Some(word) if word.eq_ignore_ascii_case("facet") => {}
        found => return Err(line.unexpected(expected, found.unwrap_or_default())),
    }
    phrase(lines, &["outer", "loop"], index)?;
    let mut corners = [[0.0; 3]; 3];
    for corner in &mut corners {
        let mut line = lines.due(format_args!("a vertex of facet {index}"))?;
        word(
            &mut line,
            "vertex",
            format_args!("a vertex of facet {index}"),
        )?;
        *corner = line.coordinates("a corner of triangle", index)?;
        line.end(format_args!("the coordinates of a vertex"))?;
    }
    phrase(lines, &["endloop"], index)?;
    phrase(lines, &["endfacet"], index)?;
    Ok(Some(corners))
}

/// A line of these words and no more.
fn phrase(lines: &mut Lines<'_>, words: &[&str], index: usize) -> Result<(), ReadError> {
    let expected = words.join(" ");
    let expected = format_args!("{expected} of facet {index}");
    let mut line = lines.due(expected)?;
    for due in words {
        word(&mut line, due, expected)?;
    }
    line.end(expected)
}

/// A word, in any case.
fn word(
    line: &mut Line<'_>,
    due: &str,
    expected: std::fmt::Arguments<'_>,
) -> Result<(), ReadError> {
    match line.word() {
        Some(found) if found.eq_ignore_ascii_case(due) => Ok(()),
        Some(found) => Err(line.unexpected(expected, found)),
        None => Err(line.problem(ReadProblem::Expected {
            expected: expected.to_string(),
            found: "the end of the line".into(),
        })),
    }
}

/// Triangles whose corners become points by their places.
#[derive(Default)]
struct Soup {
    points: Vec<[f64; 3]>,
    /// By the bits of the coordinates. Asked, never iterated.
    known: HashMap<[u64; 3], u32>,
    triangles: Vec<[u32; 3]>,
}

impl Soup {
    fn triangle(&mut self, corners: [[f64; 3]; 3]) -> Result<(), ReadError> {
        let mut named = [0; 3];
        for (name, corner) in named.iter_mut().zip(corners) {
            *name = self.point(corner)?;
        }
        self.triangles.push(named);
        Ok(())
    }

    fn point(&mut self, point: [f64; 3]) -> Result<u32, ReadError> {
        // Makes -0.0 the same place as 0.0.
        let point = point.map(|coordinate| coordinate + 0.0);
        let count = self.points.len();
        let next = u32::try_from(count).map_err(|_| MeshDefect::TooManyPoints(count))?;
        let name = *self.known.entry(point.map(f64::to_bits)).or_insert(next);
        if name == next {
            self.points.push(point);
        }
        Ok(name)
    }

    fn into_mesh(self) -> Mesh {
        Mesh::new(self.points, Cells::of_triangles(self.triangles))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TWO: [[[f64; 3]; 3]; 2] = [
        [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.5, 0.0]],
        [[1.0, 0.0, -0.0], [0.0, 0.0, 0.0], [0.0, 0.0, 2.0]],
    ];

    fn text_of(triangles: &[[[f64; 3]; 3]]) -> String {
        let mut text = "solid two # of them\n".to_owned();
        for triangle in triangles {
            text += " facet normal nan 0 1\n  outer loop\n";
            for [x, y, z] in triangle {
                text += &format!("   vertex {x:?} {y:?} {z:?}\n");
            }
            text += "  endloop\n endfacet\n";
        }
        text + "endsolid two\n"
    }

    fn binary_of(triangles: &[[[f64; 3]; 3]], header: &[u8]) -> Vec<u8> {
        let mut file = header.to_vec();
        file.resize(HEADER, b' ');
        file.extend((triangles.len() as u32).to_le_bytes());
        for triangle in triangles {
            file.extend([0xff; NORMAL]);
            let numbers = triangle.as_flattened().iter();
            file.extend(numbers.flat_map(|&x| (x as f32).to_le_bytes()));
            file.extend([1, 2]);
        }
        file
    }

    fn error(bytes: impl AsRef<[u8]>) -> String {
        parse(bytes.as_ref()).unwrap_err().to_string()
    }

    #[test]
    fn corners_at_one_place_are_one_point() {
        let text = text_of(&TWO);
        let wanted = Cells::of_triangles(vec![[0, 1, 2], [1, 0, 3]]);
        for file in [
            text.to_uppercase().replace("SOLID TWO", "solid").into(),
            text.into_bytes(),
            binary_of(&TWO, b"made by hand"),
            binary_of(&TWO, b"solid, but binary"),
        ] {
            let mesh = parse(&file).unwrap();
            assert_eq!((mesh.points.len(), &mesh.cells), (4, &wanted));
            assert_eq!(mesh.points[2], [0.0, 1.5, 0.0]);
        }
    }

    #[test]
    fn the_solids_of_one_file_are_one_mesh() {
        let text = text_of(&TWO[..1]) + &text_of(&TWO[1..]);
        let [several, one] = [text, text_of(&TWO)].map(|text| parse(text.as_bytes()).unwrap());
        assert_eq!(several, one);
        assert_eq!(parse(b"solid\nendsolid").unwrap(), Mesh::default());
    }

    #[test]
    fn errors_name_line_or_byte_and_triangle() {
        insta::assert_snapshot!(error(""), @"byte 0: the file ends where the word solid, or 80 bytes and the number of triangles should follow");
        insta::assert_snapshot!(error("solid"), @"line 1: the file ends where facet 0 or the word endsolid should follow");
        insta::assert_snapshot!(error("solid\nfacette"), @"line 2: expected facet 0 or the word endsolid, found `facette`");
        insta::assert_snapshot!(error("solid\nfacet\nouter\n"), @"line 3: expected outer loop of facet 0, found the end of the line");
        insta::assert_snapshot!(error("solid\nfacet\nouter loop\nvertex 0 0\n"), @"line 4: expected coordinate z of a corner of triangle 0, found the end of the line");
        insta::assert_snapshot!(error("solid\nfacet\nouter loop\nvertex 0 inf 0\n"), @"line 4: a corner of triangle 0: y is inf, which is not a finite number");
        insta::assert_snapshot!(error("solid\nfacet\nouter loop\nvertex 0 0 0 0\n"), @"line 4: expected nothing after the coordinates of a vertex, found `0`");
        insta::assert_snapshot!(error(text_of(&TWO).replace("endloop", "vertex 0 0 0\nendloop")), @"line 7: expected endloop of facet 0, found `vertex`");
        insta::assert_snapshot!(error(text_of(&TWO) + "end"), @"line 17: expected the word solid, found `end`");
        let mut file = binary_of(&TWO, b"");
        insta::assert_snapshot!(error(&file[..file.len() - 1]), @"byte 183: the file ends where triangle 1 of 2 should follow");
        file.push(0);
        insta::assert_snapshot!(error(&file), @"byte 184: expected the end of the file after 2 triangles, found more");
        file[FRONT + TRIANGLE + NORMAL + 16..].fill(0xff);
        insta::assert_snapshot!(error(&file), @"byte 158: a corner of triangle 1: y is NaN, which is not a finite number");
    }

    #[test]
    fn a_number_of_triangles_costs_nothing() {
        let mut file = binary_of(&[], b"");
        file[HEADER..FRONT].fill(0xff);
        insta::assert_snapshot!(error(&file), @"byte 84: the file ends where triangle 0 of 4294967295 should follow");
    }
}
