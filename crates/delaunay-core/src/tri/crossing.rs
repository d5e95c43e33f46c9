//! Segments that cross: that have more in common than an end.

use super::outline::Outline;
use super::sight::precedes;
use geo_predicates::{Sign, orient2d};
use glam::DVec2;

/// The first pair of segments of an outline that cross, of which one at least is `suspect`, by index; exactly.
///
/// A line sweeps over the plane from left to right and keeps the segments that it meets: n log n time, and for each
/// suspect segment the number kept, which is about √n in usual outlines.
pub(super) fn first_crossing(outline: &Outline, suspect: &[bool]) -> Option<[usize; 2]> {
    let ends = |segment: &usize| {
        let [a, b] = outline.segments()[*segment].map(|v| outline.points()[v.index()]);
        if precedes(a, b) { [a, b] } else { [b, a] }
    };
    let mut by_start: Vec<usize> = (0..outline.segments().len()).collect();
    by_start.sort_by(|s, t| {
        let [s, t] = [ends(s), ends(t)].map(|[start, _]| start.x);
        s.total_cmp(&t)
    });
    let mut kept: Vec<usize> = Vec::new();
    let mut found: Option<[usize; 2]> = None;
    for segment in by_start {
        let [start, end] = ends(&segment);
        kept.retain(|other| ends(other)[1].x >= start.x);
        for &other in &kept {
            if (suspect[segment] || suspect[other]) && cross([start, end], ends(&other)) {
                let pair = [segment.min(other), segment.max(other)];
                found = Some(found.map_or(pair, |first| first.min(pair)));
            }
        }
        kept.push(segment);
    }
    found
}

/// Whether two different segments have more in common than an end. Exact.
///
/// All ends must be accepted points, and no segment begin where it ends.
#[must_use]
pub fn segments_cross(first: [DVec2; 2], second: [DVec2; 2]) -> bool {
    let in_order = |[a, b]: [DVec2; 2]| if precedes(a, b) { [a, b] } else { [b, a] };
    cross(in_order(first), in_order(second))
}

/// Whether `p` is on the segment between `a` and `b`, or an end of it. Exact.
pub(super) fn is_on(p: DVec2, [a, b]: [DVec2; 2]) -> bool {
    orient2d(a, b, p) == Sign::Zero && p.clamp(a.min(b), a.max(b)) == p
}

/// [`segments_cross`] with the ends of each in lexicographic order.
fn cross([a, b]: [DVec2; 2], [c, d]: [DVec2; 2]) -> bool {
    let of_first = [orient2d(a, b, c), orient2d(a, b, d)];
    if of_first == [Sign::Zero; 2] {
        // On one line: they overlap unless one ends before or where the other starts.
        return precedes(a, d) && precedes(c, b);
    }
    let is_end = a == c || a == d || b == c || b == d;
    let of_second = [orient2d(c, d, a), orient2d(c, d, b)];
    let apart = |[s, t]: [Sign; 2]| s == t && s != Sign::Zero;
    !is_end && !apart(of_first) && !apart(of_second)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn crosses(segments: [[[f64; 2]; 2]; 2]) -> bool {
        let [s, t] = segments.map(|[a, b]| {
            let [a, b] = [a, b].map(DVec2::from);
            if precedes(a, b) { [a, b] } else { [b, a] }
        });
        assert_eq!(cross(s, t), cross(t, s));
        cross(s, t)
    }

    #[test]
    fn segments_cross_where_they_share_more_than_an_end() {
        let s = [[0.0, 0.0], [4.0, 0.0]];
        for (t, expected) in [
            ([[1.0, -1.0], [2.0, 1.0]], true),
            ([[1.0, 0.0], [2.0, 1.0]], true),
            ([[4.0, 0.0], [2.0, 1.0]], false),
            ([[4.0, 0.0], [5.0, 0.0]], false),
            ([[4.0, 0.0], [1.0, 0.0]], true),
            ([[1.0, 0.0], [2.0, 0.0]], true),
            ([[-1.0, 0.0], [9.0, 0.0]], true),
            ([[5.0, 0.0], [9.0, 0.0]], false),
            ([[5.0, -1.0], [5.0, 1.0]], false),
            ([[1.0, 1.0], [2.0, 1.0]], false),
            ([[9.0, -1.0], [-1.0, 4.0]], false),
        ] {
            assert_eq!(crosses([s, t]), expected, "{t:?}");
        }
    }
}
