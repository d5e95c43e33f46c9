//! Sizes that grow no faster than they may, along curves and from one to another.

use rayon::prelude::*;

use super::track::{Sample, Track};
use crate::envelope::{Cone, Envelope};

/// Limits the sizes of all samples.
pub(super) fn grade(tracks: &mut [Track<'_>], grade: f64) {
    let samples = tracks.iter().flat_map(|track| &track.samples);
    let cones = samples.map(|sample| Cone {
        place: sample.place,
        size: sample.limit(),
    });
    let envelope = Envelope::of(cones.collect(), grade);
    let limit = |sample: &mut Sample| sample.size = envelope.at(sample.place, sample.limit());
    for track in tracks {
        track
            .samples
            .par_iter_mut()
            .with_min_len(256)
            .for_each(limit);
    }
}
