//! Files spoiled at random: what a reader must answer with an error or a mesh, but never with a panic.

use proptest::prelude::*;

/// One way to spoil a file. Positions are fractions of its length, in 65536ths.
#[derive(Clone, Debug)]
pub(crate) enum Spoil {
    Truncate(u16),
    Flip(u16, u8),
    Splice { from: u16, length: u8, to: u16 },
    Drop { from: u16, length: u8 },
    Insert(u16, &'static [u8]),
}

/// One to four ways at once.
pub(crate) fn spoils() -> impl Strategy<Value = Vec<Spoil>> {
    const TOKENS: &[&[u8]] = &[
        b" 999999999999 ",
        b" -1 ",
        b" nan ",
        b" 1e999 ",
        b"\n",
        b" 0 ",
        b" 4294967296 ",
        &[0xff; 8],
        &[0; 8],
        &[0, 0, 0, 0, 1, 0, 0, 0],
    ];
    let spoil =
        prop_oneof![
            any::<u16>().prop_map(Spoil::Truncate),
            (any::<u16>(), 0..8u8).prop_map(|(at, bit)| Spoil::Flip(at, bit)),
            (any::<u16>(), any::<u8>(), any::<u16>())
                .prop_map(|(from, length, to)| Spoil::Splice { from, length, to }),
            (any::<u16>(), any::<u8>()).prop_map(|(from, length)| Spoil::Drop { from, length }),
            (any::<u16>(), prop::sample::select(TOKENS))
                .prop_map(|(at, token)| Spoil::Insert(at, token)),
        ];
    prop::collection::vec(spoil, 1..4)
}

/// The file after all of them.
pub(crate) fn spoiled(file: &[u8], spoils: &[Spoil]) -> Vec<u8> {
    let mut file = file.to_vec();
    for spoil in spoils {
        let at = |position: u16| usize::from(position) * file.len() / 65536;
        let end = |from: usize, length: u8| (from + usize::from(length)).min(file.len());
        match *spoil {
            Spoil::Truncate(position) => file.truncate(at(position)),
            Spoil::Flip(position, bit) => {
                let index = at(position);
                if let Some(byte) = file.get_mut(index) {
                    *byte ^= 1 << bit;
                }
            }
            Spoil::Splice { from, length, to } => {
                let piece = file[at(from)..end(at(from), length)].to_vec();
                let to = at(to);
                file.splice(to..to, piece);
            }
            Spoil::Drop { from, length } => {
                let range = at(from)..end(at(from), length);
                file.drain(range);
            }
            Spoil::Insert(position, token) => {
                let at = at(position);
                file.splice(at..at, token.iter().copied());
            }
        }
    }
    file
}
