//! The whole, step by step.

use delaunay_core::Delaunay2;

use super::chain::Curve;
use super::error::SamplingError;
use super::grade::grade;
use super::params::Sampling;
use super::place::{Span, count, place};
use super::sampled::{Numbering, Sampled};
use super::stray::tighten;
use super::track::{Sizes, Track};

/// At most so many times sizes are adapted to the edges that they lead to; it seldom takes more than five.
const ROUNDS: usize = 24;

/// Edges that are this part of their size or more are as long as they should be.
const CLOSE: f64 = 0.9;

/// Samples one curve; as [`sample_all`].
///
/// # Errors
/// As [`sample_all`].
pub fn sample(curve: &Curve, sampling: &Sampling) -> Result<Sampled, SamplingError> {
    sample_all(std::slice::from_ref(curve), sampling)
}

/// Samples several curves together, so that sizes know of each other.
///
/// The [module](super) says what is promised. Takes n log n time for n nodes, a few times over; the same curves give the same nodes, bit
/// for bit, on any number of threads. It ends when no edge strays too far from its curve and few are much
/// shorter than their size: sizes only ever shrink, where edges stray never below two tolerances, and for the sake of short edges in
/// a few rounds at most.
///
/// # Errors
/// [`SamplingError`] when what is asked for makes no sense, or takes more nodes than are allowed.
pub fn sample_all(curves: &[Curve], sampling: &Sampling) -> Result<Sampled, SamplingError> {
    sampling.check()?;
    sample_sized(curves, sampling, Sizes::Free)
}

/// As [`sample_all`], with sizes of the curves' own; the largest may be infinite then.
pub(crate) fn sample_sized(
    curves: &[Curve],
    sampling: &Sampling,
    sizes: Sizes,
) -> Result<Sampled, SamplingError> {
    let mut tracks: Vec<Track<'_>> = curves
        .iter()
        .map(|curve| Track::of(curve, sampling, sizes))
        .collect();
    let mut rounds = 0;
    loop {
        refine(&mut tracks, sampling)?;
        check_budget(tracks.iter().map(count).sum(), sampling)?;
        let placed: Vec<Vec<Span>> = tracks.iter().map(place).collect();
        let mut is_good = true;
        for (track, spans) in tracks.iter_mut().zip(&placed) {
            let strays = tighten(track, spans, sampling);
            let settles = rounds == ROUNDS || settle(track, spans);
            is_good &= settles && !strays;
        }
        if is_good {
            return number(&placed, sampling);
        }
        rounds = ROUNDS.min(rounds + 1);
    }
}

/// Limits sizes and divides intervals until sizes are known well everywhere.
fn refine(tracks: &mut [Track<'_>], sampling: &Sampling) -> Result<(), SamplingError> {
    loop {
        grade(tracks, sampling.grade);
        let least = tracks
            .iter()
            .map(|track| track.least_edges(sampling) - track.pieces());
        check_budget(least.sum(), sampling)?;
        let mut is_divided = false;
        for track in &mut *tracks {
            is_divided |= track.divide(sampling);
        }
        if !is_divided {
            return Ok(());
        }
    }
}

/// Asks for the sizes that edges have where these are much shorter than asked for; whether that is nowhere so.
///
/// A piece as long as one edge and a bit has edges half as long. Its neighbours should know.
fn settle(track: &mut Track<'_>, spans: &[Span]) -> bool {
    let short = spans.iter().filter(|span| span.share < CLOSE);
    let mut is_settled = true;
    for span in short {
        is_settled = false;
        let [first, last] = span.samples;
        for sample in &mut track.samples[first..=last] {
            sample.ask(span.share * sample.size);
        }
    }
    is_settled
}

/// Judges how many nodes there are between joints.
fn check_budget(nodes: f64, sampling: &Sampling) -> Result<(), SamplingError> {
    let at_most = sampling.at_most.min(Delaunay2::MAX_POINTS);
    match nodes <= at_most as f64 {
        true => Ok(()),
        false => Err(SamplingError::TooManyNodes { at_most }),
    }
}

fn number(placed: &[Vec<Span>], sampling: &Sampling) -> Result<Sampled, SamplingError> {
    let mut numbering = Numbering::default();
    for (curve, spans) in placed.iter().enumerate() {
        numbering.add(curve, spans);
    }
    let sampled = numbering.finish();
    check_budget(sampled.points.len() as f64, sampling)?;
    Ok(sampled)
}
