//! Reading: node counts first, then the length of the file tells planar from spatial, then the nodes.

use super::UNKNOWN_SIDE;
use crate::blocks::{Connection, StructuredBlock, StructuredBlocks};
use crate::error::{ReadError, ReadProblem};
use crate::numbers::{Encoding, Numbers};

/// The blocks of a file, every side a patch called [`UNKNOWN_SIDE`]. O(file).
///
/// # Errors
/// A file whose length does not fit its node counts, a block of more than one layer of nodes, and numbers that are none or not
/// finite, with their line (ASCII) or byte (binary).
pub fn parse(bytes: &[u8], encoding: Encoding) -> Result<StructuredBlocks, ReadError> {
    let file = Numbers::new(bytes, encoding);
    let found = file.length();
    let heads = [
        Head::read(file.clone(), Space::Plane),
        Head::read(file, Space::Solid),
    ];
    let readable = || heads.iter().flatten().filter(|head| head.length() == found);
    // Taken for planar, a file in space of more than one block has a block of one node across.
    let head = readable()
        .find(|head| !head.has_thin_blocks())
        .or(readable().next());
    if let Some(head) = head {
        return head.clone().read_blocks();
    }
    let [plane, solid] = heads.map(|head| head.map(|head| head.length()));
    // A file that has no head in the plane has none in space either.
    let expected = match (plane?, solid) {
        (plane, Ok(solid)) => format!(
            "{plane} {unit} in the plane or {solid} in space",
            unit = unit(encoding)
        ),
        (plane, Err(_)) => format!("{plane} {unit}", unit = unit(encoding)),
    };
    let problem = ReadProblem::Expected {
        expected,
        found: format!("{found} in the whole file"),
    };
    Err(problem.into())
}

const fn unit(encoding: Encoding) -> &'static str {
    match encoding {
        Encoding::Ascii => "numbers",
        Encoding::Binary => "bytes",
    }
}

/// How many counts and coordinates there are.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Space {
    Plane,
    Solid,
}

/// The node counts of every block, and the file behind them.
#[derive(Clone)]
struct Head<'a> {
    file: Numbers<'a>,
    space: Space,
    /// Nodes along `i`, `j` and `k`.
    counts: Vec<[u32; 3]>,
}

impl<'a> Head<'a> {
    fn read(mut file: Numbers<'a>, space: Space) -> Result<Self, ReadError> {
        let blocks = read_count(&mut file, format_args!("the number of blocks"))?;
        let mut counts = Vec::with_capacity(file.room_for(blocks.into(), 4));
        for block in 0..blocks {
            let ni = read_count(&mut file, format_args!("ni of block {block}"))?;
            let nj = read_count(&mut file, format_args!("nj of block {block}"))?;
            let nk = match space {
                Space::Plane => 1,
                Space::Solid => read_count(&mut file, format_args!("nk of block {block}"))?,
            };
            counts.push([ni, nj, nk]);
        }
        Ok(Self {
            file,
            space,
            counts,
        })
    }

    /// Length of a file of these blocks, in the unit of [`Numbers::length`].
    fn length(&self) -> u128 {
        let (per_count, per_coordinate) = match self.file.encoding {
            Encoding::Ascii => (1, 1),
            Encoding::Binary => (4, 8),
        };
        let dimensions = match self.space {
            Space::Plane => 2,
            Space::Solid => 3,
        };
        let nodes: u128 = self
            .counts
            .iter()
            .map(|counts| counts.map(u128::from).iter().product::<u128>())
            .sum();
        per_count * (1 + dimensions * self.counts.len() as u128)
            + per_coordinate * dimensions * nodes
    }

    fn has_thin_blocks(&self) -> bool {
        self.counts.iter().any(|&[ni, nj, _]| ni < 2 || nj < 2)
    }

    /// Reads the nodes, of which the file holds as many as the counts say.
    fn read_blocks(mut self) -> Result<StructuredBlocks, ReadError> {
        let counts = std::mem::take(&mut self.counts);
        let blocks = counts
            .into_iter()
            .enumerate()
            .map(|(block, counts)| self.read_block(block, counts));
        let blocks = StructuredBlocks {
            blocks: blocks.collect::<Result<_, _>>()?,
        };
        blocks.check()?;
        Ok(blocks)
    }

    fn read_block(
        &mut self,
        block: usize,
        [ni, nj, nk]: [u32; 3],
    ) -> Result<StructuredBlock, ReadError> {
        if nk != 1 {
            let problem =
                ReadProblem::Unsupported(format!("block {block} of {nk} layers of nodes"));
            return Err(self.file.problem(self.file.at(), problem));
        }
        let (ni, nj) = (ni as usize, nj as usize);
        let mut points = vec![[0.0; 3]; ni * nj];
        for (axis, name) in [(0, 'x'), (1, 'y'), (2, 'z')] {
            if axis == 2 && self.space == Space::Plane {
                break;
            }
            for (node, point) in points.iter_mut().enumerate() {
                point[axis] =
                    self.read_coordinate(format_args!("{name} of node {node} of block {block}"))?;
            }
        }
        let sides = std::array::from_fn(|_| Connection::Patch(UNKNOWN_SIDE.into()));
        Ok(StructuredBlock {
            name: format!("block {block}"),
            ni,
            nj,
            points,
            sides,
        })
    }

    fn read_coordinate(&mut self, expected: std::fmt::Arguments<'_>) -> Result<f64, ReadError> {
        let start = self.file.at();
        let value = self.file.real(expected)?;
        if value.is_finite() {
            return Ok(value);
        }
        // The blanks before a number may hold ends of lines.
        let place = if self.file.encoding == Encoding::Ascii {
            self.file.at()
        } else {
            start
        };
        let expected = format!("a finite {expected}");
        Err(self.file.problem(
            place,
            ReadProblem::Expected {
                expected,
                found: value.to_string(),
            },
        ))
    }
}

fn read_count(file: &mut Numbers<'_>, expected: std::fmt::Arguments<'_>) -> Result<u32, ReadError> {
    file.skip_blanks_in_text();
    let start = file.at();
    let count = file.int(expected)?;
    u32::try_from(count).map_err(|_| {
        file.problem(
            start,
            ReadProblem::Expected {
                expected: expected.to_string(),
                found: count.to_string(),
            },
        )
    })
}
