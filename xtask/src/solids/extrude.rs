//! Prisms: two triangulations of one region, and walls between their rims in one layer or more.
//!
//! ```text
//!      ______________
//!     /   top       /|   layer n
//!    /_____________/ |
//!    |  \   |  /   | |   walls: two triangles for each edge of the rim and layer
//!    |____\_|/_____|/    layer 0: the bottom, turned over
//! ```

use glam::{DVec2, DVec3};

use super::Random;
use super::flat::Cap;
use super::skin::Skin;

/// The surface between `bottom` at layer 0 and `top` at layer `layers`. Both must have the same rim.
///
/// `place` tells where a point of the plane is in a layer. Where two layers are at one place, nothing is between them.
pub fn between(
    bottom: &Cap,
    top: &Cap,
    layers: usize,
    place: impl Fn(DVec2, usize) -> DVec3,
    random: &mut Random,
) -> Skin {
    let mut skin = Skin::default();
    for [a, b, c] in bottom.places() {
        skin.triangle([a, c, b].map(|p| place(p, 0)));
    }
    for corners in top.places() {
        skin.triangle(corners.map(|p| place(p, layers)));
    }
    for [a, b] in bottom.rim() {
        for layer in 0..layers {
            let above = layer + 1;
            let corners = [
                place(a, layer),
                place(b, layer),
                place(b, above),
                place(a, above),
            ];
            skin.quad(corners, random);
        }
    }
    skin
}

/// A straight prism from height 0 to `height`, in `layers` equal layers.
pub fn straight(bottom: &Cap, top: &Cap, height: f64, layers: usize, random: &mut Random) -> Skin {
    let place = |p: DVec2, layer| p.extend(height * layer as f64 / layers as f64);
    between(bottom, top, layers, place, random)
}

#[cfg(test)]
mod tests {
    use super::super::check::defect;
    use super::super::flat::Drawing;
    use super::super::random;
    use super::*;
    use glam::dvec2;

    #[test]
    fn a_prism_over_a_triangle_with_a_hole_is_closed() {
        let mut drawing = Drawing::default();
        drawing.ring(&[DVec2::ZERO, dvec2(9.0, 0.0), dvec2(0.0, 9.0)]);
        drawing.ring(&[DVec2::ONE, dvec2(2.0, 1.0), dvec2(1.0, 2.0)]);
        let mut random = random(3);
        let [bottom, top] = [0, 1].map(|_| drawing.inside(&mut random));
        let solid = straight(&bottom, &top, 2.0, 3, &mut random).into_solid("prism");
        assert_eq!(defect(&solid), None);
        assert_eq!(solid.triangles.len(), 6 + 6 + 2 * 3 * 6);
    }
}
