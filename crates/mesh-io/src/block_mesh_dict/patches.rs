//! Boundary patches: walls by name, and pairs of cyclic patches by shift.

use std::collections::{BTreeMap, BTreeSet};

use super::unsupported::unsupported;
use super::vertices::{Turn, Vertices};
use crate::blocks::{BlockSide, Connection, StructuredBlocks};
use crate::error::WriteError;

/// Name of the patch of all faces in front and at the back.
pub(super) const FRONT_AND_BACK: &str = "frontAndBack";

/// A patch and its faces, each by the two vertices at the back, counterclockwise round the block.
pub(super) struct Patch {
    pub(super) name: String,
    pub(super) kind: PatchKind,
    pub(super) faces: Vec<[usize; 2]>,
}

pub(super) enum PatchKind {
    Wall,
    /// The patch that `shift`, added to this one, leads to.
    Cyclic {
        neighbour: String,
        shift: [f64; 3],
    },
}

/// The walls in the order in which their names first appear, then the cyclic patches, low and high of every pair.
///
/// # Errors
/// A shift out of the plane.
pub(super) fn patches(
    blocks: &StructuredBlocks,
    vertices: &Vertices,
    turns: &[Turn],
) -> Result<Vec<Patch>, WriteError> {
    let face = |block: usize, side: BlockSide| {
        let [from, to] = vertices.ends(block, side);
        let forward = matches!(side, BlockSide::JMin | BlockSide::IMax);
        if forward == (turns[block] == Turn::Counterclockwise) {
            [from, to]
        } else {
            [to, from]
        }
    };
    let (mut walls, mut cyclic) = (Groups::default(), Groups::default());
    for (index, block) in blocks.blocks.iter().enumerate() {
        for side in BlockSide::ALL {
            match block.connection(side) {
                Connection::Patch(name) => walls.at(name.clone()).push(face(index, side)),
                Connection::Block {
                    shift: [0.0, 0.0, 0.0],
                    ..
                } => {}
                &Connection::Block {
                    shift: [_, _, z], ..
                } if z != 0.0 => {
                    return Err(unsupported(format!(
                        "block {index}, whose side {side} is shifted along z"
                    )));
                }
                &Connection::Block {
                    block: other,
                    side: there,
                    shift,
                    ..
                } if is_upward(shift) => {
                    cyclic
                        .at(shift.map(bits))
                        .push((shift, face(index, side), face(other, there)));
                }
                Connection::Block { .. } => {}
            }
        }
    }
    let mut patches = named_walls(walls);
    for (number, (_, sides)) in (1..).zip(cyclic.in_order()) {
        patches.extend(pair(number, &sides));
    }
    Ok(patches)
}

/// Whether a shift is the one of the two directions by which its pair is known.
fn is_upward(shift: [f64; 3]) -> bool {
    shift
        .into_iter()
        .find(|&along| along != 0.0)
        .is_some_and(|along| along > 0.0)
}

/// The bits of a number, with one zero only.
fn bits(value: f64) -> u64 {
    (value + 0.0).to_bits()
}

fn pair(number: usize, sides: &[([f64; 3], [usize; 2], [usize; 2])]) -> [Patch; 2] {
    let [low, high] = ["low", "high"].map(|end| format!("periodic{number}_{end}"));
    let shift = sides.first().map_or([0.0; 3], |&(shift, ..)| shift);
    let kind = |neighbour: &String, shift| PatchKind::Cyclic {
        neighbour: neighbour.clone(),
        shift,
    };
    let faces_low = sides.iter().map(|&(_, face, _)| face).collect();
    let faces_high = sides.iter().map(|&(_, _, face)| face).collect();
    [
        Patch {
            kind: kind(&high, shift),
            name: low.clone(),
            faces: faces_low,
        },
        Patch {
            kind: kind(&low, shift.map(|along| 0.0 - along)),
            name: high,
            faces: faces_high,
        },
    ]
}

fn named_walls(walls: Groups<String, [usize; 2]>) -> Vec<Patch> {
    let mut taken = BTreeSet::from([FRONT_AND_BACK.to_owned()]);
    // The number to try next for every word: very many names may become the same one.
    let mut next_number = BTreeMap::<String, usize>::new();
    let mut patches = Vec::new();
    for (name, faces) in walls.in_order() {
        let word = word(&name);
        let number = next_number.entry(word.clone()).or_insert(2);
        let mut name = word.clone();
        while taken.contains(&name) || name.starts_with("periodic") {
            name = format!("wall_{word}_{number}");
            *number += 1;
        }
        taken.insert(name.clone());
        patches.push(Patch {
            name,
            kind: PatchKind::Wall,
            faces,
        });
    }
    patches
}

/// A name as a word that `OpenFOAM` accepts: letters, digits and `_`, and a letter first.
fn word(name: &str) -> String {
    let word: String = name
        .chars()
        .map(|c| if c.is_ascii_alphanumeric() { c } else { '_' })
        .collect();
    if word.starts_with(|first: char| first.is_ascii_alphabetic()) {
        word
    } else {
        format!("wall_{word}")
    }
}

/// Lists by key, in the order in which the keys first appeared.
struct Groups<K, V> {
    position: BTreeMap<K, usize>,
    groups: Vec<(K, Vec<V>)>,
}

impl<K, V> Default for Groups<K, V> {
    fn default() -> Self {
        Self {
            position: BTreeMap::new(),
            groups: Vec::new(),
        }
    }
}

impl<K: Ord + Clone, V> Groups<K, V> {
    fn at(&mut self, key: K) -> &mut Vec<V> {
        let position = *self
            .position
            .entry(key.clone())
            .or_insert(self.groups.len());
        if position == self.groups.len() {
            self.groups.push((key, Vec::new()));
        }
        &mut self.groups[position].1
    }

    fn in_order(self) -> impl Iterator<Item = (K, Vec<V>)> {
        self.groups.into_iter()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_become_words_and_stay_apart() {
        assert_eq!(word("particle 3"), "particle_3");
        assert_eq!(
            (word("3"), word(""), word("a;{}")),
            ("wall_3".into(), "wall_".into(), "a___".into())
        );
        let mut walls = Groups::default();
        for name in ["a b", "a_b", "a-b", "frontAndBack", "periodic1_low"] {
            walls.at(name.to_owned()).push([0, 1]);
        }
        let names: Vec<String> = named_walls(walls)
            .into_iter()
            .map(|patch| patch.name)
            .collect();
        assert_eq!(
            names,
            [
                "a_b",
                "wall_a_b_2",
                "wall_a_b_3",
                "wall_frontAndBack_2",
                "wall_periodic1_low_2"
            ]
        );
    }

    #[test]
    fn very_many_names_of_one_word_take_no_more_than_linear_time() {
        let mut walls = Groups::default();
        for letter in ('\u{4e00}'..).take(20_000) {
            walls.at(letter.to_string()).push([0, 1]);
        }
        let start = std::time::Instant::now();
        let names: BTreeSet<_> = named_walls(walls)
            .into_iter()
            .map(|patch| patch.name)
            .collect();
        assert_eq!(names.len(), 20_000);
        assert!(start.elapsed().as_secs() < 10);
    }
}
