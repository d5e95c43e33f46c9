//! Triangles in a fixed boundary: whatever is done to them, they stay a triangulation of the same region.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use delaunay_core::geo_predicates::{Sign, in_circle_perturbed, orient2d};
use delaunay_core::progress::silent;
use delaunay_core::{
    BuildOptions, Complex2, Constrained2, Crossings, FaceId, HalfEdgeId, VertexId,
};
use glam::DVec2;
use proptest::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

fn ids(segments: &[[usize; 2]]) -> Vec<[VertexId; 2]> {
    let named = segments.iter().map(|ends| ends.map(VertexId::new));
    named.collect()
}

/// The triangles between points, cut apart along segments.
fn cut(points: &[DVec2], segments: &[[usize; 2]]) -> Complex2 {
    let crossings = Crossings::Divide { at_most: 1000 };
    let options = BuildOptions::default();
    let built = Constrained2::build(points, &ids(segments), crossings, options, &mut silent);
    Complex2::of(built.unwrap().subcomplex(|_| true))
}

/// The edges on the boundary, from inside, and how often each comes.
fn boundary(complex: &Complex2) -> BTreeMap<[VertexId; 2], usize> {
    let mesh = complex.mesh();
    let mut edges = BTreeMap::new();
    for h in complex.faces().flat_map(FaceId::half_edges) {
        if complex.is_boundary(h) {
            *edges.entry([mesh.origin(h), mesh.target(h)]).or_insert(0) += 1;
        }
    }
    edges
}

fn area(complex: &Complex2) -> f64 {
    let areas = complex.faces().map(|f| {
        let [a, b, c] = complex.triangle(f);
        (b - a).perp_dot(c - a) / 2.0
    });
    areas.sum()
}

/// Vertices less edges and faces, where the two sides of a cut are two edges.
fn euler_characteristic(complex: &Complex2) -> isize {
    let mesh = complex.mesh();
    let corners = complex.faces().flat_map(|f| mesh.face_vertices(f));
    let vertices = corners.collect::<BTreeSet<_>>().len();
    let faces = complex.faces().count();
    let edges = (3 * faces + boundary(complex).values().sum::<usize>()) / 2;
    vertices as isize - edges as isize + faces as isize
}

/// Checks without a word from the complex itself that its triangles are glued along common edges, turn counterclockwise and that
/// their vertices know them and whether they are inside.
fn check(complex: &Complex2) {
    assert_eq!(complex.check(), Ok(()));
    let mesh = complex.mesh();
    let mut edges = BTreeSet::new();
    for f in complex.faces() {
        let [a, b, c] = complex.triangle(f);
        assert_eq!(orient2d(a, b, c), Sign::Positive, "{f}");
        for h in f.half_edges() {
            let ends = [mesh.origin(h), mesh.target(h)];
            let twin = mesh.twin(h);
            assert!(edges.insert(ends), "{h} is there twice");
            assert_eq!([mesh.target(twin), mesh.origin(twin)], ends);
            assert!(twin != h && mesh.twin(twin) == h);
            let outgoing = mesh.outgoing(ends[0]).unwrap();
            assert_eq!(mesh.origin(outgoing), ends[0]);
        }
    }
    let on_boundary: BTreeSet<VertexId> = boundary(complex).into_keys().flatten().collect();
    let all: BTreeSet<VertexId> = edges.into_iter().flatten().collect();
    assert!(
        complex
            .inner_vertices()
            .eq(all.difference(&on_boundary).copied())
    );
}

/// A lattice with many points on lines and circles, or points anywhere, and segments to cut along.
fn regions() -> impl Strategy<Value = Complex2> {
    let coordinate = || prop_oneof![2 => (0..6i32).prop_map(f64::from), 1 => 0.0..5.0f64];
    let inner = prop::collection::vec((coordinate(), coordinate()), 4..40);
    let segments = prop::collection::vec([0..44usize, 0..44], 0..8);
    (inner, segments).prop_map(|(inner, segments)| {
        let corners = [(0.0, 0.0), (5.0, 0.0), (5.0, 5.0), (0.0, 5.0)];
        let points: Vec<DVec2> = corners.into_iter().chain(inner).map(DVec2::from).collect();
        let named = segments.iter().map(|ends| ends.map(|v| v % points.len()));
        let segments: Vec<[usize; 2]> = named.filter(|&[a, b]| points[a] != points[b]).collect();
        cut(&points, &segments)
    })
}

/// What may be done, with numbers that choose where and how far.
#[derive(Clone, Copy, Debug)]
enum Change {
    Flip(usize),
    Move(usize, usize, f64),
    MoveAll(usize, f64),
    Insert(usize, f64),
    Remove(usize),
    RestoreDelaunay,
    Piece(usize, usize),
}

fn changes() -> impl Strategy<Value = Change> {
    let any = || 0..1000usize;
    prop_oneof![
        4 => any().prop_map(Change::Flip),
        4 => (any(), any(), 0.0..1.0f64).prop_map(|(v, f, way)| Change::Move(v, f, way)),
        1 => (any(), 0.0..0.1f64).prop_map(|(f, way)| Change::MoveAll(f, way)),
        2 => (any(), 0.0..1.0f64).prop_map(|(f, way)| Change::Insert(f, way)),
        2 => any().prop_map(Change::Remove),
        1 => Just(Change::RestoreDelaunay),
        2 => (any(), 1..12usize).prop_map(|(f, size)| Change::Piece(f, size)),
    ]
}

fn choose<T: Copy>(from: impl Iterator<Item = T>, number: usize) -> Option<T> {
    let all: Vec<T> = from.collect();
    (!all.is_empty()).then(|| all[number % all.len()])
}

/// A place in the triangle, from its center to its first corner.
fn place(complex: &Complex2, f: FaceId, way: f64) -> DVec2 {
    let corners = complex.triangle(f);
    (corners.into_iter().sum::<DVec2>() / 3.0).lerp(corners[0], way)
}

/// Whether the triangles of `v` would turn counterclockwise with it at `p`.
fn has_room(complex: &Complex2, v: VertexId, p: DVec2) -> bool {
    let mesh = complex.mesh();
    let mut triangles = mesh.star(v).map(|f| {
        let corners = mesh.face_vertices(f);
        corners.map(|u| if u == v { p } else { complex.point(u) })
    });
    triangles.all(|[a, b, c]| orient2d(a, b, c) == Sign::Positive)
}

/// Makes a change where it can be made and tells by how many triangles there are more or less.
fn make(complex: &mut Complex2, change: Change) -> isize {
    let before = complex.mesh().clone();
    match change {
        Change::Flip(h) => {
            let h = choose(before.half_edges(), h).unwrap();
            match complex.flip(h) {
                Some(sides) => {
                    let diagonal = sides[0].next();
                    let [a, b] = [before.apex(h), before.apex(before.twin(h))];
                    let mesh = complex.mesh();
                    assert_eq!([mesh.target(diagonal), mesh.origin(diagonal)], [a, b]);
                    assert_eq!(mesh.twin(diagonal), sides[2].next());
                }
                None => assert_eq!(complex.mesh(), &before),
            }
            0
        }
        Change::Move(v, f, way) => {
            let (Some(v), Some(f)) = (
                choose(complex.inner_vertices(), v),
                choose(complex.faces(), f),
            ) else {
                return 0;
            };
            let p = complex.point(v).lerp(place(complex, f, 0.0), way);
            let fits = has_room(complex, v, p);
            assert_eq!(complex.move_vertex(v, p), fits);
            assert_eq!(complex.point(v) == p, fits);
            0
        }
        Change::MoveAll(f, way) => {
            let f = choose(complex.faces(), f).unwrap();
            let center = place(complex, f, 0.0);
            let vertices: Vec<VertexId> = complex.inner_vertices().collect();
            let places = vertices.iter().map(|&v| complex.point(v).lerp(center, way));
            let places: Vec<DVec2> = places.collect();
            let old = complex.points().to_vec();
            let moved = complex.move_vertices(&vertices, &places);
            let now = vertices.iter().map(|&v| complex.point(v));
            assert!(moved && now.eq(places) || complex.points() == old);
            0
        }
        Change::Insert(f, way) => {
            let f = choose(complex.faces(), f).unwrap();
            let p = place(complex, f, way);
            let Some(v) = complex.insert(p, f) else {
                return 0;
            };
            assert_eq!((complex.point(v), complex.mesh().around(v).count()), (p, 3));
            2
        }
        Change::Remove(v) => {
            let Some(v) = choose(complex.inner_vertices(), v) else {
                return 0;
            };
            let refilled = complex.remove(v).unwrap();
            assert_eq!(
                (complex.is_inner(v), complex.mesh().outgoing(v)),
                (false, None)
            );
            assert!(complex.remove(v).is_none());
            let there = |f: &FaceId| f.index() < complex.mesh().face_count();
            assert!(refilled.made.iter().all(there));
            -2
        }
        Change::RestoreDelaunay => {
            complex.restore_delaunay();
            let mesh = complex.mesh();
            for h in complex.faces().flat_map(FaceId::half_edges) {
                let corners = [mesh.origin(h), mesh.target(h), mesh.apex(h)];
                let beyond = mesh.apex(mesh.twin(h));
                let [a, b, c] = corners.map(|v| complex.point(v));
                assert!(beyond.is_ghost() || !in_circle_perturbed(a, b, c, complex.point(beyond)));
            }
            0
        }
        Change::Piece(f, size) => change_piece(complex, f, size),
    }
}

/// Takes out a piece, puts it back as it is and then with an insertion, a removal and a flip.
fn change_piece(complex: &mut Complex2, f: usize, size: usize) -> isize {
    let all: Vec<FaceId> = complex.faces().collect();
    let chosen: BTreeSet<FaceId> = (0..size).map(|k| all[(f + 5 * k) % all.len()]).collect();
    let near = chosen.iter().flat_map(|f| f.half_edges());
    let near = near.map(|h| complex.mesh().twin(h).face());
    let near = near.filter(|&f| !complex.mesh().is_ghost_face(f));
    let faces: BTreeSet<FaceId> = near.chain(chosen.iter().copied()).collect();
    let piece = complex.piece(&faces.into_iter().collect::<Vec<_>>());
    check(piece.complex());

    let before = complex.mesh().canonical();
    let mut same = complex.clone();
    same.put_back(&piece, piece.complex());
    assert_eq!(same.mesh().canonical(), before);

    let mut changed = piece.complex().clone();
    let mut more = 0;
    for change in [Change::Insert(f, 0.3), Change::Remove(f), Change::Flip(f)] {
        more += make(&mut changed, change);
    }
    complex.put_back(&piece, &changed);
    more
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn changes_leave_a_triangulation_of_the_same_region(
        mut complex in regions(),
        changes in prop::collection::vec(changes(), 1..30),
    ) {
        check(&complex);
        let kept = (boundary(&complex), euler_characteristic(&complex));
        let whole = area(&complex);
        for change in changes {
            let count = complex.faces().count() as isize;
            let more = make(&mut complex, change);
            check(&complex);
            prop_assert_eq!(complex.faces().count() as isize, count + more);
            prop_assert_eq!(&(boundary(&complex), euler_characteristic(&complex)), &kept);
            prop_assert!((area(&complex) - whole).abs() < 1e-9);
        }
    }

    #[test]
    fn all_vertices_inside_can_be_removed(mut complex in regions()) {
        let kept = boundary(&complex);
        while let Some(v) = complex.inner_vertices().last() {
            prop_assert!(complex.remove(v).is_some());
        }
        check(&complex);
        prop_assert_eq!(boundary(&complex), kept);
    }
}

#[test]
fn what_is_fixed_or_no_number_stays_where_it_is() {
    let corners = [[0.0, 0.0], [8.0, 0.0], [8.0, 8.0], [0.0, 8.0]];
    let wall = [[3.0, 3.0], [5.0, 3.0], [2.0, 5.0]];
    let points: Vec<DVec2> = corners.into_iter().chain(wall).map(DVec2::from).collect();
    let mut complex = cut(&points, &[[4, 5]]);
    let inner: Vec<VertexId> = complex.inner_vertices().collect();
    assert_eq!(inner, [VertexId::new(6)]);
    let before = complex.clone();
    let strangers = [VertexId::GHOST, VertexId::new(7), VertexId::new(4_000_000)];
    for v in [0, 4, 5].map(VertexId::new).into_iter().chain(strangers) {
        assert!(!complex.is_inner(v));
        assert!(!complex.move_vertex(v, DVec2::ONE));
        assert!(!complex.move_vertices(&[inner[0], v], &[DVec2::splat(4.5); 2]));
        assert!(complex.remove(v).is_none());
    }
    let f = complex.faces().next().unwrap();
    for p in [f64::NAN, f64::INFINITY, 1e-60, 1e70].map(DVec2::splat) {
        assert!(!complex.move_vertex(inner[0], p));
        assert!(!complex.move_vertices(&inner, &[p]));
        assert!(complex.insert(p, f).is_none());
    }
    let boundary = |h: &HalfEdgeId| before.is_boundary(*h);
    for h in before.mesh().half_edges().filter(boundary) {
        assert!(complex.flip(h).is_none());
    }
    assert_eq!(complex.points(), before.points());
    assert_eq!(complex.mesh(), before.mesh());
}

#[test]
fn a_piece_on_both_sides_of_a_cut_is_put_back_on_both() {
    let corners = [[0.0, 0.0], [8.0, 0.0], [8.0, 8.0], [0.0, 8.0]];
    let wall = [[3.0, 3.0], [4.0, 4.0], [5.0, 5.0]];
    let points: Vec<DVec2> = corners.into_iter().chain(wall).map(DVec2::from).collect();
    let whole = cut(&points, &[[4, 6]]);
    assert_eq!(whole.check(), Ok(()));
    let all: Vec<FaceId> = whole.faces().collect();
    for start in 0..all.len() {
        for end in start + 1..=all.len() {
            let piece = whole.piece(&all[start..end]);
            assert_eq!(piece.complex().check(), Ok(()));
            let mut again = whole.clone();
            again.put_back(&piece, piece.complex());
            assert_eq!(again.check(), Ok(()));
            assert_eq!(again.mesh().canonical(), whole.mesh().canonical());
        }
    }
}
