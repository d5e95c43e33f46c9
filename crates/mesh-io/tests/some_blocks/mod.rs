//! Structured blocks to try formats with.

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
