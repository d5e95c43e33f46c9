//! Work in equal shares, one for each thread.

use rayon::prelude::*;

/// Runs `work` on every task, at the same time as far as the current pool has threads; a single task stays
/// on the caller's thread.
pub(crate) fn for_each<T: Send>(tasks: Vec<T>, work: impl Fn(T) + Sync + Send) {
    if tasks.len() > 1 {
        tasks.into_par_iter().with_max_len(1).for_each(work);
    } else {
        tasks.into_iter().for_each(work);
    }
}

/// As [`for_each`], with what `work` answers, in the order of the tasks.
pub(crate) fn map<T: Send, R: Send>(tasks: Vec<T>, work: impl Fn(T) -> R + Sync + Send) -> Vec<R> {
    if tasks.len() > 1 {
        tasks.into_par_iter().with_max_len(1).map(work).collect()
    } else {
        tasks.into_iter().map(work).collect()
    }
}

/// The size of `threads` equal shares of `count` things; never 0.
pub(crate) fn share(count: usize, threads: usize) -> usize {
    count.div_ceil(threads.max(1)).max(1)
}

/// Makes each of `places` out of its source, in one share for each thread.
pub(crate) fn fill<T: Send, S: Sync>(
    places: &mut [T],
    sources: &[S],
    threads: usize,
    make: impl Fn(&S) -> T + Sync + Send,
) {
    debug_assert_eq!(places.len(), sources.len());
    let share = share(places.len(), threads);
    let shares = places.chunks_mut(share).zip(sources.chunks(share));
    for_each(shares.collect(), |(places, sources)| {
        for (place, source) in places.iter_mut().zip(sources) {
            *place = make(source);
        }
    });
}

/// What `judge` says of all `things`, which it looks at in one share for each thread.
pub(crate) fn check<T: Sync, E: Send>(
    things: &[T],
    threads: usize,
    judge: impl Fn(&[T]) -> Result<(), E> + Sync + Send,
) -> Result<(), E> {
    let shares = things.chunks(share(things.len(), threads)).collect();
    match map(shares, &judge).iter().all(Result::is_ok) {
        true => Ok(()),
        // An error may name a place, and that of a share counts from the start of the share.
        false => judge(things),
    }
}
