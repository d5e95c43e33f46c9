//! Two triangles of a surface that intersect, found by a plane that sweeps across it.
//!
//! ```text
//!            │  ┌──────┐        Boxes are opened when the plane comes to them and closed when
//!     ┌──────┼──┼─┐    │        it has left them; a box is compared with those that are open.
//!     │      │  └─┼────┘
//!     └──────┼────┘
//!            │ ->
//! ```

use super::bounds::Bounds;
use super::intersection::triangles_intersect;
use super::surface::Surface;
use crate::ids::VertexId;
use crate::progress::{Cancelled, Meter};
use glam::DVec3;

/// The first pair of intersecting triangles, the smaller number in front, of which at least one is suspect; `None`
/// when there is none.
///
/// Takes time n log n, and for each suspect triangle time proportional to the number of triangles that the plane
/// meets when it comes to it: about √n on a surface of even triangles.
pub(super) fn first_intersection(
    surface: &Surface,
    suspect: &[bool],
    meter: &mut Meter<'_>,
) -> Result<Option<[usize; 2]>, Cancelled> {
    let (points, triangles) = (surface.points(), surface.triangles());
    let place = |v: VertexId| points[v.index()];
    let bounds_of = |corners: &[VertexId; 3]| Bounds::of(corners.map(place));
    let bounds: Vec<Bounds> = triangles.iter().map(bounds_of).collect();
    let axis = sweep_axis(Bounds::of(points.iter().copied()), &bounds);
    let mut order: Vec<usize> = (0..triangles.len()).collect();
    order.sort_by(|&i, &j| bounds[i].low[axis].total_cmp(&bounds[j].low[axis]));
    let (mut suspects, mut others) = (Vec::new(), Vec::new());
    for here in order {
        meter.advance()?;
        let find_in = |open: &mut Vec<usize>| {
            open.retain(|&there| bounds[there].high[axis] >= bounds[here].low[axis]);
            open.iter().copied().find(|&there| {
                bounds[here].meets(bounds[there])
                    && triangles_intersect(place, triangles[here], triangles[there])
            })
        };
        let mut found = find_in(&mut suspects);
        if suspect[here] && found.is_none() {
            found = find_in(&mut others);
        }
        if let Some(there) = found {
            return Ok(Some([here.min(there), here.max(there)]));
        }
        let open = if suspect[here] {
            &mut suspects
        } else {
            &mut others
        };
        open.push(here);
    }
    Ok(None)
}

/// The axis along which the boxes are shortest, compared with the whole: fewest are open at a time.
fn sweep_axis(whole: Bounds, bounds: &[Bounds]) -> usize {
    let sum: DVec3 = bounds.iter().copied().map(Bounds::size).sum();
    (sum / whole.size()).min_position()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::progress::silent;
    use proptest::prelude::*;

    /// Tetrahedra of one size at the given places: closed, and apart or not.
    fn tetrahedra(places: &[[u8; 3]]) -> Surface {
        let corners = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
        let place = |(i, p): (usize, &[u8; 3])| {
            // Shifted a little, so that no two vertices coincide.
            DVec3::from(p.map(f64::from)) / 8.0 + DVec3::splat(i as f64 / 128.0)
        };
        let places = places.iter().enumerate().map(place);
        let points = places.flat_map(|p| corners.map(|corner| p + corner));
        let points: Vec<DVec3> = points.collect();
        let facets = [[1, 2, 3], [2, 0, 3], [0, 1, 3], [2, 1, 0]];
        let solids = (0..points.len()).step_by(4);
        let triangles =
            solids.flat_map(|first| facets.map(|f| f.map(|i| VertexId::new(first + i))));
        let triangles = triangles.collect();
        Surface::new(points, triangles).unwrap()
    }

    proptest! {
        #[test]
        fn the_sweep_finds_a_pair_when_all_pairs_do(
            places in prop::collection::vec(prop::array::uniform3(0_u8..40), 1..12),
            seed in any::<u64>(),
        ) {
            let surface = tetrahedra(&places);
            let (points, triangles) = (surface.points(), surface.triangles());
            let place = |v: VertexId| points[v.index()];
            let suspect: Vec<bool> = (0..triangles.len()).map(|i| seed >> (i % 64) & 1 == 1).collect();
            let mut pairs = (0..triangles.len()).flat_map(|j| (0..j).map(move |i| [i, j]));
            let wanted = |&[i, j]: &[usize; 2]| {
                (suspect[i] || suspect[j]) && triangles_intersect(place, triangles[i], triangles[j])
            };
            let some = pairs.clone().any(|pair| wanted(&pair));
            let mut report = silent;
            let mut meter = Meter::start(&mut report, "sweep", triangles.len()).unwrap();
            let found = first_intersection(&surface, &suspect, &mut meter).unwrap();
            prop_assert_eq!(found.is_some(), some);
            prop_assert!(found.is_none_or(|found| pairs.any(|pair| pair == found && wanted(&pair))));
        }
    }
}
