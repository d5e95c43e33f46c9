//! Circular holes in a circle or in a periodic rectangle, as written in a `DOMAIN.toml`.

/// Circles that bound a domain of the plane. Nothing is judged but the form: radii may be negative and numbers NaN.
#[derive(Clone, Debug, PartialEq)]
pub struct CirclesDomain {
    /// What the holes lie in.
    pub frame: Frame,
    /// The circular holes, in the order of the file.
    pub holes: Vec<Hole>,
}

/// What the holes lie in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Frame {
    /// The inside of a circle.
    Circle {
        /// Its centre.
        centre: [f64; 2],
        /// Its radius.
        radius: f64,
    },
    /// The plane, repeated in `x` and `y`.
    Periodic {
        /// Width and height of what is repeated.
        period: [f64; 2],
    },
}

/// A circular hole.
#[derive(Clone, Debug, PartialEq)]
pub struct Hole {
    /// Its centre.
    pub centre: [f64; 2],
    /// Its radius.
    pub radius: f64,
    /// A word that holes of one sort share, where given.
    pub kind: Option<String>,
    /// Line of the file where the hole starts, from 1; `None` when it did not come from a file.
    pub line: Option<usize>,
}
