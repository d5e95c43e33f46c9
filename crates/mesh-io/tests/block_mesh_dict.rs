//! `blockMeshDict` end to end: what is written can be told apart by its vertices, and what cannot be written is refused with a reason.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

mod some_blocks;

use std::collections::BTreeMap;

use mesh_io::block_mesh_dict::{Thickness, write};
use mesh_io::{BlockSide, Connection, StructuredBlock, StructuredBlocks};
use proptest::prelude::*;
use some_blocks::{blocks, ring};

fn written(blocks: &StructuredBlocks, thickness: Thickness) -> Result<String, String> {
    let mut file = Vec::new();
    write(&mut file, blocks, thickness).map_err(|error| error.to_string())?;
    Ok(String::from_utf8(file).unwrap())
}

/// A unit square of `n` by `n` cells that repeats itself in `x`, with `i` from bottom to top when `turned`.
fn periodic_square(n: usize, turned: bool) -> StructuredBlocks {
    let at = |k: usize| k as f64 / n as f64;
    let node = |k: usize| {
        let (i, j) = (at(k % (n + 1)), at(k / (n + 1)));
        if turned { [j, i, 0.0] } else { [i, j, 0.0] }
    };
    let to = |side, shift| Connection::Block {
        block: 0,
        side,
        reversed: false,
        shift: [shift, 0.0, 0.0],
    };
    let (bottom, top) = (
        Connection::Patch("bottom".into()),
        Connection::Patch("top".into()),
    );
    let sides = if turned {
        [
            bottom,
            top,
            to(BlockSide::JMax, 1.0),
            to(BlockSide::JMin, -1.0),
        ]
    } else {
        [
            to(BlockSide::IMax, 1.0),
            to(BlockSide::IMin, -1.0),
            bottom,
            top,
        ]
    };
    let points = (0..(n + 1) * (n + 1)).map(node).collect();
    StructuredBlocks {
        blocks: vec![StructuredBlock {
            name: "square".into(),
            ni: n + 1,
            nj: n + 1,
            points,
            sides,
        }],
    }
}

#[test]
fn a_ring_of_two_blocks_is_cut_so_that_its_curves_have_different_ends() {
    insta::assert_snapshot!(written(&ring(), Thickness::Length(0.5)).unwrap());
}

#[test]
fn a_period_becomes_a_pair_of_cyclic_patches() {
    insta::assert_snapshot!(written(&periodic_square(2, false), Thickness::default()).unwrap());
}

#[test]
fn a_clockwise_block_is_written_counterclockwise() {
    let hex = |turned| {
        let file = written(&periodic_square(2, turned), Thickness::default()).unwrap();
        file.lines()
            .find(|line| line.contains("hex"))
            .map(str::to_owned)
    };
    assert_eq!(
        hex(false).unwrap(),
        "    hex (0 1 2 3 4 5 6 7) (2 2 1) simpleGrading (1 1 1)"
    );
    assert_eq!(
        hex(true).unwrap(),
        "    hex (0 3 2 1 4 7 6 5) (2 2 1) simpleGrading (1 1 1)"
    );
}

#[test]
fn what_block_mesh_cannot_make_is_refused() {
    let refused = |blocks: &StructuredBlocks, thickness| written(blocks, thickness).unwrap_err();
    let mut lifted = ring();
    lifted.blocks[1].points[4][2] = 1e-3;
    let mut flat = ring();
    flat.blocks[0]
        .points
        .iter_mut()
        .for_each(|point| point[1] = 0.0);
    let mut coarse = ring();
    for block in &mut coarse.blocks {
        block.ni = 2;
        block.points = [0, 2, 3, 5].map(|node| block.points[node]).to_vec();
    }
    let mut huge = periodic_square(2, false);
    huge.blocks[0]
        .points
        .iter_mut()
        .for_each(|point| *point = point.map(|x| x * 1e200));
    // Two squares glued along all sides make a pillow.
    let mut pillow = periodic_square(1, false);
    pillow.blocks.push(pillow.blocks[0].clone());
    for (block, other) in [(0, 1), (1, 0)] {
        pillow.blocks[block].sides = BlockSide::ALL.map(|side| Connection::Block {
            block: other,
            side,
            reversed: false,
            shift: [0.0; 3],
        });
    }
    let errors = [
        refused(&pillow, Thickness::default()),
        refused(&lifted, Thickness::default()),
        refused(&flat, Thickness::default()),
        refused(&coarse, Thickness::default()),
        refused(&huge, Thickness::default()),
        refused(&ring(), Thickness::Length(-1.0)),
        refused(&ring(), Thickness::Length(f64::NAN)),
    ];
    insta::assert_snapshot!(errors.join("\n"));
}

/// The groups of numbers in parentheses of a section, between its name and the next `);` at the start of a line.
fn groups(file: &str, section: &str) -> Vec<Vec<usize>> {
    let start = file.find(&format!("\n{section}\n(")).unwrap();
    let section = &file[start..][..file[start..].find("\n);").unwrap()];
    let groups = section
        .split('(')
        .map(|group| group.split(')').next().unwrap_or_default());
    let numbers = |group: &str| {
        group
            .split_whitespace()
            .map(|word| word.parse().ok())
            .collect()
    };
    groups
        .filter_map(numbers)
        .filter(|group: &Vec<usize>| !group.is_empty())
        .collect()
}

proptest! {
    #[test]
    fn every_face_is_shared_or_in_one_patch(blocks in blocks()) {
        // Where nodes lie is left to chance, so a few outlines have no area and some blocks touch themselves.
        let Ok(file) = written(&flat(blocks), Thickness::Length(1.0)) else { return Ok(()) };
        let mut uses = BTreeMap::<Vec<usize>, usize>::new();
        for hex in groups(&file, "blocks").iter().filter(|group| group.len() == 8) {
            for face in [[0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7], [0, 1, 2, 3], [4, 5, 6, 7]] {
                let mut face = face.map(|corner| hex[corner]).to_vec();
                face.sort_unstable();
                *uses.entry(face).or_default() += 1;
            }
        }
        for mut face in groups(&file, "boundary").into_iter().filter(|group| group.len() == 4) {
            face.sort_unstable();
            *uses.entry(face).or_default() += 1;
        }
        for (face, count) in uses {
            prop_assert_eq!(count, 2, "face {:?} in\n{}", face, file);
        }
    }
}

fn flat(mut blocks: StructuredBlocks) -> StructuredBlocks {
    for block in &mut blocks.blocks {
        block.points.iter_mut().for_each(|point| point[2] = 0.0);
        for side in &mut block.sides {
            if let Connection::Block { shift, .. } = side {
                shift[2] = 0.0;
                if shift[0].abs() < 0.7 {
                    *shift = [0.0; 3];
                }
            }
        }
    }
    blocks
}
