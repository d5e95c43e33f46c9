//! Convex polyhedra: the windows that Voronoi cells are clipped to, and the clipped cells.
//!
//! Every corner is the end of three edges and lies on three faces. Where more faces meet, several corners
//! share the place, joined by edges without length; so the surface is one graph of three edges per
//! corner, whatever the input, and [clipping](super::clip) is surgery on it.
//!
//! ```text
//!      f2  |  f1         corner with the faces [f0, f1, f2], counterclockwise seen from outside;
//!        0 |             edge i leaves between the faces i + 1 and i + 2 (modulo 3)
//!          *
//!      1 /   \ 2         counterclockwise round f0: in by edge 2, out by edge 1
//!       /  f0  \
//! ```

use super::face_plane::FacePlane;
use super::half_space::HalfSpace;
use crate::ids::VertexId;
use geo_predicates::{Axis, CoordinateError, check_points3};
use glam::DVec3;
use thiserror::Error;

/// A convex polyhedron, possibly empty.
///
/// ```
/// use delaunay_core::{ConvexPolyhedron, HalfSpace, Side};
/// use glam::DVec3;
///
/// let mut cube = ConvexPolyhedron::cuboid(DVec3::ZERO, DVec3::ONE)?;
/// cube.clip(&HalfSpace::new(DVec3::ONE, 1.0)?, Side::Window(6));
/// assert!((cube.volume() - 1.0 / 6.0).abs() < 1e-15);
/// let slanted = cube.faces().find(|face| face.side() == Side::Window(6)).unwrap();
/// assert!((slanted.area() - 0.75_f64.sqrt()).abs() < 1e-15);
/// assert_eq!(slanted.corners().count(), 3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ConvexPolyhedron {
    /// Corners and planes are relative to it.
    pub(super) origin: DVec3,
    pub(super) corners: Vec<Corner>,
    pub(super) faces: Vec<Face>,
}

/// What a face of a polyhedron comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Side {
    /// A side of the window, by number.
    Window(u32),
    /// The bisector between the vertex of the cell and this one, its Delaunay neighbour; in a cell cut out of a window
    /// that is a Voronoi cell itself, also a face of that window.
    Neighbor(VertexId),
}

/// Why corners do not bound a polyhedron.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum PolyhedronError {
    /// A coordinate is not accepted: of the low corner (index 0) or the high one (index 1).
    #[error(transparent)]
    Coordinate(#[from] CoordinateError),
    /// The two corners leave no room between them.
    #[error("the low corner is not below the high one along {axis}: {low:e} and {high:e}")]
    NotBelow {
        /// Along which axis.
        axis: Axis,
        /// Coordinate of the low corner.
        low: f64,
        /// Coordinate of the high corner.
        high: f64,
    },
}

/// Where three faces meet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Corner {
    pub(super) place: DVec3,
    /// Bound on the error of each coordinate.
    pub(super) blur: f64,
    /// Counterclockwise seen from outside.
    pub(super) faces: [u32; 3],
    /// The other ends of the edges.
    pub(super) twins: [End; 3],
}

/// One end of an edge: end `4 c + i` is edge `i` of corner `c`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct End(u32);

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Face {
    pub(super) plane: FacePlane,
    pub(super) side: Side,
    /// A corner of the face; [`Face::LOST`] when it has none left.
    pub(super) corner: u32,
}

impl Face {
    pub(super) const LOST: u32 = u32::MAX;
}

impl End {
    #[inline]
    pub(super) fn new(corner: usize, edge: usize) -> Self {
        debug_assert!(corner < 1 << 30 && edge < 3);
        Self(4 * corner as u32 + edge as u32)
    }

    #[inline]
    pub(super) fn corner(self) -> usize {
        (self.0 / 4) as usize
    }

    #[inline]
    pub(super) fn edge(self) -> usize {
        (self.0 % 4) as usize
    }

    /// The next edge of the same corner, counterclockwise seen from outside.
    #[inline]
    pub(super) fn next(self) -> Self {
        Self(if self.0 % 4 == 2 {
            self.0 - 2
        } else {
            self.0 + 1
        })
    }

    /// The edge before, of the same corner.
    #[inline]
    pub(super) fn prev(self) -> Self {
        Self(if self.0.is_multiple_of(4) {
            self.0 + 2
        } else {
            self.0 - 1
        })
    }
}

impl ConvexPolyhedron {
    /// The axis-parallel box between two opposite corners.
    ///
    /// Its faces are [`Side::Window`] 0 and 1 across the x axis, low before high, 2 and 3 across y, 4
    /// and 5 across z.
    ///
    /// # Errors
    /// [`PolyhedronError`] when a coordinate is not accepted or `low` is not strictly below `high` along
    /// every axis.
    pub fn cuboid(low: DVec3, high: DVec3) -> Result<Self, PolyhedronError> {
        check_points3(&[low, high])?;
        for (i, axis) in [Axis::X, Axis::Y, Axis::Z].into_iter().enumerate() {
            let (low, high) = (low[i], high[i]);
            if low >= high {
                return Err(PolyhedronError::NotBelow { axis, low, high });
            }
        }
        Ok(Self {
            origin: DVec3::ZERO,
            corners: (0..8).map(|bits| cuboid_corner(bits, low, high)).collect(),
            faces: (0..6).map(|face| cuboid_face(face, low, high)).collect(),
        })
    }

    /// Whether nothing is left of it.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.corners.is_empty()
    }

    /// The corners, in no order; where more than three faces meet, the place comes several times.
    #[must_use]
    pub fn corners(&self) -> impl ExactSizeIterator<Item = DVec3> + Clone + '_ {
        self.corners.iter().map(|corner| self.origin + corner.place)
    }

    /// Whether `p` is inside or on the border, up to rounding.
    #[must_use]
    pub fn contains(&self, p: DVec3) -> bool {
        let mut faces = self.faces.iter().filter(|face| face.corner != Face::LOST);
        !self.is_empty() && faces.all(|face| face.plane.height(p - self.origin) <= 0.0)
    }

    /// Becomes `window` in coordinates relative to `origin`, in the room that it has.
    pub(super) fn assign(&mut self, window: &Self, origin: DVec3) {
        let offset = origin - window.origin;
        self.origin = origin;
        self.corners.clone_from(&window.corners);
        self.faces.clone_from(&window.faces);
        for face in &mut self.faces {
            face.plane = face.plane.seen_from(origin);
        }
        for corner in &mut self.corners {
            corner.place -= offset;
            if corner.blur > 0.0 {
                // Known less well than it may be here.
                let planes = corner.faces.map(|face| &self.faces[face as usize].plane);
                let reach = corner.place.abs().max_element();
                (corner.place, corner.blur) = FacePlane::meet(planes, origin, reach);
            } else if offset != DVec3::ZERO {
                // Of the offset and of the difference.
                let sizes = offset.abs().max_element() + corner.place.abs().max_element();
                corner.blur = f64::EPSILON * sizes;
            }
        }
    }

    /// Becomes empty and keeps its room.
    pub(super) fn clear(&mut self) {
        self.corners.clear();
        self.faces.clear();
    }

    #[inline]
    pub(super) fn twin(&self, end: End) -> End {
        self.corners[end.corner()].twins[end.edge()]
    }

    /// The ends by which the border of a face leaves its corners, counterclockwise seen from outside.
    pub(super) fn border(&self, number: u32) -> impl Iterator<Item = End> + Clone + '_ {
        let corner = self.faces[number as usize].corner as usize;
        let corners = self.corners.get(corner).map(|corner| corner.faces);
        let position = corners.and_then(|faces| faces.into_iter().position(|f| f == number));
        let start = position.map(|position| End::new(corner, position).next());
        // In by the edge after the next one round the corner, out by the next.
        std::iter::successors(start, move |&end| {
            Some(self.twin(end).prev()).filter(|&next| Some(next) != start)
        })
    }
}

/// Corner `bits` of a box: bit `i` tells whether it is high along axis `i`.
fn cuboid_corner(bits: usize, low: DVec3, high: DVec3) -> Corner {
    let is_high = |axis: usize| bits >> axis & 1 == 1;
    let place = [0, 1, 2].map(|axis| if is_high(axis) { high[axis] } else { low[axis] });
    // Each edge runs along the axis of the face that it leaves, to a corner of the other sense.
    let axes = cuboid_axes(bits);
    let along = |axis: usize| {
        let other = bits ^ (1 << axis);
        End::new(other, cuboid_axes(other)[axis])
    };
    Corner {
        place: DVec3::from(place),
        blur: 0.0,
        faces: axes.map(|axis| 2 * axis as u32 + u32::from(is_high(axis))),
        twins: axes.map(along),
    }
}

/// The axes of the three faces at a corner, counterclockwise seen from outside; as a permutation it is its
/// own inverse.
fn cuboid_axes(bits: usize) -> [usize; 3] {
    match bits.count_ones() % 2 {
        1 => [0, 1, 2],
        _ => [1, 0, 2],
    }
}

fn cuboid_face(number: usize, low: DVec3, high: DVec3) -> Face {
    let axis = number / 2;
    let (sign, bound) = match number % 2 {
        0 => (-1.0, low[axis]),
        _ => (1.0, high[axis]),
    };
    let half_space = HalfSpace {
        normal: DVec3::AXES[axis] * sign,
        limit: bound * sign,
    };
    Face {
        plane: FacePlane::of(&half_space, DVec3::ZERO),
        side: Side::Window(number as u32),
        // The corner that is high along this axis alone, or low.
        corner: (number % 2) as u32 * (1 << axis),
    }
}
