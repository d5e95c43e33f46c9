//! A part of a `GeoJSON` document: what it is called in messages, and what it must hold.

use std::fmt;

use serde_json::Value;

use crate::error::{ReadError, ReadProblem};
use crate::lines::quoted;

/// A part and what it is part of. Prints as `ring 1 of polygon 0 of feature 3`.
#[derive(Clone, Copy)]
pub(super) struct Part<'a> {
    name: &'static str,
    index: Option<usize>,
    of: Option<&'a Part<'a>>,
}

impl Part<'_> {
    /// The whole.
    pub(super) const FILE: Part<'static> = Part {
        name: "the file",
        index: None,
        of: None,
    };

    /// A numbered part of this one, from 0.
    pub(super) const fn inner(&self, name: &'static str, index: usize) -> Part<'_> {
        Part {
            name,
            index: Some(index),
            of: Some(self),
        }
    }

    /// The type that an object tells.
    pub(super) fn type_of<'v>(&self, object: &'v Value) -> Result<&'v str, ReadError> {
        let told = self.member(object, "type")?;
        told.as_str()
            .ok_or_else(|| self.unexpected("a string as `type`", told))
    }

    /// A member that an object must have.
    pub(super) fn member<'v>(&self, object: &'v Value, key: &str) -> Result<&'v Value, ReadError> {
        object
            .get(key)
            .ok_or_else(|| self.unexpected(&format!("an object with `{key}`"), object))
    }

    /// A member that an object must have and that is an array.
    pub(super) fn list_in<'v>(
        &self,
        object: &'v Value,
        key: &str,
    ) -> Result<&'v [Value], ReadError> {
        let member = self.member(object, key)?;
        member.as_array().map(Vec::as_slice).ok_or_else(|| {
            let expected = format!("an array as `{key}`");
            self.unexpected(&expected, member)
        })
    }

    /// The elements of this part, which must be an array.
    pub(super) fn list<'v>(&self, value: &'v Value) -> Result<&'v [Value], ReadError> {
        let list = value.as_array().map(Vec::as_slice);
        list.ok_or_else(|| self.unexpected("an array", value))
    }

    /// Something else than expected in this part.
    pub(super) fn unexpected(&self, expected: &str, found: &Value) -> ReadError {
        let expected = format!("{expected} in {self}");
        let found = quoted(&found.to_string());
        ReadProblem::Expected { expected, found }.into()
    }

    /// Fewer positions than this part needs.
    pub(super) fn too_short(&self, fewest: usize, found: usize) -> ReadError {
        let expected = format!("at least {fewest} positions in {self}");
        let found = found.to_string();
        ReadProblem::Expected { expected, found }.into()
    }
}

impl fmt::Display for Part<'_> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(self.name)?;
        if let Some(index) = self.index {
            write!(out, " {index}")?;
        }
        match self.of {
            Some(Part { of: None, .. }) | None => Ok(()),
            Some(whole) => write!(out, " of {whole}"),
        }
    }
}
