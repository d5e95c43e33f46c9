//! The unit circle by turns, the same bits on every machine.

use glam::{DVec2, dvec2};

/// The point of the unit circle after so many turns, counterclockwise from (1, 0); any finite number, also negative.
///
/// Within 2e-16 of the circle. Points half a turn and quarter turns apart are exact images of each other when their turns are.
/// (The sine and the cosine of the standard library differ between machines.)
#[must_use]
pub fn turned(turns: f64) -> DVec2 {
    let eighths = ((turns - turns.floor()) * 8.0).min(8.0);
    let quarter = ((eighths + 1.0) / 2.0).floor();
    // Between -1/8 and 1/8 of a turn.
    let rest = (eighths - 2.0 * quarter) / 8.0 * std::f64::consts::TAU;
    let point = dvec2(cosine(rest), sine(rest));
    (0..quarter as usize).fold(point, |point, _| point.perp())
}

/// The point at `index` of `count` evenly spaced ones.
#[must_use]
pub fn nth(index: usize, count: usize) -> DVec2 {
    turned((index % count) as f64 / count as f64)
}

/// Taylor's series, for |x| at most 0.8; the next term would be below 1e-18.
fn sine(x: f64) -> f64 {
    series(
        x * x,
        x,
        [6.0, 20.0, 42.0, 72.0, 110.0, 156.0, 210.0, 272.0],
    )
}

fn cosine(x: f64) -> f64 {
    series(
        x * x,
        1.0,
        [2.0, 12.0, 30.0, 56.0, 90.0, 132.0, 182.0, 240.0],
    )
}

/// `first (1 - s/d0 (1 - s/d1 (1 - ...)))`.
fn series(square: f64, first: f64, divisors: [f64; 8]) -> f64 {
    let inner = divisors
        .iter()
        .rev()
        .fold(1.0, |sum, divisor| 1.0 - square / divisor * sum);
    first * inner
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn turns_are_those_of_sine_and_cosine() {
        for step in -100..200_i32 {
            let turns = f64::from(step) / 97.0;
            let (sine, cosine) = (turns * std::f64::consts::TAU).sin_cos();
            assert!(
                turned(turns).distance(dvec2(cosine, sine)) < 1e-14,
                "{turns}"
            );
        }
    }

    #[test]
    fn quarters_are_exact_and_halves_are_opposite() {
        assert_eq!(turned(0.0), DVec2::X);
        assert_eq!(turned(0.25), DVec2::Y);
        assert_eq!(turned(-0.5), DVec2::NEG_X);
        for index in 0..16 {
            assert_eq!(nth(index, 32), -nth(index + 16, 32));
        }
    }
}
