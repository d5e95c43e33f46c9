//! `$MeshFormat`: version, encoding and the width of sizes.

use super::section::{decimal, end_section, next_section};
use crate::error::{ReadError, ReadProblem};
use crate::numbers::{Encoding, Numbers, quoted};

/// A version that can be read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Version {
    V2,
    V41,
}

/// Reads the section that starts every file, and sets the encoding of what follows.
pub(super) fn read_format(file: &mut Numbers<'_>) -> Result<Version, ReadError> {
    match next_section(file)? {
        Some(b"MeshFormat") => {}
        Some(name) => {
            let problem = ReadProblem::Expected {
                expected: "`$MeshFormat`".into(),
                found: quoted(name),
            };
            return Err(file.problem(0, problem));
        }
        None => {
            return Err(file.problem(
                0,
                ReadProblem::Truncated {
                    expected: "`$MeshFormat`".into(),
                },
            ));
        }
    }
    let start = file.at();
    let number: f64 = decimal(file, "the version number")?;
    let binary: i32 = decimal(file, "the file type, 0 or 1")?;
    let width: u32 = decimal(file, "the width of sizes")?;
    let unsupported = |what: String| Err(file.problem(start, ReadProblem::Unsupported(what)));
    let version = match (number, binary, width) {
        (4.1, 0 | 1, 8) => Version::V41,
        (4.1, 0 | 1, _) => return unsupported(format!("an MSH file with sizes of {width} bytes")),
        (2.0..3.0, 0, _) | (2.0..3.0, 1, 8) => Version::V2,
        (2.0..3.0, 1, _) => return unsupported(format!("an MSH file with reals of {width} bytes")),
        (_, 0 | 1, _) => return unsupported(format!("MSH version {number}")),
        _ => return unsupported(format!("MSH file type {binary}")),
    };
    if binary == 1 {
        file.end_line();
        file.encoding = Encoding::Binary;
        check_byte_order(file)?;
    }
    end_section(file, "MeshFormat")?;
    Ok(version)
}

/// The number one, written to show the order of bytes.
fn check_byte_order(file: &mut Numbers<'_>) -> Result<(), ReadError> {
    let start = file.at();
    let problem = match file.int(format_args!("the number 1"))? {
        1 => return Ok(()),
        0x0100_0000 => ReadProblem::Unsupported("an MSH file in big-endian binary".into()),
        other => ReadProblem::Expected {
            expected: "the number 1".into(),
            found: format!("{other}"),
        },
    };
    Err(file.problem(start, problem))
}
