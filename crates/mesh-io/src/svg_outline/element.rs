//! An element of a drawing and its attributes.

use kurbo::Affine;
use quick_xml::escape;
use quick_xml::events::BytesStart;
use svgtypes::{Length, LengthUnit, NumberListParser, Transform};

use super::DrawingDefect;
use crate::error::ReadProblem;
use crate::lines::quoted;

/// The start of an element.
pub(super) struct Element<'a> {
    tag: &'a BytesStart<'a>,
}

impl<'a> Element<'a> {
    pub(super) fn of(tag: &'a BytesStart<'a>) -> Self {
        Self { tag }
    }

    /// Its name without the prefix `svg:`; any other prefix stays.
    pub(super) fn name(&self) -> &'a str {
        let name = self.tag.name().into_inner();
        name.strip_prefix("svg:").unwrap_or(name)
    }

    /// How messages call it: its name, and its id if it has one.
    pub(super) fn label(&self) -> String {
        let name = quoted(self.name());
        let name = name.trim_matches('`');
        match self.attribute("id") {
            Ok(Some(id)) => format!("<{name} id={}>", quoted(&id)),
            _ => format!("<{name}>"),
        }
    }

    /// The value of an attribute, if it is there.
    pub(super) fn attribute(&self, name: &str) -> Result<Option<String>, ReadProblem> {
        let syntax = |error: String| ReadProblem::Syntax(error);
        let found = self.tag.try_get_attribute(name);
        let Some(found) = found.map_err(|error| syntax(error.to_string()))? else {
            return Ok(None);
        };
        let value = escape::unescape(&found.value).map_err(|error| syntax(error.to_string()))?;
        Ok(Some(value.into_owned()))
    }

    /// Whether neither `display` nor `style` hides it.
    pub(super) fn is_displayed(&self) -> Result<bool, ReadProblem> {
        // A declaration may end in `!important`.
        let hides = |value: &str| {
            let word = value.split('!').next().unwrap_or_default();
            word.trim().eq_ignore_ascii_case("none")
        };
        let style = self.attribute("style")?.unwrap_or_default();
        let declared = style.split(';').filter_map(|one| one.split_once(':'));
        // As in CSS the last declaration counts, and any counts more than the attribute.
        let mut declared = declared.filter(|(name, _)| name.trim().eq_ignore_ascii_case("display"));
        Ok(match declared.next_back() {
            Some((_, value)) => !hides(value),
            None => !self
                .attribute("display")?
                .is_some_and(|value| hides(&value)),
        })
    }

    /// Its own transform.
    pub(super) fn transform(&self) -> Result<Affine, ReadProblem> {
        let Some(value) = self.attribute("transform")? else {
            return Ok(Affine::IDENTITY);
        };
        let parsed = value.parse::<Transform>();
        let Transform { a, b, c, d, e, f } =
            parsed.map_err(|error| self.fault("transform", error.to_string()))?;
        Ok(Affine::new([a, b, c, d, e, f]))
    }

    /// A coordinate in user units, 0 if it is not there.
    pub(super) fn coordinate(&self, name: &'static str) -> Result<f64, ReadProblem> {
        Ok(self.length(name)?.unwrap_or(0.0))
    }

    /// A width, height or radius in user units, not negative; `None` if it is not there or `auto`.
    pub(super) fn extent(&self, name: &'static str) -> Result<Option<f64>, ReadProblem> {
        match self.length(name)? {
            Some(value) if value < 0.0 => Err(DrawingDefect::Negative {
                element: self.label(),
                attribute: name,
                value,
            }
            .into()),
            length => Ok(length),
        }
    }

    fn length(&self, name: &'static str) -> Result<Option<f64>, ReadProblem> {
        let value = self.attribute(name)?;
        let Some(value) = value
            .as_deref()
            .map(str::trim)
            .filter(|&value| value != "auto")
        else {
            return Ok(None);
        };
        let length = value
            .parse::<Length>()
            .map_err(|_| self.fault(name, format!("{} is no number", quoted(value))))?;
        match length.unit {
            LengthUnit::None | LengthUnit::Px => Ok(Some(length.number)),
            _ => Err(ReadProblem::Unsupported(format!(
                "{}: the unit of {name} in {}",
                self.label(),
                quoted(value)
            ))),
        }
    }

    /// The points of a list of coordinates, in order; none if the attribute is not there.
    pub(super) fn points(&self, name: &'static str) -> Result<Vec<[f64; 2]>, ReadProblem> {
        let value = self.attribute(name)?.unwrap_or_default();
        let numbers: Vec<f64> = NumberListParser::from(value.trim())
            .collect::<Result<_, _>>()
            .map_err(|error| self.fault(name, error.to_string()))?;
        let (points, odd) = numbers.as_chunks();
        match odd {
            [] => Ok(points.to_vec()),
            _ => Err(self.fault(name, format!("{} numbers make no points", numbers.len()))),
        }
    }

    /// Something wrong with an attribute.
    pub(super) fn fault(&self, attribute: &'static str, fault: String) -> ReadProblem {
        DrawingDefect::Attribute {
            element: self.label(),
            attribute,
            fault,
        }
        .into()
    }
}
