//! The appended data of a VTU: arrays one behind the other after the XML, in raw bytes or in base64.

use std::borrow::Cow;

use memchr::{memchr, memmem};

use super::base64_runs;
use super::budget::Budget;
use super::packed::Layout;
use crate::error::ReadProblem;

const TAG: &[u8] = b"<AppendedData";

/// Everything up to `<AppendedData`, and what follows it. O(file).
pub(super) fn split_appended(bytes: &[u8]) -> (&[u8], &[u8]) {
    bytes.split_at(memmem::find(bytes, TAG).unwrap_or(bytes.len()))
}

/// What lies behind the underscore that opens the data.
#[derive(Clone, Copy)]
pub(super) struct Appended<'a> {
    is_raw: bool,
    data: &'a [u8],
}

impl<'a> Appended<'a> {
    /// The data of the element that `split_appended` found; `None` when there is none.
    pub(super) fn find(element: &'a [u8]) -> Option<Self> {
        let (tag, content) = element.split_at(memchr(b'>', element)?);
        let (_, data) = content.split_at_checked(memchr(b'_', content)? + 1)?;
        let is_raw = memmem::find(tag, b"raw").is_some();
        Some(Self { is_raw, data })
    }

    /// The array at `offset` with its header, and perhaps more behind it.
    ///
    /// # Errors
    /// An offset behind the end, base64 that is none, an empty budget: many arrays may share one place.
    pub(super) fn at(
        appended: Option<Self>,
        layout: Layout,
        offset: usize,
        budget: &mut Budget,
    ) -> Result<Cow<'a, [u8]>, ReadProblem> {
        let missing = || ReadProblem::Truncated {
            expected: "appended data".into(),
        };
        let Self { is_raw, data } = appended.ok_or_else(missing)?;
        let array = data.get(offset..).ok_or_else(missing)?;
        if is_raw {
            return Ok(Cow::Borrowed(array));
        }
        let run = base64_runs::appended_run(layout, array)?;
        budget.spend(run.len())?;
        base64_runs::decode(run).map(Cow::Owned)
    }
}
