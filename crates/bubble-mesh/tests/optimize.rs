//! Meshes that are optimized: as the equations say, valid, better, and the same on any number of threads.

mod regions;

use std::ops::ControlFlow;

use bubble_mesh::paper::{
    Mesh, Optimized, Params, RINGS, generate, initial_bubbles, moved, optimize, resized, rings,
};
use bubble_mesh::{Bubble, Domain, radius_ratio};
use delaunay_core::measure::{AngleSummary, Statistics, triangle};
use delaunay_core::progress::{Progress, silent};
use delaunay_core::{Subcomplex2, VertexId};
use glam::DVec2;
use proptest::prelude::*;
use regions::{circle, domain, even, square};

fn generated(domain: &Domain) -> Mesh {
    generate(domain, &Params::paper(), &mut silent)
}

fn optimized_with(mesh: &Mesh, params: &Params) -> Optimized {
    optimize(mesh, params, &mut silent).expect("nodes that stay inside")
}

fn optimized(mesh: &Mesh, iterations: usize) -> Optimized {
    let params = Params {
        iterations,
        ..Params::paper()
    };
    optimized_with(mesh, &params)
}

/// An annulus with uneven edges: fine on one side or on both.
fn annulus() -> impl Strategy<Value = Domain> {
    let steps = prop::collection::vec(0.4..1.0f64, 16..40);
    (steps, 0.2..0.5f64, 10..30u32).prop_map(|(steps, radius, nodes)| {
        let whole: f64 = steps.iter().sum();
        let turns = steps.iter().scan(0.0, |turn, step| {
            *turn += step / whole;
            Some(*turn)
        });
        let outer = circle(DVec2::ZERO, 1.0, turns);
        domain(&[outer, circle(DVec2::new(0.1, 0.0), radius, even(nodes))])
    })
}

/// The bubbles after some iterations, by the equations alone: no lists but the three rings, no threads.
fn by_the_equations(mesh: &Mesh, params: &Params) -> Vec<Bubble> {
    let count = mesh.bubbles().len();
    let nearby = |node: usize| {
        let rings = rings(mesh.region(), VertexId::new(node));
        let mut nodes: Vec<usize> = rings.concat().into_iter().map(VertexId::index).collect();
        nodes.sort_unstable();
        nodes
    };
    let interior = mesh.boundary_nodes()..count;
    let nearby: Vec<Vec<usize>> = interior.clone().map(nearby).collect();
    let mut bubbles = initial_bubbles(mesh, params);
    for _ in 0..params.iterations {
        let old = bubbles.clone();
        for (node, nearby) in interior.clone().zip(&nearby) {
            bubbles[node].center = moved(old[node], nearby.iter().map(|&j| old[j]), params.step);
        }
        let old = bubbles.clone();
        for (node, nearby) in interior.clone().zip(&nearby) {
            bubbles[node].radius = resized(old[node], nearby.iter().map(|&j| old[j]));
        }
    }
    bubbles
}

fn ratios(region: &Subcomplex2) -> Statistics<usize> {
    let ratios = region.faces().map(|f| radius_ratio(region.triangle(f)));
    Statistics::of(ratios.enumerate()).expect("triangles")
}

fn area(region: &Subcomplex2) -> f64 {
    let areas = region.faces().map(|f| triangle::area(region.triangle(f)));
    areas.sum()
}

fn boundary(region: &Subcomplex2) -> Vec<[VertexId; 2]> {
    let mesh = region.mesh();
    let ends = region.boundary().map(|h| [mesh.origin(h), mesh.target(h)]);
    let mut ends: Vec<_> = ends.collect();
    ends.sort_unstable();
    ends
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn lists_of_contacts_change_no_bit(domain in annulus()) {
        let mesh = generated(&domain);
        let params = Params { iterations: 40, ..Params::paper() };
        let optimized = optimized_with(&mesh, &params);
        prop_assume!(optimized.held.is_empty());
        prop_assert_eq!(optimized.bubbles, by_the_equations(&mesh, &params));
    }

    #[test]
    fn area_and_boundary_stay_and_triangles_are_delaunay(domain in annulus(), step in 0.0..1.0f64) {
        let mesh = generated(&domain);
        let params = Params { iterations: 30, step, ..Params::paper() };
        let optimized = optimized_with(&mesh, &params);
        prop_assert_eq!(optimized.region.check(), Ok(()));
        prop_assert!((area(&optimized.region) / domain.area() - 1.0).abs() < 1e-12);
        prop_assert_eq!(boundary(&optimized.region), boundary(domain.region()));
        prop_assert_eq!(optimized.region.faces().count(), mesh.region().faces().count());
        let nodes = mesh.boundary_nodes();
        prop_assert_eq!(&optimized.bubbles[..nodes], &initial_bubbles(&mesh, &params)[..nodes]);
        for (bubble, point) in optimized.bubbles.iter().zip(optimized.region.points()) {
            prop_assert_eq!(bubble.center, *point);
        }
    }

    #[test]
    fn radii_stay_within_those_of_the_boundary(domain in annulus()) {
        let mesh = generated(&domain);
        let optimized = optimized(&mesh, 60);
        let (boundary, inner) = optimized.bubbles.split_at(mesh.boundary_nodes());
        let radii = boundary.iter().map(|bubble| bubble.radius);
        let (least, largest) = (radii.clone().fold(f64::MAX, f64::min), radii.fold(0.0, f64::max));
        for bubble in inner {
            prop_assert!((least * (1.0 - 1e-9)..largest * (1.0 + 1e-9)).contains(&bubble.radius));
        }
    }
}

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    // More than two blocks of nodes, some of them moving into the next triangle.
    let mesh = generated(&domain(&[square(50, 0.2)]));
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
        pool.build().unwrap().install(|| optimized(&mesh, 30))
    };
    let one = on(1);
    for threads in [2, 3, 8] {
        let many = on(threads);
        assert_eq!(many.bubbles, one.bubbles);
        let corners = |o: &Optimized| -> Vec<[VertexId; 3]> {
            let mesh = o.region.mesh();
            o.region.faces().map(|f| mesh.face_vertices(f)).collect()
        };
        assert_eq!(corners(&many), corners(&one));
    }
}

/// What a faithful implementation was found to reach on regions of these kinds: mean radius ratio 0.85 to 0.87 as generated,
/// 0.94 after 50 iterations, 0.94 to 0.96 after 200. The gradings of the second and the third are steep.
#[test]
fn the_regions_of_the_paper_are_as_good_as_expected() {
    let least = [0.75, 0.5, 0.55, 0.65];
    for ((name, domain), least) in regions::of_the_paper().into_iter().zip(least) {
        let mesh = generated(&domain);
        let generated = ratios(mesh.region());
        assert!(
            (0.84..0.88).contains(&generated.mean()),
            "{name}: {}",
            generated.mean()
        );
        assert!(
            (0.38..0.55).contains(&generated.min()),
            "{name}: {}",
            generated.min()
        );
        let [fifty, all] = [50, 200].map(|iterations| optimized(&mesh, iterations));
        assert!(ratios(&fifty.region).mean() > 0.925, "{name}");
        let [start, end] = [mesh.region(), &all.region].map(ratios);
        assert!(
            end.mean() > 0.94 && end.min() > least,
            "{name}: {} {}",
            end.mean(),
            end.min()
        );
        let low = |ratios: &Statistics<usize>| {
            let low = ratios
                .smallest(usize::MAX)
                .take_while(|(_, ratio)| *ratio < 0.7);
            low.count() as f64 / ratios.count() as f64
        };
        assert!(low(&start) > 0.03 && low(&end) < 0.01, "{name}");
        let triangles = all.region.faces().map(|f| all.region.triangle(f));
        let angles = AngleSummary::of_triangles(triangles).unwrap();
        assert!(
            angles.min > 29.0 && angles.max < 116.0,
            "{name}: {angles:?}"
        );
        assert_eq!(all.held, [], "{name}");
    }
}

#[test]
fn rings_are_three() {
    let mesh = generated(&domain(&[square(8, 0.0)]));
    let node = VertexId::new(mesh.boundary_nodes());
    let rings: [Vec<VertexId>; RINGS] = rings(mesh.region(), node);
    let neighbors = mesh.region().mesh().neighbors(node).count();
    assert_eq!((rings.len(), rings[0].len()), (3, neighbors));
}

/// Bubbles so large that they push each other everywhere, with steps so large that nodes swing.
#[test]
fn nodes_that_would_leave_are_held() {
    for (name, domain) in regions::of_the_paper() {
        let mesh = generated(&domain);
        let params = Params {
            amplification: 5.0,
            step: 1.0,
            iterations: 20,
            ..Params::paper()
        };
        let optimized = optimized_with(&mesh, &params);
        assert!(!optimized.held.is_empty(), "{name}");
        assert!(
            optimized
                .held
                .iter()
                .all(|v| v.index() >= mesh.boundary_nodes())
        );
        assert_eq!(optimized.region.check(), Ok(()), "{name}");
        assert!((area(&optimized.region) / domain.area() - 1.0).abs() < 1e-12);
    }
}

#[test]
fn parts_that_touch_are_optimized_each_for_itself() {
    let domain = regions::of_outline(&regions::touching_squares());
    let optimized = optimized(&generated(&domain), 50);
    assert_eq!(optimized.region.check(), Ok(()));
    assert_eq!(boundary(&optimized.region), boundary(domain.region()));
    assert!(ratios(&optimized.region).mean() > 0.93);
}

#[test]
fn without_iterations_the_mesh_stays() {
    let mesh = generated(&domain(&[square(12, 0.0)]));
    let same = optimized(&mesh, 0);
    assert_eq!((same.iterations, same.held.len()), (0, 0));
    assert_eq!(same.region.points(), mesh.region().points());
    assert_eq!(same.bubbles, initial_bubbles(&mesh, &Params::paper()));
}

#[test]
fn a_report_that_breaks_ends_the_iterations() {
    let mesh = generated(&domain(&[square(12, 0.0)]));
    let stopped_at = |iteration: usize| {
        let mut iterates = false;
        let mut report = |progress: Progress| {
            iterates |= progress.stage == "relax";
            match iterates && progress.done >= iteration {
                true => ControlFlow::Break(()),
                false => ControlFlow::Continue(()),
            }
        };
        optimize(&mesh, &Params::paper(), &mut report).unwrap()
    };
    for iterations in [0, 1, 7, 200] {
        // The last one too: then nothing is left to end but the triangulation, which is not ended.
        let stopped = stopped_at(iterations);
        assert_eq!(stopped.iterations, iterations);
        assert_eq!(stopped.bubbles, optimized(&mesh, iterations).bubbles);
    }
    let before = optimize(&mesh, &Params::paper(), &mut |_| ControlFlow::Break(())).unwrap();
    assert_eq!((before.iterations, before.region.check()), (0, Ok(())));
    assert_eq!(before.bubbles, optimized(&mesh, 0).bubbles);
    let mut in_the_end = |progress: Progress| match progress.stage {
        "nearby" | "relax" => ControlFlow::Continue(()),
        _ => ControlFlow::Break(()),
    };
    let ended = optimize(&mesh, &Params::paper(), &mut in_the_end);
    let error = ended.map(|optimized| optimized.iterations).unwrap_err();
    assert!(
        error
            .to_string()
            .starts_with("the moved nodes have no triangulation: cancelled")
    );
}

#[test]
fn numbers_that_cannot_be_worked_with_are_refused() {
    let mesh = generated(&domain(&[square(3, 0.0)]));
    let refusal = |amplification, step| {
        let params = Params {
            amplification,
            step,
            ..Params::paper()
        };
        optimize(&mesh, &params, &mut silent).unwrap_err()
    };
    insta::assert_snapshot!(refusal(0.0, 0.1), @"the amplification 0 is not a number above 0 and up to 100");
    insta::assert_snapshot!(refusal(f64::NAN, 0.1), @"the amplification NaN is not a number above 0 and up to 100");
    insta::assert_snapshot!(refusal(1.7, -0.1), @"the step -0.1 is not a number from 0 to 1");
}
