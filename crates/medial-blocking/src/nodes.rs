//! Nodes along the bounding curves of the blocks (§5, §6).
//!
//! Nodes are equally spaced by length along medial arcs and, unless empty circles match them, along
//! walls. The paper holds that such nodes never fold a cell. They can: where an arc runs far out
//! from a small hole, equal lengths of arc belong to very unequal angles of wall. So every strip of
//! cells is tested, by exact signs, and where one folds the nodes of that arc *lean*: first the
//! wall's nodes towards the touching points, then the arc's nodes towards equal angles round the
//! walls on both sides, in quarters, as little as unfolds the strips. Nodes that lean all the way
//! fold no cell when there are four or more.

use std::cell::LazyCell;
use std::f64::consts::PI;
use std::ops::Deref;

use geo_predicates::orient2d;
use glam::DVec2;

use crate::arc_length::ArcLength;
use crate::block::{ArcSide, BlockId};
use crate::blocking::{Blocking, COLLAPSED};
use crate::error::BlockingError;
use crate::medial_graph::{ArcEnd, ArcId};
use crate::params::NodeMatching;
use crate::turn::Turn;

/// How far nodes lean away from equal spacing, tried in this order until no strip folds.
const LEANS: [f64; 5] = [0.0, 0.25, 0.5, 0.75, 1.0];

impl Blocking {
    /// Length of a medial arc, to about 1e-9 of itself.
    #[must_use]
    pub fn arc_length(&self, arc: ArcId) -> f64 {
        ArcLength::of(self.arc(arc).curve).total()
    }

    /// The longest of an arc and the two pieces of wall on its sides.
    pub(crate) fn longest_curve_along(&self, arc: ArcId) -> f64 {
        let wall = |block: BlockId| {
            self.wall_sweep(block).abs() * self.wall_of(self.block(block)).circle.radius
        };
        self.arc_length(arc)
            .max(wall(arc.right_block()))
            .max(wall(arc.left_block()))
    }

    /// Nodes along an arc and the two walls on its sides, with no strip of cells folded.
    ///
    /// # Errors
    /// [`BlockingError::TooFewCells`] when a cell would still fold. Arcs that rounding has left of
    /// co-circular holes are exempt: their cells are empty however they are matched.
    pub(crate) fn nodes_along(
        &self,
        id: ArcId,
        cells: u32,
        matching: NodeMatching,
    ) -> Result<NodesAlong, BlockingError> {
        let arc = self.arc(id);
        let center = |image| self.domain().wall_image(image).circle.center;
        let length = ArcLength::of(arc.curve);
        // Few arcs lean, so few need it.
        let turn = LazyCell::new(|| Turn::of(arc.curve, [arc.right, arc.left].map(center)));
        let mut folded = id.right_block();
        for lean in LEANS {
            let nodes = self.arc_nodes(id, (&length, &turn), cells, lean);
            let [right, left] = [id.right_block(), id.left_block()]
                .map(|block| self.side_nodes(block, &nodes, matching));
            folded = if right.folded {
                id.right_block()
            } else {
                id.left_block()
            };
            if !(right.folded || left.folded) || self.is_thin(id, COLLAPSED) {
                return Ok(NodesAlong { lean, right, left });
            }
        }
        let wall = self.domain().name(self.block(folded).wall);
        Err(BlockingError::TooFewCells {
            arc: id.index(),
            cells,
            wall,
        })
    }

    /// Nodes along an arc in the arc's frame; the ends are the medial vertices.
    fn arc_nodes(
        &self,
        id: ArcId,
        (length, turn): (&ArcLength, &impl Deref<Target = Turn>),
        cells: u32,
        lean: f64,
    ) -> Vec<DVec2> {
        let arc = self.arc(id);
        let end =
            |end: &ArcEnd| self.vertex(end.vertex).center + self.domain().translation(end.shift);
        let mut nodes = vec![end(&arc.start)];
        nodes.extend((1..cells).map(|k| {
            let fraction = f64::from(k) / f64::from(cells);
            let equal_length = length.parameter(length.total() * fraction);
            let u = if lean > 0.0 {
                equal_length + lean * (turn.parameter(fraction) - equal_length)
            } else {
                equal_length
            };
            self.domain().snap(arc.curve.point(u))
        }));
        nodes.push(end(&arc.end));
        nodes
    }

    /// The nodes on arc and wall of a block, the wall's leaning as little as unfolds the strips.
    fn side_nodes(&self, id: BlockId, arc_nodes: &[DVec2], matching: NodeMatching) -> SideNodes {
        let xi0 = self.xi0_nodes(id, arc_nodes);
        let angles = WallAngles::of(self, id, &xi0);
        let leans = match matching {
            NodeMatching::EqualSpacing => &LEANS[..],
            NodeMatching::EmptyCircle => &LEANS[LEANS.len() - 1..],
        };
        let candidate = |lean| (lean, angles.nodes(self, id, lean));
        let unfolded = leans
            .iter()
            .map(|&lean| candidate(lean))
            .find(|(_, xi1)| !folds(&xi0, xi1));
        let folded = unfolded.is_none();
        let (lean, xi1) = unfolded.unwrap_or_else(|| candidate(1.0));
        SideNodes {
            xi0,
            xi1,
            lean,
            folded,
        }
    }

    /// An arc's nodes as the ξ0-curve of a block.
    fn xi0_nodes(&self, id: BlockId, arc_nodes: &[DVec2]) -> Vec<DVec2> {
        let block = self.block(id);
        let by = self.domain().translation(block.arc_shift);
        let moved = arc_nodes.iter().map(|&node| node + by);
        if block.side == ArcSide::Right {
            moved.collect()
        } else {
            moved.rev().collect()
        }
    }

    /// Equally spaced nodes on the straight lines η = 0 and η = 1 of a block.
    pub(crate) fn eta_nodes(&self, id: BlockId, cells: u32) -> [Vec<DVec2>; 2] {
        let block = self.block(id);
        [block.start, block.end].map(|corner| {
            let (from, to) = (self.inner_corner(&corner), self.wall_corner(block, &corner));
            (0..=cells)
                .map(|k| from.lerp(to, f64::from(k) / f64::from(cells)))
                .collect()
        })
    }
}

/// Nodes along an arc, as the ξ0- and ξ1-curves of the blocks on its sides.
pub(crate) struct NodesAlong {
    /// How far the arc's nodes lean from equal lengths towards equal angles.
    pub(crate) lean: f64,
    pub(crate) right: SideNodes,
    pub(crate) left: SideNodes,
}

/// Nodes at ξ = 0 and ξ = 1 of a block, by η.
pub(crate) struct SideNodes {
    pub(crate) xi0: Vec<DVec2>,
    pub(crate) xi1: Vec<DVec2>,
    /// How far the wall's nodes lean from equal spacing towards the touching points.
    pub(crate) lean: f64,
    folded: bool,
}

/// Angles of the points where the empty circles round the nodes of an arc touch a wall, from the
/// first one.
struct WallAngles(Vec<f64>);

impl WallAngles {
    fn of(blocking: &Blocking, id: BlockId, xi0: &[DVec2]) -> Self {
        let block = blocking.block(id);
        let (center, start) = (
            blocking.wall_of(block).circle.center,
            blocking.touch_direction(&block.start),
        );
        let sweep = blocking.wall_sweep(id);
        let last = xi0.len() - 1;
        let angles = xi0.iter().enumerate().map(|(k, &node)| match k {
            0 => 0.0,
            k if k == last => sweep,
            _ => near(start.angle_to((node - center).normalize_or(start)), sweep),
        });
        Self(angles.collect())
    }

    /// The wall's nodes, `lean` of the way from equal spacing to the touching points; the ends are
    /// the block's corners.
    fn nodes(&self, blocking: &Blocking, id: BlockId, lean: f64) -> Vec<DVec2> {
        let block = blocking.block(id);
        let (wall, start) = (
            blocking.wall_of(block),
            blocking.touch_direction(&block.start),
        );
        let last = self.0.len() - 1;
        let node = |(k, &touching): (usize, &f64)| match k {
            0 => blocking.wall_corner(block, &block.start),
            k if k == last => blocking.wall_corner(block, &block.end),
            _ => {
                let equal = self.0[last] * k as f64 / last as f64;
                wall.point_towards(
                    DVec2::from_angle(equal + lean * (touching - equal)).rotate(start),
                )
            }
        };
        self.0.iter().enumerate().map(node).collect()
    }
}

/// `angle`, known up to whole turns, brought between 0 and `sweep`, or as near to that as it comes.
fn near(angle: f64, sweep: f64) -> f64 {
    let middle = sweep / 2.0;
    angle - ((angle - middle) / (2.0 * PI)).round() * 2.0 * PI
}

/// Whether a strip of cells between two grid lines from arc to wall is not convex.
fn folds(xi0: &[DVec2], xi1: &[DVec2]) -> bool {
    xi0.windows(2).zip(xi1.windows(2)).any(|(m, c)| {
        let corners = [m[0], c[0], c[1], m[1]];
        (0..4).any(|k| {
            !orient2d(corners[k], corners[(k + 1) % 4], corners[(k + 2) % 4]).is_positive()
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::example_domains::{
        four_co_circular_holes, one_hole, three_holes, two_periodic_holes,
    };
    use crate::{CellCounts, Params};

    #[test]
    fn the_nodes_of_an_arc_are_equally_spaced_by_length() {
        for domain in [three_holes(), two_periodic_holes()] {
            let blocking = Blocking::of(&domain).unwrap();
            for id in blocking.arc_ids() {
                let length = ArcLength::of(blocking.arc(id).curve);
                let parameters: Vec<f64> = (0..=8)
                    .map(|k| length.parameter(length.total() * f64::from(k) / 8.0))
                    .collect();
                let fine = |from: f64, to: f64| -> f64 {
                    let at = |k: i32| {
                        blocking
                            .arc(id)
                            .curve
                            .point(from + (to - from) * f64::from(k) / 200.0)
                    };
                    (0..200).map(|k| at(k).distance(at(k + 1))).sum()
                };
                for two in parameters.windows(2) {
                    let piece = fine(two[0], two[1]);
                    assert!((8.0 * piece / length.total() - 1.0).abs() < 1e-4, "{piece}");
                }
            }
        }
    }

    #[test]
    fn matched_nodes_of_the_wall_are_where_the_empty_circles_touch() {
        let params = Params {
            cells: CellCounts::PerBlock(6),
            matching: NodeMatching::EmptyCircle,
        };
        let mesh = crate::mesh(&three_holes(), &params).unwrap();
        for (block, grid) in mesh.blocks() {
            let wall = mesh.blocking().wall_of(block);
            for j in 0..=6 {
                let (node, on_wall) = (grid.node(0, j), grid.node(6, j));
                assert!((node.distance(on_wall) - wall.distance(node)).abs() < 1e-13);
            }
        }
    }

    #[test]
    fn equally_spaced_nodes_of_the_wall_have_equal_chords() {
        let mesh = crate::mesh(&three_holes(), &Params::default()).unwrap();
        for (block, grid) in mesh.blocks() {
            if mesh.leaning_arcs().contains(&block.arc) {
                continue;
            }
            let chord = |j| grid.node(16, j).distance(grid.node(16, j + 1));
            assert!((0..16).all(|j| (chord(j) - chord(0)).abs() < 1e-12));
        }
    }

    #[test]
    fn a_cell_round_half_a_wall_is_refused() {
        let params = Params {
            cells: CellCounts::PerBlock(1),
            ..Params::default()
        };
        let hole = crate::Circle::new(DVec2::new(0.5, 0.0), 0.01);
        let large = crate::Circle::new(DVec2::new(-0.4, 0.0), 0.5);
        let outer = crate::Circle::new(DVec2::ZERO, 1.0);
        let domain = crate::Domain::in_circle(outer, &[hole, large]).unwrap();
        assert!(matches!(
            crate::mesh(&domain, &params),
            Err(BlockingError::TooFewCells { cells: 1, .. })
        ));
    }

    #[test]
    fn an_arc_without_length_is_meshed_with_empty_cells() {
        let mesh = crate::mesh(&four_co_circular_holes(), &Params::default()).unwrap();
        let thin: Vec<ArcId> = mesh.blocking().thin_arcs(COLLAPSED).collect();
        assert_eq!(thin.len(), 1);
        for (_, grid) in mesh.blocks().filter(|(block, _)| block.arc == thin[0]) {
            for [a, b, c, d] in grid.cells() {
                assert!((c - a).perp_dot(d - b).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn an_angle_is_brought_next_to_its_sweep() {
        for (angle, sweep, expected) in [
            (0.5, 1.0, 0.5),
            (0.5, -6.0, 0.5 - 2.0 * PI),
            (-3.0, 6.0, 2.0 * PI - 3.0),
        ] {
            assert!((near(angle, sweep) - expected).abs() < 1e-15);
        }
        assert_eq!(Blocking::of(&one_hole()).unwrap().arcs().len(), 4);
    }
}
