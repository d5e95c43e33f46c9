//! Nodes on a curve: between two joints as many equal shares of edges as it takes.

use glam::DVec2;

use super::track::Track;

/// A number of edges that exceeds an integer by this part of itself is that integer.
const ROUNDING: f64 = 1e-9;

/// A curve from one joint to the next, with nodes.
pub(super) struct Span {
    /// From joint to joint, both included.
    pub(super) marks: Vec<Mark>,
    /// The samples at both joints.
    pub(super) samples: [usize; 2],
    /// What part of its size an edge is long, more than a half and up to 1.
    pub(super) share: f64,
}

/// A node on a curve.
#[derive(Clone, Copy, Debug)]
pub(super) struct Mark {
    pub(super) place: DVec2,
    /// The arc length from the start of the curve.
    pub(super) arc: f64,
    pub(super) interval: usize,
    /// The parameter in that interval.
    pub(super) at: f64,
}

/// How many nodes a curve has between its joints.
pub(super) fn count(track: &Track<'_>) -> f64 {
    let spans = joints(track).map(|[first, last]| shares(track, first, last).1 - 1.0);
    spans.sum()
}

/// Places the nodes of a curve, span by span.
pub(super) fn place(track: &Track<'_>) -> Vec<Span> {
    let mut arc = 0.0;
    let mut spans = Vec::new();
    for [first, last] in joints(track) {
        spans.push(span(track, first, last, arc));
        let lengths = track.intervals[first..last]
            .iter()
            .map(|interval| interval.length);
        arc += lengths.sum::<f64>();
    }
    spans
}

/// The samples at consecutive joints.
fn joints(track: &Track<'_>) -> impl Iterator<Item = [usize; 2]> {
    let samples = track.samples.iter().enumerate();
    let joints = samples
        .filter(|(_, sample)| sample.is_joint)
        .map(|(i, _)| i);
    let joints: Vec<usize> = joints.collect();
    let pairs: Vec<[usize; 2]> = joints.windows(2).map(|pair| [pair[0], pair[1]]).collect();
    pairs.into_iter()
}

/// The length between two joints in sizes, and in edges.
fn shares(track: &Track<'_>, first: usize, last: usize) -> (f64, f64) {
    let sizes = (first..last)
        .map(|interval| track.edges(interval))
        .sum::<f64>();
    (sizes, (sizes * (1.0 - ROUNDING)).ceil().max(1.0))
}

fn span(track: &Track<'_>, first: usize, last: usize, start: f64) -> Span {
    let (sizes, count) = shares(track, first, last);
    let share = sizes / count;
    let mut marks = vec![Mark {
        place: track.samples[first].place,
        arc: start,
        interval: first,
        at: track.intervals[first].from,
    }];
    let (mut passed, mut arc) = (0.0, start);
    let mut edges = 1.0;
    for interval in first..last {
        let here = track.edges(interval);
        while edges < count && edges * share < passed + here {
            let length = track.length_of(interval, edges * share - passed);
            let at = track.intervals[interval].at(length);
            marks.push(Mark {
                place: track.intervals[interval].stretch.point(at),
                arc: arc + length,
                interval,
                at,
            });
            edges += 1.0;
        }
        passed += here;
        arc += track.intervals[interval].length;
    }
    marks.push(Mark {
        place: track.samples[last].place,
        arc,
        interval: last - 1,
        at: track.intervals[last - 1].to,
    });
    Span {
        marks,
        samples: [first, last],
        share,
    }
}
