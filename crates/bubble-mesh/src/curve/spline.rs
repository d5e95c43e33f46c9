//! Cubic splines through given points, twice continuously differentiable in the chord length.
//!
//! The derivative at each point by the length of the polygon is unknown; equal second derivatives on both sides give one equation
//! for each point and its two neighbours, which always has an answer because its diagonal dominates. An open spline is *natural*: its
//! second derivative is zero at both ends. A closed one is periodic.

use glam::DVec2;

use super::stretch::Stretch;

/// The cubics of the natural spline through at least two points, no two consecutive ones at one place.
pub(super) fn open(points: &[DVec2]) -> Vec<Stretch> {
    let steps: Vec<Step> = points
        .windows(2)
        .map(|ends| Step::between(ends[0], ends[1]))
        .collect();
    let natural = |step: &Step| Row {
        before: 1.0 / step.length,
        own: 2.0 / step.length,
        after: 1.0 / step.length,
        right: 3.0 * step.weighted(),
    };
    let inner = steps.windows(2).map(|pair| Row::of(&pair[0], &pair[1]));
    let mut rows: Vec<Row> = Vec::with_capacity(points.len());
    rows.extend(steps.first().map(natural));
    rows.extend(inner);
    rows.extend(steps.last().map(natural));
    let slopes = solve(&rows);
    let ends = slopes.windows(2).map(|ends| [ends[0], ends[1]]);
    let cubics = points.windows(2).zip(&steps).zip(ends);
    cubics
        .map(|((p, step), slopes)| step.cubic([p[0], p[1]], slopes))
        .collect()
}

/// The cubics of the periodic spline through at least three points, from the first round to it again.
pub(super) fn closed(points: &[DVec2]) -> Vec<Stretch> {
    let count = points.len();
    let next = |i: usize| (i + 1) % count;
    let steps: Vec<Step> = (0..count)
        .map(|i| Step::between(points[i], points[next(i)]))
        .collect();
    let rows = (0..count).map(|i| Row::of(&steps[(i + count - 1) % count], &steps[i]));
    let slopes = solve_cyclic(rows.collect());
    let cubic =
        |i: usize| steps[i].cubic([points[i], points[next(i)]], [slopes[i], slopes[next(i)]]);
    (0..count).map(cubic).collect()
}

/// From a point to the next.
struct Step {
    vector: DVec2,
    length: f64,
}

impl Step {
    fn between(a: DVec2, b: DVec2) -> Self {
        let vector = b - a;
        Self {
            vector,
            length: vector.length(),
        }
    }

    fn weighted(&self) -> DVec2 {
        self.vector / self.length / self.length
    }

    /// The cubic with these ends and derivatives by the length.
    fn cubic(&self, [a, b]: [DVec2; 2], slopes: [DVec2; 2]) -> Stretch {
        let [s, t] = slopes.map(|slope| slope * (self.length / 3.0));
        Stretch::Cubic([a, a + s, b - t, b])
    }
}

/// The equation of a point: what its slope and those of its neighbours are multiplied with, and the sum.
struct Row {
    before: f64,
    own: f64,
    after: f64,
    right: DVec2,
}

impl Row {
    /// Equal second derivatives before and after.
    fn of(before: &Step, after: &Step) -> Self {
        let (p, q) = (1.0 / before.length, 1.0 / after.length);
        Self {
            before: p,
            own: 2.0 * (p + q),
            after: q,
            right: 3.0 * (before.weighted() + after.weighted()),
        }
    }
}

/// The slopes, by elimination from the first to the last and back. Neither the first row's `before` nor the last row's `after` counts.
fn solve(rows: &[Row]) -> Vec<DVec2> {
    let mut slopes: Vec<DVec2> = Vec::with_capacity(rows.len());
    let mut factors = Vec::with_capacity(rows.len());
    let (mut factor, mut sum) = (0.0, DVec2::ZERO);
    for row in rows {
        let pivot = row.own - row.before * factor;
        (factor, sum) = (row.after / pivot, (row.right - row.before * sum) / pivot);
        factors.push(factor);
        slopes.push(sum);
    }
    for i in (0..slopes.len().saturating_sub(1)).rev() {
        let next = slopes[i + 1];
        slopes[i] -= factors[i] * next;
    }
    slopes
}

/// The slopes when the first and the last are neighbours: two systems without that, put together as Sherman and Morrison do.
fn solve_cyclic(mut rows: Vec<Row>) -> Vec<DVec2> {
    let last = rows.len() - 1;
    let (corner, other) = (rows[0].before, rows[last].after);
    let shift = -rows[0].own;
    rows[0].own -= shift;
    rows[last].own -= other * corner / shift;
    let mut slopes = solve(&rows);
    for (i, row) in rows.iter_mut().enumerate() {
        row.right = match i {
            0 => DVec2::splat(shift),
            _ if i == last => DVec2::splat(other),
            _ => DVec2::ZERO,
        };
    }
    let change = solve(&rows);
    let part = corner / shift;
    let scale = (slopes[0] + part * slopes[last]) / (1.0 + change[0].x + part * change[last].x);
    for (slope, change) in slopes.iter_mut().zip(change) {
        *slope -= scale * change.x;
    }
    slopes
}

#[cfg(test)]
mod tests {
    use super::*;

    const POINTS: [[f64; 2]; 5] = [[0.0, 0.0], [1.0, 0.2], [1.5, 1.5], [0.4, 1.1], [-0.6, 1.0]];

    /// First and second derivative by the chord length at both ends.
    fn derivatives(cubic: &Stretch) -> [[DVec2; 2]; 2] {
        let &Stretch::Cubic([a, b, c, d]) = cubic else {
            panic!("no cubic")
        };
        let h = a.distance(d);
        let [start, end] = [6.0 * (a - 2.0 * b + c), 6.0 * (b - 2.0 * c + d)].map(|v| v / (h * h));
        [[3.0 * (b - a) / h, start], [3.0 * (d - c) / h, end]]
    }

    fn assert_smooth(before: &Stretch, after: &Stretch) {
        assert_eq!(before.ends()[1], after.ends()[0]);
        let (p, q) = (derivatives(before)[1], derivatives(after)[0]);
        assert!(
            p.iter().zip(q).all(|(&p, q)| (p - q).length() < 1e-12),
            "{p:?} {q:?}"
        );
    }

    #[test]
    fn splines_are_twice_continuously_differentiable() {
        for count in 2..=5 {
            let points: Vec<DVec2> = POINTS[..count].iter().map(|&p| DVec2::from(p)).collect();
            let open = open(&points);
            assert_eq!(open.len(), count - 1);
            open.windows(2)
                .for_each(|pair| assert_smooth(&pair[0], &pair[1]));
            assert!(derivatives(&open[0])[0][1].length() < 1e-12);
            assert!(derivatives(&open[count - 2])[1][1].length() < 1e-12);
            if count > 2 {
                let closed = closed(&points);
                assert_eq!(closed.len(), count);
                (0..count).for_each(|i| assert_smooth(&closed[i], &closed[(i + 1) % count]));
            }
        }
    }

    #[test]
    fn two_points_give_a_straight_piece() {
        let line = open(&[DVec2::ZERO, DVec2::new(3.0, 6.0)]);
        assert!((line[0].velocity(0.3) - DVec2::new(3.0, 6.0)).length() < 1e-14);
        assert!(line[0].curvature(0.3) < 1e-14);
    }
}
