//! What lies behind the sides of structured blocks, as a text beside a format that has no place for it: `NAME.map` beside `NAME.p3d` or
//! `NAME.p3b`.
//!
//! ```text
//! # A ring of two blocks round a hole, in a periodic box one unit wide.
//! connectivity 1
//! blocks 2
//! block 1 nodes 17 9 name upper%20half
//! i_min to 2 i_max same shift 0.0 0.0 0.0
//! i_max to 2 i_min same shift 1.0 0.0 0.0
//! j_min patch hole
//! j_max to 2 j_max reversed shift 0.0 0.0 0.0
//! block 2 nodes 17 9 name lower%20half
//! ...
//! ```
//!
//! One statement a line, words between blanks, `#` starts a comment:
//!
//! ```text
//! file  = "connectivity" "1" newline "blocks" COUNT newline { block }
//! block = "block" NUMBER "nodes" NI NJ "name" NAME newline side side side side
//! side  = SIDE ( "patch" NAME | "to" NUMBER SIDE ( "same" | "reversed" ) "shift" X Y Z ) newline
//! SIDE  = "i_min" | "i_max" | "j_min" | "j_max", in this order
//! ```
//!
//! Blocks are counted from 1, as Plot3D tools do, and come in the order of the grid file. `same` and `reversed` say whether `i` or `j` grows in
//! the same direction along both sides; `shift` is what to add to the nodes of this side to reach those of the other, 0 or a period. A
//! NAME is a word: blanks, control characters, `#` and `%` are written as `%` and two hexadecimal digits for every byte of their
//! UTF-8 form, and the empty name as `-` (so `-` itself as `%2D`).

use std::fmt::Write as _;
use std::io::Write;
use std::path::{Path, PathBuf};

use crate::blocks::{BlockSide, Connection, StructuredBlock, StructuredBlocks};
use crate::error::{ReadError, ReadProblem, WriteError};
use crate::lines::{Line, Lines};

/// Path of the map that belongs to a grid file: the same with the extension `.map`.
#[must_use]
pub fn path_beside(grid: &Path) -> PathBuf {
    grid.with_extension("map")
}

/// Writes names and connections of blocks. O(blocks).
///
/// # Errors
/// Blocks that contradict each other, and what `out` refuses.
pub fn write(out: &mut impl Write, blocks: &StructuredBlocks) -> Result<(), WriteError> {
    blocks.check()?;
    writeln!(
        out,
        "# What lies behind the sides of structured blocks, counted from 1."
    )?;
    writeln!(out, "connectivity 1\nblocks {}", blocks.blocks.len())?;
    for (number, block) in (1..).zip(&blocks.blocks) {
        let StructuredBlock { ni, nj, name, .. } = block;
        writeln!(out, "block {number} nodes {ni} {nj} name {}", encoded(name))?;
        for side in BlockSide::ALL {
            match block.connection(side) {
                Connection::Patch(name) => writeln!(out, "{side} patch {}", encoded(name))?,
                Connection::Block {
                    block,
                    side: other,
                    reversed,
                    shift: [x, y, z],
                } => {
                    let direction = if *reversed { "reversed" } else { "same" };
                    writeln!(
                        out,
                        "{side} to {} {other} {direction} shift {x:?} {y:?} {z:?}",
                        block + 1
                    )?;
                }
            }
        }
    }
    Ok(())
}

/// The grids with the names and connections of a map. O(map + grids).
///
/// # Errors
/// What is no map, and a map that contradicts itself or has other blocks than the grids, with its line.
pub fn parse(bytes: &[u8], mut grids: StructuredBlocks) -> Result<StructuredBlocks, ReadError> {
    let mut lines = Lines::new(bytes)?;
    let mut head = lines.due(format_args!("`connectivity 1`"))?;
    keyword(&mut head, "connectivity")?;
    keyword(&mut head, "1")?;
    let mut head = lines.due(format_args!("the number of blocks"))?;
    keyword(&mut head, "blocks")?;
    let claimed: u64 = head.number(format_args!("the number of blocks"))?;
    let found = grids.blocks.len() as u64;
    if claimed != found {
        return Err(head.problem(ReadProblem::Count {
            what: "blocks in map and grid file".into(),
            claimed,
            found,
        }));
    }
    for (number, block) in (1..).zip(&mut grids.blocks) {
        read_block(&mut lines, number, block)?;
    }
    lines.end()?;
    grids.check()?;
    Ok(grids)
}

fn read_block(
    lines: &mut Lines<'_>,
    number: usize,
    block: &mut StructuredBlock,
) -> Result<(), ReadError> {
    let mut line = lines.due(format_args!("block {number}"))?;
    keyword(&mut line, "block")?;
    keyword(&mut line, &number.to_string())?;
    keyword(&mut line, "nodes")?;
    keyword(&mut line, &block.ni.to_string())?;
    keyword(&mut line, &block.nj.to_string())?;
    keyword(&mut line, "name")?;
    block.name = read_name(&mut line)?;
    line.end(format_args!("the name of block {number}"))?;
    for (side, connection) in BlockSide::ALL.into_iter().zip(&mut block.sides) {
        let mut line = lines.due(format_args!("side {side} of block {number}"))?;
        keyword(&mut line, side.name())?;
        *connection = read_connection(&mut line)?;
        line.end(format_args!("side {side} of block {number}"))?;
    }
    Ok(())
}

fn read_connection(line: &mut Line<'_>) -> Result<Connection, ReadError> {
    match one_of(line, &["patch", "to"])? {
        0 => Ok(Connection::Patch(read_name(line)?)),
        _ => {
            let number: usize = line.number(format_args!("the number of a block"))?;
            let Some(block) = number.checked_sub(1) else {
                return Err(line.unexpected(format_args!("the number of a block, from 1"), "0"));
            };
            let side = BlockSide::ALL[one_of(line, &BlockSide::ALL.map(BlockSide::name))?];
            let reversed = one_of(line, &["same", "reversed"])? == 1;
            keyword(line, "shift")?;
            let mut shift = [0.0; 3];
            for (along, axis) in shift.iter_mut().zip(crate::mesh::Axis::ALL) {
                *along = line.number(format_args!("the shift along {axis}"))?;
            }
            Ok(Connection::Block {
                block,
                side,
                reversed,
                shift,
            })
        }
    }
}

fn keyword(line: &mut Line<'_>, word: &str) -> Result<(), ReadError> {
    one_of(line, &[word]).map(|_| ())
}

/// Which of some words comes next.
fn one_of(line: &mut Line<'_>, words: &[&str]) -> Result<usize, ReadError> {
    let found = line.word().unwrap_or("the end of the line");
    words.iter().position(|&word| word == found).ok_or_else(|| {
        let words: Vec<String> = words.iter().map(|word| format!("`{word}`")).collect();
        line.unexpected(format_args!("{}", words.join(" or ")), found)
    })
}

fn read_name(line: &mut Line<'_>) -> Result<String, ReadError> {
    let Some(found) = line.word() else {
        return Err(line.unexpected(format_args!("a name"), "the end of the line"));
    };
    decoded(found).ok_or_else(|| line.unexpected(format_args!("a name"), found))
}

/// A name as a word.
fn encoded(name: &str) -> String {
    let mut word = String::new();
    for character in name.chars() {
        if character.is_whitespace() || character.is_control() || matches!(character, '#' | '%') {
            for byte in character.to_string().bytes() {
                // Writing to a string cannot fail.
                let _ = write!(word, "%{byte:02X}");
            }
        } else {
            word.push(character);
        }
    }
    match word.as_str() {
        "" => "-".into(),
        "-" => "%2D".into(),
        _ => word,
    }
}

/// The name of a word; `None` for half an escape, or bytes that are not UTF-8.
fn decoded(word: &str) -> Option<String> {
    if word == "-" {
        return Some(String::new());
    }
    let mut pieces = word.split('%');
    let mut bytes = pieces.next()?.as_bytes().to_vec();
    for piece in pieces {
        let (digits, rest) = piece.split_at_checked(2)?;
        let digit = |k: usize| digits.chars().nth(k).and_then(|digit| digit.to_digit(16));
        bytes.push(u8::try_from(digit(0)? * 16 + digit(1)?).ok()?);
        bytes.extend_from_slice(rest.as_bytes());
    }
    String::from_utf8(bytes).ok()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn every_name_is_a_word_and_comes_back(name in any::<String>()) {
            let word = encoded(&name);
            prop_assert_eq!(word.split_whitespace().collect::<Vec<_>>(), [word.as_str()]);
            prop_assert!(!word.contains('#'));
            prop_assert_eq!(decoded(&word), Some(name));
        }

        #[test]
        fn no_word_panics(word in "[%0-9a-zä]{0,8}") {
            let _ = decoded(&word);
        }
    }
}
