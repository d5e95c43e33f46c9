//! Places on a Hilbert curve through a square or cubic grid: cells that follow each other on the curve share a side.

mod lanes;
mod table;

pub(crate) use lanes::{MAX_BITS_IN_PLANE, places_in_plane};
pub(crate) use table::SPACE;
