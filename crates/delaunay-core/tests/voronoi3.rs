//! The Voronoi diagram of space against its definition.

#![allow(clippy::unwrap_used)]

use delaunay_core::{
    ConvexPolyhedron, Delaunay3, HalfSpace, PolyhedronFace, Side, VertexId, VoronoiEdge3,
    VoronoiFacet3,
};
use glam::{DVec3, dvec3};
use proptest::prelude::*;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

fn uniform(count: usize, seed: u64) -> Vec<DVec3> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    (0..count)
        .map(|_| dvec3(rng.random(), rng.random(), rng.random()))
        .collect()
}

fn lattice(n: [u32; 3]) -> Vec<DVec3> {
    let [a, b, c] = n;
    let cells = (0..a).flat_map(move |i| (0..b).flat_map(move |j| (0..c).map(move |k| [i, j, k])));
    cells.map(|cell| DVec3::from(cell.map(f64::from))).collect()
}

fn hard_sets() -> Vec<(&'static str, Vec<DVec3>)> {
    let scaled = |points: Vec<DVec3>, scale: f64| points.iter().map(|p| p * scale).collect();
    let sphere = uniform(200, 2)
        .into_iter()
        .map(|p| (p * 2.0 - 1.0).normalize());
    // Integer points exactly on one sphere.
    let shell = lattice([19, 19, 19]).into_iter().map(|p| p - 9.0);
    let shell = shell.filter(|p| p.length_squared() == 81.0).collect();
    let clusters = uniform(300, 5).into_iter().enumerate().map(|(i, p)| {
        let scale = [1e-5, 1e-9, 1e-13][i % 3];
        p * scale + DVec3::splat([0.1, 0.5, 0.9][i % 3])
    });
    let snapped = uniform(300, 3).into_iter().map(|p| (p * 5.0).floor());
    let skew = (0..20).map(f64::from);
    let skew = skew.flat_map(|t| [dvec3(t, 0.0, 0.0), dvec3(0.5, t, 1.0)]);
    vec![
        ("uniform", uniform(400, 1)),
        ("lattice", lattice([6, 6, 6])),
        ("flat lattice", lattice([3, 3, 2])),
        ("tenths", scaled(lattice([5, 5, 5]), 0.1)),
        ("sphere", sphere.collect()),
        ("shell", shell),
        ("skew lines", skew.collect()),
        ("snapped, with duplicates", snapped.collect()),
        ("clusters", clusters.collect()),
        ("tiny", scaled(uniform(100, 6), 2f64.powi(-130))),
        ("huge", scaled(uniform(100, 7), 2f64.powi(200))),
        ("four", vec![DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z]),
    ]
}

/// The box round the points, half as large again.
fn window_around(points: &[DVec3]) -> ConvexPolyhedron {
    let low = points.iter().copied().reduce(DVec3::min).unwrap();
    let high = points.iter().copied().reduce(DVec3::max).unwrap();
    let margin = DVec3::splat((high - low).max_element() / 4.0);
    ConvexPolyhedron::cuboid(low - margin, high + margin).unwrap()
}

#[test]
fn cells_tile_the_window_and_contain_their_vertices() {
    for (name, points) in hard_sets() {
        let delaunay = Delaunay3::build(&points).unwrap();
        let window = window_around(&points);
        let mut carver = delaunay.voronoi().carver(&window);
        let mut sum = 0.0;
        for v in delaunay.vertices() {
            let cell = carver.cell(v);
            assert!(cell.volume() > 0.0, "{name}: {v}");
            assert!(cell.contains(delaunay.point(v)), "{name}: {v}");
            assert!(cell.contains(cell.centroid().unwrap()), "{name}: {v}");
            sum += cell.volume();
        }
        assert!((sum / window.volume() - 1.0).abs() < 1e-12, "{name}: {sum}");
    }
}

/// The cell of a pole has a face for every point of the ring, and their planes meet in one point nearly: corners
/// above a plane once seemed not to hang together there, and some of them stayed.
#[test]
fn large_cells_with_an_apex_tile_the_window() {
    for count in [200, 400, 700] {
        let angle = |i: u32| f64::from(i) / f64::from(count) * std::f64::consts::TAU;
        let ring = (0..count).map(|i| dvec3(angle(i).cos(), angle(i).sin(), 0.0));
        let points: Vec<DVec3> = ring.chain([DVec3::Z, -DVec3::Z]).collect();
        let delaunay = Delaunay3::build(&points).unwrap();
        let window = ConvexPolyhedron::cuboid(DVec3::splat(-3.0), DVec3::splat(3.0)).unwrap();
        let mut carver = delaunay.voronoi().carver(&window);
        let sum: f64 = delaunay.vertices().map(|v| carver.cell(v).volume()).sum();
        assert!((sum / 216.0 - 1.0).abs() < 1e-12, "{count}: {sum}");
    }
}

/// Bisectors of points a few ulps apart all but coincide: only exact sides of corners keep the cells' surfaces sound.
#[test]
fn cells_of_an_ulp_cluster_amid_others_tile_the_window() {
    for (seed, ulps) in (0..20).flat_map(|seed| [(seed, 6.0), (seed, 50.0)]) {
        let cluster = uniform(100, 1000 + seed).into_iter();
        let cluster = cluster.map(|p| DVec3::ONE + (p * ulps).floor() * f64::EPSILON);
        let others = uniform(100, seed).into_iter().map(|p| p * 2.0);
        let points: Vec<DVec3> = cluster.chain(others).collect();
        let delaunay = Delaunay3::build(&points).unwrap();
        let window = ConvexPolyhedron::cuboid(DVec3::ZERO, DVec3::splat(2.0)).unwrap();
        let mut carver = delaunay.voronoi().carver(&window);
        let sum: f64 = delaunay.vertices().map(|v| carver.cell(v).volume()).sum();
        assert!((sum / 8.0 - 1.0).abs() < 1e-12, "{seed} {ulps}: {sum}");
    }
}

#[test]
fn the_cells_of_a_lattice_are_cubes() {
    let delaunay = Delaunay3::build(&lattice([5, 4, 6])).unwrap();
    let window = ConvexPolyhedron::cuboid(DVec3::splat(-0.5), dvec3(4.5, 3.5, 5.5)).unwrap();
    for v in delaunay.vertices() {
        let cell = delaunay.voronoi().cell(v, &window);
        assert_eq!(cell.volume(), 1.0);
        assert_eq!(cell.centroid(), Some(delaunay.point(v)));
        assert_eq!(cell.moments().second, 0.25);
        assert_eq!(cell.faces().count(), 6);
        assert_eq!(cell.corners().len(), 8);
    }
}

/// A cluster of size 1e-9 or 1e-13 in a window of size 1: its inner cells are as good as alone.
#[test]
fn a_large_window_does_not_blur_small_cells() {
    let points = uniform(200, 8);
    let measure = |scale: f64, window: f64| -> Vec<(VertexId, f64)> {
        let scaled: Vec<DVec3> = points.iter().map(|p| (p - 0.5) * scale).collect();
        let delaunay = Delaunay3::build(&scaled).unwrap();
        let window = ConvexPolyhedron::cuboid(-DVec3::splat(window), DVec3::splat(window)).unwrap();
        let mut carver = delaunay.voronoi().carver(&window);
        let mut inner = Vec::new();
        for v in delaunay.vertices() {
            let cell = carver.cell(v);
            let is_inner = |face: PolyhedronFace<'_>| matches!(face.side(), Side::Neighbor(_));
            if cell.faces().all(is_inner) {
                inner.push((v, cell.volume() / scale.powi(3)));
            }
        }
        inner
    };
    let [alone, amid] = [measure(1.0, 2.0), measure(2f64.powi(-43), 1.0)];
    let pairs = || alone.iter().flat_map(|a| amid.iter().map(move |b| (a, b)));
    let common: Vec<_> = pairs().filter(|((v, _), (w, _))| v == w).collect();
    assert!(common.len() > 50);
    for ((v, volume), (_, same)) in common {
        assert!((same / volume - 1.0).abs() < 1e-12, "{v}: {volume} {same}");
    }
}

/// From a vertex to the nearest other.
fn least_distance(delaunay: &Delaunay3, v: VertexId) -> f64 {
    let neighbors = delaunay.mesh().neighbors(v).filter(|u| !u.is_ghost());
    let distances = neighbors.map(|u| delaunay.point(u).distance(delaunay.point(v)));
    distances.fold(f64::INFINITY, f64::min)
}

/// Seen from far away, the bisectors to the points of a cluster are nearly parallel: the better the more the
/// distance exceeds the least one, the less is known about which of them has what share of the face.
#[test]
fn neighbours_share_a_face() {
    for (name, points) in hard_sets() {
        let delaunay = Delaunay3::build(&points).unwrap();
        let window = window_around(&points);
        let vertices = (0..points.len()).map(VertexId::new);
        let cells: Vec<_> = vertices
            .map(|v| delaunay.voronoi().cell(v, &window))
            .collect();
        for v in delaunay.vertices() {
            let surface: f64 = cells[v.index()].faces().map(|face| face.area()).sum();
            for face in cells[v.index()].faces() {
                let Side::Neighbor(u) = face.side() else {
                    continue;
                };
                assert!(delaunay.mesh().find_edge(u, v).is_some(), "{name}");
                let mut back = cells[u.index()].faces();
                let back = back.find(|face| face.side() == Side::Neighbor(v));
                let area = back.map_or(0.0, |face| face.area());
                let [p, q] = [u, v].map(|v| delaunay.point(v));
                let spread =
                    p.distance(q) / least_distance(&delaunay, u).min(least_distance(&delaunay, v));
                assert!(
                    (area - face.area()).abs() < 1e-14 * spread * surface,
                    "{name}: {u} {v}"
                );
                if let Some(back) = back {
                    assert_eq!(back.normal(), -face.normal());
                }
            }
        }
    }
}

#[test]
fn samples_are_in_the_cell_of_their_nearest_vertex() {
    for (name, points) in hard_sets() {
        let delaunay = Delaunay3::build(&points).unwrap();
        let window = window_around(&points);
        let low = window.corners().reduce(DVec3::min).unwrap();
        let high = window.corners().reduce(DVec3::max).unwrap();
        for sample in uniform(100, 9) {
            let sample = low + sample * (high - low);
            let distance = |v: &VertexId| delaunay.point(*v).distance(sample);
            let nearest = delaunay
                .vertices()
                .min_by(|a, b| distance(a).total_cmp(&distance(b)));
            let cell = delaunay.voronoi().cell(nearest.unwrap(), &window);
            assert!(cell.contains(sample), "{name}: {sample}");
        }
    }
}

#[test]
fn what_is_no_vertex_has_no_cell() {
    let mut points = lattice([3, 3, 3]);
    points.push(points[0]);
    let delaunay = Delaunay3::build(&points).unwrap();
    let window = window_around(&points);
    for v in [VertexId::GHOST, VertexId::new(27), VertexId::new(77)] {
        assert!(delaunay.voronoi().cell(v, &window).is_empty());
    }
}

#[test]
fn a_window_that_misses_vertices_is_tiled_by_the_others() {
    let delaunay = Delaunay3::build(&uniform(300, 10)).unwrap();
    let mut window = ConvexPolyhedron::cuboid(DVec3::splat(0.3), DVec3::splat(0.8)).unwrap();
    window.clip(
        &HalfSpace::new(dvec3(1.0, 2.0, -0.5), 1.2).unwrap(),
        Side::Window(6),
    );
    let mut carver = delaunay.voronoi().carver(&window);
    let volumes: Vec<f64> = delaunay
        .vertices()
        .map(|v| carver.cell(v).volume())
        .collect();
    let sum: f64 = volumes.iter().sum();
    assert!((sum / window.volume() - 1.0).abs() < 1e-12, "{sum}");
    assert!(volumes.contains(&0.0));
}

/// Looking at all corners for every neighbour took quadratic time.
#[test]
fn the_center_of_a_sphere_has_a_face_for_every_point_on_it() {
    let count = 20_000;
    let on_sphere = uniform(count, 12)
        .into_iter()
        .map(|p| (p * 2.0 - 1.0).normalize());
    let points: Vec<DVec3> = on_sphere.chain([DVec3::ZERO]).collect();
    let delaunay = Delaunay3::build(&points).unwrap();
    let window = ConvexPolyhedron::cuboid(-DVec3::ONE, DVec3::ONE).unwrap();
    let cell = delaunay.voronoi().cell(VertexId::new(count), &window);
    assert_eq!(cell.faces().count(), count);
    assert_eq!(cell.corners().len(), 2 * count - 4);
    let inner_ball = std::f64::consts::PI / 6.0;
    assert!(
        (inner_ball..1.01 * inner_ball).contains(&cell.volume()),
        "{}",
        cell.volume()
    );
    let flux: DVec3 = cell.faces().map(|face| face.area() * face.normal()).sum();
    assert!(flux.length() < 1e-12, "{flux}");
}

/// Sets without facets that are so thin that their centers are beyond comparison.
fn round_sets() -> Vec<(&'static str, Vec<DVec3>)> {
    let names = [
        "uniform",
        "lattice",
        "shell",
        "snapped, with duplicates",
        "four",
    ];
    let sets = hard_sets().into_iter();
    sets.filter(|(name, _)| names.contains(name)).collect()
}

/// Whether `p` is at the same distance from all of `vertices`, and no nearer to any other vertex.
fn is_between(delaunay: &Delaunay3, p: DVec3, vertices: &[VertexId]) -> bool {
    let distance = |v: VertexId| delaunay.point(v).distance(p);
    let least = delaunay
        .vertices()
        .map(distance)
        .fold(f64::INFINITY, f64::min);
    let error = 1e-13 * p.length().max(1.0);
    vertices.iter().all(|&v| distance(v) <= least + error)
}

#[test]
fn edges_join_the_centers_of_tetrahedra_and_rays_leave_the_hull() {
    for (name, points) in round_sets() {
        let delaunay = Delaunay3::build(&points).unwrap();
        let (mesh, mut rays) = (delaunay.mesh(), 0);
        for (f, edge) in delaunay.voronoi().edges() {
            let corners = mesh.facet_vertices(f);
            let [a, b, c] = corners.map(|v| delaunay.point(v));
            let (from, to) = match edge {
                VoronoiEdge3::Segment { from, to } => (from, to),
                VoronoiEdge3::Ray { from, direction } => {
                    rays += 1;
                    assert!((direction.length() - 1.0).abs() < 1e-15);
                    (from, from + direction)
                }
            };
            assert!(is_between(&delaunay, from, &corners), "{name}: {f}");
            assert!(is_between(&delaunay, to, &corners), "{name}: {f}");
            // The edge crosses outwards.
            let outwards = (b - a).cross(c - a);
            assert!(
                (to - from).dot(outwards) >= -1e-13 * from.length().max(1.0),
                "{name}: {f}"
            );
        }
        assert_eq!(rays, delaunay.hull().count(), "{name}");
        let facets = mesh.facets().count() / 2;
        assert_eq!(
            delaunay.voronoi().edges().count(),
            facets - 3 * rays / 2,
            "{name}"
        );
    }
}

#[test]
fn facets_turn_counterclockwise_round_their_delaunay_edge() {
    for (name, points) in round_sets() {
        let delaunay = Delaunay3::build(&points).unwrap();
        let (mut bounded, mut unbounded) = (0, 0);
        for VoronoiFacet3 {
            edge,
            corners,
            rays,
        } in delaunay.voronoi().facets()
        {
            let [p, q] = edge.map(|v| delaunay.point(v));
            let axis = (q - p).normalize();
            let mut outline = corners;
            match rays {
                None => bounded += 1,
                Some([first, last]) => {
                    unbounded += 1;
                    let ends = [outline[0] + first, outline[outline.len() - 1] + last];
                    outline.insert(0, ends[0]);
                    outline.push(ends[1]);
                }
            }
            assert!(
                outline
                    .iter()
                    .all(|&corner| is_between(&delaunay, corner, &edge)),
                "{name}"
            );
            let turns = outline.windows(2).skip(1);
            let areas =
                turns.map(|turn| (turn[0] - outline[0]).cross(turn[1] - outline[0]).dot(axis));
            let size = outline
                .iter()
                .map(|corner| corner.length())
                .fold(1.0, f64::max);
            assert!(
                areas.into_iter().all(|area| area >= -1e-13 * size * size),
                "{name}: {edge:?}"
            );
        }
        let hull = delaunay.hull().count();
        assert_eq!(unbounded, 3 * hull / 2, "{name}");
        // Euler: vertices - edges + triangles - tetrahedra = 1 for the ball that is the hull.
        let tets = delaunay.tets().count();
        let triangles = (4 * tets + hull) / 2;
        assert_eq!(
            bounded + unbounded + tets + 1,
            delaunay.vertex_count() + triangles,
            "{name}"
        );
    }
}

#[test]
fn facets_are_the_faces_of_cells() {
    let delaunay = Delaunay3::build(&uniform(100, 11)).unwrap();
    let window = ConvexPolyhedron::cuboid(DVec3::splat(-1e3), DVec3::splat(1e3)).unwrap();
    for VoronoiFacet3 {
        edge: [v, u],
        corners,
        rays,
    } in delaunay.voronoi().facets()
    {
        if rays.is_some() || corners.iter().any(|corner| corner.length() > 3.0) {
            continue;
        }
        let cell = delaunay.voronoi().cell(v, &window);
        let face = cell
            .faces()
            .find(|face| face.side() == Side::Neighbor(u))
            .unwrap();
        assert_eq!(face.corners().count(), corners.len());
        for corner in face.corners() {
            assert!(corners.iter().any(|c| c.distance(corner) < 1e-12));
        }
    }
}

fn half_space() -> impl Strategy<Value = HalfSpace> {
    // Often through corners and along faces of the cube, often nearly.
    let number = prop_oneof![
        3 => (-2_i32..=2).prop_map(f64::from),
        1 => -2.0..2.0,
        1 => (-2_i32..=2, -2_i32..=2).prop_map(|(base, ulps)| {
            f64::from(base) * (1.0 + f64::from(ulps) * f64::EPSILON)
        }),
    ];
    let numbers = prop::array::uniform4(number);
    numbers.prop_filter_map("no normal", |[x, y, z, limit]| {
        HalfSpace::new(dvec3(x, y, z), limit).ok()
    })
}

fn cube() -> ConvexPolyhedron {
    ConvexPolyhedron::cuboid(-DVec3::ONE, DVec3::ONE).unwrap()
}

fn clipped<'a>(cuts: impl IntoIterator<Item = &'a HalfSpace>) -> ConvexPolyhedron {
    let mut polyhedron = cube();
    for (number, cut) in cuts.into_iter().enumerate() {
        polyhedron.clip(cut, Side::Window(6 + number as u32));
    }
    polyhedron
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(500))]

    #[test]
    fn the_two_sides_of_a_cut_add_up(cuts in prop::collection::vec(half_space(), 0..8), cut in half_space()) {
        let whole = clipped(&cuts);
        let (mut front, mut back) = (whole.clone(), whole.clone());
        front.clip(&cut, Side::Window(90));
        back.clip(&cut.complement(), Side::Window(91));
        prop_assert!((front.volume() + back.volume() - whole.volume()).abs() < 1e-12);
        let area = |polyhedron: &ConvexPolyhedron, number| -> f64 {
            let faces = polyhedron.faces().filter(|face| face.side() == Side::Window(number));
            faces.map(|face| face.area()).sum()
        };
        if front.volume() > 1e-9 && back.volume() > 1e-9 {
            prop_assert!((area(&front, 90) - area(&back, 91)).abs() < 1e-6);
        }
    }

    #[test]
    fn clipping_twice_is_clipping_once(cuts in prop::collection::vec(half_space(), 1..8)) {
        let once = clipped(&cuts);
        let twice = clipped(cuts.iter().chain(&cuts));
        prop_assert!((once.volume() - twice.volume()).abs() < 1e-12);
    }

    #[test]
    fn the_order_of_half_spaces_does_not_matter(cuts in prop::collection::vec(half_space(), 1..12)) {
        let forth = clipped(&cuts);
        let back = clipped(cuts.iter().rev());
        prop_assert!((forth.volume() - back.volume()).abs() < 1e-12);
        let corners = forth.corners().chain(back.corners());
        prop_assert!(corners.clone().all(|corner| corner.abs().max_element() <= 1.0 + 1e-12));
    }

    #[test]
    fn no_finite_half_space_leaves_what_is_not_a_number(
        cuts in prop::collection::vec(prop::array::uniform4(any::<f64>()), 0..8),
        low in prop::array::uniform3(any::<f64>()),
    ) {
        let low = DVec3::from(low).clamp(DVec3::splat(-1e60), DVec3::splat(1e60));
        let window = ConvexPolyhedron::cuboid(low, low + low.abs().max(DVec3::splat(1e-40)));
        let mut polyhedron = window.unwrap_or_else(|_| cube());
        for [x, y, z, limit] in cuts {
            let Ok(half_space) = HalfSpace::new(dvec3(x, y, z), limit) else { continue };
            polyhedron.clip(&half_space, Side::Window(6));
            prop_assert!(polyhedron.corners().all(DVec3::is_finite));
            prop_assert!(polyhedron.volume().is_finite());
            prop_assert!(polyhedron.moments().second.is_finite());
            prop_assert!(polyhedron.faces().all(|face| face.area().is_finite() && face.normal().is_normalized()));
        }
    }

    #[test]
    fn a_closed_surface_has_no_flux(cuts in prop::collection::vec(half_space(), 0..12)) {
        let polyhedron = clipped(&cuts);
        let flux: DVec3 = polyhedron.faces().map(|face| face.area() * face.normal()).sum();
        prop_assert!(flux.length() < 1e-12, "{}", flux);
    }

    #[test]
    fn cells_of_any_cloud_tile_the_window(points in prop::collection::vec(prop::array::uniform3(-3_i32..=3), 4..40)) {
        let points: Vec<DVec3> = points.iter().map(|p| DVec3::from(p.map(f64::from))).collect();
        let Ok(delaunay) = Delaunay3::build(&points) else { return Ok(()) };
        let window = ConvexPolyhedron::cuboid(DVec3::splat(-4.0), DVec3::splat(4.0)).unwrap();
        let mut carver = delaunay.voronoi().carver(&window);
        let sum: f64 = delaunay.vertices().map(|v| carver.cell(v).volume()).sum();
        prop_assert!((sum - 512.0).abs() < 1e-9, "{}", sum);
    }
}
