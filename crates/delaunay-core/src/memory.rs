//! Large pages for large arrays, and calls for single elements ahead of their use.
//!
//! A build writes arrays of many megabytes once and reads them in a local but not sequential order. In pages
//! of 2 MiB instead of 4 KiB the system has 500 times fewer pages to hand out and the processor finds
//! nearly all their addresses in its cache: a fifth of the time of a build of 10^6 points.
//!
//! Only Linux is asked; elsewhere, and for small arrays, nothing happens.

#![allow(unsafe_code)]

use glam::DVec2;
use std::collections::TryReserveError;
use std::mem::MaybeUninit;

/// Smallest array worth large pages, in bytes: below, a part of a page is lost and little is gained.
const LARGE: usize = 4 << 20;

/// Size of a large page.
const PAGE: usize = 2 << 20;

/// An empty vector with room for `count` elements, in large pages if `huge_pages` says so and it is large.
pub(crate) fn vec_with_capacity<T>(count: usize, huge_pages: bool) -> Vec<T> {
    let mut vec = Vec::with_capacity(count);
    if huge_pages {
        prefer_huge_pages(vec.spare_capacity_mut());
    }
    vec
}

/// As [`vec_with_capacity`], with an error instead of an end when there is no memory.
pub(crate) fn try_vec_with_capacity<T>(
    count: usize,
    huge_pages: bool,
) -> Result<Vec<T>, TryReserveError> {
    let mut vec = Vec::new();
    vec.try_reserve_exact(count)?;
    if huge_pages {
        prefer_huge_pages(vec.spare_capacity_mut());
    }
    Ok(vec)
}

/// `count` times `value`, in large pages if `huge_pages` says so and they are large.
pub(crate) fn vec_of<T: Clone>(value: T, count: usize, huge_pages: bool) -> Vec<T> {
    let mut vec = vec_with_capacity(count, huge_pages);
    vec.resize(count, value);
    vec
}

/// The memory of points as numbers, for what has to be written before the points are: memory fresh from the system is
/// cleared first, which takes longer than the sorting of it.
pub(crate) fn words_of(points: &mut [DVec2]) -> &mut [u64] {
    const { assert!(size_of::<DVec2>() == 16 && align_of::<DVec2>().is_multiple_of(align_of::<u64>())) };
    let words = points.as_mut_ptr().cast();
    // SAFETY: a point is two doubles and nothing else, as large and aligned as two numbers; any bits are valid
    // for either, and the points are borrowed as long as the numbers.
    unsafe { std::slice::from_raw_parts_mut(words, 2 * points.len()) }
}

/// Asks the system to back memory that is not used yet with large pages, where it is large enough.
///
/// A wish about speed alone: nothing is read, written or promised.
pub(crate) fn prefer_huge_pages<T>(spare: &mut [MaybeUninit<T>]) {
    let bytes = size_of_val(spare);
    if bytes < LARGE {
        return;
    }
    let start = spare.as_mut_ptr().cast::<u8>();
    let before = start.align_offset(PAGE);
    let inner = bytes.saturating_sub(before) / PAGE * PAGE;
    advise(start.wrapping_add(before), inner);
}

/// Calls for what is at `place` to be near when it is read soon; any address will do.
#[inline(always)]
pub(crate) fn prefetch<T>(place: *const T) {
    #[cfg(target_arch = "x86_64")]
    {
        use std::arch::x86_64::{_MM_HINT_T0, _mm_prefetch};
        // SAFETY: prefetching has no effect that a program can see, whatever the address.
        unsafe {
            _mm_prefetch::<_MM_HINT_T0>(place.cast());
        }
    }
    #[cfg(not(target_arch = "x86_64"))]
    let _ = place;
}

#[cfg(target_os = "linux")]
fn advise(start: *mut u8, bytes: usize) {
    // SAFETY: the range lies inside one allocation that the caller borrows exclusively. MADV_HUGEPAGE
    // changes neither its contents nor its protection, only which pages back it, so no access to it
    // can tell; an error (no large pages in this kernel) leaves everything as it was.
    unsafe {
        libc::madvise(start.cast(), bytes, libc::MADV_HUGEPAGE);
    }
}

#[cfg(not(target_os = "linux"))]
fn advise(_start: *mut u8, _bytes: usize) {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_vector_in_large_pages_holds_what_is_put_into_it() {
        for count in [0, 10, LARGE / 8 - 1, LARGE / 8, 2 * LARGE / 8 + 77] {
            for huge_pages in [false, true] {
                let mut numbers: Vec<u64> = vec_with_capacity(count, huge_pages);
                numbers.extend(0..count as u64);
                assert_eq!(numbers.capacity(), count);
                assert!(numbers.iter().enumerate().all(|(i, &n)| n == i as u64));
            }
        }
    }
}
