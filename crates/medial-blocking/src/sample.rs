//! Boundary samples dense enough that their Delaunay triangulation represents the domain (§2).
//!
//! The triangulation contains every piece of wall between neighbouring samples once the disk over
//! the piece holds no sample of another wall, so the spacing follows the *local gap*: a piece is
//! halved until it is shorter than [`PIECE_PER_GAP`] times the distance from it to the nearest
//! other wall. Wide water costs thirty-two samples per circle, a gap g between circles of radius r
//! about √(r/g) more. Pieces are halved by normalising the sum of two directions: no sine or
//! cosine, the same bits on every machine.

use delaunay_core::progress::Meter;
use glam::DVec2;

use crate::Report;
use crate::clearance::{Clearance, NearWall};
use crate::domain::Domain;
use crate::error::BlockingError;
use crate::wall::{Shift, WallId, WallImage};

/// Longest piece of wall between neighbouring samples, in units of the distance from the piece to
/// the nearest other wall.
pub const PIECE_PER_GAP: f64 = 0.5;

/// Most samples of a domain: with their images in a periodic one they still have 32-bit ids.
pub const MAX_SAMPLES: usize = 1 << 26;

/// Samples nearer than this, in radii, are one in any case.
const CLOSEST: f64 = 1.0 / (1u64 << 25) as f64;

/// Rounding of coordinates in a domain of size about 1, with a margin: 2^-47.
const ROUNDING: f64 = 1.0 / (1u64 << 47) as f64;

/// A coordinate below this is zero, in a domain of size about 1: 2^-100.
const DUST: f64 = 1.0 / (1u128 << 100) as f64;

/// Arc over chord of a sixteenth of a circle is 1.0065: this bounds it.
const ARC_PER_CHORD: f64 = 1.01;

/// Halvings after which a piece is kept whatever its gap: the accepted gaps need at most 27.
const MAX_HALVINGS: u32 = 40;

/// A boundary sample, numbered along the walls.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct SampleId(pub(crate) u32);

impl SampleId {
    /// Position in [`Samples::points`].
    #[must_use]
    pub const fn index(self) -> usize {
        self.0 as usize
    }
}

/// The samples of all walls, wall after wall, counterclockwise round each circle.
#[derive(Clone, Debug)]
pub struct Samples {
    directions: Vec<DVec2>,
    points: Vec<DVec2>,
    wall_of: Vec<WallId>,
    /// Samples of wall `w` are `first[w]..first[w + 1]`.
    first: Vec<u32>,
}

impl Samples {
    /// Samples of every wall, spaced by the local gap.
    ///
    /// O(s log n) for s samples and n walls.
    pub(crate) fn by_local_gap(
        domain: &Domain,
        clearance: &Clearance<'_>,
        report: &mut Report<'_>,
    ) -> Result<Self, BlockingError> {
        let mut samples = Self::empty();
        let mut meter = Meter::start(report, "sample walls", domain.walls().len())?;
        for wall in domain.wall_ids() {
            meter.advance()?;
            samples.push_wall(domain, wall, &directions_of_wall(domain, clearance, wall))?;
        }
        Ok(samples)
    }

    /// These samples and `extra` ones: unit directions from the centres of the walls named.
    ///
    /// An extra sample almost at the place of another is left out.
    pub(crate) fn with(
        &self,
        domain: &Domain,
        extra: &[(WallId, DVec2)],
    ) -> Result<Self, BlockingError> {
        let mut by_wall: Vec<Vec<DVec2>> = vec![Vec::new(); domain.walls().len()];
        for &(wall, direction) in extra {
            by_wall[wall.index()].push(direction);
        }
        let mut samples = Self::empty();
        for (wall, extra) in domain.wall_ids().zip(by_wall) {
            let closest = closest(domain.wall(wall).circle.radius);
            let directions = merged(self.wall_directions(wall), extra, closest);
            samples.push_wall(domain, wall, &directions)?;
        }
        Ok(samples)
    }

    fn empty() -> Self {
        Self {
            directions: Vec::new(),
            points: Vec::new(),
            wall_of: Vec::new(),
            first: vec![0],
        }
    }

    fn push_wall(
        &mut self,
        domain: &Domain,
        wall: WallId,
        directions: &[DVec2],
    ) -> Result<(), BlockingError> {
        if self.points.len() + directions.len() > MAX_SAMPLES {
            return Err(BlockingError::TooManySamples { limit: MAX_SAMPLES });
        }
        self.directions.extend(directions);
        let point = |&direction| domain.snap(domain.wall(wall).point_towards(direction));
        self.points
            .extend(directions.iter().map(point).map(without_dust));
        self.wall_of.resize(self.points.len(), wall);
        self.first.push(self.points.len() as u32);
        Ok(())
    }

    /// The same samples with all lengths multiplied by `size`.
    pub(crate) fn scaled(mut self, size: f64) -> Self {
        for point in &mut self.points {
            *point *= size;
        }
        self
    }

    /// Number of samples.
    #[must_use]
    pub fn len(&self) -> usize {
        self.points.len()
    }

    /// Whether there is no sample; never true of a domain's samples.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.points.is_empty()
    }

    /// The positions, one per sample.
    #[must_use]
    pub fn points(&self) -> &[DVec2] {
        &self.points
    }

    /// The wall on which a sample lies.
    #[must_use]
    pub fn wall(&self, sample: SampleId) -> WallId {
        self.wall_of[sample.index()]
    }

    /// Unit vector from the centre of the sample's circle to the sample.
    #[must_use]
    pub fn direction(&self, sample: SampleId) -> DVec2 {
        self.directions[sample.index()]
    }

    /// The next sample counterclockwise round the circle.
    #[must_use]
    pub fn next(&self, sample: SampleId) -> SampleId {
        let wall = self.wall(sample).index();
        let next = sample.0 + 1;
        SampleId(if next == self.first[wall + 1] {
            self.first[wall]
        } else {
            next
        })
    }

    /// The next sample clockwise round the circle.
    #[must_use]
    pub fn previous(&self, sample: SampleId) -> SampleId {
        let wall = self.wall(sample).index();
        SampleId(if sample.0 == self.first[wall] {
            self.first[wall + 1] - 1
        } else {
            sample.0 - 1
        })
    }

    /// The unit direction halfway from a sample to the next one.
    pub(crate) fn direction_after(&self, sample: SampleId) -> DVec2 {
        halfway(self.direction(sample), self.direction(self.next(sample)))
    }

    fn wall_directions(&self, wall: WallId) -> &[DVec2] {
        &self.directions[self.first[wall.index()] as usize..self.first[wall.index() + 1] as usize]
    }
}

/// Unit directions of one wall's samples, counterclockwise from the x-axis.
fn directions_of_wall(domain: &Domain, clearance: &Clearance<'_>, wall: WallId) -> Vec<DVec2> {
    let mut directions = Vec::new();
    let start = sixteenths();
    for (k, &from) in start.iter().enumerate() {
        directions.push(from);
        let piece = Piece {
            domain,
            wall,
            from,
            to: start[(k + 1) % start.len()],
        };
        piece.sample_between(clearance, &mut directions);
    }
    directions
}

/// Sixteen directions, by halving the quarters twice.
fn sixteenths() -> Vec<DVec2> {
    let mut directions = vec![DVec2::X, DVec2::Y, -DVec2::X, -DVec2::Y];
    for _ in 0..2 {
        let count = directions.len();
        directions = (0..count)
            .flat_map(|k| {
                [
                    directions[k],
                    halfway(directions[k], directions[(k + 1) % count]),
                ]
            })
            .collect();
    }
    directions
}

/// A piece of wall between two directions.
#[derive(Clone, Copy)]
struct Piece<'a> {
    domain: &'a Domain,
    wall: WallId,
    from: DVec2,
    to: DVec2,
}

impl Piece<'_> {
    /// Appends the directions strictly between the ends of the piece.
    fn sample_between(&self, clearance: &Clearance<'_>, directions: &mut Vec<DVec2>) {
        let own = WallImage {
            wall: self.wall,
            shift: Shift::ZERO,
        };
        let middle = self.middle_point();
        let Some(nearest) = clearance.nearest(middle, |image| image != own) else {
            return;
        };
        if self.is_short(nearest.distance) {
            directions.push(self.middle());
            return;
        }
        let near: Vec<NearWall> = clearance
            .within(middle, self.reach(nearest.distance))
            .filter(|near| near.image != own)
            .collect();
        self.halve(&near, MAX_HALVINGS, directions);
    }

    /// Halves the piece until each part is short; `near` holds every wall that can be nearest to a
    /// part.
    fn halve(&self, near: &[NearWall], halvings: u32, directions: &mut Vec<DVec2>) {
        let middle = self.middle_point();
        let near: Vec<NearWall> = near
            .iter()
            .map(|near| NearWall {
                distance: self.domain.wall_image(near.image).distance(middle),
                ..*near
            })
            .collect();
        let gap = near
            .iter()
            .map(|near| near.distance)
            .fold(f64::INFINITY, f64::min);
        if halvings == 0 || self.is_short(gap) {
            return;
        }
        let reach = self.reach(gap);
        let near: Vec<NearWall> = near
            .into_iter()
            .filter(|near| near.distance <= reach)
            .collect();
        let middle = self.middle();
        Self {
            to: middle,
            ..*self
        }
        .halve(&near, halvings - 1, directions);
        directions.push(middle);
        Self {
            from: middle,
            ..*self
        }
        .halve(&near, halvings - 1, directions);
    }

    /// Whether the piece is short enough when its middle has the distance `gap` to the nearest
    /// other wall.
    fn is_short(&self, gap: f64) -> bool {
        let length = self.length();
        length <= PIECE_PER_GAP * (gap - length / 2.0)
    }

    /// A wall farther than this from the middle is nowhere the nearest to the piece.
    fn reach(&self, gap: f64) -> f64 {
        gap + 2.0 * self.length()
    }

    fn length(&self) -> f64 {
        ARC_PER_CHORD * self.domain.wall(self.wall).circle.radius * self.from.distance(self.to)
    }

    fn middle(&self) -> DVec2 {
        halfway(self.from, self.to)
    }

    fn middle_point(&self) -> DVec2 {
        self.domain.wall(self.wall).point_towards(self.middle())
    }
}

/// The unit vector halfway between two unit vectors less than half a turn apart.
fn halfway(a: DVec2, b: DVec2) -> DVec2 {
    (a + b).normalize_or(a)
}

/// `p` with coordinates that are nothing but rounding put to zero, below the range of the predicates.
fn without_dust(p: DVec2) -> DVec2 {
    DVec2::select(p.abs().cmpge(DVec2::splat(DUST)), p, DVec2::ZERO)
}

/// Samples of a circle of this radius that are nearer, in radians, would not be in convex position
/// once rounded: the arc between them rises above its chord by less than coordinates are rounded.
///
/// Either stands for the other to a depth of [`ROUNDING`].
fn closest(radius: f64) -> f64 {
    (ROUNDING / radius).sqrt().max(CLOSEST)
}

/// Directions counterclockwise: all of `kept`, which are, and those of `extra` that are not nearer
/// than `closest` to one before or after them.
fn merged(kept: &[DVec2], mut extra: Vec<DVec2>, closest: f64) -> Vec<DVec2> {
    let by_angle = |a: &DVec2, b: &DVec2| pseudo_angle(*a).total_cmp(&pseudo_angle(*b));
    extra.sort_by(by_angle);
    let is_near = |a: DVec2, b: Option<&DVec2>| b.is_some_and(|&b| a.distance(b) < closest);
    let mut merged = Vec::with_capacity(kept.len() + extra.len());
    let mut following = kept.iter().peekable();
    for direction in extra {
        while let Some(&next) = following.next_if(|next| by_angle(next, &direction).is_le()) {
            merged.push(next);
        }
        let after = following.peek().copied().or(kept.first());
        let before = merged.last().or(kept.last());
        if !is_near(direction, before) && !is_near(direction, after) {
            merged.push(direction);
        }
    }
    merged.extend(following);
    merged
}

/// Grows with the angle of a unit vector, from 0 at the x-axis to 4 after a full turn.
fn pseudo_angle(d: DVec2) -> f64 {
    let along = d.x / (d.x.abs() + d.y.abs());
    if d.y >= 0.0 { 1.0 - along } else { 3.0 + along }
}

#[cfg(test)]
mod tests {
    use delaunay_core::progress::silent;

    use super::*;
    use crate::wall::Circle;

    fn two_holes(gap: f64) -> Domain {
        let holes = [
            Circle::new(DVec2::new(-1.0 - gap / 2.0, 0.0), 1.0),
            Circle::new(DVec2::new(1.0 + gap / 2.0, 0.0), 1.0),
        ];
        Domain::in_circle(Circle::new(DVec2::ZERO, 4.0), &holes).unwrap()
    }

    #[test]
    fn samples_run_counterclockwise_and_lie_on_their_walls() {
        let domain = two_holes(0.01);
        let samples =
            Samples::by_local_gap(&domain, &Clearance::new(&domain), &mut silent).unwrap();
        for id in (0..samples.len() as u32).map(SampleId) {
            let wall = domain.wall(samples.wall(id));
            assert!(wall.distance(samples.points()[id.index()]).abs() < 1e-14);
            assert!(
                samples
                    .direction(id)
                    .perp_dot(samples.direction(samples.next(id)))
                    > 0.0
            );
        }
    }

    #[test]
    fn every_piece_is_short_against_its_gap() {
        let domain = two_holes(1e-3);
        let clearance = Clearance::new(&domain);
        let samples = Samples::by_local_gap(&domain, &clearance, &mut silent).unwrap();
        for id in (0..samples.len() as u32).map(SampleId) {
            let (p, q) = (
                samples.points()[id.index()],
                samples.points()[samples.next(id).index()],
            );
            let own = samples.wall(id);
            for end in [p, q] {
                let gap = clearance
                    .nearest(end, |image| image.wall != own)
                    .unwrap()
                    .distance;
                assert!(p.distance(q) <= PIECE_PER_GAP * gap * 1.001);
            }
        }
    }

    #[test]
    fn the_number_of_samples_grows_with_the_root_of_the_gap() {
        let count = |gap| {
            let domain = two_holes(gap);
            Samples::by_local_gap(&domain, &Clearance::new(&domain), &mut silent)
                .unwrap()
                .len() as f64
        };
        let ratio = count(1e-6) / count(1e-4);
        assert!((5.0..20.0).contains(&ratio), "{ratio}");
    }

    #[test]
    fn extra_samples_keep_the_order_round_the_wall() {
        let domain = two_holes(0.5);
        let samples =
            Samples::by_local_gap(&domain, &Clearance::new(&domain), &mut silent).unwrap();
        let more = samples
            .with(
                &domain,
                &[
                    (WallId(0), DVec2::new(0.6, -0.8)),
                    (WallId(2), DVec2::new(-0.8, 0.6)),
                ],
            )
            .unwrap();
        assert_eq!(more.len(), samples.len() + 2);
        for id in (0..more.len() as u32).map(SampleId) {
            assert!(more.direction(id).perp_dot(more.direction(more.next(id))) > 0.0);
        }
    }
}
