//! Plot3D and its map end to end: what is written comes back, spoiled files are refused without a panic, errors say what and where.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

mod some_blocks;
mod spoiled;

use mesh_io::{Connection, Encoding, StructuredBlocks, connectivity_map, plot3d};
use proptest::prelude::*;
use some_blocks::{blocks, ring};
use spoiled::{spoiled, spoils};

fn grids(blocks: &StructuredBlocks, encoding: Encoding) -> Vec<u8> {
    let mut file = Vec::new();
    plot3d::write(&mut file, blocks, encoding).unwrap();
    file
}

fn map(blocks: &StructuredBlocks) -> Vec<u8> {
    let mut file = Vec::new();
    connectivity_map::write(&mut file, blocks).unwrap();
    file
}

const ENCODINGS: [Encoding; 2] = [Encoding::Ascii, Encoding::Binary];

proptest! {
    #[test]
    fn blocks_come_back_from_grids_and_map(blocks in blocks()) {
        for encoding in ENCODINGS {
            let bare = plot3d::parse(&grids(&blocks, encoding), encoding).unwrap();
            prop_assert_eq!(connectivity_map::parse(&map(&blocks), bare).unwrap(), blocks.clone());
        }
    }

    #[test]
    fn spoiled_grids_never_panic(blocks in blocks(), spoils in spoils()) {
        for encoding in ENCODINGS {
            if let Ok(blocks) = plot3d::parse(&spoiled(&grids(&blocks, encoding), &spoils), encoding) {
                prop_assert_eq!(blocks.check(), Ok(()));
            }
        }
    }

    #[test]
    fn spoiled_maps_never_panic(blocks in blocks(), spoils in spoils()) {
        if let Ok(blocks) = connectivity_map::parse(&spoiled(&map(&blocks), &spoils), blocks) {
            prop_assert_eq!(blocks.check(), Ok(()));
        }
    }

    #[test]
    fn any_bytes_never_panic(bytes in prop::collection::vec(any::<u8>(), 0..64)) {
        for encoding in ENCODINGS {
            let _ = plot3d::parse(&bytes, encoding);
        }
    }
}

#[test]
fn a_small_ring_reads_as_the_manual_says() {
    let text = [grids(&ring(), Encoding::Ascii), map(&ring())].concat();
    insta::assert_snapshot!(String::from_utf8(text).unwrap());
}

#[test]
fn sides_without_a_map_are_unknown_patches() {
    let blocks = plot3d::parse(&grids(&ring(), Encoding::Binary), Encoding::Binary).unwrap();
    let unknown = Connection::Patch(plot3d::UNKNOWN_SIDE.into());
    assert!(
        blocks
            .blocks
            .iter()
            .flat_map(|block| &block.sides)
            .all(|side| *side == unknown)
    );
}

#[test]
fn errors_name_the_element_and_its_place() {
    let file = String::from_utf8(grids(&ring(), Encoding::Ascii)).unwrap();
    let error = |text: &str| {
        plot3d::parse(text.as_bytes(), Encoding::Ascii)
            .unwrap_err()
            .to_string()
    };
    let binary = grids(&ring(), Encoding::Binary);
    let errors = [
        error(""),
        error("-1"),
        error("1000000000 2"),
        error("1\n2 2\n"),
        error("1\n2 2 2\n0 1 0 1 0 1 0 1\n0 0 1 1 0 0 1 1\n0 0 0 0 1 1 1 1\n"),
        error("1\n1 4\n0 1 2 3\n0 1 2 3\n"),
        error(&format!("{file} 7")),
        error(&file.replacen("2.0", "two", 1)),
        error(&file.replacen("2.0", "nan", 1)),
        plot3d::parse(&binary[..binary.len() - 1], Encoding::Binary)
            .unwrap_err()
            .to_string(),
        plot3d::parse(&[2, 0, 0, 0, 2], Encoding::Binary)
            .unwrap_err()
            .to_string(),
    ];
    insta::assert_snapshot!(errors.join("\n"));
}

#[test]
fn errors_in_a_map_name_their_line() {
    let file = String::from_utf8(map(&ring())).unwrap();
    let error = |from: &str, to: &str| {
        assert!(file.contains(from), "{from}");
        connectivity_map::parse(file.replacen(from, to, 1).as_bytes(), ring())
            .unwrap_err()
            .to_string()
    };
    let errors = [
        error("connectivity 1", "connectivity 2"),
        error("blocks 2", "blocks 3"),
        error("block 2", "block 3"),
        error("nodes 3 2", "nodes 3 4"),
        error("j_min patch", "j_max patch"),
        error("patch hole", "patch"),
        error("patch hole", "patch ho%2le"),
        error("to 2", "to 0"),
        error("to 2", "to 3"),
        error("same", "some"),
        error("shift 0.0", "shift zero"),
        error("shift 0.0", "shift nan"),
        error("shift 0.0", "shift 1.0"),
        error("patch hole", "patch hole in one"),
    ];
    insta::assert_snapshot!(errors.join("\n"));
}
