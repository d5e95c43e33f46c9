//! Block letters as polygons with whole coordinates, drawn by hand on a field five wide and seven high.

use glam::{DVec2, dvec2};

/// A closed polygon, outer or of a hole.
pub type Ring = &'static [[i8; 2]];

/// A letter and its rings, the outer ones first.
pub struct Letter {
    /// Which letter.
    pub name: char,
    /// Closed polygons; what an odd number of them surrounds is ink.
    pub rings: &'static [Ring],
}

/// The letters that there are.
pub const LETTERS: [Letter; 16] = [
    letter(
        'A',
        &[
            &[
                [0, 0],
                [1, 0],
                [1, 2],
                [4, 2],
                [4, 0],
                [5, 0],
                [5, 5],
                [3, 7],
                [2, 7],
                [0, 5],
            ],
            &[[1, 3], [4, 3], [4, 4], [3, 6], [2, 6], [1, 4]],
        ],
    ),
    letter(
        'B',
        &[
            &[
                [0, 0],
                [4, 0],
                [5, 1],
                [5, 3],
                [4, 4],
                [5, 5],
                [5, 6],
                [4, 7],
                [0, 7],
            ],
            &[[1, 1], [4, 1], [4, 3], [1, 3]],
            &[[1, 5], [4, 5], [4, 6], [1, 6]],
        ],
    ),
    letter(
        'C',
        &[&[
            [1, 0],
            [5, 0],
            [5, 1],
            [1, 1],
            [1, 6],
            [5, 6],
            [5, 7],
            [1, 7],
            [0, 6],
            [0, 1],
        ]],
    ),
    letter(
        'D',
        &[
            &[[0, 0], [3, 0], [5, 2], [5, 5], [3, 7], [0, 7]],
            &[[1, 1], [3, 1], [4, 2], [4, 5], [3, 6], [1, 6]],
        ],
    ),
    letter(
        'E',
        &[&[
            [0, 0],
            [5, 0],
            [5, 1],
            [1, 1],
            [1, 3],
            [4, 3],
            [4, 4],
            [1, 4],
            [1, 6],
            [5, 6],
            [5, 7],
            [0, 7],
        ]],
    ),
    letter(
        'H',
        &[&[
            [0, 0],
            [1, 0],
            [1, 3],
            [4, 3],
            [4, 0],
            [5, 0],
            [5, 7],
            [4, 7],
            [4, 4],
            [1, 4],
            [1, 7],
            [0, 7],
        ]],
    ),
    letter(
        'I',
        &[
            &[[2, 0], [3, 0], [3, 5], [2, 5]],
            &[[2, 6], [3, 6], [3, 7], [2, 7]],
        ],
    ),
    letter(
        'M',
        &[&[
            [0, 0],
            [1, 0],
            [1, 5],
            [2, 3],
            [3, 3],
            [4, 5],
            [4, 0],
            [5, 0],
            [5, 7],
            [4, 7],
            [3, 5],
            [2, 5],
            [1, 7],
            [0, 7],
        ]],
    ),
    letter(
        'O',
        &[
            &[
                [0, 1],
                [1, 0],
                [4, 0],
                [5, 1],
                [5, 6],
                [4, 7],
                [1, 7],
                [0, 6],
            ],
            &[[1, 1], [4, 1], [4, 6], [1, 6]],
        ],
    ),
    letter(
        'P',
        &[
            &[[0, 0], [1, 0], [1, 3], [5, 3], [5, 7], [0, 7]],
            &[[1, 4], [4, 4], [4, 6], [1, 6]],
        ],
    ),
    letter(
        'R',
        &[
            &[
                [0, 0],
                [1, 0],
                [1, 3],
                [2, 3],
                [4, 0],
                [5, 0],
                [3, 3],
                [5, 4],
                [5, 7],
                [0, 7],
            ],
            &[[1, 4], [4, 4], [4, 6], [1, 6]],
        ],
    ),
    letter(
        'S',
        &[&[
            [0, 0],
            [5, 0],
            [5, 4],
            [1, 4],
            [1, 6],
            [5, 6],
            [5, 7],
            [0, 7],
            [0, 3],
            [4, 3],
            [4, 1],
            [0, 1],
        ]],
    ),
    letter(
        'T',
        &[&[
            [2, 0],
            [3, 0],
            [3, 6],
            [5, 6],
            [5, 7],
            [0, 7],
            [0, 6],
            [2, 6],
        ]],
    ),
    letter(
        'V',
        &[&[
            [2, 0],
            [3, 0],
            [5, 7],
            [4, 7],
            [3, 3],
            [2, 3],
            [1, 7],
            [0, 7],
        ]],
    ),
    letter(
        'X',
        &[&[
            [0, 0],
            [1, 0],
            [2, 3],
            [3, 3],
            [4, 0],
            [5, 0],
            [3, 4],
            [5, 7],
            [4, 7],
            [3, 5],
            [2, 5],
            [1, 7],
            [0, 7],
            [2, 4],
        ]],
    ),
    letter(
        '8',
        &[
            &[[0, 0], [5, 0], [5, 7], [0, 7]],
            &[[1, 1], [4, 1], [4, 3], [1, 3]],
            &[[1, 4], [4, 4], [4, 6], [1, 6]],
            &[[2, 2], [3, 2], [2, 3]],
        ],
    ),
];

const fn letter(name: char, rings: &'static [Ring]) -> Letter {
    Letter { name, rings }
}

impl Letter {
    /// The rings, with the field's least corner at the `column`-th place of a line; letters are one apart.
    pub fn at(&self, column: usize) -> impl Iterator<Item = Vec<DVec2>> + '_ {
        const ADVANCE: f64 = 6.0;
        let offset = dvec2(ADVANCE * column as f64, 0.0);
        self.rings.iter().map(move |ring| {
            let corner = |&[x, y]: &[i8; 2]| dvec2(f64::from(x), f64::from(y)) + offset;
            ring.iter().map(corner).collect()
        })
    }
}
