//! Nothing panics, and nothing loops, for coordinates that the door would have refused.

use geo_predicates::{
    DVec2, DVec3, Sign, WeightedPoint2, WeightedPoint3, filter::Filter2, filter::Filter3,
    in_circle, in_circle_perturbed, in_diametral_ball, in_diametral_circle, in_diametral_sphere,
    in_sphere, in_sphere_perturbed, orient2d, orient3d, power_circle_perturbed,
    power_sphere_perturbed,
};
use proptest::prelude::*;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

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

/// Expansions of NaN keep their zeros and once grew to full length: minutes instead of moments.
#[test]
fn thousands_of_queries_with_numbers_that_are_none_end() {
    let mut rng = ChaCha8Rng::seed_from_u64(6);
    let mut signs = [0; 3];
    for _ in 0..20_000 {
        let mut hostile = || match rng.random_range(0..5) {
            0 => f64::NAN,
            1 => f64::from_bits(rng.random()),
            2 => f64::INFINITY,
            3 => f64::from_bits(rng.random_range(0..9)),
            _ => 1.0,
        };
        let points = [(); 5].map(|()| DVec3::new(hostile(), hostile(), hostile()));
        let [a, b, c, d, e] = points;
        let [p, q, r, s, _] = points.map(DVec3::truncate);
        for sign in [
            in_sphere(a, b, c, d, e),
            orient3d(a, b, c, d),
            in_circle(p, q, r, s),
            orient2d(p, q, r),
        ] {
            signs[(sign as i8 + 1) as usize] += 1;
        }
    }
    assert!(signs[(Sign::Zero as i8 + 1) as usize] > 1000, "{signs:?}");
}
