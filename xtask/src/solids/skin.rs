//! A surface while its triangles are gathered: one vertex at each place, whoever asks for it.

use glam::DVec3;
use rand::RngExt;

use super::places::Places;
use super::{Random, Solid};

/// Triangles between places.
#[derive(Clone, Debug, Default)]
pub struct Skin {
    points: Vec<DVec3>,
    at: Places<3>,
    triangles: Vec<[u32; 3]>,
}

impl Skin {
    /// The index of the vertex at this place.
    pub fn vertex(&mut self, place: DVec3) -> u32 {
        let place = place + 0.0;
        let (index, is_new) = self.at.number(place.to_array());
        if is_new {
            self.points.push(place);
        }
        index as u32
    }

    /// Adds a triangle, unless two of its corners are at one place.
    pub fn triangle(&mut self, corners: [DVec3; 3]) {
        let [a, b, c] = corners.map(|corner| self.vertex(corner));
        if a != b && b != c && c != a {
            self.triangles.push([a, b, c]);
        }
    }

    /// Adds two triangles between four corners in order round, split either way; or one, where two corners in a row are at one
    /// place.
    pub fn quad(&mut self, corners: [DVec3; 4], random: &mut Random) {
        let [a, b, c, d] = corners;
        let is_split_at_a = if a == b || c == d {
            // Either diagonal leaves the same triangle and one without area.
            true
        } else {
            random.random_bool(0.5)
        };
        if is_split_at_a {
            self.triangle([a, b, c]);
            self.triangle([a, c, d]);
        } else {
            self.triangle([a, b, d]);
            self.triangle([b, c, d]);
        }
    }

    /// Adds another surface, with its triangles turned over when it bounds a cavity.
    pub fn add(&mut self, solid: &Solid, is_cavity: bool) {
        for corners in &solid.triangles {
            let [a, b, c] = corners.map(|corner| solid.points[corner as usize]);
            self.triangle(if is_cavity { [a, c, b] } else { [a, b, c] });
        }
    }

    /// How many triangles there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.triangles.len()
    }

    /// Whether there is no triangle.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.triangles.is_empty()
    }

    /// The solid that the triangles bound.
    #[must_use]
    pub fn into_solid(self, name: impl Into<String>) -> Solid {
        Solid {
            name: name.into(),
            points: self.points,
            triangles: self.triangles,
        }
    }
}

impl Solid {
    /// The solid with its points moved; places that become one stay two points.
    #[must_use]
    pub fn moved(mut self, place: impl FnMut(DVec3) -> DVec3) -> Self {
        self.points = self.points.into_iter().map(place).collect();
        self
    }

    /// The solid with every coordinate of every point moved by up to `most` either way.
    #[must_use]
    pub fn jittered(self, most: f64, random: &mut Random) -> Self {
        let mut offset = || random.random_range(-most..=most);
        self.moved(|p| p + DVec3::new(offset(), offset(), offset()))
    }
}
