//! What stands before the points: the kind of the file, and how much follows.

use crate::error::{ReadError, ReadProblem};
use crate::lines::{Line, Lines};
use crate::mesh::MeshDefect;

/// The counts of a file, and whether more than coordinates stands on the line of a point.
pub(super) struct Header {
    pub(super) points: usize,
    pub(super) faces: usize,
    pub(super) has_attributes: bool,
}

impl Header {
    /// The lines of a file that is text, and its header: the word OFF, with letters in front where points have texture coordinates
    /// (ST), colours (C) or normals (N), and the counts behind it or on the line below. Files without the word begin with the counts.
    pub(super) fn read(bytes: &[u8]) -> Result<(Self, Lines<'_>), ReadError> {
        refuse_binary(bytes)?;
        let mut lines = Lines::new(bytes)?;
        let mut line = lines.due(format_args!("the word OFF"))?;
        let first = line.first_word().unwrap_or_default();
        let has_kind = first.parse::<usize>().is_err();
        let has_attributes = has_kind && has_attributes(&mut line)?;
        if line.is_done() {
            line = lines.due(format_args!("the numbers of points, faces and edges"))?;
        }
        let points = line.number(format_args!("the number of points"))?;
        let faces = line.number(format_args!("the number of faces"))?;
        // The number of edges never means anything.
        let _edges = line.word();
        line.end(format_args!("the numbers of points, faces and edges"))?;
        if u32::try_from(points).is_err() {
            return Err(line.problem(MeshDefect::TooManyPoints(points)));
        }
        let header = Self {
            points,
            faces,
            has_attributes,
        };
        Ok((header, lines))
    }
}

/// Reads the word for the kind of the file.
fn has_attributes(line: &mut Line<'_>) -> Result<bool, ReadError> {
    let word = line.word().unwrap_or_default();
    let strange = || line.unexpected(format_args!("the word OFF"), word);
    let mut rest = word.strip_suffix("OFF").ok_or_else(strange)?;
    let mut has_attributes = false;
    for attribute in ["ST", "C", "N"] {
        if let Some(behind) = rest.strip_prefix(attribute) {
            has_attributes = true;
            rest = behind;
        }
    }
    let what = match rest {
        "" => return Ok(has_attributes),
        "4" => format!("{word}, whose points have four coordinates,"),
        "n" | "4n" => format!("{word}, whose points have any number of coordinates,"),
        _ => return Err(strange()),
    };
    Err(line.problem(ReadProblem::Unsupported(what)))
}

/// Refuses a file that says to be binary, before its bytes are found to be no text.
fn refuse_binary(bytes: &[u8]) -> Result<(), ReadError> {
    let mut lines = (1..).zip(bytes.split(|&byte| byte == b'\n').map(<[u8]>::trim_ascii));
    let first = lines.find(|(_, text)| !text.is_empty() && !text.starts_with(b"#"));
    let Some((number, text)) = first else {
        return Ok(());
    };
    let words = text.split(u8::is_ascii_whitespace);
    let mut words = words.filter(|word| !word.is_empty());
    match (words.next(), words.next()) {
        (Some(kind), Some(b"BINARY")) if kind.ends_with(b"OFF") => {
            let problem = ReadProblem::Unsupported("binary OFF".into());
            Err(ReadError::at_line(number, problem))
        }
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use crate::off::{parse, parse_outline};

    const POINT: [&str; 4] = ["OFF", "COFF", "NOFF", "STCNOFF"];

    #[test]
    fn colours_normals_and_texture_coordinates_of_points_are_passed_over() {
        let attributes = ["", " 255 0 0 255", " 0 0 1", " 0.5 0.5 1 0 0 1 0 0 1"];
        let wanted = parse(b"OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2").unwrap();
        for (word, more) in POINT.into_iter().zip(attributes) {
            for counts in [" 3 1 0", "\n# counts\n\n3 1", "\n3 1 0 # counts"] {
                let points = format!("0 0 0{more}\n1 0 0{more} # a comment\n0 1 0{more}\n");
                let file = format!("# a file\n{word}{counts}\n{points}3 0 1 2 0.5 0.5 0.5\n");
                assert_eq!(parse(file.as_bytes()).unwrap(), wanted, "{file}");
                assert_eq!(parse_outline(file.as_bytes()).unwrap().segments.len(), 3);
            }
        }
        assert_eq!(
            parse(b"3 1 3\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2").unwrap(),
            wanted
        );
    }

    #[test]
    fn other_kinds_are_refused_by_name() {
        let error = |text: &[u8]| parse(text).unwrap_err();
        insta::assert_snapshot!(error(b"4OFF\n1 0 0\n0 0 0 1"), @"line 1: 4OFF, whose points have four coordinates, is not supported");
        insta::assert_snapshot!(error(b"CnOFF\n3\n1 0 0"), @"line 1: CnOFF, whose points have any number of coordinates, is not supported");
        insta::assert_snapshot!(error(b"# a comment\nOFF BINARY\n\0\0\0\xff"), @"line 2: binary OFF is not supported");
        insta::assert_snapshot!(error(b"NCOFF\n0 0 0"), @"line 1: expected the word OFF, found `NCOFF`");
        insta::assert_snapshot!(error(b"-3 1 0\n"), @"line 1: expected the word OFF, found `-3`");
        insta::assert_snapshot!(error(b"OFF\n1 0 0\n0 0 0 255"), @"line 3: expected nothing after the coordinates of point 0, found `255`");
        insta::assert_snapshot!(error(b"COFF\n1 0 0\n0 0"), @"line 3: expected coordinate z of point 0, found the end of the line");
        insta::assert_snapshot!(error(b"3 1\n0 0 0\n"), @"line 2: the file ends where point 1 of 3 should follow");
    }
}
