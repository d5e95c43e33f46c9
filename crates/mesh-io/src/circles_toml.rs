//! `DOMAIN.toml`: circles as people write them.
//!
//! ```toml
//! [domain]
//! kind = "circle"          # or "periodic", with period = [1.0, 1.0]
//! centre = [0.0, 0.0]
//! radius = 1.74
//!
//! [[hole]]
//! centre = [0.5, 0.0]
//! radius = 0.3
//! kind = "large"           # optional
//! ```

use std::io::Write;

use serde::Deserialize;
use toml::Spanned;

use crate::circles::{CirclesDomain, Frame, Hole};
use crate::error::{ReadError, ReadProblem, WriteError};

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Document {
    domain: Spanned<FrameTable>,
    #[serde(default)]
    hole: Vec<Spanned<HoleTable>>,
}

/// The kind decides which of the other keys must be there, which serde could say only without lines.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct FrameTable {
    kind: Spanned<String>,
    centre: Option<Spanned<Pair>>,
    radius: Option<Spanned<f64>>,
    period: Option<Spanned<Pair>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct HoleTable {
    centre: Pair,
    radius: f64,
    kind: Option<String>,
}

/// Two numbers. (An array type would be content with the first two of three.)
#[derive(Deserialize)]
#[serde(try_from = "Vec<f64>")]
struct Pair([f64; 2]);

impl TryFrom<Vec<f64>> for Pair {
    type Error = String;

    fn try_from(numbers: Vec<f64>) -> Result<Self, String> {
        <[f64; 2]>::try_from(numbers)
            .map(Self)
            .map_err(|numbers| format!("expected 2 numbers, found {}", numbers.len()))
    }
}

/// The circles of a `DOMAIN.toml`, every hole with its line. Numbers are kept as they are, infinite and NaN included.
///
/// # Errors
/// Syntax, missing and unknown keys, values of another type, each with its line. O(file).
pub fn parse(bytes: &[u8]) -> Result<CirclesDomain, ReadError> {
    let text = std::str::from_utf8(bytes)
        .map_err(|error| ReadError::at_byte(error.valid_up_to(), ReadProblem::NotText))?;
    let lines = LineEnds::of(text);
    let document: Document = toml::from_str(text).map_err(|error| {
        let problem = ReadProblem::Syntax(one_line(error.message()));
        match error.span() {
            Some(span) => ReadError::at_line(lines.line_of(span.start), problem),
            None => problem.into(),
        }
    })?;
    let frame = frame(&lines, document.domain)?;
    let hole = |table: Spanned<HoleTable>| {
        let line = Some(lines.line_of(table.span().start));
        let HoleTable {
            centre,
            radius,
            kind,
        } = table.into_inner();
        Hole {
            centre: centre.0,
            radius,
            kind,
            line,
        }
    };
    Ok(CirclesDomain {
        frame,
        holes: document.hole.into_iter().map(hole).collect(),
    })
}

fn frame(lines: &LineEnds, table: Spanned<FrameTable>) -> Result<Frame, ReadError> {
    let line = lines.line_of(table.span().start);
    let FrameTable {
        kind,
        centre,
        radius,
        period,
    } = table.into_inner();
    let kind_line = lines.line_of(kind.span().start);
    let missing = |key: &str| {
        let expected = format!("`{key}` in a domain of kind \"{}\"", kind.get_ref());
        ReadError::at_line(
            line,
            ReadProblem::Expected {
                expected,
                found: "none".into(),
            },
        )
    };
    let foreign = |key: &str, start: usize| {
        let expected = format!("no `{key}` in a domain of kind \"{}\"", kind.get_ref());
        ReadError::at_line(
            lines.line_of(start),
            ReadProblem::Expected {
                expected,
                found: "one".into(),
            },
        )
    };
    match kind.get_ref().as_str() {
        "circle" => {
            if let Some(period) = period {
                return Err(foreign("period", period.span().start));
            }
            let centre = centre.ok_or_else(|| missing("centre"))?.into_inner().0;
            let radius = radius.ok_or_else(|| missing("radius"))?.into_inner();
            Ok(Frame::Circle { centre, radius })
        }
        "periodic" => {
            if let Some(centre) = centre {
                return Err(foreign("centre", centre.span().start));
            }
            if let Some(radius) = radius {
                return Err(foreign("radius", radius.span().start));
            }
            Ok(Frame::Periodic {
                period: period.ok_or_else(|| missing("period"))?.into_inner().0,
            })
        }
        other => {
            let expected = "\"circle\" or \"periodic\" as the kind of domain".into();
            Err(ReadError::at_line(
                kind_line,
                ReadProblem::Expected {
                    expected,
                    found: format!("{other:?}"),
                },
            ))
        }
    }
}

/// Where the lines of a text end, to find the line of any byte.
struct LineEnds(Vec<usize>);

impl LineEnds {
    fn of(text: &str) -> Self {
        Self(text.match_indices('\n').map(|(byte, _)| byte).collect())
    }

    /// Number of the line that holds a byte, from 1. O(log lines).
    fn line_of(&self, byte: usize) -> usize {
        self.0.partition_point(|&end| end < byte) + 1
    }
}

fn one_line(message: &str) -> String {
    message.lines().collect::<Vec<_>>().join("; ")
}

/// Writes circles so that reading gives the same bits.
///
/// # Errors
/// Only what the writer `out` answers.
pub fn write(out: &mut impl Write, domain: &CirclesDomain) -> Result<(), WriteError> {
    writeln!(out, "[domain]")?;
    match domain.frame {
        Frame::Circle { centre, radius } => {
            writeln!(
                out,
                "kind = \"circle\"\ncentre = {}\nradius = {}",
                pair(centre),
                number(radius)
            )?;
        }
        Frame::Periodic { period } => {
            writeln!(out, "kind = \"periodic\"\nperiod = {}", pair(period))?;
        }
    }
    for hole in &domain.holes {
        writeln!(
            out,
            "\n[[hole]]\ncentre = {}\nradius = {}",
            pair(hole.centre),
            number(hole.radius)
        )?;
        if let Some(kind) = &hole.kind {
            writeln!(out, "kind = {}", toml::Value::from(kind.as_str()))?;
        }
    }
    Ok(())
}

fn pair([x, y]: [f64; 2]) -> String {
    format!("[{}, {}]", number(x), number(y))
}

/// A float of TOML: the shortest that reads back the same.
fn number(value: f64) -> String {
    if value.is_nan() {
        "nan".into()
    } else {
        format!("{value:?}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CIRCLE: &str = "[domain]\nkind = \"circle\"\ncentre = [0, 0.5]\nradius = 2\n";

    fn error(text: &str) -> String {
        parse(text.as_bytes()).unwrap_err().to_string()
    }

    #[test]
    fn every_hole_knows_its_line() {
        let text = format!(
            "{CIRCLE}\n[[hole]]\ncentre = [1, nan]\nradius = -inf\n\n# big\n[[hole]]\nkind = \"a\"\ncentre = [0, 0]\nradius = 1\n"
        );
        let domain = parse(text.as_bytes()).unwrap();
        assert_eq!(
            domain.frame,
            Frame::Circle {
                centre: [0.0, 0.5],
                radius: 2.0
            }
        );
        assert_eq!(
            domain
                .holes
                .iter()
                .map(|hole| hole.line)
                .collect::<Vec<_>>(),
            [Some(6), Some(11)]
        );
        assert!(domain.holes[0].centre[1].is_nan() && domain.holes[0].radius == f64::NEG_INFINITY);
        assert_eq!(domain.holes[1].kind.as_deref(), Some("a"));
    }

    #[test]
    fn what_is_written_reads_back() {
        let hole = Hole {
            centre: [1e300, -0.0],
            radius: 0.1 + 0.2,
            kind: Some("\"tricky\"\n'#".into()),
            line: None,
        };
        for frame in [
            Frame::Periodic {
                period: [1.0, f64::INFINITY],
            },
            Frame::Circle {
                centre: [1e-300, 7.0],
                radius: 3.0,
            },
        ] {
            let domain = CirclesDomain {
                frame,
                holes: vec![
                    hole.clone(),
                    Hole {
                        kind: None,
                        ..hole.clone()
                    },
                ],
            };
            let mut out = Vec::new();
            write(&mut out, &domain).unwrap();
            let mut read = parse(&out).unwrap();
            read.holes.iter_mut().for_each(|hole| hole.line = None);
            assert_eq!(read, domain);
        }
    }

    /// Once every hole counted its line from the start of the file.
    #[test]
    fn many_holes_are_read_in_proportion_to_their_number() {
        const HOLES: usize = 50_000;
        let text = format!(
            "{CIRCLE}{}",
            "[[hole]]\ncentre = [1, 2]\nradius = 3\n".repeat(HOLES)
        );
        let domain = parse(text.as_bytes()).unwrap();
        assert_eq!(
            domain.holes.last().and_then(|hole| hole.line),
            Some(3 * HOLES + 2)
        );
    }

    #[test]
    fn errors_name_their_line() {
        insta::assert_snapshot!(error(""), @"line 1: missing field `domain`");
        insta::assert_snapshot!(error("[domain]\nkind = \"square\""), @r#"line 2: expected "circle" or "periodic" as the kind of domain, found "square""#);
        insta::assert_snapshot!(error("[domain]\nkind = \"circle\"\ncentre = [0, 0]"), @r#"line 1: expected `radius` in a domain of kind "circle", found none"#);
        insta::assert_snapshot!(error("[domain]\nkind = \"periodic\"\nperiod = [1, 1]\nradius = 3"), @r#"line 4: expected no `radius` in a domain of kind "periodic", found one"#);
        insta::assert_snapshot!(error(&format!("{CIRCLE}period = [1, 1]")), @r#"line 5: expected no `period` in a domain of kind "circle", found one"#);
        insta::assert_snapshot!(error(&format!("{CIRCLE}\n[[hole]]\nradius = 1\nrum = 2\n")), @"line 8: unknown field `rum`, expected one of `centre`, `radius`, `kind`");
        insta::assert_snapshot!(error(&format!("{CIRCLE}\n[[hole]]\nradius = 1\n")), @"line 6: missing field `centre`");
        insta::assert_snapshot!(error(&format!("{CIRCLE}\n[[hole]]\nradius = \"1\"\n")), @r#"line 7: invalid type: string "1", expected f64"#);
        insta::assert_snapshot!(error(&format!("{CIRCLE}\n[[hole]]\ncentre = [1, 2, 3]\nradius = 1\n")), @"line 7: expected 2 numbers, found 3");
        insta::assert_snapshot!(error(&format!("{CIRCLE}\n[[hole]\n")), @"line 6: unclosed array table, expected `]`");
        insta::assert_snapshot!(error(&format!("{CIRCLE}[[holes]]\nradius = 1")), @"line 5: unknown field `holes`, expected `domain` or `hole`");
    }
}
