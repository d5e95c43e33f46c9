//! A curve in short intervals, with the size that edges shall have at the ends of each.
//!
//! Between two samples sizes are linear in the arc length, so the number of edges on an interval and the place where a part of that
//! number is reached are elementary functions.

use glam::DVec2;

use super::chain::Curve;
use super::interval::Interval;
use super::params::Sampling;

/// Intervals are at most this part of the size.
const FINENESS: f64 = 0.25;

/// Sizes that curvature asks for in the middle of an interval are at least this part of those at its ends.
const SMOOTHNESS: f64 = 0.875;

/// What says how long edges shall be, beside the sampling.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Sizes {
    /// Nothing.
    Free,
    /// The stretches of the curve: edges are about as long as they are.
    OfStretches,
}

/// A curve with samples, one more than there are intervals between them.
pub(super) struct Track<'a> {
    pub(super) intervals: Vec<Interval<'a>>,
    pub(super) samples: Vec<Sample>,
}

/// A place on a curve and the size there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sample {
    pub(super) place: DVec2,
    /// What the curvature asks for.
    bend: f64,
    /// What was asked for since.
    asked: f64,
    /// The least of both, limited so that it grows no faster than it may.
    pub(super) size: f64,
    /// Whether pieces meet here, or the curve begins or ends.
    pub(super) is_joint: bool,
}

impl Sample {
    /// The size before others have their say.
    pub(super) fn limit(&self) -> f64 {
        self.bend.min(self.asked)
    }

    pub(super) fn ask(&mut self, size: f64) {
        self.asked = self.asked.min(size);
    }
}

/// The arc length of a stretch, from that of its parts.
fn length_of(parts: &[Interval<'_>]) -> f64 {
    parts.iter().map(|part| part.length).sum()
}

/// The sizes at the ends of stretches of these lengths: the means of those that meet.
fn of_knots(lengths: &[f64], is_loop: bool) -> Vec<f64> {
    let inner = lengths.windows(2).map(|pair| 0.5 * (pair[0] + pair[1]));
    let [first, last] = [lengths.first(), lengths.last()].map(|end| end.copied().unwrap_or(0.0));
    let [first, last] = match is_loop {
        true => [0.5 * (first + last); 2],
        false => [first, last],
    };
    std::iter::once(first).chain(inner).chain([last]).collect()
}

impl<'a> Track<'a> {
    /// The curve in its coarsest samples.
    ///
    /// No edge shall be longer than a piece, for the sake of its neighbours, nor than a third of a closed curve.
    pub(super) fn of(curve: &'a Curve, sampling: &Sampling, sizes: Sizes) -> Self {
        let mut track = Self {
            intervals: Vec::new(),
            samples: Vec::new(),
        };
        let longest = match curve.is_closed() {
            true => curve.length() / 3.0,
            false => curve.length(),
        };
        for piece in curve.pieces() {
            let intervals: Vec<Vec<Interval<'a>>> =
                piece.stretches.iter().map(Interval::of).collect();
            let lengths: Vec<f64> = intervals.iter().map(|parts| length_of(parts)).collect();
            let length = lengths.iter().sum();
            let first = track.samples.len().saturating_sub(1);
            track.append(intervals.concat(), longest.min(length), sampling);
            if sizes == Sizes::OfStretches {
                let is_loop = curve.is_closed() && curve.pieces().len() == 1;
                track.ask_for(first, &intervals, &of_knots(&lengths, is_loop));
            }
        }
        if let [first, .., last] = track.samples.as_mut_slice()
            && curve.is_closed()
        {
            last.place = first.place;
        }
        track
    }

    /// Adds a piece whose edges are not longer than a limit.
    fn append(&mut self, intervals: Vec<Interval<'a>>, limit: f64, sampling: &Sampling) {
        for (i, interval) in intervals.iter().enumerate() {
            let [start, end] = [interval.from, interval.to].map(|at| Sample {
                place: interval.stretch.point(at),
                bend: sampling.of_curvature(interval.stretch.curvature(at)),
                asked: limit,
                size: sampling.size,
                is_joint: false,
            });
            match self.samples.last_mut() {
                Some(last) => {
                    last.place = start.place;
                    last.bend = last.bend.min(start.bend);
                    last.ask(limit);
                }
                None => self.samples.push(start),
            }
            if let Some(last) = self.samples.last_mut() {
                last.is_joint |= i == 0;
            }
            self.samples.push(end);
        }
        if let Some(last) = self.samples.last_mut() {
            last.is_joint = true;
        }
        self.intervals.extend(intervals);
    }

    /// Asks for sizes at the ends of the stretches of a piece, linear in between; its samples begin with `first`.
    fn ask_for(&mut self, first: usize, stretches: &[Vec<Interval<'_>>], knots: &[f64]) {
        let mut samples = self.samples[first..].iter_mut();
        for (parts, ends) in stretches.iter().zip(knots.windows(2)) {
            let (length, mut before) = (length_of(parts), 0.0);
            for (part, sample) in parts.iter().zip(&mut samples) {
                sample.ask(ends[0] + (ends[1] - ends[0]) * before / length);
                before += part.length;
            }
        }
        if let (Some(last), Some(&size)) = (samples.next(), knots.last()) {
            last.ask(size);
        }
    }

    /// Halves the intervals that are too long for what is known of sizes; whether there were any.
    pub(super) fn divide(&mut self, sampling: &Sampling) -> bool {
        let Some(&first) = self.samples.first() else {
            return false;
        };
        let before = self.intervals.len();
        let mut samples = vec![first];
        let mut intervals = Vec::with_capacity(before);
        for (interval, ends) in self.intervals.iter().zip(self.samples.windows(2)) {
            let at = interval.middle();
            let bend = sampling.of_curvature(interval.stretch.curvature(at));
            let mean = |part: fn(&Sample) -> f64| 0.5 * (part(&ends[0]) + part(&ends[1]));
            let size = mean(|end| end.size);
            let is_long = interval.length > FINENESS * ends[0].size.min(ends[1].size);
            if (is_long || bend < SMOOTHNESS * size) && interval.is_divisible() {
                samples.push(Sample {
                    place: interval.stretch.point(at),
                    bend,
                    asked: mean(|end| end.asked),
                    size,
                    is_joint: false,
                });
                intervals.extend(interval.halves());
            } else {
                intervals.push(*interval);
            }
            samples.push(ends[1]);
        }
        (self.intervals, self.samples) = (intervals, samples);
        self.intervals.len() > before
    }

    /// How many edges there are at least, however sizes vary between samples when they grow no faster than they may.
    pub(super) fn least_edges(&self, sampling: &Sampling) -> f64 {
        let grade = sampling.grade;
        let least = |(interval, ends): (&Interval<'_>, &[Sample])| {
            let [a, b] = [ends[0].size, ends[1].size];
            // Sizes rise from both ends and meet at the top.
            let top = 0.5 * (a + b + grade * interval.length);
            let graded = ((top / a).ln().max(0.0) + (top / b).ln().max(0.0)) / grade;
            graded.max(interval.length / sampling.size)
        };
        self.intervals
            .iter()
            .zip(self.samples.windows(2))
            .map(least)
            .sum()
    }

    /// The number of pieces.
    pub(super) fn pieces(&self) -> f64 {
        self.samples.iter().filter(|sample| sample.is_joint).count() as f64 - 1.0
    }

    /// How many edges the interval has: its length over its size, integrated.
    pub(super) fn edges(&self, interval: usize) -> f64 {
        let [a, b] = self.sizes(interval);
        let growth = (b - a) / a;
        let mean = match growth == 0.0 {
            true => 1.0,
            false => growth.ln_1p() / growth,
        };
        self.intervals[interval].length / a * mean
    }

    /// The arc length after the start of the interval at which it has so many edges.
    pub(super) fn length_of(&self, interval: usize, edges: f64) -> f64 {
        let [a, b] = self.sizes(interval);
        let slope = (b - a) / self.intervals[interval].length;
        match slope == 0.0 {
            true => a * edges,
            false => a * (slope * edges).exp_m1() / slope,
        }
    }

    fn sizes(&self, interval: usize) -> [f64; 2] {
        [interval, interval + 1].map(|i| self.samples[i].size)
    }
}
