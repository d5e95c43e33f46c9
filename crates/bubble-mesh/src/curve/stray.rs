//! How far a curve strays from the chord of an edge.
//!
//! A curve of length `l` and curvature up to `k` strays by at most `k l² / 8`, which settles most edges. For the others the distance is
//! measured at places between, and the same bound serves from one of these to the next.

use glam::DVec2;

use super::params::Sampling;
use super::place::{Mark, Span};
use super::track::Track;

/// Places at which each interval is looked at.
const STEPS: u32 = 4;

/// Distances may exceed the tolerance by this part of it.
const ROUNDING: f64 = 1e-9;

/// Asks for smaller sizes where an edge strays too far; whether there is one.
///
/// No edge up to two tolerances long strays too far. In a longer one some sample has a size above that, which becomes smaller by a
/// twentieth at least, but not less than two tolerances: so this can happen only finitely many times.
pub(super) fn tighten(track: &mut Track<'_>, spans: &[Span], sampling: &Sampling) -> bool {
    let chord = sampling.chord;
    let mut strays = false;
    for edge in spans.iter().flat_map(|span| span.marks.windows(2)) {
        let length = edge[1].arc - edge[0].arc;
        if length <= 2.0 * chord * (1.0 + ROUNDING) {
            continue;
        }
        let bound = bound(track, &edge[0], &edge[1], length);
        if bound <= chord * (1.0 + ROUNDING) {
            continue;
        }
        strays = true;
        let factor = (chord / bound).sqrt().clamp(0.5, 0.95);
        for sample in &mut track.samples[edge[0].interval..=edge[1].interval + 1] {
            sample.ask((factor * sample.size).max(2.0 * chord));
        }
    }
    strays
}

/// At most how far the curve strays from the chord of an edge.
fn bound(track: &Track<'_>, a: &Mark, b: &Mark, length: f64) -> f64 {
    let looks = looks(track, a, b);
    let curvature = |looks: &[Look]| {
        looks
            .iter()
            .fold(0.0, |most, look| f64::max(most, look.curvature))
    };
    let rough = curvature(&looks) * length * length / 8.0;
    let between = looks.windows(2).map(|pair| {
        let length = pair[1].arc - pair[0].arc;
        let apart = pair
            .iter()
            .map(|look| distance(look.place, [a.place, b.place]));
        apart.fold(0.0, f64::max) + (curvature(pair) * length * length / 8.0).min(length / 2.0)
    });
    rough.min(between.fold(0.0, f64::max))
}

/// A place on the curve where it is looked at.
struct Look {
    place: DVec2,
    curvature: f64,
    arc: f64,
}

/// Places along an edge, its ends among them.
fn looks(track: &Track<'_>, a: &Mark, b: &Mark) -> Vec<Look> {
    let mut looks = Vec::new();
    let mut arc = 0.0;
    for i in a.interval..=b.interval {
        let interval = &track.intervals[i];
        let stretch = interval.stretch;
        let from = if i == a.interval { a.at } else { interval.from };
        let to = if i == b.interval { b.at } else { interval.to };
        let steps = (0..=STEPS).map(|k| from + (to - from) * (f64::from(k) / f64::from(STEPS)));
        let mut before = from;
        for at in steps {
            arc += stretch.length(before, at);
            before = at;
            looks.push(Look {
                place: stretch.point(at),
                curvature: stretch.curvature(at),
                arc,
            });
        }
    }
    looks
}

/// The distance of a place from a segment.
fn distance(place: DVec2, [a, b]: [DVec2; 2]) -> f64 {
    let (along, from) = (b - a, place - a);
    let square = along.length_squared();
    let part = match square > 0.0 {
        true => (from.dot(along) / square).clamp(0.0, 1.0),
        false => 0.0,
    };
    from.distance(part * along)
}
