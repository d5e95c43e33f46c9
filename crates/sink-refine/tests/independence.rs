//! What the paper proves of flowers and independent points (§4.2, §4.4), and of radii along the flow (§3.3), in the plane
//! and in space, on points at random and on points of small lattices.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use proptest::prelude::*;

/// Whole numbers within a small or a large range: many ties, or few.
fn coordinates<const N: usize>(max: usize) -> impl Strategy<Value = Vec<[f64; N]>> {
    let side = prop_oneof![Just(3), Just(20), Just(1_000_000)];
    side.prop_flat_map(move |side: i32| {
        let point = prop::array::uniform::<_, N>(-side..=side);
        prop::collection::vec(point.prop_map(|p| p.map(f64::from)), 6..max)
    })
}

mod plane {
    use super::*;
    use delaunay_core::geo_predicates::{Sign, in_circle};
    use delaunay_core::{Cavity, Delaunay2, FaceId, VertexId};
    use glam::DVec2;
    use sink_refine::tri::are_independent;

    /// A point with its prestar; none when it is a vertex or not inside the hull.
    fn prestar(delaunay: &Delaunay2, x: DVec2) -> Option<Cavity> {
        let cavity = delaunay.cavity(x).unwrap();
        let real = !cavity.faces().iter().any(|&f| delaunay.is_ghost_face(f));
        (real && !cavity.faces().is_empty()).then_some(cavity)
    }

    fn with(delaunay: &Delaunay2, x: DVec2) -> (Delaunay2, VertexId) {
        let mut with = delaunay.clone();
        let v = with.insert(x).unwrap().vertex();
        (with, v)
    }

    /// Where `x` is, at best, with respect to the circumcircles of some triangles.
    fn flower(delaunay: &Delaunay2, faces: impl IntoIterator<Item = FaceId>, x: DVec2) -> Sign {
        let sides = faces.into_iter().map(|f| {
            let [a, b, c] = delaunay.triangle(f);
            in_circle(a, b, c, x)
        });
        sides.max().unwrap_or(Sign::Negative)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(400))]

        /// The Flower Lemma.
        #[test]
        fn the_flower_of_a_prestar_is_in_that_of_the_star(points in coordinates::<2>(60)) {
            let points: Vec<DVec2> = points.into_iter().map(DVec2::from).collect();
            let (samples, given) = points.split_at(points.len() / 3);
            let Ok(delaunay) = Delaunay2::build(given) else { return Ok(()) };
            for &x in samples.iter().take(4) {
                let Some(prestar) = prestar(&delaunay, x) else { continue };
                let (with_x, v) = with(&delaunay, x);
                for &y in samples {
                    let before = flower(&delaunay, prestar.faces().iter().copied(), y);
                    let after = flower(&with_x, with_x.mesh().star(v), y);
                    // The new vertex is on every circle of its star, and inside of their union.
                    prop_assert!(before <= after || y == x, "{} {}: {:?} {:?}", x, y, before, after);
                }
            }
        }

        /// The Independence Lemma.
        #[test]
        fn independent_points_are_no_neighbors_and_outside_each_others_flowers(points in coordinates::<2>(120)) {
            let points: Vec<DVec2> = points.into_iter().map(DVec2::from).collect();
            let (samples, given) = points.split_at(points.len() / 4);
            let Ok(delaunay) = Delaunay2::build(given) else { return Ok(()) };
            for pair in samples.windows(2).take(6) {
                let [x, y] = [pair[0], pair[1]];
                let (Some(of_x), Some(of_y)) = (prestar(&delaunay, x), prestar(&delaunay, y)) else { continue };
                if x == y {
                    continue;
                }
                let (with_y, w) = with(&delaunay, y);
                let (with_both, v) = with(&with_y, x);
                let one = are_independent(&of_x, &of_y);
                let two = !with_both.mesh().neighbors(v).any(|u| u == w);
                let three = flower(&with_y, with_y.mesh().star(w), x) != Sign::Positive;
                let four = flower(&delaunay, of_y.faces().iter().copied(), x) != Sign::Positive;
                prop_assert_eq!(one, are_independent(&of_y, &of_x));
                prop_assert!(!one || two, "I does not imply II");
                prop_assert!(!two || three, "II does not imply III");
                prop_assert!(!three || four, "III does not imply IV");
            }
        }
    }

    #[test]
    fn far_points_are_independent_and_near_ones_are_not() {
        let lattice: Vec<DVec2> = (0..100)
            .map(|i| DVec2::new(f64::from(i % 10), f64::from(i / 10)))
            .collect();
        let delaunay = Delaunay2::build(&lattice).unwrap();
        let at = |x: f64, y: f64| prestar(&delaunay, DVec2::new(x, y)).unwrap();
        assert!(are_independent(&at(1.5, 1.5), &at(7.5, 7.5)));
        assert!(!are_independent(&at(1.5, 1.5), &at(2.5, 1.5)));
    }
}

mod space {
    use super::*;
    use delaunay_core::geo_predicates::{Sign, in_sphere};
    use delaunay_core::{Cavity3, Delaunay3, Subcomplex3, TetId, VertexId};
    use glam::DVec3;
    use sink_refine::tet::{
        FlowGraph3, FlowWalk, Successor3, are_independent, is_sink, successors,
    };

    fn prestar(delaunay: &Delaunay3, x: DVec3) -> Option<Cavity3> {
        let cavity = delaunay.cavity(x).unwrap();
        let mut tets = cavity.tets().iter();
        let real = !tets.any(|&t| delaunay.mesh().is_ghost_tet(t));
        (real && !cavity.tets().is_empty()).then_some(cavity)
    }

    fn with(delaunay: &Delaunay3, x: DVec3) -> (Delaunay3, VertexId) {
        let mut with = delaunay.clone();
        let v = with.insert(x).unwrap().vertex();
        (with, v)
    }

    fn flower(delaunay: &Delaunay3, tets: impl IntoIterator<Item = TetId>, x: DVec3) -> Sign {
        let sides = tets.into_iter().map(|t| {
            let [a, b, c, d] = delaunay.tetrahedron(t);
            in_sphere(a, b, c, d, x)
        });
        sides.max().unwrap_or(Sign::Negative)
    }

    /// Squared circumradius as a fraction.
    fn squared_radius(corners: [DVec3; 4]) -> (i128, i128) {
        let [a, b, c, d] = corners.map(|p| p.to_array().map(|x| x as i128));
        let minus = |p: [i128; 3]| [p[0] - a[0], p[1] - a[1], p[2] - a[2]];
        let dot = |u: [i128; 3], v: [i128; 3]| u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
        let cross = |u: [i128; 3], v: [i128; 3]| {
            [
                u[1] * v[2] - u[2] * v[1],
                u[2] * v[0] - u[0] * v[2],
                u[0] * v[1] - u[1] * v[0],
            ]
        };
        let [u, v, w] = [b, c, d].map(minus);
        let (vw, wu, uv) = (cross(v, w), cross(w, u), cross(u, v));
        let n: [i128; 3] =
            std::array::from_fn(|i| dot(u, u) * vw[i] + dot(v, v) * wu[i] + dot(w, w) * uv[i]);
        let twice = 2 * dot(u, vw);
        (dot(n, n), twice * twice)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(200))]

        /// The Flower Lemma.
        #[test]
        fn the_flower_of_a_prestar_is_in_that_of_the_star(points in coordinates::<3>(60)) {
            let points: Vec<DVec3> = points.into_iter().map(DVec3::from).collect();
            let (samples, given) = points.split_at(points.len() / 3);
            let Ok(delaunay) = Delaunay3::build(given) else { return Ok(()) };
            for &x in samples.iter().take(4) {
                let Some(prestar) = prestar(&delaunay, x) else { continue };
                let (with_x, v) = with(&delaunay, x);
                for &y in samples {
                    let before = flower(&delaunay, prestar.tets().iter().copied(), y);
                    let after = flower(&with_x, with_x.mesh().star(v), y);
                    // The new vertex is on every sphere of its star, and inside of their union.
                    prop_assert!(before <= after || y == x, "{} {}: {:?} {:?}", x, y, before, after);
                }
            }
        }

        /// The Independence Lemma.
        #[test]
        fn independent_points_are_no_neighbors_and_outside_each_others_flowers(points in coordinates::<3>(250)) {
            let points: Vec<DVec3> = points.into_iter().map(DVec3::from).collect();
            let (samples, given) = points.split_at(points.len() / 4);
            let Ok(delaunay) = Delaunay3::build(given) else { return Ok(()) };
            for pair in samples.windows(2).take(6) {
                let [x, y] = [pair[0], pair[1]];
                let (Some(of_x), Some(of_y)) = (prestar(&delaunay, x), prestar(&delaunay, y)) else { continue };
                if x == y {
                    continue;
                }
                let (with_y, w) = with(&delaunay, y);
                let (with_both, v) = with(&with_y, x);
                let one = are_independent(delaunay.mesh(), &of_x, &of_y);
                let two = !with_both.mesh().neighbors(v).any(|u| u == w);
                let three = flower(&with_y, with_y.mesh().star(w), x) != Sign::Positive;
                let four = flower(&delaunay, of_y.tets().iter().copied(), x) != Sign::Positive;
                prop_assert_eq!(one, are_independent(delaunay.mesh(), &of_y, &of_x));
                prop_assert!(!one || two, "I does not imply II");
                prop_assert!(!two || three, "II does not imply III");
                prop_assert!(!three || four, "III does not imply IV");
            }
        }

        #[test]
        fn the_circumradius_grows_along_the_flow_except_on_one_sphere(
            points in prop::collection::vec(prop::array::uniform3(-20_i32..=20), 4..60),
            shrink in prop_oneof![Just(1), Just(7)],
        ) {
            let points: Vec<DVec3> = points.into_iter().map(|p| DVec3::from(p.map(|x| f64::from(x / shrink)))).collect();
            let Ok(delaunay) = Delaunay3::build(&points) else { return Ok(()) };
            let solid = Subcomplex3::of(&delaunay, |_| true);
            let graph = FlowGraph3::of(&solid);
            let mut walk = FlowWalk::default();
            for t in solid.tets() {
                prop_assert!(successors(&solid, t).count() <= 2);
                prop_assert_eq!(is_sink(&solid, t), graph.sinks().contains(&t));
                for successor in successors(&solid, t) {
                    let Successor3::Tet(next) = successor else { continue };
                    let [small, large] = [t, next].map(|t| squared_radius(solid.tetrahedron(t)));
                    let [a, b, c, d] = solid.tetrahedron(t);
                    let one_sphere = solid.tetrahedron(next).iter().all(|&p| in_sphere(a, b, c, d, p) == Sign::Zero);
                    if one_sphere {
                        prop_assert_eq!(small.0 * large.1, large.0 * small.1);
                    } else {
                        prop_assert!(small.0 * large.1 < large.0 * small.1);
                    }
                }
                // The walk ends: it passes no tetrahedron twice.
                let sinks = walk.sinks_of(&solid, t).to_vec();
                prop_assert!(sinks.iter().all(|&s| graph.ancestors(s).contains(&t)));
                prop_assert!(!sinks.is_empty() || walk.leaves());
            }
        }
    }
}
