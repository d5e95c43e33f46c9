//! Structured blocks to try formats with.

#![allow(dead_code, reason = "each test uses a part of it")]

use mesh_io::{BlockSide, Connection, StructuredBlock, StructuredBlocks};
use proptest::prelude::*;

/// A polar grid round a hole: two blocks of 3 by 2 nodes, of which the second runs clockwise and meets the first end to end.
pub(crate) fn ring() -> StructuredBlocks {
    let half = |name: &str, other: usize, points: [[f64; 2]; 6]| StructuredBlock {
        name: name.into(),
        ni: 3,
        nj: 2,
        points: points.map(|[x, y]| [x, y, 0.0]).to_vec(),
        sides: [
            Connection::Block {
                block: other,
                side: BlockSide::IMin,
                reversed: false,
                shift: [0.0; 3],
            },
            Connection::Block {
                block: other,
                side: BlockSide::IMax,
                reversed: false,
                shift: [0.0; 3],
            },
            Connection::Patch("hole".into()),
            Connection::Patch("outer wall".into()),
        ],
    };
    let upper = [
        [1.0, 0.0],
        [0.0, 1.0],
        [-1.0, 0.0],
        [2.0, 0.0],
        [0.0, 2.0],
        [-2.0, 0.0],
    ];
    let lower = upper.map(|[x, y]| [x, -y]);
    StructuredBlocks {
        blocks: vec![half("upper half", 1, upper), half("lower half", 0, lower)],
    }
}

/// Up to five square blocks, some of whose sides lead to each other; where nodes lie is left to chance.
pub(crate) fn blocks() -> impl Strategy<Value = StructuredBlocks> {
    (1..6usize, 2..5usize, any::<bool>()).prop_flat_map(|(count, nodes, planar)| {
        let places: Vec<(usize, BlockSide)> = (0..count)
            .flat_map(|block| BlockSide::ALL.map(|side| (block, side)))
            .collect();
        let points = prop::collection::vec(prop::array::uniform3(-9.0..9.0), nodes * nodes);
        let blocks = prop::collection::vec(("\\PC{0,6}", points), count);
        let pairs = (0..=places.len() / 2, Just(places).prop_shuffle());
        let links =
            prop::collection::vec((any::<bool>(), prop::array::uniform3(-1.0..1.0)), 2 * count);
        (blocks, pairs, links).prop_map(move |(blocks, (linked, places), links)| {
            let blocks = blocks
                .into_iter()
                .map(|(name, points)| square(name, nodes, points, planar))
                .collect();
            let mut blocks = StructuredBlocks { blocks };
            for (pair, (reversed, shift)) in places.chunks_exact(2).zip(links).take(linked) {
                link(&mut blocks, pair[0], pair[1], reversed, shift);
                link(
                    &mut blocks,
                    pair[1],
                    pair[0],
                    reversed,
                    shift.map(|along: f64| -along),
                );
            }
            blocks
        })
    })
}

fn square(name: String, nodes: usize, mut points: Vec<[f64; 3]>, planar: bool) -> StructuredBlock {
    if planar {
        points.iter_mut().for_each(|point| point[2] = 0.0);
    }
    let sides = std::array::from_fn(|side| Connection::Patch(format!("{name} {side}")));
    StructuredBlock {
        name,
        ni: nodes,
        nj: nodes,
        points,
        sides,
    }
}

fn link(
    blocks: &mut StructuredBlocks,
    from: (usize, BlockSide),
    to: (usize, BlockSide),
    reversed: bool,
    shift: [f64; 3],
) {
    let sides = &mut blocks.blocks[from.0].sides;
    sides[from.1.index()] = Connection::Block {
        block: to.0,
        side: to.1,
        reversed,
        shift,
    };
}

/// Four blocks in a ring between two walls, each numbered in another way, with `place` for the node at a fraction of the way round
/// and from wall to wall. The last leads to the first by `shift`.
pub(crate) fn chain(
    around: usize,
    across: usize,
    place: impl Fn(f64, f64) -> [f64; 2],
    shift: [f64; 3],
) -> StructuredBlocks {
    let blocks = (0..STYLES.len()).map(|block| {
        let Style { swap, back, inward } = STYLES[block];
        let (ni, nj) = if swap {
            (across, around)
        } else {
            (around, across)
        };
        let node = |index: usize| {
            let (i, j) = (index % ni, index / ni);
            let (along, outward) = if swap { (j, i) } else { (i, j) };
            let along = if back { around - 1 - along } else { along };
            let outward = if inward {
                across - 1 - outward
            } else {
                outward
            };
            let along = (block as f64 + along as f64 / (around - 1) as f64) / STYLES.len() as f64;
            let [x, y] = place(along, outward as f64 / (across - 1) as f64);
            [x, y, 0.0]
        };
        StructuredBlock {
            name: format!("block {block}"),
            ni,
            nj,
            points: (0..ni * nj).map(node).collect(),
            sides: BlockSide::ALL.map(|side| behind(block, side, shift)),
        }
    });
    StructuredBlocks {
        blocks: blocks.collect(),
    }
}

/// How a block is numbered: with `j` round the ring instead of `i`, the other way round, and from the outer wall inwards.
struct Style {
    swap: bool,
    back: bool,
    inward: bool,
}

const STYLES: [Style; 4] = [
    Style {
        swap: false,
        back: false,
        inward: false,
    },
    Style {
        swap: true,
        back: false,
        inward: true,
    },
    Style {
        swap: false,
        back: true,
        inward: true,
    },
    Style {
        swap: true,
        back: true,
        inward: false,
    },
];

/// The sides at the start, at the end, at the inner and at the outer wall.
fn sides(block: usize) -> [BlockSide; 4] {
    let Style { swap, back, inward } = STYLES[block];
    let [i_min, i_max, j_min, j_max] = BlockSide::ALL;
    let (mut ends, mut walls) = ([i_min, i_max], [j_min, j_max]);
    if swap {
        (ends, walls) = (walls, ends);
    }
    if back {
        ends.reverse();
    }
    if inward {
        walls.reverse();
    }
    [ends[0], ends[1], walls[0], walls[1]]
}

fn behind(block: usize, side: BlockSide, shift: [f64; 3]) -> Connection {
    let count = STYLES.len();
    let [start, end, inner, _] = sides(block);
    let to = |other: usize, there: usize, shift| {
        let reversed = STYLES[block].inward != STYLES[other].inward;
        Connection::Block {
            block: other,
            side: sides(other)[there],
            reversed,
            shift,
        }
    };
    if side == start {
        let shift = if block == 0 {
            shift.map(|along| 0.0 - along)
        } else {
            [0.0; 3]
        };
        to((block + count - 1) % count, 1, shift)
    } else if side == end {
        to(
            (block + 1) % count,
            0,
            if block + 1 == count { shift } else { [0.0; 3] },
        )
    } else {
        Connection::Patch(
            if side == inner {
                "inner wall"
            } else {
                "outer wall"
            }
            .into(),
        )
    }
}

/// A ring between two circles.
pub(crate) fn annulus(around: usize, across: usize) -> StructuredBlocks {
    let place = |along: f64, outward: f64| {
        // The end is the start, to the last bit.
        let (sin, cos) = (along.fract() * std::f64::consts::TAU).sin_cos();
        [(1.0 + outward) * cos, (1.0 + outward) * sin]
    };
    chain(around, across, place, [0.0; 3])
}

/// A wavy strip that repeats itself every 4 units.
pub(crate) fn strip(around: usize, across: usize) -> StructuredBlocks {
    let place = |along: f64, outward: f64| {
        let wave = 0.1 * (along * std::f64::consts::TAU).sin();
        [4.0 * along, (1.0 - outward) * wave - outward]
    };
    chain(around, across, place, [4.0, 0.0, 0.0])
}
