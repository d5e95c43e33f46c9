//! Parts of triangulations with a fixed boundary, and the outlines that bound them.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

mod clouds;

use clouds::{grid, rng, uniform};
use delaunay_core::progress::silent;
use delaunay_core::{
    BuildOptions, Cavity, Delaunay2, FaceId, HalfEdgeId, Outline, Region, Subcomplex2, VertexId,
};
use glam::DVec2;
use proptest::prelude::*;
use rand::RngExt;
use std::collections::BTreeSet;

fn cloud(seed: u64, count: usize, on_lattice: bool) -> Delaunay2 {
    let points = match on_lattice {
        true => grid(count / 4 + 2, 4),
        false => uniform(count, seed),
    };
    Delaunay2::build(&points).unwrap()
}

fn random_choice(delaunay: &Delaunay2, seed: u64, share: f64) -> Vec<bool> {
    let mut random = rng(seed);
    let faces = delaunay.mesh().faces();
    faces.map(|_| random.random::<f64>() < share).collect()
}

/// The boundary, each edge by its ends, inside on the left.
fn boundary_ends(region: &Subcomplex2) -> BTreeSet<[VertexId; 2]> {
    let ends = |h: HalfEdgeId| [region.mesh().origin(h), region.mesh().target(h)];
    region.boundary().map(ends).collect()
}

fn corners(region: &Subcomplex2) -> BTreeSet<[VertexId; 3]> {
    let sorted = |f: FaceId| {
        let mut corners = region.mesh().face_vertices(f);
        corners.sort_unstable();
        corners
    };
    region.faces().map(sorted).collect()
}

fn center_of(region: &Subcomplex2, f: FaceId) -> DVec2 {
    region.triangle(f).into_iter().sum::<DVec2>() / 3.0
}

/// The outline round the triangles that are kept; none when there are none.
fn outline_of(delaunay: &Delaunay2, keep: &[bool]) -> Option<Outline> {
    let mesh = delaunay.mesh();
    let kept = |f: FaceId| !mesh.is_ghost_face(f) && keep[f.index()];
    let outer = mesh
        .half_edges()
        .filter(|&h| kept(h.face()) && !kept(mesh.twin(h).face()));
    let segments: Vec<[VertexId; 2]> = outer.map(|h| [mesh.origin(h), mesh.target(h)]).collect();
    Outline::new(delaunay.points().to_vec(), segments).ok()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(128))]

    /// Parts that touch at vertices, holes, and what else chance makes.
    #[test]
    fn any_part_of_a_triangulation_is_sound(seed in any::<u64>(), count in 5_usize..60, on_lattice: bool, share in 0.0..1.0) {
        let delaunay = cloud(seed, count, on_lattice);
        let keep = random_choice(&delaunay, seed, share);
        let part = Subcomplex2::of(&delaunay, |f| keep[f.index()]);
        prop_assert_eq!(part.check(), Ok(()));
        prop_assert_eq!(part.faces().count(), delaunay.faces().filter(|f| keep[f.index()]).count());
        let ghosts = part.mesh().face_count() - part.faces().count();
        prop_assert_eq!(part.boundary().count(), ghosts);
    }

    #[test]
    fn insertions_leave_the_boundary_and_removals_undo_them(
        seed in any::<u64>(),
        count in 5_usize..60,
        on_lattice: bool,
        share in 0.1..1.0,
    ) {
        let delaunay = cloud(seed, count, on_lattice);
        let keep = random_choice(&delaunay, seed, share);
        let mut part = Subcomplex2::of(&delaunay, |f| keep[f.index()]);
        let (boundary, before) = (boundary_ends(&part), corners(&part));
        let homes: Vec<DVec2> = part.faces().map(|f| center_of(&part, f)).collect();
        let mut inserted = Vec::new();
        let mut cavity = Cavity::default();
        for point in homes {
            let conflicts: Vec<FaceId> = part.faces().filter(|&f| part.in_conflict(point, f)).collect();
            let Some(&seed) = conflicts.iter().find(|&&f| part.dig(point, f, &mut cavity)) else {
                prop_assert!(false, "{point} is inside");
                continue;
            };
            // Whatever triangle the search begins with.
            let found: BTreeSet<FaceId> = cavity.faces().iter().copied().collect();
            for &f in cavity.faces().to_vec().iter().chain([&seed]) {
                prop_assert!(part.dig(point, f, &mut cavity));
                prop_assert_eq!(&cavity.faces().iter().copied().collect::<BTreeSet<_>>(), &found);
            }
            inserted.push(part.fill(point, &mut cavity).unwrap());
            prop_assert_eq!(part.check(), Ok(()));
        }
        prop_assert_eq!(&boundary_ends(&part), &boundary);
        while let Some(v) = inserted.pop() {
            let patch = part.patch(v).unwrap();
            let refilled = part.remove(&patch);
            let filled = refilled.made.iter().map(|&f| part.mesh().face_vertices(f));
            prop_assert_eq!(filled.collect::<Vec<_>>(), patch.made());
            prop_assert_eq!(part.check(), Ok(()));
        }
        prop_assert_eq!(boundary_ends(&part), boundary);
        prop_assert_eq!(corners(&part), before);
    }

    #[test]
    fn moves_tell_where_faces_have_gone(seed in any::<u64>(), count in 20_usize..60) {
        let mut part = Subcomplex2::of(&cloud(seed, count, false), |_| true);
        let inner = (0..count).map(VertexId::new).filter(|&v| part.patch(v).is_some());
        for v in inner.collect::<Vec<_>>() {
            let mut faces: Vec<Option<[VertexId; 3]>> =
                part.mesh().faces().map(|f| Some(part.mesh().face_vertices(f))).collect();
            let Some(patch) = part.patch(v) else { continue };
            patch.star().iter().for_each(|f| faces[f.index()] = None);
            let refilled = part.remove(&patch);
            for (old, new) in refilled.moved {
                faces[new.index()] = faces[old.index()].take();
            }
            for &f in &refilled.made {
                faces[f.index()] = Some(part.mesh().face_vertices(f));
            }
            faces.truncate(part.mesh().face_count());
            let now: Vec<_> = part.mesh().faces().map(|f| Some(part.mesh().face_vertices(f))).collect();
            prop_assert_eq!(faces, now);
        }
    }

    #[test]
    fn points_on_or_beyond_the_boundary_are_refused(seed in any::<u64>(), count in 5_usize..40, share in 0.1..1.0) {
        let delaunay = cloud(seed, count, true);
        let keep = random_choice(&delaunay, seed, share);
        let part = Subcomplex2::of(&delaunay, |f| keep[f.index()]);
        let mut cavity = Cavity::default();
        let outside = delaunay.faces().filter(|f| !keep[f.index()]);
        let outside = outside.map(|f| delaunay.triangle(f).into_iter().sum::<DVec2>() / 3.0);
        let middles = part.boundary().map(|h| part.segment(h).into_iter().sum::<DVec2>() / 2.0);
        let vertices = delaunay.points().iter().copied();
        for point in outside.chain(middles).chain(vertices) {
            prop_assert!(!part.faces().any(|f| part.dig(point, f, &mut cavity)), "{}", point);
        }
    }

    #[test]
    fn the_outline_of_any_triangles_gives_them_back(seed in any::<u64>(), count in 5_usize..60, on_lattice: bool) {
        let delaunay = cloud(seed, count, on_lattice);
        let mut keep = random_choice(&delaunay, seed, 0.5);
        for v in delaunay.vertices() {
            // A vertex needs a triangle, and one that is not there.
            let real: Vec<FaceId> = delaunay.mesh().star(v).filter(|&f| !delaunay.is_ghost_face(f)).collect();
            if !real.iter().any(|f| keep[f.index()]) {
                keep[real[0].index()] = true;
            }
        }
        let outline = outline_of(&delaunay, &keep);
        prop_assume!(outline.is_some());
        let region: Region = outline.unwrap().region(BuildOptions::default(), &mut silent).unwrap();
        let given = Subcomplex2::of(&delaunay, |f| keep[f.index()]);
        let found = region.subcomplex();
        prop_assert_eq!(corners(&found), corners(&given));
    }
}

#[test]
fn the_outline_of_the_sink_paper_has_229_triangles() {
    let usa = fixtures::outlines::usa();
    let points = usa.points.iter().copied().map(DVec2::from).collect();
    let segments = usa
        .segments
        .iter()
        .map(|ends| ends.map(|v| VertexId::new(v as usize)));
    let outline = Outline::new(points, segments.collect()).unwrap();
    let region = outline
        .region(BuildOptions::default(), &mut silent)
        .unwrap();
    assert_eq!(region.faces().count(), 229);
    let part = region.subcomplex();
    assert_eq!((part.vertex_count(), part.boundary().count()), (231, 231));
    // One curve: the infinite vertex has one ring too.
    assert_eq!((part.check(), part.mesh().check()), (Ok(()), Ok(())));
}

#[test]
fn round_a_hole_the_infinite_vertex_has_a_ring_of_its_own() {
    let delaunay = Delaunay2::build(&grid(4, 4)).unwrap();
    let part = Subcomplex2::of(&delaunay, |f| {
        let center = delaunay.triangle(f).into_iter().sum::<DVec2>() / 3.0;
        let [low, high] = [delaunay.points()[0], delaunay.points()[15]];
        ((center - low) / (high - low) - 0.5).abs().max_element() > 1.0 / 6.0
    });
    assert_eq!((part.faces().count(), part.boundary().count()), (16, 16));
    assert_eq!(part.check(), Ok(()));
    assert!(part.mesh().check().is_err());
}
