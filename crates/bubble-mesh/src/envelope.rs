//! Sizes that grow no faster than they may.
//!
//! The limited size at a place is the least of `h + grade · distance` over all places with their sizes `h`: the lower envelope of
//! cones, and the greatest field below the given sizes whose steepness is at most `grade` (Persson 2006). Because
//! the distance is that of the plane, one envelope serves along curves, across a gap and round a corner. Boxes of places whose least
//! size and distance promise nothing are passed by, so a place takes log n time unless very many cones are about as low there.

use glam::DVec2;

/// Boxes with so many cones are not divided.
const LEAF: usize = 8;

/// A size at a place.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cone {
    pub(crate) place: DVec2,
    pub(crate) size: f64,
}

/// Consecutive cones.
#[derive(Clone)]
struct Group {
    first: usize,
    end: usize,
    /// The box that follows when this one is passed by.
    skip: usize,
    low: DVec2,
    high: DVec2,
    /// The least size.
    least: f64,
}

/// What all sizes permit together.
#[derive(Clone)]
pub(crate) struct Envelope {
    cones: Vec<Cone>,
    boxes: Vec<Group>,
    grade: f64,
}

impl Envelope {
    /// The envelope of cones that rise by `grade` of the distance. Takes n log n time.
    pub(crate) fn of(cones: Vec<Cone>, grade: f64) -> Self {
        let mut envelope = Self {
            cones,
            boxes: Vec::new(),
            grade,
        };
        envelope.divide(0, envelope.cones.len());
        envelope
    }

    /// The least of all cones at a place and of a size that is known.
    pub(crate) fn at(&self, place: DVec2, known: f64) -> f64 {
        let mut least = known;
        let mut next = 0;
        while let Some(group) = self.boxes.get(next) {
            let apart = place.clamp(group.low, group.high).distance(place);
            if group.least + self.grade * apart >= least {
                next = group.skip;
                continue;
            }
            next += 1;
            if next == group.skip {
                for cone in &self.cones[group.first..group.end] {
                    least = least.min(cone.size + self.grade * cone.place.distance(place));
                }
            }
        }
        least
    }

    /// Lists the box of some cones and those that it is divided into, half of its cones each.
    fn divide(&mut self, first: usize, end: usize) {
        let cones = &mut self.cones[first..end];
        if cones.is_empty() {
            return;
        }
        let corner = |start: DVec2, extreme: fn(DVec2, DVec2) -> DVec2| {
            cones
                .iter()
                .fold(start, |corner, cone| extreme(corner, cone.place))
        };
        let low = corner(DVec2::INFINITY, DVec2::min);
        let high = corner(DVec2::NEG_INFINITY, DVec2::max);
        let this = self.boxes.len();
        self.boxes.push(Group {
            first,
            end,
            skip: 0,
            low,
            high,
            least: cones
                .iter()
                .fold(f64::INFINITY, |least, cone| least.min(cone.size)),
        });
        if cones.len() > LEAF {
            let half = cones.len() / 2;
            let axis = usize::from((high - low).y > (high - low).x);
            cones.select_nth_unstable_by(half, |a, b| a.place[axis].total_cmp(&b.place[axis]));
            self.divide(first, first + half);
            self.divide(first + half, end);
        }
        self.boxes[this].skip = self.boxes.len();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn boxes_find_the_lowest_cone(
            given in prop::collection::vec((0.0..1.0f64, 0.0..1.0f64, 0.01..1.0f64), 0..200),
            grade in 0.01..3.0f64,
        ) {
            let cones: Vec<Cone> = given
                .iter()
                .map(|&(x, y, size)| Cone { place: DVec2::new(x, y), size })
                .collect();
            let envelope = Envelope::of(cones.clone(), grade);
            for &Cone { place, size } in &cones {
                let heights = cones.iter().map(|cone| cone.size + grade * cone.place.distance(place));
                let plainly = heights.fold(size, f64::min);
                prop_assert_eq!(envelope.at(place, size), plainly);
            }
        }
    }
}
