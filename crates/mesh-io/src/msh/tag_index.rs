//! Which element of a list a tag means.

/// Positions by tag.
#[derive(Debug)]
pub(super) enum TagIndex {
    /// Tags count up from `first`.
    Contiguous { first: u64, count: u64 },
    /// Tags in growing order, each with its position.
    Sorted(Vec<(u64, u32)>),
}

/// Two elements with one tag.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Twice {
    pub(super) tag: u64,
    pub(super) first: u32,
    pub(super) second: u32,
}

impl TagIndex {
    /// The index of a list of tags. O(n) when they are contiguous, otherwise O(n log n).
    ///
    /// # Errors
    /// The smallest tag that occurs twice.
    pub(super) fn of(tags: &[u64]) -> Result<Self, Twice> {
        let first = tags.first().copied().unwrap_or(0);
        if (first..).zip(tags).all(|(expected, &tag)| expected == tag) {
            return Ok(Self::Contiguous {
                first,
                count: tags.len() as u64,
            });
        }
        let mut sorted: Vec<(u64, u32)> = tags.iter().copied().zip(0..).collect();
        sorted.sort_unstable();
        for (&(tag, first), &(next, second)) in sorted.iter().zip(sorted.iter().skip(1)) {
            if tag == next {
                return Err(Twice { tag, first, second });
            }
        }
        Ok(Self::Sorted(sorted))
    }

    /// Position of the element of a tag; `None` when there is none. O(1) for contiguous tags, otherwise O(log n).
    pub(super) fn position(&self, tag: u64) -> Option<u32> {
        match self {
            Self::Contiguous { first, count } => {
                let position = tag
                    .checked_sub(*first)
                    .filter(|position| position < count)?;
                u32::try_from(position).ok()
            }
            Self::Sorted(tags) => {
                let found = tags.binary_search_by_key(&tag, |&(tag, _)| tag).ok()?;
                tags.get(found).map(|&(_, position)| position)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tag_means_the_element_that_has_it_and_no_other() {
        for tags in [vec![], vec![7, 8, 9], vec![9, 3, u64::MAX, 4]] {
            let index = TagIndex::of(&tags).unwrap();
            for tag in (0..20).chain([u64::MAX]) {
                let expected = tags.iter().position(|&found| found == tag);
                assert_eq!(
                    index.position(tag).map(|position| position as usize),
                    expected,
                    "{tag} in {tags:?}"
                );
            }
        }
    }

    #[test]
    fn a_tag_that_occurs_twice_is_named_with_both_elements() {
        assert_eq!(
            TagIndex::of(&[5, 2, 9, 5]).unwrap_err(),
            Twice {
                tag: 5,
                first: 0,
                second: 3
            }
        );
    }
}
