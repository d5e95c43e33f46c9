//! How often a build asks for memory.

#![allow(clippy::unwrap_used, unsafe_code)]

mod clouds;

use delaunay_core::Delaunay2;
use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

/// The system's allocator, counting the requests of each thread.
struct Counting;

thread_local! {
    static REQUESTS: Cell<usize> = const { Cell::new(0) };
}

// SAFETY: all is done by the system's allocator; the counter takes no memory from it.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        REQUESTS.set(REQUESTS.get() + 1);
        // SAFETY: the caller's promise.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, place: *mut u8, layout: Layout) {
        // SAFETY: the caller's promise.
        unsafe { System.dealloc(place, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

fn requests(work: impl FnOnce()) -> usize {
    let before = REQUESTS.get();
    work();
    REQUESTS.get() - before
}

#[test]
fn the_insertion_loop_asks_for_no_memory() {
    let build = |count| {
        let points = clouds::uniform(count, 3);
        requests(|| drop(Delaunay2::build(&points).unwrap()))
    };
    // Arrays per build and per round, nothing per point: eight times the points are one round more.
    let (few, many) = (build(9000), build(72_000));
    assert!(few > 0 && few < 60 && many <= few + 8, "{few} {many}");
}
