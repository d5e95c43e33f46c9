//! A bound on what the arrays of a file may unpack to.

use crate::error::ReadProblem;

/// Bytes granted to every file, however small.
const FREE: u64 = 64 << 20;

/// Bytes granted for every byte of the file. Text, base64 and raw numbers need at most 8, zlib of real meshes a few dozen.
const PER_BYTE: u64 = 64;

/// Bytes that the arrays of a file may still unpack to.
///
/// zlib packs up to a thousand bytes into one, and any number of arrays may lie at the same place of the appended data, so without a
/// bound a small file could ask for any memory and time.
#[derive(Debug)]
pub(crate) struct Budget {
    limit: u64,
    left: u64,
}

impl Budget {
    /// That of a file of `length` bytes.
    pub(crate) const fn of_file(length: usize) -> Self {
        let limit = FREE.saturating_add(PER_BYTE.saturating_mul(length as u64));
        Self { limit, left: limit }
    }

    /// Sets bytes aside, before they are allocated or worked through.
    ///
    /// # Errors
    /// [`ReadProblem::TooLarge`] when there are not as many left.
    pub(crate) fn spend(&mut self, bytes: usize) -> Result<(), ReadProblem> {
        let left = self.left.checked_sub(bytes as u64);
        self.left = left.ok_or(ReadProblem::TooLarge { limit: self.limit })?;
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_budget_is_spent_to_the_last_byte_and_no_further() {
        let mut budget = Budget::of_file(1);
        budget.spend((FREE + PER_BYTE - 1) as usize).unwrap();
        budget.spend(1).unwrap();
        insta::assert_snapshot!(budget.spend(1).unwrap_err(), @"the arrays unpack to more than 67108928 bytes, the most for a file of this size");
        assert!(Budget::of_file(usize::MAX).spend(usize::MAX).is_ok());
    }
}
