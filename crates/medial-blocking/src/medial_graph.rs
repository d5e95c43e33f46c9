//! The medial axis as a graph: vertices with the walls they touch, arcs with the bisector they
//! follow.
//!
//! Every arc has a *frame*, the one in which its driving hole is at home; the other wall and the
//! end vertices carry the periods that move them there.

use glam::DVec2;

use crate::bisector::Bisector;
use crate::blocking2d::BlockPair;
use crate::corner::{Corner, wall_image};
use crate::domain::Domain;
use crate::medial_axis::SampledAxis;
use crate::wall::{Shift, Wall, WallId, WallImage, WallKind};

/// A vertex of the medial axis, numbered like the interior triangles.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct MedialVertexId(pub(crate) u32);

impl MedialVertexId {
    /// Position in [`crate::Blocking::vertices`].
    #[must_use]
    pub const fn index(self) -> usize {
        self.0 as usize
    }
}

/// An arc of the medial axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct ArcId(pub(crate) u32);

impl ArcId {
    /// Position in [`crate::Blocking::arcs`].
    #[must_use]
    pub const fn index(self) -> usize {
        self.0 as usize
    }
}

/// Where an empty circle touches a wall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Touch {
    /// The wall, moved to where the circle is.
    pub image: WallImage,
    /// Unit vector from the centre of the wall's circle to the touching point.
    pub direction: DVec2,
}

impl Touch {
    pub(crate) fn of(image: WallImage, wall: &Wall, center: DVec2) -> Self {
        Self {
            image,
            direction: (center - wall.circle.center).normalize_or_zero(),
        }
    }
}

/// A vertex of the medial axis: the centre of an empty circle that touches three walls.
///
/// The four cuts of the closed medial axis round a single hole are vertices that touch two.
#[derive(Clone, Debug, PartialEq)]
pub struct MedialVertex {
    /// Centre of the empty circle.
    pub center: DVec2,
    /// Its radius.
    pub clearance: f64,
    /// Where it touches walls, counterclockwise round the centre.
    pub touches: Vec<Touch>,
}

/// One end of an arc.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ArcEnd {
    /// The vertex.
    pub vertex: MedialVertexId,
    /// The periods that move the vertex to the arc's end.
    pub shift: Shift,
    /// Which of the vertex's touches is on the wall to the right of the arc, travelling from start
    /// to end.
    pub right: u8,
    /// Which is on the wall to the left.
    pub left: u8,
}

/// An arc of the medial axis: the centres of the empty circles that touch two walls, between two
/// vertices.
#[derive(Clone, Debug, PartialEq)]
pub struct MedialArc {
    /// Where it starts.
    pub start: ArcEnd,
    /// Where it ends.
    pub end: ArcEnd,
    /// The wall on the right, travelling from start to end.
    pub right: WallImage,
    /// The wall on the left.
    pub left: WallImage,
    /// The curve between the ends.
    pub curve: ArcCurve,
}

/// A piece of bisector, by the direction from the driving hole.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArcCurve {
    bisector: Bisector,
    from: DVec2,
    /// Radians from the start to the end of the arc round the driving hole, counterclockwise
    /// positive.
    sweep: f64,
}

impl ArcCurve {
    pub(crate) const fn new(bisector: Bisector, from: DVec2, sweep: f64) -> Self {
        Self {
            bisector,
            from,
            sweep,
        }
    }

    /// The point at the fraction `u` in [0, 1] of the sweep.
    #[must_use]
    pub fn point(&self, u: f64) -> DVec2 {
        self.bisector.point(self.direction(u))
    }

    /// Length of curve per unit of `u`.
    #[must_use]
    pub fn speed(&self, u: f64) -> f64 {
        self.bisector.speed(self.direction(u)) * self.sweep.abs()
    }

    fn direction(&self, u: f64) -> DVec2 {
        DVec2::from_angle(u * self.sweep).rotate(self.from)
    }
}

/// The arcs that the block pairs follow, in the same order.
///
/// `vertices` are those of the interior triangles, in the triangulation's order.
pub(crate) fn medial_arcs(
    axis: &SampledAxis<'_>,
    vertices: &[MedialVertex],
    pairs: &[BlockPair],
) -> Vec<MedialArc> {
    let mut vertex_of = vec![MedialVertexId(u32::MAX); axis.triangulation.triangles().len()];
    for (k, triangle) in axis.triangulation.interior().enumerate() {
        vertex_of[triangle.index()] = MedialVertexId(k as u32);
    }
    pairs
        .iter()
        .filter_map(|pair| medial_arc(axis, vertices, &vertex_of, pair))
        .collect()
}

fn medial_arc(
    axis: &SampledAxis<'_>,
    vertices: &[MedialVertex],
    vertex_of: &[MedialVertexId],
    pair: &BlockPair,
) -> Option<MedialArc> {
    let (first, last) = (pair.sequence.start, *pair.sequence.entries.last()?);
    // A side's corner k is the touch k of the vertex; at the end of the arc the side is seen from
    // beyond.
    let start = ArcEnd {
        vertex: vertex_of[first.triangle.index()],
        shift: Shift::ZERO,
        right: first.side,
        left: first.next().side,
    };
    let end = ArcEnd {
        vertex: vertex_of[last.side.triangle.index()],
        shift: last.shift,
        right: last.side.next().side,
        left: last.side.side,
    };
    let (right, left) = (
        wall_image(axis.samples, pair.c1[0]),
        wall_image(axis.samples, pair.c2[0]),
    );
    let right_drives = drives(axis.domain, right, left);
    let (driver, other, chain) = if right_drives {
        (right, left, &pair.c1)
    } else {
        (left, right, &pair.c2)
    };
    let touch = |end: &ArcEnd| {
        let touch = if right_drives { end.right } else { end.left };
        vertices[end.vertex.index()].touches[usize::from(touch)].direction
    };
    let home = -driver.shift;
    let moved = |image: WallImage| WallImage {
        shift: image.shift + home,
        ..image
    };
    let bisector = Bisector::between(
        axis.domain.wall(driver.wall),
        &axis.domain.wall_image(moved(other)),
    );
    let curve = ArcCurve::new(
        bisector,
        touch(&start),
        sweep(axis, chain, touch(&start), touch(&end)),
    );
    let at_home = |end: ArcEnd| ArcEnd {
        shift: end.shift + home,
        ..end
    };
    Some(MedialArc {
        start: at_home(start),
        end: at_home(end),
        right: moved(right),
        left: moved(left),
        curve,
    })
}

/// Whether the first of two walls drives the arc between them: a hole before the bounding circle,
/// else the smaller, round which directions change most; between equals the smaller id, then shift.
fn drives(domain: &Domain, first: WallImage, second: WallImage) -> bool {
    let rank = |image: WallImage| {
        let wall = domain.wall(image.wall);
        (wall.kind == WallKind::Bounding, wall.circle.radius)
    };
    let (a, b) = (rank(first), rank(second));
    let ids = |image: WallImage| (image.wall, image.shift.to_array());
    a.0.cmp(&b.0)
        .then(a.1.total_cmp(&b.1))
        .then(ids(first).cmp(&ids(second)))
        .is_le()
}

/// Radians from one touching point to another, following the samples between them so that no turn
/// is lost.
fn sweep(axis: &SampledAxis<'_>, chain: &[Corner], from: DVec2, to: DVec2) -> f64 {
    let directions = chain
        .iter()
        .map(|corner| axis.samples.direction(corner.sample));
    let mut sum = 0.0;
    let mut at = from;
    for direction in directions.chain([to]) {
        sum += at.angle_to(direction);
        at = direction;
    }
    sum
}

/// The medial axis of a single hole in a circle, a closed curve, cut into four arcs.
///
/// The cuts lie in the direction of the bounding circle's centre and at right angles to it, so the
/// blocks are as symmetric as the domain.
pub(crate) fn ring(
    domain: &Domain,
    hole: WallId,
    bounding: WallId,
) -> (Vec<MedialVertex>, Vec<MedialArc>) {
    let (inner, outer) = (*domain.wall(hole), *domain.wall(bounding));
    let bisector = Bisector::between(&inner, &outer);
    let image = |wall| WallImage {
        wall,
        shift: Shift::ZERO,
    };
    let mut direction = (outer.circle.center - inner.circle.center).normalize_or(DVec2::X);
    let (mut vertices, mut arcs) = (Vec::new(), Vec::new());
    for k in 0..4u32 {
        let center = bisector.point(direction);
        let touches = vec![
            Touch::of(image(hole), &inner, center),
            Touch::of(image(bounding), &outer, center),
        ];
        vertices.push(MedialVertex {
            center,
            clearance: inner.distance(center),
            touches,
        });
        let end = |vertex| ArcEnd {
            vertex: MedialVertexId(vertex),
            shift: Shift::ZERO,
            right: 0,
            left: 1,
        };
        let curve = ArcCurve::new(bisector, direction, -std::f64::consts::FRAC_PI_2);
        arcs.push(MedialArc {
            start: end(k),
            end: end((k + 1) % 4),
            right: image(hole),
            left: image(bounding),
            curve,
        });
        direction = -direction.perp();
    }
    (vertices, arcs)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Blocking;
    use crate::example_domains::{one_hole, three_holes, two_periodic_holes};

    #[test]
    fn an_arc_starts_and_ends_at_its_vertices() {
        for domain in [one_hole(), three_holes(), two_periodic_holes()] {
            let blocking = Blocking::of(&domain).unwrap();
            for arc in blocking.arcs() {
                for (end, u) in [(arc.start, 0.0), (arc.end, 1.0)] {
                    let vertex = blocking.vertex(end.vertex).center + domain.translation(end.shift);
                    assert!(arc.curve.point(u).distance(vertex) < 1e-13);
                }
            }
        }
    }

    #[test]
    fn the_ends_of_an_arc_touch_the_walls_on_its_two_sides() {
        let blocking = Blocking::of(&two_periodic_holes()).unwrap();
        for arc in blocking.arcs() {
            for end in [arc.start, arc.end] {
                let touches = &blocking.vertex(end.vertex).touches;
                let image = |touch: u8| {
                    let image = touches[usize::from(touch)].image;
                    WallImage {
                        shift: image.shift + end.shift,
                        ..image
                    }
                };
                assert_eq!((image(end.right), image(end.left)), (arc.right, arc.left));
            }
        }
    }

    #[test]
    fn the_speed_of_a_curve_is_the_length_of_its_derivative() {
        let blocking = Blocking::of(&three_holes()).unwrap();
        for arc in blocking.arcs() {
            let step = 1e-6;
            let chord = arc
                .curve
                .point(0.3 + step)
                .distance(arc.curve.point(0.3 - step));
            let speed = arc.curve.speed(0.3);
            assert!((chord / (2.0 * step) - speed).abs() < 1e-6 * speed);
        }
    }

    #[test]
    fn a_hole_drives_before_the_bounding_circle_and_a_small_one_before_a_large() {
        let domain = three_holes();
        let image = |wall| WallImage {
            wall: WallId(wall),
            shift: Shift::ZERO,
        };
        for (first, second) in [(0, 3), (1, 3), (2, 0), (0, 1)] {
            assert!(drives(&domain, image(first), image(second)));
            assert!(!drives(&domain, image(second), image(first)));
        }
    }
}
