//! Triangles judged: every kind of defect, what is repaired, and how triangles of bodies are turned.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

mod clouds;

use clouds::space::{lattice, rng, uniform};
use delaunay_core::progress::{Progress, silent};
use delaunay_core::{
    DefectKind, Delaunay3, Domain3, Domain3Options, DomainDefects, DomainError, Repairs, TetId,
    VertexId, triangles_intersect,
};
use fixtures::surfaces;
use glam::DVec3;
use proptest::prelude::*;
use rand::RngExt;
use rayon::ThreadPoolBuilder;
use std::collections::BTreeSet;
use std::ops::ControlFlow;

/// Points, and triangles as triples of their indices.
#[derive(Clone, Debug, Default)]
struct Soup {
    points: Vec<DVec3>,
    triangles: Vec<[VertexId; 3]>,
}

impl Soup {
    fn of(points: &[[i32; 3]], triangles: &[[usize; 3]]) -> Self {
        let points = points.iter().map(|p| DVec3::from(p.map(f64::from)));
        let named = triangles.iter().map(|corners| corners.map(VertexId::new));
        Self {
            points: points.collect(),
            triangles: named.collect(),
        }
    }

    /// The cube between two corners, outward.
    fn cube(low: i32, high: i32) -> Self {
        let corner = |i: i32| [i & 1, i >> 1 & 1, i >> 2].map(|bit| [low, high][bit as usize]);
        let squares = [
            [0, 2, 3, 1],
            [4, 5, 7, 6],
            [0, 1, 5, 4],
            [2, 6, 7, 3],
            [0, 4, 6, 2],
            [1, 3, 7, 5],
        ];
        let halves = squares.map(|[a, b, c, d]| [[a, b, c], [a, c, d]]);
        let corners: Vec<_> = (0..8).map(corner).collect();
        Self::of(&corners, halves.as_flattened())
    }

    fn tetrahedron() -> Self {
        let corners = [[0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 4]];
        Self::of(&corners, &TETRAHEDRON)
    }

    fn and(mut self, other: &Self) -> Self {
        let shift = self.points.len();
        let shifted = |v: VertexId| VertexId::new(v.index() + shift);
        let triangles = other.triangles.iter().map(|corners| corners.map(shifted));
        self.triangles.extend(triangles);
        self.points.extend(&other.points);
        self
    }

    fn flipped(mut self, flip: impl Fn(usize) -> bool) -> Self {
        let flipped = (0..self.triangles.len()).filter(|&i| flip(i));
        flipped.for_each(|i| self.triangles[i].swap(0, 1));
        self
    }

    fn build(&self, options: Domain3Options) -> Result<(Domain3, Repairs), DomainError> {
        Domain3::build(&self.points, &self.triangles, options, &mut silent)
    }

    /// What is wrong when nothing is repaired.
    fn defects(&self) -> DomainDefects {
        self.defects_with(Domain3Options::default())
    }

    fn defects_with(&self, options: Domain3Options) -> DomainDefects {
        match self.build(options) {
            Err(DomainError::Defects(defects)) => *defects,
            other => panic!("{other:?}"),
        }
    }

    fn volumes(&self) -> Vec<f64> {
        let (domain, _) = self.build(Domain3Options::default()).unwrap();
        let shells = domain.shells();
        shells.iter().map(|shell| shell.volume).collect()
    }
}

const TETRAHEDRON: [[usize; 3]; 4] = [[1, 2, 3], [2, 0, 3], [0, 1, 3], [2, 1, 0]];

const WELD: Domain3Options = Domain3Options {
    weld: true,
    drop_unused: false,
    interfaces: false,
    dangling: false,
    most_intersections: 10_000,
};

const DROP: Domain3Options = Domain3Options {
    drop_unused: true,
    weld: false,
    ..WELD
};

const INTERFACES: Domain3Options = Domain3Options {
    interfaces: true,
    weld: false,
    ..WELD
};

#[test]
fn points_out_of_range_are_all_listed_and_the_rest_is_judged() {
    let mut soup = Soup::tetrahedron();
    soup.points[1].y = f64::NAN;
    soup.points[3].z = 1e308;
    soup.points.push(DVec3::splat(f64::NEG_INFINITY));
    insta::assert_snapshot!(soup.defects());
    let defects = soup.defects();
    let named: Vec<_> = defects.iter().map(|defect| defect.vertices()).collect();
    assert_eq!(named[0], [VertexId::new(1)]);
}

#[test]
fn huge_indices_and_the_ghost_are_no_points() {
    let mut soup = Soup::tetrahedron();
    soup.triangles[2][0] = VertexId::new(VertexId::LIMIT - 1);
    soup.triangles.push([VertexId::GHOST; 3]);
    insta::assert_snapshot!(soup.defects());
    let nothing = Soup::of(&[], &[[0, 1, 2]]).defects();
    assert_eq!(nothing.count_of(DefectKind::NoSuchCorner), 3);
    assert_eq!(nothing.count(), 3);
}

#[test]
fn no_triangles_are_no_surface() {
    for points in [&[][..], &[[1, 2, 3]]] {
        let error = Soup::of(points, &[]).build(WELD).unwrap_err();
        assert_eq!(error, DomainError::Empty);
        assert!(error.defects().is_none());
    }
    insta::assert_snapshot!(DomainError::Empty, @"the surface has no triangles");
}

#[test]
fn triangles_without_area_are_told_from_those_with_a_corner_twice() {
    let flat = Soup::of(
        &[[0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 4], [2, 0, 0]],
        &[TETRAHEDRON.as_slice(), &[[0, 4, 1], [2, 2, 3]]].concat(),
    );
    insta::assert_snapshot!(flat.defects());
}

/// A tetrahedron with one edge divided on one side only, closed by a triangle without area.
#[test]
fn a_triangle_without_area_is_one_to_its_neighbours() {
    let triangles = [
        [1, 2, 3],
        [2, 0, 3],
        [0, 1, 3],
        [2, 1, 4],
        [2, 4, 0],
        [1, 0, 4],
    ];
    let soup = Soup::of(
        &[[0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 4], [2, 0, 0]],
        &triangles,
    );
    let defects = soup.defects();
    assert_eq!(defects.no_area.len(), 1);
    // The middle of the edge is on the triangle that has the whole edge.
    let count = defects.count_of(DefectKind::Intersection);
    assert_eq!(defects.count(), 1 + count, "{defects}");
}

#[test]
fn points_at_one_place_are_welded_when_asked() {
    let given = Soup::tetrahedron();
    let each = |corners: &[VertexId; 3]| corners.map(|v| given.points[v.index()]);
    let mut apart = Soup {
        points: given.triangles.iter().flat_map(each).collect(),
        triangles: Vec::new(),
    };
    let corners = (0..12).map(VertexId::new).collect::<Vec<_>>();
    apart.triangles = corners.chunks(3).map(|c| [c[0], c[1], c[2]]).collect();
    apart.points[4] = DVec3::new(-0.0, 0.0, -0.0);
    insta::assert_snapshot!(apart.defects());
    let (domain, repairs) = apart.build(WELD).unwrap();
    assert_eq!(domain.points().len(), 4);
    assert_eq!(repairs.welded.len(), 8);
    assert!(repairs.dropped.is_empty() && repairs.turned.is_empty());
    for (v, kept) in corners.iter().zip(&repairs.vertices) {
        assert_eq!(
            apart.points[v.index()],
            domain.points()[kept.unwrap().index()]
        );
    }
    assert_eq!(domain.triangles()[0], [0, 1, 2].map(VertexId::new));
    assert_eq!(domain.shells().len(), 1);
}

#[test]
fn a_triangle_that_welding_robs_of_a_corner_has_no_area() {
    let mut soup = Soup::tetrahedron();
    soup.points.push(soup.points[1]);
    soup.triangles.push([0, 1, 4].map(VertexId::new));
    let defects = soup.defects_with(WELD);
    insta::assert_snapshot!(defects, @r"
    the surface has defects:
    1 triangle without area: triangle 4 has no area: its corners v0 (0.0, 0.0, 0.0), v1 (4.0, 0.0, 0.0) and v4 (4.0, 0.0, 0.0) are on one line
    ");
    let unrepaired = soup.defects();
    assert_eq!((unrepaired.count(), unrepaired.coincident.len()), (2, 1));
}

#[test]
fn points_that_are_no_corners_are_dropped_when_asked() {
    let mut soup = Soup::tetrahedron();
    soup.points.insert(0, DVec3::ONE);
    soup.points.push(DVec3::X);
    // Where a corner is, and still no corner.
    soup.points.push(soup.points[2]);
    for v in soup.triangles.as_flattened_mut() {
        *v = VertexId::new(v.index() + 1);
    }
    insta::assert_snapshot!(soup.defects());
    let (domain, repairs) = soup.build(DROP).unwrap();
    assert_eq!(domain.points(), Soup::tetrahedron().points);
    assert_eq!(domain.triangles(), Soup::tetrahedron().triangles);
    assert_eq!(repairs.dropped, [0, 5, 6].map(VertexId::new));
    assert_eq!(repairs.vertices[5..], [None, None]);
    let welded = soup.defects_with(WELD);
    assert_eq!((welded.count(), welded.unused.len()), (2, 2));
}

#[test]
fn triangles_given_twice_count_once() {
    let mut soup = Soup::tetrahedron();
    soup.triangles.push([3, 2, 1].map(VertexId::new));
    soup.triangles.push([3, 1, 2].map(VertexId::new));
    insta::assert_snapshot!(soup.defects());
}

#[test]
fn open_edges_are_listed_and_follow_one_another_round_holes() {
    let mut box_without_lids = Soup::cube(0, 1);
    box_without_lids.triangles.drain(..4);
    insta::assert_snapshot!(box_without_lids.defects());
    let holes = box_without_lids.defects().holes;
    assert!(
        holes
            .iter()
            .all(|hole| hole.closed && hole.edge_count() == 4)
    );
    let dangling = Domain3Options {
        dangling: true,
        ..INTERFACES
    };
    assert!(box_without_lids.build(dangling).is_ok());
    assert_eq!(
        box_without_lids.defects_with(INTERFACES).open_edges.len(),
        8
    );
}

#[test]
fn an_odd_number_of_triangles_at_an_edge_separates_regions_or_is_wrong() {
    let halves = two_halves();
    insta::assert_snapshot!(halves.defects());
    let (domain, repairs) = halves.build(INTERFACES).unwrap();
    assert!(repairs.is_empty() && domain.has_interfaces());
    assert_eq!(domain.shells().len(), 1);
}

/// Two tetrahedra with a common triangle between them.
fn two_halves() -> Soup {
    let places = [[0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 4], [0, 0, -4]];
    let below = [[1, 4, 2], [2, 4, 0], [0, 4, 1]];
    Soup::of(&places, &[TETRAHEDRON.as_slice(), &below].concat())
}

/// A strip of five triangles with a half twist.
#[test]
fn a_moebius_strip_has_one_side_and_one_rim() {
    let strip = [0, 1, 2, 3, 4].map(|i| [i, (i + 1) % 5, (i + 2) % 5]);
    let places = [[0, 0, 0], [2, 0, 1], [3, 2, 0], [1, 4, 2], [-1, 2, 1]];
    let soup = Soup::of(&places, &strip);
    insta::assert_snapshot!(soup.defects());
    let dangling = Domain3Options {
        dangling: true,
        ..INTERFACES
    };
    let defects = soup.defects_with(dangling);
    assert_eq!(defects.one_sided.len(), 1);
}

/// Closed, every edge with two triangles, one side: no such surface fits into space.
#[test]
fn a_projective_plane_has_one_side_and_intersects_itself() {
    let places = [
        [0, 0, 0],
        [3, 0, 1],
        [1, 4, 0],
        [-2, 2, 1],
        [-2, -3, 1],
        [1, -2, 5],
    ];
    let fan = [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5], [0, 5, 1]];
    let rest = [[1, 2, 4], [2, 3, 5], [3, 4, 1], [4, 5, 2], [5, 1, 3]];
    let defects = Soup::of(&places, &[fan, rest].concat()).defects();
    assert_eq!(defects.one_sided.len(), 1);
    assert_eq!(
        (defects.one_sided[0].first, defects.one_sided[0].triangles),
        (0, 10)
    );
    assert!(!defects.intersections.is_empty());
    assert_eq!(defects.count(), 1 + defects.intersections.len());
}

/// A grid whose columns close to a ring after a reflection; with another reflection it is a torus.
fn ring_of_columns(reflected: bool) -> Soup {
    let (columns, rows) = (8, 6);
    let vertex = |column: usize, row: usize| {
        let reflect = reflected && column == columns;
        let row = if reflect { rows - row % rows } else { row };
        (column % columns) * rows + row % rows
    };
    let square = |i: usize| {
        let (column, row) = (i / rows, i % rows);
        let [a, b] = [0, 1].map(|step| vertex(column + step, row));
        let [d, c] = [0, 1].map(|step| vertex(column + step, row + 1));
        [[a, b, c], [a, c, d]]
    };
    // Exact whatever the machine: integer points near circles.
    let large = [
        [9, 0],
        [6, 6],
        [0, 9],
        [-6, 6],
        [-9, 0],
        [-6, -6],
        [0, -9],
        [6, -6],
    ];
    let small = [[2, 0], [1, 2], [-1, 2], [-2, 0], [-1, -2], [1, -2]];
    let place = |i: usize| {
        let ([x, y], [out, z]) = (large[i / rows], small[i % rows]);
        [x * (9 + out), y * (9 + out), 9 * z]
    };
    let places: Vec<_> = (0..columns * rows).map(place).collect();
    let triangles: Vec<_> = (0..columns * rows).flat_map(square).collect();
    Soup::of(&places, &triangles)
}

#[test]
fn a_klein_bottle_has_one_side_and_a_torus_two() {
    let torus = ring_of_columns(false);
    let volumes = torus.volumes();
    assert!(volumes.len() == 1 && volumes[0] > 0.0, "{volumes:?}");
    let bottle = ring_of_columns(true).defects();
    assert_eq!(bottle.one_sided.len(), 1);
    assert!(!bottle.intersections.is_empty());
    assert_eq!(bottle.count(), 1 + bottle.intersections.len());
}

#[test]
fn bodies_may_touch_at_a_vertex_and_along_an_edge() {
    let other = |[a, b, c, d]: [usize; 4]| [[b, c, d], [c, a, d], [a, b, d], [c, b, a]];
    let first = [[0, 0, 0], [0, 0, 6], [6, 0, 0], [6, 6, 0]];
    let at_vertex = [[-6, 0, 0], [-6, -6, 0], [-6, 0, -6]];
    let triangles = [other([0, 1, 2, 3]), other([0, 4, 5, 6])].concat();
    let touching = Soup::of(&[first.as_slice(), &at_vertex].concat(), &triangles);
    assert_eq!(touching.volumes(), [36.0, 36.0]);
    let at_edge = [[-6, 0, 0], [-6, -6, 0]];
    let triangles = [other([0, 1, 2, 3]), other([0, 1, 4, 5])].concat();
    let touching = Soup::of(&[first.as_slice(), &at_edge].concat(), &triangles);
    assert_eq!(touching.volumes(), [72.0]);
    let turned = touching.flipped(|i| i > 4);
    assert_eq!(turned.volumes(), [72.0]);
}

#[test]
fn normals_point_out_of_bodies_and_into_voids() {
    let inverted = Soup::cube(0, 2).flipped(|_| true);
    let (_, repairs) = inverted.build(Domain3Options::default()).unwrap();
    assert_eq!(repairs.turned, (0..12).collect::<Vec<_>>());
    assert_eq!(inverted.volumes(), [8.0]);
    let nested = Soup::cube(0, 8)
        .and(&Soup::cube(1, 7))
        .and(&Soup::cube(2, 4))
        .and(&Soup::cube(5, 6))
        .and(&Soup::cube(9, 10));
    assert_eq!(nested.volumes(), [512.0, -216.0, 8.0, 1.0, 1.0]);
    let (_, repairs) = nested.build(Domain3Options::default()).unwrap();
    assert_eq!(repairs.turned, (12..24).collect::<Vec<_>>());
    // Bodies in one another are regions, whose triangles have no side of their own.
    assert!(nested.build(INTERFACES).unwrap().1.is_empty());
}

#[test]
fn regions_agree_patch_by_patch_with_as_few_triangles_turned_as_possible() {
    let turned = two_halves().flipped(|i| i == 1 || i == 5);
    let (domain, repairs) = turned.build(INTERFACES).unwrap();
    assert_eq!(repairs.turned, [1, 5]);
    let sides = |soup: &[[VertexId; 3]]| soup.iter().map(|&c| rotated(c)).collect::<Vec<_>>();
    assert_eq!(sides(domain.triangles()), sides(&two_halves().triangles));
}

/// The corners from the smallest on.
fn rotated([a, b, c]: [VertexId; 3]) -> [VertexId; 3] {
    let turns = [[a, b, c], [b, c, a], [c, a, b]];
    turns.into_iter().min().unwrap()
}

#[test]
fn the_surfaces_of_the_sink_paper_are_valid_as_they_are() {
    for set in [surfaces::cuboctahedron(), surfaces::star()] {
        let named = set.triangles.iter().map(|c| c.map(VertexId::new));
        let triangles: Vec<_> = named.collect();
        let options = Domain3Options::default();
        let built = Domain3::build(&set.points, &triangles, options, &mut silent);
        let (domain, repairs) = built.unwrap();
        assert!(repairs.is_empty());
        assert_eq!(
            (domain.points(), domain.triangles()),
            (&*set.points, &*triangles)
        );
        assert!(
            domain
                .shells()
                .iter()
                .all(|shell| shell.volume > 0.0 && shell.area > 0.0)
        );
    }
}

#[test]
fn markers_are_one_for_each_triangle() {
    let soup = Soup::tetrahedron();
    let domain = Domain3::new(&soup.points, &soup.triangles).unwrap();
    assert_eq!(domain.markers(), None);
    let marked = domain.clone().with_markers(vec![3, 1, 4, 1]).unwrap();
    assert_eq!(marked.markers(), Some(&[3, 1, 4, 1][..]));
    let error = domain.with_markers(vec![3]).unwrap_err();
    insta::assert_snapshot!(error, @"1 markers for 4 triangles");
}

#[test]
fn the_report_stops_every_stage() {
    let soup = Soup::cube(0, 1);
    for stage in ["check triangles", "find intersections", "turn outwards"] {
        let mut stop = |progress: Progress| match progress.stage == stage {
            true => ControlFlow::Break(()),
            false => ControlFlow::Continue(()),
        };
        let options = Domain3Options::default();
        let stopped = Domain3::build(&soup.points, &soup.triangles, options, &mut stop);
        let error = stopped.unwrap_err();
        assert!(error.to_string().contains(stage), "{error}");
        assert!(matches!(error, DomainError::Cancelled(_)));
    }
}

#[test]
fn intersections_are_listed_up_to_a_limit() {
    let soup = random_triangles(7, 300, 6);
    let unlimited = Domain3Options {
        most_intersections: usize::MAX,
        ..DROP
    };
    let all = soup.defects_with(unlimited).intersections;
    assert!(all.len() > 2000);
    for most in [0, 1, 2000, all.len(), usize::MAX] {
        let defects = soup.defects_with(Domain3Options {
            most_intersections: most,
            ..DROP
        });
        assert_eq!(defects.intersections, all[..most.min(all.len())]);
        assert_eq!(defects.more_intersections, most < all.len());
        let summary = defects.summary(DefectKind::Intersection).unwrap();
        assert_eq!(summary.starts_with("at least"), most < all.len());
    }
}

/// Triangles with corners on a small lattice, some without area, some twice.
fn random_triangles(seed: u64, count: usize, side: usize) -> Soup {
    let mut random = rng(seed);
    let points = lattice([side as u32; 3]);
    let mut corner = || VertexId::new(random.random_range(0..points.len()));
    let triangles = (0..count).map(|_| [(); 3].map(|()| corner())).collect();
    Soup { points, triangles }
}

#[test]
fn the_answer_does_not_depend_on_the_number_of_threads() {
    let soup = random_triangles(3, 3000, 12);
    let on = |threads: usize| {
        let pool = ThreadPoolBuilder::new().num_threads(threads).build();
        pool.unwrap().install(|| soup.defects())
    };
    let alone = on(1);
    assert!(alone.more_intersections);
    assert_eq!(alone, on(2));
    assert_eq!(alone, on(5));
}

/// The triangles round random tetrahedra of a triangulation, outward; bodies touch, and there are voids.
fn round_tetrahedra(seed: u64, points: Vec<DVec3>) -> Soup {
    let delaunay = Delaunay3::build(&points).unwrap();
    let mesh = delaunay.mesh();
    let mut random = rng(seed);
    let keep: Vec<bool> = (0..mesh.tet_slots()).map(|_| random.random()).collect();
    let kept = |t: TetId| !mesh.is_ghost_tet(t) && keep[t.index()];
    let outer = mesh.facets();
    let outer = outer.filter(|&f| kept(f.tet()) && !kept(mesh.twin(f).tet()));
    Soup {
        triangles: outer.map(|f| mesh.facet_vertices(f)).collect(),
        points,
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// On a lattice nearly all triangles that meet touch, many in one plane.
    #[test]
    fn all_pairs_that_intersect_are_listed_and_no_others(seed in any::<u64>(), count in 1_usize..60, side in 2_usize..6) {
        let soup = random_triangles(seed, count, side);
        let defects = soup.defects_with(Domain3Options { most_intersections: usize::MAX, ..DROP });
        let unfit: BTreeSet<usize> = defects.iter().filter_map(|defect| match defect.kind() {
            DefectKind::RepeatedCorner | DefectKind::NoArea => Some(defect.triangles()[0]),
            DefectKind::RepeatedTriangle => Some(defect.triangles()[1]),
            _ => None,
        }).collect();
        let place = |v: VertexId| soup.points[v.index()];
        let fit: Vec<usize> = (0..count).filter(|i| !unfit.contains(i)).collect();
        let pairs = fit.iter().flat_map(|&i| fit.iter().map(move |&j| (i, j))).filter(|(i, j)| i < j);
        let expected: Vec<_> = pairs
            .filter(|&(i, j)| triangles_intersect(place, soup.triangles[i], soup.triangles[j]))
            .collect();
        let found: Vec<_> = defects.intersections.iter().map(|of| (of.first, of.second)).collect();
        prop_assert_eq!(found, expected);
    }

    /// Every edge of such a surface has an even number of triangles; those with four part patches.
    #[test]
    fn flipped_triangles_of_bodies_are_turned_back(seed in any::<u64>(), count in 5_u32..40, on_lattice: bool) {
        let points = if on_lattice { lattice([3, 3, count / 9 + 2]) } else { uniform(count as usize, seed) };
        let whole = round_tetrahedra(seed, points);
        prop_assume!(!whole.triangles.is_empty());
        let mut random = rng(!seed);
        let flips: Vec<bool> = whole.triangles.iter().map(|_| random.random()).collect();
        let given = whole.clone().flipped(|i| flips[i]);
        let (domain, repairs) = given.build(DROP).unwrap();
        let flipped: Vec<usize> = (0..flips.len()).filter(|&i| flips[i]).collect();
        prop_assert_eq!(repairs.turned, flipped);
        let kept = |v: VertexId| repairs.vertices[v.index()].unwrap();
        let expected: Vec<_> = whole.triangles.iter().map(|&c| rotated(c.map(kept))).collect();
        let found: Vec<_> = domain.triangles().iter().map(|&c| rotated(c)).collect();
        prop_assert_eq!(found, expected);
        let again = Domain3::build(domain.points(), domain.triangles(), Domain3Options::default(), &mut silent);
        prop_assert_eq!(again, Ok((domain, Repairs {
            vertices: (0..repairs.vertices.iter().flatten().count()).map(|i| Some(VertexId::new(i))).collect(),
            ..Repairs::default()
        })));
    }

    /// Whatever is given, everything is said and nothing panics.
    #[test]
    fn random_triangles_are_judged_without_panic(seed in any::<u64>(), count in 1_usize..40, wild: bool, weld: bool, interfaces: bool, dangling: bool) {
        let mut soup = random_triangles(seed, count, 3);
        if wild {
            let mut random = rng(seed);
            for value in [f64::NAN, f64::INFINITY, 1e308, 1e-300] {
                let index = random.random_range(0..soup.points.len());
                soup.points[index].y = value;
            }
            soup.points.truncate(25);
            soup.points[3] = soup.points[4];
        }
        let options = Domain3Options { weld, interfaces, dangling, ..Domain3Options::default() };
        if let Err(error) = soup.build(options) {
            let defects = error.defects().unwrap();
            prop_assert_eq!(defects.iter().count(), defects.count());
            prop_assert!(defects.iter().all(|defect| !defect.to_string().is_empty()));
            let holes = &defects.holes;
            prop_assert_eq!(holes.iter().map(delaunay_core::Hole::edge_count).sum::<usize>(), defects.open_edges.len());
        }
    }
}
