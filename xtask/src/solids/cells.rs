//! The surface of a set of unit cubes of a grid, with coplanar squares merged into polygons as large as they get.
//!
//! ```text
//!    ·───·───·───·         ·───────────·     An edge of the grid is a crease unless its two
//!    │   │   │   │         │           │     squares lie in one plane. A vertex stays unless it
//!    ·───·───·───·   ->    │   ·───·   │     has no creases, or two in line. Creases between
//!    │   │   │   │         │   │   │   │     such vertices are the segments of the polygons on
//!    ·───·   ·───·         ·───·   ·───·     both sides, so that these fit together.
//! ```
//!
//! In line, along a vertex that goes, the squares round the crease are the same on both sides of it: where one ended, the edge
//! across would be a crease.

use glam::{DVec2, DVec3};

use super::Random;
use super::flat::Drawing;
use super::skin::Skin;

/// A place of the grid: a cube by its least corner, or a vertex.
pub type Place = [i32; 3];

/// A set of cubes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cells {
    size: Place,
    is_filled: Vec<bool>,
}

/// How bodies touch in a set of cubes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Touch {
    /// Edges with four squares.
    pub edges: usize,
    /// Vertices where parts meet that share no edge there.
    pub vertices: usize,
}

/// Squares of the grid that look along one axis at one height.
struct Layer {
    axis: usize,
    height: i32,
}

impl Cells {
    /// No cubes in a grid of so many.
    #[must_use]
    pub fn new(size: Place) -> Self {
        let count = size.iter().map(|&count| count as usize).product();
        Self {
            size,
            is_filled: vec![false; count],
        }
    }

    /// How many cubes the grid has along each axis.
    #[must_use]
    pub fn size(&self) -> Place {
        self.size
    }

    /// Whether there is a cube; there is none outside of the grid.
    #[must_use]
    pub fn has(&self, cell: Place) -> bool {
        self.slot(cell).is_some_and(|slot| self.is_filled[slot])
    }

    /// Adds a cube or takes it away; outside of the grid nothing happens.
    pub fn set(&mut self, cell: Place, is_filled: bool) {
        if let Some(slot) = self.slot(cell) {
            self.is_filled[slot] = is_filled;
        }
    }

    /// Adds all cubes between two corners, or takes them away.
    pub fn set_box(&mut self, low: Place, high: Place, is_filled: bool) {
        for x in low[0]..high[0] {
            for y in low[1]..high[1] {
                for z in low[2]..high[2] {
                    self.set([x, y, z], is_filled);
                }
            }
        }
    }

    /// Whether there is no cube.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        !self.is_filled.contains(&true)
    }

    fn slot(&self, cell: Place) -> Option<usize> {
        let is_inside = (0..3).all(|axis| (0..self.size[axis]).contains(&cell[axis]));
        let [x, y, z] = cell.map(|count| count as usize);
        let [_, ny, nz] = self.size.map(|count| count as usize);
        is_inside.then(|| (x * ny + y) * nz + z)
    }

    /// How parts touch.
    #[must_use]
    pub fn touch(&self) -> Touch {
        let mut touch = Touch::default();
        for vertex in self.vertices() {
            let touching = (0..3)
                .filter(|&axis| self.is_touching(vertex, axis))
                .count();
            touch.edges += touching;
            let is_on_touching = touching > 0
                || (0..3).any(|axis| self.is_touching(shifted(vertex, axis, -1), axis));
            if !is_on_touching && !self.is_whole(vertex) {
                touch.vertices += 1;
            }
        }
        touch
    }

    /// The surface, every square in two triangles split at random.
    pub fn squares(&self, place: impl Fn(Place) -> DVec3, random: &mut Random) -> Skin {
        let mut skin = Skin::default();
        for layer in self.layers() {
            let [right, up] = layer.axes();
            for square in self.squares_of(&layer) {
                let mut corners = [
                    square,
                    shifted(square, right, 1),
                    shifted(shifted(square, right, 1), up, 1),
                    shifted(square, up, 1),
                ];
                if !self.faces_up(square) {
                    corners.reverse();
                }
                skin.quad(corners.map(&place), random);
            }
        }
        skin
    }

    /// The surface in merged polygons, triangulated badly.
    pub fn polygons(&self, place: impl Fn(Place) -> DVec3, random: &mut Random) -> Skin {
        let mut skin = Skin::default();
        for layer in self.layers() {
            let squares = self.squares_of(&layer);
            if squares.is_empty() {
                continue;
            }
            let square_at = |p: DVec2| layer.vertex(p.floor());
            let cap = self
                .drawing(&layer)
                .wherever(|p| self.is_square(square_at(p), layer.axis), random);
            for corners in cap.places() {
                let [a, b, c] = corners.map(|p| place(layer.vertex(p)));
                let centre = corners.iter().sum::<DVec2>() / 3.0;
                let faces_up = self.faces_up(square_at(centre));
                skin.triangle(if faces_up { [a, b, c] } else { [a, c, b] });
            }
        }
        skin
    }

    /// Creases and vertices of the squares of a layer.
    fn drawing(&self, layer: &Layer) -> Drawing {
        let mut drawing = Drawing::default();
        let axes = layer.axes();
        for along in axes {
            let across = axes[0] + axes[1] - along;
            for row in 0..=self.size[across] {
                let mut start = None;
                for step in 0..=self.size[along] {
                    let mut vertex = [layer.height; 3];
                    vertex[along] = step;
                    vertex[across] = row;
                    let stays = self.stays(vertex);
                    if stays && let Some(start) = start.take() {
                        drawing.segment(layer.flat(start), layer.flat(vertex));
                    }
                    let is_drawn = self.is_crease(vertex, along)
                        && [0, -1]
                            .into_iter()
                            .any(|back| self.is_square(shifted(vertex, across, back), layer.axis));
                    if stays && is_drawn {
                        start = Some(vertex);
                    }
                }
            }
        }
        drawing
    }

    fn layers(&self) -> impl Iterator<Item = Layer> + use<> {
        let size = self.size;
        (0..3).flat_map(move |axis| (0..=size[axis]).map(move |height| Layer { axis, height }))
    }

    fn squares_of(&self, layer: &Layer) -> Vec<Place> {
        let [right, up] = layer.axes();
        let mut squares = Vec::new();
        for i in 0..self.size[right] {
            for j in 0..self.size[up] {
                let mut square = [layer.height; 3];
                square[right] = i;
                square[up] = j;
                if self.is_square(square, layer.axis) {
                    squares.push(square);
                }
            }
        }
        squares
    }

    fn vertices(&self) -> impl Iterator<Item = Place> + use<> {
        let [nx, ny, nz] = self.size;
        (0..=nx).flat_map(move |x| (0..=ny).flat_map(move |y| (0..=nz).map(move |z| [x, y, z])))
    }

    /// Whether one of the cubes above and below a square is there.
    fn is_square(&self, square: Place, axis: usize) -> bool {
        self.has(square) != self.has(shifted(square, axis, -1))
    }

    /// Whether the body is below a square, and not above.
    fn faces_up(&self, square: Place) -> bool {
        !self.has(square)
    }

    /// The four cubes round the edge from a vertex along an axis, in order.
    fn round_edge(&self, vertex: Place, axis: usize) -> [bool; 4] {
        let [b, c] = [(axis + 1) % 3, (axis + 2) % 3];
        [[-1, -1], [0, -1], [0, 0], [-1, 0]]
            .map(|[i, j]| self.has(shifted(shifted(vertex, b, i), c, j)))
    }

    fn is_crease(&self, vertex: Place, axis: usize) -> bool {
        let [p, q, r, s] = self.round_edge(vertex, axis);
        [p, q, r, s].iter().filter(|&&has| has).count() % 2 == 1 || (p == r && q == s && p != q)
    }

    fn is_touching(&self, vertex: Place, axis: usize) -> bool {
        let [p, q, r, s] = self.round_edge(vertex, axis);
        p == r && q == s && p != q
    }

    fn stays(&self, vertex: Place) -> bool {
        let creases = [0, 1, 2]
            .map(|axis| [0, -1].map(|back| self.is_crease(shifted(vertex, axis, back), axis)));
        let count = creases.as_flattened().iter().filter(|&&is| is).count();
        let is_straight = count == 2 && creases.contains(&[true, true]);
        count > 0 && !is_straight
    }

    /// Whether the cubes at a vertex hang together by squares there, and the space between them too.
    fn is_whole(&self, vertex: Place) -> bool {
        let cubes: [bool; 8] = std::array::from_fn(|i| {
            self.has([0, 1, 2].map(|axis| vertex[axis] - (i as i32 >> axis & 1)))
        });
        [true, false].into_iter().all(|kind| {
            let Some(first) = cubes.iter().position(|&has| has == kind) else {
                return true;
            };
            let mut reached = [false; 8];
            reached[first] = true;
            // Seven steps reach whatever can be reached among eight.
            for _ in 0..7 {
                for i in 0..8 {
                    let is_next = (0..3).any(|axis| reached[i ^ (1 << axis)]);
                    reached[i] |= cubes[i] == kind && is_next;
                }
            }
            (0..8).all(|i| cubes[i] != kind || reached[i])
        })
    }
}

impl Layer {
    /// The two other axes: to the right and up when this one points to the eye.
    fn axes(&self) -> [usize; 2] {
        [(self.axis + 1) % 3, (self.axis + 2) % 3]
    }

    fn flat(&self, vertex: Place) -> DVec2 {
        DVec2::from(self.axes().map(|axis| f64::from(vertex[axis])))
    }

    fn vertex(&self, flat: DVec2) -> Place {
        let [right, up] = self.axes();
        let mut vertex = [self.height; 3];
        vertex[right] = flat.x as i32;
        vertex[up] = flat.y as i32;
        vertex
    }
}

fn shifted(mut place: Place, axis: usize, by: i32) -> Place {
    place[axis] += by;
    place
}

/// The place itself, in whole numbers.
#[must_use]
pub fn whole(place: Place) -> DVec3 {
    DVec3::from(place.map(f64::from))
}

#[cfg(test)]
mod tests {
    use super::super::check::defect;
    use super::super::random;
    use super::*;

    #[test]
    fn a_box_of_many_cubes_has_twelve_triangles() {
        let mut cells = Cells::new([4, 5, 6]);
        cells.set_box([1, 1, 1], [3, 4, 6], true);
        let solid = cells.polygons(whole, &mut random(1)).into_solid("box");
        assert_eq!((solid.points.len(), solid.triangles.len()), (8, 12));
        assert_eq!(defect(&solid), None);
        let squares = cells.squares(whole, &mut random(1)).into_solid("box");
        assert_eq!(squares.triangles.len(), 2 * 2 * (2 * 3 + 2 * 5 + 3 * 5));
        assert_eq!(defect(&squares), None);
    }

    #[test]
    fn triangles_face_outwards() {
        let mut cells = Cells::new([3, 3, 3]);
        cells.set_box([0, 0, 0], [3, 3, 3], true);
        cells.set([1, 1, 1], false);
        for solid in [
            cells.polygons(whole, &mut random(2)).into_solid(""),
            cells.squares(whole, &mut random(2)).into_solid(""),
        ] {
            let six_volumes = solid.triangles.iter().map(|corners| {
                let [a, b, c] = corners.map(|v| solid.points[v as usize]);
                a.cross(b).dot(c)
            });
            assert_eq!(six_volumes.sum::<f64>(), 6.0 * 26.0);
        }
    }

    #[test]
    fn cubes_that_touch_are_noticed_and_stay_valid() {
        let touching = |other| {
            let mut cells = Cells::new([2, 2, 2]);
            cells.set([0, 0, 0], true);
            cells.set(other, true);
            let solid = cells.polygons(whole, &mut random(1)).into_solid("");
            assert_eq!(defect(&solid), None);
            (cells.touch().edges, cells.touch().vertices)
        };
        assert_eq!(touching([1, 0, 0]), (0, 0));
        assert_eq!(touching([1, 1, 0]), (1, 0));
        assert_eq!(touching([1, 1, 1]), (0, 1));
    }
}
