//! What the given boundary nodes allow: how sharp its corners are, how steeply its sizes change, how narrow its gaps are.
//!
//! The boundary's edges are edges of triangles, so where a long edge faces short ones across a small gap, or two long ones a gap narrower
//! than they are long, triangles are poor whatever is done inside:
//!
//! ```text
//!     --- H ---          steepness = (H - h) / gap        of a long edge H and a short one h that see each other
//!        gap             width     = gap / H              of an edge H and what it sees
//!     · h · h · h ·      angle                            of two edges that meet
//! ```
//!
//! Edges see each other where the triangulation of the boundary nodes has a triangle or an edge between them.

use delaunay_core::{FaceId, HalfEdgeId, Subcomplex2, VertexId};
use glam::DVec2;
use rstar::RTree;
use rstar::primitives::GeomWithData;

use crate::bubble::centroid;
use crate::domain::Domain;

/// What holds at one boundary node.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NodeSpacing {
    /// The smallest angle inside between two edges at the node; radians, above 0, up to 2π.
    pub angle: f64,
    /// The largest difference of the lengths of an edge at the node and one that it sees, over their distance; not negative.
    pub steepness: f64,
    /// The least distance of what an edge at the node sees, over the edge's length; above 0, infinite when it sees its neighbours only.
    pub width: f64,
}

impl NodeSpacing {
    /// Angles below this, 45 degrees in radians, are sharp: the best triangle in a corner of 26 degrees has a ratio of 0.7.
    pub const SHARP: f64 = std::f64::consts::FRAC_PI_4;
    /// Sizes that change by more than this are steep.
    pub const STEEP: f64 = 0.5;
    /// Gaps narrower than this are narrow: there is room for one row of triangles and a part of another.
    pub const NARROW: f64 = 1.5;

    /// Of a node that sees nothing.
    const FREE: Self = Self {
        angle: std::f64::consts::TAU,
        steepness: 0.0,
        width: f64::INFINITY,
    };

    /// Whether triangles there can be expected to be good: it is neither sharp nor steep nor narrow.
    #[must_use]
    pub fn is_fair(&self) -> bool {
        self.angle >= Self::SHARP && self.steepness <= Self::STEEP && self.width >= Self::NARROW
    }

    fn worst_of(self, other: Self) -> Self {
        Self {
            angle: self.angle.min(other.angle),
            steepness: self.steepness.max(other.steepness),
            width: self.width.min(other.width),
        }
    }
}

/// What holds at the boundary nodes of a domain.
///
/// ```
/// use bubble_mesh::{Domain, Spacing};
/// use delaunay_core::{BuildOptions, Outline, VertexId, progress::silent};
/// use glam::DVec2;
///
/// // A strip four units long and one wide, with a node in the middle of its lower side.
/// let points = [[0.0, 0.0], [2.0, 0.0], [4.0, 0.0], [4.0, 1.0], [0.0, 1.0]].map(DVec2::from);
/// let segments = (0..5).map(|i| [i, (i + 1) % 5].map(VertexId::new));
/// let outline = Outline::new(points.to_vec(), segments.collect())?;
/// let domain = Domain::new(&outline, BuildOptions::default(), &mut silent)?;
/// let spacing = Spacing::of(&domain);
/// assert_eq!(spacing.worst().width, 0.25);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Spacing {
    /// By vertex.
    nodes: Vec<NodeSpacing>,
    /// By vertex, the longest edge of the boundary there.
    longest: Vec<f64>,
    /// The nodes that are not fair.
    unfair: RTree<GeomWithData<[f64; 2], VertexId>>,
    /// The longest edge at one of them.
    farthest: f64,
}

impl Spacing {
    /// Looks at the boundary. Takes linear time.
    #[must_use]
    pub fn of(domain: &Domain) -> Self {
        let region = domain.region();
        let mut survey = Survey::of(region);
        for h in region.boundary() {
            survey.look_along(h);
            survey.look_across(h);
        }
        for h in region.mesh().half_edges() {
            survey.look_beyond(h);
        }
        let ids = (0..survey.nodes.len()).map(VertexId::new);
        let unfair: Vec<VertexId> = ids.filter(|v| !survey.nodes[v.index()].is_fair()).collect();
        let longest = unfair.iter().map(|v| survey.longest[v.index()]);
        let farthest = longest.fold(0.0, f64::max);
        let place = |v: VertexId| GeomWithData::new(region.point(v).to_array(), v);
        Self {
            unfair: RTree::bulk_load(unfair.into_iter().map(place).collect()),
            nodes: survey.nodes,
            longest: survey.longest,
            farthest,
        }
    }

    /// What stands in the way of a triangle: the worst of the nodes that are not fair and not farther from its centroid than their
    /// longest edge or its own. `None` where all is fair, so that it ought to be good.
    ///
    /// Takes time for the nodes that are not fair within the longest edge of all of these.
    #[must_use]
    pub fn against(&self, corners: [DVec2; 3]) -> Option<NodeSpacing> {
        let [a, b, c] = corners;
        let own = a.distance(b).max(b.distance(c)).max(c.distance(a));
        let center = centroid(corners);
        let reach = own.max(self.farthest);
        let near = self
            .unfair
            .locate_within_distance(center.to_array(), reach * reach);
        let reaches = |v: &VertexId, place: &[f64; 2]| {
            DVec2::from(*place).distance(center) <= own.max(self.longest[v.index()])
        };
        let near = near.filter(|node| reaches(&node.data, node.geom()));
        near.map(|node| self.at(node.data))
            .reduce(NodeSpacing::worst_of)
    }

    /// What holds at a boundary node.
    ///
    /// # Panics
    /// When there is no such node.
    #[must_use]
    pub fn at(&self, v: VertexId) -> NodeSpacing {
        self.nodes[v.index()]
    }

    /// The boundary nodes and what holds there, by id.
    pub fn nodes(&self) -> impl Iterator<Item = (VertexId, NodeSpacing)> + '_ {
        (0..).map(VertexId::new).zip(self.nodes.iter().copied())
    }

    /// The worst of each kind anywhere.
    #[must_use]
    pub fn worst(&self) -> NodeSpacing {
        let nodes = self.nodes.iter().copied();
        nodes.fold(NodeSpacing::FREE, NodeSpacing::worst_of)
    }

    /// The longest boundary edge at a node; unit of length.
    ///
    /// # Panics
    /// When there is no such node.
    #[must_use]
    pub fn longest_edge(&self, v: VertexId) -> f64 {
        self.longest[v.index()]
    }
}

/// The boundary while it is looked at.
struct Survey<'a> {
    region: &'a Subcomplex2,
    nodes: Vec<NodeSpacing>,
    /// By vertex, of the boundary edges there.
    shortest: Vec<f64>,
    longest: Vec<f64>,
}

impl<'a> Survey<'a> {
    fn of(region: &'a Subcomplex2) -> Self {
        let count = region.points().len();
        let mut survey = Self {
            region,
            nodes: vec![NodeSpacing::FREE; count],
            shortest: vec![f64::INFINITY; count],
            longest: vec![0.0; count],
        };
        for h in region.boundary() {
            let [a, b] = region.segment(h);
            let length = a.distance(b);
            for v in survey.ends(h) {
                survey.shortest[v.index()] = survey.shortest[v.index()].min(length);
                survey.longest[v.index()] = survey.longest[v.index()].max(length);
            }
        }
        survey
    }

    fn ends(&self, h: HalfEdgeId) -> [VertexId; 2] {
        [self.region.mesh().origin(h), self.region.mesh().target(h)]
    }

    /// An edge and the next one round its origin inside: the angle between them, and how their lengths differ.
    fn look_along(&mut self, h: HalfEdgeId) {
        let (region, mesh) = (self.region, self.region.mesh());
        let mut last = h.prev();
        while !region.is_boundary(last) {
            last = mesh.twin(last).prev();
        }
        let [here, to] = region.segment(h);
        let [from, _] = region.segment(last);
        let [ahead, back] = [to - here, from - here];
        let angle = ahead.angle_to(back).rem_euclid(std::f64::consts::TAU);
        let [ahead, back] = [ahead, back].map(DVec2::length);
        let found = NodeSpacing {
            // An edge with the inside on both sides all round.
            angle: if angle > 0.0 {
                angle
            } else {
                std::f64::consts::TAU
            },
            steepness: (ahead - back).abs() / (0.5 * (ahead + back)),
            ..NodeSpacing::FREE
        };
        self.note(mesh.origin(h), found);
    }

    /// An edge and the corner of its triangle, unless an edge of the boundary joins them.
    fn look_across(&mut self, h: HalfEdgeId) {
        let (region, mesh) = (self.region, self.region.mesh());
        if [h.next(), h.prev()]
            .into_iter()
            .any(|h| region.is_boundary(h))
        {
            return;
        }
        let apex = mesh.apex(h);
        let [a, b] = region.segment(h);
        let length = a.distance(b);
        let gap = distance_to_segment(region.point(apex), a, b);
        let found = NodeSpacing {
            steepness: (length - self.shortest[apex.index()]).max(0.0) / gap,
            width: gap / length,
            ..NodeSpacing::FREE
        };
        let [a, b] = self.ends(h);
        [a, b, apex].into_iter().for_each(|v| self.note(v, found));
    }

    /// The edges at both ends of an edge inside.
    fn look_beyond(&mut self, h: HalfEdgeId) {
        let (region, mesh) = (self.region, self.region.mesh());
        let is_ghost = |f: FaceId| mesh.is_ghost_face(f);
        if is_ghost(h.face()) || is_ghost(mesh.twin(h).face()) {
            return;
        }
        let [a, b] = region.segment(h);
        let [v, w] = self.ends(h);
        let differs = (self.longest[v.index()] - self.shortest[w.index()]).max(0.0);
        let found = NodeSpacing {
            steepness: differs / a.distance(b),
            ..NodeSpacing::FREE
        };
        [v, w].into_iter().for_each(|v| self.note(v, found));
    }

    fn note(&mut self, v: VertexId, found: NodeSpacing) {
        let node = &mut self.nodes[v.index()];
        *node = node.worst_of(found);
    }
}

/// The distance of a point from the nearest point of a segment.
fn distance_to_segment(p: DVec2, a: DVec2, b: DVec2) -> f64 {
    let along = b - a;
    let share = ((p - a).dot(along) / along.length_squared()).clamp(0.0, 1.0);
    p.distance(a + share * along)
}

#[cfg(test)]
mod tests {
    use super::*;
    use delaunay_core::progress::silent;
    use delaunay_core::{BuildOptions, Outline};

    /// The region between loops of nodes.
    fn spacing(loops: &[&[[f64; 2]]]) -> Spacing {
        let mut segments = Vec::new();
        let mut first = 0;
        for nodes in loops {
            let count = nodes.len();
            let edge = |i: usize| [i, (i + 1) % count].map(|i| VertexId::new(first + i));
            segments.extend((0..count).map(edge));
            first += count;
        }
        let points = loops.concat().into_iter().map(DVec2::from).collect();
        let outline = Outline::new(points, segments).unwrap();
        let domain = Domain::new(&outline, BuildOptions::default(), &mut silent).unwrap();
        Spacing::of(&domain)
    }

    #[test]
    fn angles_are_measured_inside() {
        // An arrow head: a notch of 90 degrees, so 270 inside, behind a tip.
        let arrow = spacing(&[&[[0.0, 0.0], [-1.0, 1.0], [3.0, 0.0], [-1.0, -1.0]]]);
        let angle = |v: usize| arrow.at(VertexId::new(v)).angle.to_degrees();
        assert!((angle(0) - 90.0).abs() < 1e-9 || (angle(0) - 270.0).abs() < 1e-9);
        assert!((angle(2) - 2.0 * 0.25_f64.atan().to_degrees()).abs() < 1e-9);
        assert!((arrow.worst().angle - angle(2).min(angle(1)).to_radians()).abs() < 1e-9);
    }

    #[test]
    fn steps_along_and_across_are_steep() {
        // Edges of 2 above, of 1 and 0.5 below, one unit apart.
        let along = [
            [0.0, 0.0],
            [1.0, 0.0],
            [1.5, 0.0],
            [2.0, 0.0],
            [2.0, 1.0],
            [0.0, 1.0],
        ];
        let strip = spacing(&[&along]);
        let at = |v: usize| strip.at(VertexId::new(v));
        // From 1 to 0.5 within 0.75; from 2 to 0.5 within 1, or to the sides.
        assert!(at(1).steepness >= 0.5 / 0.75);
        assert!(strip.worst().steepness >= 1.5);
        assert_eq!(strip.worst().width, 0.5);
        assert!(!at(4).is_fair() && !at(5).is_fair());
    }

    #[test]
    fn an_even_ring_is_fair_and_what_is_near_a_tip_is_not() {
        let turn = |i: u32| f64::from(i) / 48.0 * std::f64::consts::TAU;
        let mut ring: Vec<[f64; 2]> = (0..48)
            .map(|i| DVec2::from_angle(turn(i)).to_array())
            .collect();
        let even = spacing(&[&ring]);
        assert!(even.nodes().all(|(_, node)| node.is_fair()));
        let small = [[0.0, 0.0], [0.1, 0.0], [0.0, 0.1]].map(DVec2::from);
        assert_eq!(even.against(small), None);
        ring[0] = [2.0, 0.0];
        let tip = spacing(&[&ring]);
        let near = small.map(|p| p + DVec2::new(1.6, 0.0));
        assert!(
            tip.against(near)
                .is_some_and(|node| node.angle < NodeSpacing::SHARP)
        );
        assert_eq!(tip.against(small.map(|p| p - DVec2::new(0.5, 0.0))), None);
    }
}
