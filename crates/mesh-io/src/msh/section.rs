//! Sections: what stands between a line `$Name` and a line `$EndName`.

use crate::error::{ReadError, ReadProblem};
use crate::numbers::{Numbers, quoted};

/// The name on the line `$Name` that comes next; `None` at the end of the file.
pub(super) fn next_section<'a>(file: &mut Numbers<'a>) -> Result<Option<&'a [u8]>, ReadError> {
    let Some(word) = file.word() else {
        return Ok(None);
    };
    match word.strip_prefix(b"$") {
        Some(name) if !name.starts_with(b"End") => {
            file.end_line();
            Ok(Some(name))
        }
        _ => {
            let problem = ReadProblem::Expected {
                expected: "the start of a section".into(),
                found: quoted(word),
            };
            Err(file.problem(file.at() - word.len(), problem))
        }
    }
}

/// Reads the line `$EndName`.
pub(super) fn end_section(file: &mut Numbers<'_>, name: &str) -> Result<(), ReadError> {
    let expected = || format!("`$End{name}`");
    let Some(word) = file.word() else {
        return Err(file.problem(
            file.at(),
            ReadProblem::Truncated {
                expected: expected(),
            },
        ));
    };
    if word.strip_prefix(b"$End") != Some(name.as_bytes()) {
        let problem = ReadProblem::Expected {
            expected: expected(),
            found: quoted(word),
        };
        return Err(file.problem(file.at() - word.len(), problem));
    }
    Ok(())
}

/// Passes over a section that is not read, up to and with `$EndName`.
pub(super) fn skip_section(file: &mut Numbers<'_>, name: &[u8]) -> Result<(), ReadError> {
    let end = [b"$End", name].concat();
    let Some(length) = file
        .rest()
        .windows(end.len())
        .position(|window| window == end)
    else {
        let expected = quoted(&end);
        return Err(file.problem(file.at(), ReadProblem::Truncated { expected }));
    };
    file.skip(length + end.len());
    Ok(())
}

/// A number that is decimal in every encoding, as in `$PhysicalNames` and in the head of data.
pub(super) fn decimal<T: std::str::FromStr>(
    file: &mut Numbers<'_>,
    expected: &str,
) -> Result<T, ReadError> {
    let Some(word) = file.word() else {
        return Err(file.problem(
            file.at(),
            ReadProblem::Truncated {
                expected: expected.into(),
            },
        ));
    };
    std::str::from_utf8(word)
        .ok()
        .and_then(|word| word.parse().ok())
        .ok_or_else(|| {
            let problem = ReadProblem::Expected {
                expected: expected.into(),
                found: quoted(word),
            };
            file.problem(file.at() - word.len(), problem)
        })
}

/// A text between quotation marks.
pub(super) fn quoted_text(file: &mut Numbers<'_>, expected: &str) -> Result<String, ReadError> {
    file.skip_blanks();
    let start = file.at();
    let Some(found) = file.line() else {
        return Err(file.problem(
            start,
            ReadProblem::Truncated {
                expected: expected.into(),
            },
        ));
    };
    let text = found
        .strip_prefix(b"\"")
        .and_then(|found| found.strip_suffix(b"\""));
    text.and_then(|text| String::from_utf8(text.to_vec()).ok())
        .ok_or_else(|| {
            file.problem(
                start,
                ReadProblem::Expected {
                    expected: expected.into(),
                    found: quoted(found),
                },
            )
        })
}
