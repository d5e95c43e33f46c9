//! Where a vertex should be: the place from which the worst tetrahedron of its star is best (Freitag and Ollivier-Gooch
//! 1997, §3.2).
//!
//! The quality of a star is the least of many smooth functions of the vertex, six sines for each tetrahedron, and has its
//! maximum where several of them meet. From a place one goes in the direction in which all functions near the least one
//! rise, the nearest point to the origin of the convex hull of their gradients, as far as the linear model of all others
//! allows.

use crate::min_norm::min_norm_point;
use crate::quality::{Sine, min_sine, sines};
use glam::DVec3;

/// Steps at most.
const STEPS: usize = 5;

/// Functions less than this above the least one are near, at first; when there is no direction or no gain, a quarter of it.
const BAND: f64 = 0.03;

/// The narrowest band.
const NARROW: f64 = 0.001;

/// Tetrahedra whose quality is more than this above the least one are not asked how it changes.
const REACH: f64 = 0.2;

/// A square of a slope that leads nowhere.
const FLAT: f64 = 1e-8;

/// A climb is over when a step gains less than this.
const GAIN: f64 = 1e-3;

/// Room for climbing.
#[derive(Clone, Debug, Default)]
pub(crate) struct Ascent {
    sines: Vec<Sine>,
    near: Vec<DVec3>,
    each: Vec<f64>,
    tried: Vec<f64>,
}

/// The quality of the star of a vertex at `p` with the link `link`: triangles `[b, c, d]` such that `[p, b, c, d]` is to be
/// right-handed. When it is not above `bound`, any number up to `bound`. `each` takes the qualities of the tetrahedra.
pub(crate) fn quality_at(link: &[[DVec3; 3]], p: DVec3, bound: f64, each: &mut Vec<f64>) -> f64 {
    each.clear();
    let mut least = f64::INFINITY;
    for &[b, c, d] in link {
        let quality = min_sine([p, b, c, d]);
        each.push(quality);
        least = least.min(quality);
        if least <= bound {
            break;
        }
    }
    least
}

impl Ascent {
    /// Climbs from `start`, which sees the link strictly from inside, until the quality is `goal` or does not rise any more.
    ///
    /// Gives the place, whose quality is not below that of `start`. The size of the link must be about 1.
    pub(crate) fn climb(&mut self, link: &[[DVec3; 3]], start: DVec3, goal: f64) -> DVec3 {
        let (mut place, mut band) = (start, BAND);
        let mut quality = quality_at(link, place, f64::NEG_INFINITY, &mut self.each);
        self.differentiate(link, place, quality);
        for _ in 0..STEPS {
            if quality >= goal || quality <= 0.0 {
                break;
            }
            let step = self.step(link, place, quality, band);
            let gain = step.map_or(0.0, |(_, value)| value - quality);
            if gain < GAIN && band <= NARROW {
                return step.map_or(place, |(better, _)| better);
            }
            if gain < GAIN {
                band /= 4.0;
            }
            if let Some((better, value)) = step {
                (place, quality) = (better, value);
                self.differentiate(link, place, quality);
            }
        }
        place
    }

    /// Finds the sines at `place`, with gradients, of all tetrahedra that are not much better than the worst.
    fn differentiate(&mut self, link: &[[DVec3; 3]], place: DVec3, quality: f64) {
        self.sines.clear();
        for (&[b, c, d], &value) in link.iter().zip(&self.each) {
            if value < quality + REACH {
                self.sines.extend(sines([place, b, c, d]));
            }
        }
    }

    /// One step uphill; `None` when there is no way up.
    fn step(
        &mut self,
        link: &[[DVec3; 3]],
        place: DVec3,
        quality: f64,
        band: f64,
    ) -> Option<(DVec3, f64)> {
        let near = self.sines.iter().filter(|s| s.value <= quality + band);
        self.near.clear();
        self.near.extend(near.map(|s| s.gradient));
        let direction = min_norm_point(&self.near);
        let rise = direction.length_squared();
        if rise.is_nan() || rise <= FLAT {
            return None;
        }
        // All near functions rise at least at this rate; where another one crosses their line the model ends.
        let mut length = 0.5 / rise.sqrt();
        for sine in &self.sines {
            let slope = sine.gradient.dot(direction);
            if slope < rise * 0.999 {
                length = length.min((sine.value - quality).max(0.5 * band) / (rise - slope));
            }
        }
        for _ in 0..5 {
            let candidate = place + length * direction;
            let value = quality_at(link, candidate, quality, &mut self.tried);
            if value > quality {
                std::mem::swap(&mut self.each, &mut self.tried);
                return Some((candidate, value));
            }
            length *= 0.4;
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The facets of an octahedron, seen from inside.
    fn octahedron() -> Vec<[DVec3; 3]> {
        let [x, y, z] = DVec3::AXES;
        let mut link = Vec::new();
        for [x, y] in [[x, y], [y, -x], [-x, -y], [-y, x]] {
            link.push([x, y, z]);
            link.push([y, x, -z]);
        }
        link
    }

    #[test]
    fn in_an_octahedron_the_center_is_best() {
        let link = octahedron();
        let best = quality_at(&link, DVec3::ZERO, 0.0, &mut Vec::new());
        for start in [[0.3, 0.2, -0.4], [0.0, 0.0, 0.9], [0.45, 0.45, 0.05]] {
            let mut place = start.into();
            for _ in 0..4 {
                place = Ascent::default().climb(&link, place, 1.0);
            }
            let quality = quality_at(&link, place, 0.0, &mut Vec::new());
            assert!(best - quality < 5e-3, "{start:?}: {place} {quality} {best}");
        }
    }

    #[test]
    fn a_goal_that_is_reached_ends_the_climb() {
        let link = octahedron();
        let start = DVec3::new(0.3, 0.2, -0.4);
        assert_eq!(Ascent::default().climb(&link, start, 0.0), start);
    }
}
