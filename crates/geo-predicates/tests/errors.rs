//! Nothing panics, and nothing loops, for coordinates that the door would have refused.

use geo_predicates::{
    DVec2, DVec3, WeightedPoint2, WeightedPoint3, filter::Filter2, filter::Filter3,
    in_circle_perturbed, in_diametral_ball, in_diametral_circle, in_diametral_sphere,
    in_sphere_perturbed, orient2d, orient3d, power_circle_perturbed, power_sphere_perturbed,
};
use proptest::prelude::*;

/// Any double at all, the special ones often.
fn hostile() -> impl Strategy<Value = f64> {
    prop_oneof![
        Just(f64::NAN),
        Just(f64::INFINITY),
        Just(f64::NEG_INFINITY),
        Just(f64::MAX),
        Just(f64::MIN_POSITIVE),
        Just(f64::from_bits(1)),
        Just(0.0),
        Just(1.0),
        prop::num::f64::ANY,
    ]
}

proptest! {
    #[test]
    fn refused_coordinates_give_some_answer(values in prop::collection::vec(hostile(), 20)) {
        let solid: Vec<DVec3> = values.chunks(4).map(|v| DVec3::new(v[0], v[1], v[2])).collect();
        let flat: Vec<DVec2> = solid.iter().map(|p| p.truncate()).collect();
        let [a, b, c, d, _] = flat[..] else { unreachable!() };
        let _ = (orient2d(a, b, c), in_circle_perturbed(a, b, c, d), in_diametral_circle(a, b, c));
        let _ = (Filter2::for_points(&flat), Filter3::for_points(&solid));
        let weighted = |i: usize| WeightedPoint2 { point: flat[i], weight: values[4 * i + 3] };
        let _ = power_circle_perturbed(weighted(0), weighted(1), weighted(2), weighted(3));
        let [a, b, c, d, e] = solid[..] else { unreachable!() };
        let _ = (orient3d(a, b, c, d), in_sphere_perturbed(a, b, c, d, e));
        let _ = (in_diametral_sphere(a, b, c), in_diametral_ball(a, b, c, d));
        let weighted = |i: usize| WeightedPoint3 { point: solid[i], weight: values[4 * i + 3] };
        let _ = power_sphere_perturbed(weighted(0), weighted(1), weighted(2), weighted(3), weighted(4));
    }
}
