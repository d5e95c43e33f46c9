//! Tetrahedra that need not be Delaunay, in a fixed boundary: what may be exchanged, and what is refused.

#![allow(clippy::unwrap_used)]

mod clouds;

use clouds::space;
use delaunay_core::geo_predicates::{Sign, orient3d};
use delaunay_core::measure::tetrahedron::signed_volume;
use delaunay_core::{Complex3, ComplexError, Delaunay3, Subcomplex3, TetId, VertexId};
use glam::DVec3;
use proptest::prelude::*;
use std::collections::BTreeMap;

fn complex_of(delaunay: &Delaunay3, keep: impl FnMut(TetId) -> bool) -> Complex3 {
    Complex3::from(Subcomplex3::of(delaunay, keep))
}

/// How often each boundary facet comes, by its corners in order.
fn boundary(complex: &Complex3) -> BTreeMap<[VertexId; 3], usize> {
    let mut facets = BTreeMap::new();
    for f in complex.boundary() {
        let mut corners = complex.mesh().facet_vertices(f);
        corners.sort_unstable();
        *facets.entry(corners).or_insert(0) += 1;
    }
    facets
}

fn volume(complex: &Complex3) -> f64 {
    let volumes = complex
        .tets()
        .map(|t| signed_volume(complex.tetrahedron(t)));
    volumes.sum()
}

/// Twins are mutual with opposite corners, also those of ghosts, tetrahedra are right-handed, and the number of vertices is
/// that of those with a home.
fn assert_sound(complex: &Complex3) {
    let mesh = complex.mesh();
    for f in mesh.facets() {
        let twin = mesh.twin(f);
        assert!(twin != f && mesh.twin(twin) == f);
        let [a, b, c] = mesh.facet_vertices(f);
        assert!([[a, c, b], [c, b, a], [b, a, c]].contains(&mesh.facet_vertices(twin)));
    }
    for t in complex.tets() {
        let [a, b, c, d] = complex.tetrahedron(t);
        assert_eq!(orient3d(a, b, c, d), Sign::Positive);
    }
    let vertices = (0..complex.points().len()).map(VertexId::new);
    let homes = vertices.filter(|&v| mesh.home(v).is_some());
    assert_eq!(homes.count(), complex.vertex_count());
}

/// What may be tried, with numbers that choose where.
#[derive(Clone, Copy, Debug)]
enum Attempt {
    /// Replace a facet by an edge.
    Flip(usize),
    /// Insert at a place in a tetrahedron, in place of it and neighbours.
    Insert(usize, [f64; 4], usize),
    /// Move a vertex towards another one.
    Move(usize, usize, f64),
    /// Contract an edge.
    Contract(usize, usize),
    /// Replace some tetrahedra by others with any corners.
    Anything(usize, [usize; 8]),
}

fn attempt() -> impl Strategy<Value = Attempt> {
    let n = 0..1000_usize;
    prop_oneof![
        n.clone().prop_map(Attempt::Flip),
        (n.clone(), prop::array::uniform4(0.01..1.0), 0..6_usize)
            .prop_map(|(t, shares, more)| Attempt::Insert(t, shares, more)),
        (n.clone(), n.clone(), -0.5..1.0).prop_map(|(v, w, share)| Attempt::Move(v, w, share)),
        (n.clone(), 0..12_usize).prop_map(|(t, edge)| Attempt::Contract(t, edge)),
        (n, prop::array::uniform8(0..12_usize)).prop_map(|(t, v)| Attempt::Anything(t, v)),
    ]
}

/// Tries to change the complex.
fn try_to(complex: &mut Complex3, attempt: Attempt) -> Result<(), ComplexError> {
    let tets: Vec<TetId> = complex.tets().collect();
    let vertices = complex.points().len();
    let mesh = complex.mesh();
    match attempt {
        Attempt::Flip(n) => {
            let f = tets[n / 4 % tets.len()].facet(n % 4);
            let flip = mesh.two_to_three(f).unwrap();
            complex.replace(&flip.gone(), &flip.made())?;
        }
        Attempt::Insert(n, shares, more) => {
            let t = tets[n % tets.len()];
            let total: f64 = shares.iter().sum();
            let corners = complex.tetrahedron(t).into_iter().zip(shares);
            let p = corners
                .map(|(corner, share)| corner * (share / total))
                .sum();
            let mut gone = vec![t];
            gone.extend((0..more.min(4)).map(|i| mesh.neighbor(t, i)));
            complex.insert(&gone, p)?;
        }
        Attempt::Move(v, w, share) => {
            let [v, w] = [v, w].map(|n| VertexId::new(n % vertices));
            complex.move_vertex(v, complex.point(v).lerp(complex.point(w), share))?;
        }
        Attempt::Contract(n, edge) => {
            let corners = mesh.tet_vertices(tets[n % tets.len()]);
            let (v, onto) = (corners[edge / 3], corners[(edge / 3 + 1 + edge % 3) % 4]);
            let star: Vec<TetId> = mesh.star(v).collect();
            let others = star.iter().map(|&t| mesh.tet_vertices(t));
            let others = others.filter(|corners| !corners.contains(&onto));
            let made = others.map(|corners| corners.map(|w| if w == v { onto } else { w }));
            let made: Vec<_> = made.collect();
            complex.replace(&star, &made)?;
        }
        Attempt::Anything(n, v) => {
            let t = tets[n % tets.len()];
            let mut gone = vec![t, mesh.neighbor(t, n % 4)];
            gone.truncate(1 + n % 2);
            let mut near: Vec<VertexId> = gone.iter().flat_map(|&t| mesh.tet_vertices(t)).collect();
            near.extend((0..8).map(VertexId::new));
            let [a, b, c, d, e, f, g, h] = v.map(|i| near[i % near.len()]);
            complex.replace(&gone, &[[a, b, c, d], [e, f, g, h]])?;
        }
    }
    Ok(())
}

proptest! {
    #[test]
    fn whatever_is_tried_the_mesh_fills_its_boundary(
        points in prop::collection::vec(space::place(), 8..40),
        keep in prop_oneof![Just(vec![true]), prop::collection::vec(prop::bool::weighted(0.9), 40)],
        attempts in prop::collection::vec(attempt(), 60),
    ) {
        let Ok(delaunay) = Delaunay3::build(&points) else { return Ok(()) };
        let mut complex = complex_of(&delaunay, |t| keep[t.index() % keep.len()]);
        prop_assume!(complex.tets().next().is_some());
        let (facets, size) = (boundary(&complex), volume(&complex));
        for attempt in attempts {
            let before = complex.clone();
            if try_to(&mut complex, attempt).is_ok() {
                assert_sound(&complex);
            } else {
                prop_assert_eq!(complex.mesh(), before.mesh());
                prop_assert_eq!(complex.points(), before.points());
                prop_assert_eq!(complex.vertex_count(), before.vertex_count());
            }
        }
        prop_assert_eq!(&boundary(&complex), &facets);
        prop_assert!((volume(&complex) - size).abs() <= 1e-12 * size);
    }
}

/// Of the random attempts above enough are no refusals.
#[test]
fn changes_of_every_kind_are_made() {
    use proptest::strategy::ValueTree;
    use proptest::test_runner::TestRunner;
    let mut complex = complex_of(&Delaunay3::build(&space::uniform(60, 4)).unwrap(), |_| true);
    let (facets, size) = (boundary(&complex), volume(&complex));
    let mut runner = TestRunner::deterministic();
    let mut made = [0; 4];
    for _ in 0..4000 {
        let attempt = attempt().new_tree(&mut runner).unwrap().current();
        if try_to(&mut complex, attempt).is_ok() {
            match attempt {
                Attempt::Flip(_) => made[0] += 1,
                Attempt::Insert(..) => made[1] += 1,
                Attempt::Move(..) => made[2] += 1,
                Attempt::Contract(..) => made[3] += 1,
                Attempt::Anything(..) => {}
            }
        }
    }
    assert_sound(&complex);
    assert_eq!(complex.mesh().check(), Ok(()));
    assert_eq!(boundary(&complex), facets);
    assert!((volume(&complex) / size - 1.0).abs() < 1e-12);
    assert!(made.iter().all(|&count| count > 20), "{made:?}");
}

#[test]
fn a_vertex_comes_and_goes_and_its_id_is_given_out_again() {
    let simplex = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
    let mut complex = complex_of(&Delaunay3::build(&simplex).unwrap(), |_| true);
    let t = complex.tets().next().unwrap();
    let corners = complex.mesh().tet_vertices(t);
    let center = VertexId::new(4);
    for shift in [0.2, 0.3] {
        let (v, star) = complex.insert(&[t], DVec3::splat(shift)).unwrap();
        assert_eq!((v, star.len(), complex.vertex_count()), (center, 4, 5));
        assert!(star.iter().all(|&t| complex.mesh().tet_vertices(t)[0] == v));
        assert_eq!(complex.replace(&star, &[corners]), Ok(vec![t]));
        assert_eq!((complex.vertex_count(), complex.mesh().home(v)), (4, None));
    }
    assert_eq!(complex.points().len(), 5);
}

#[test]
fn refusals_say_why_and_change_nothing() {
    let points = [
        [0., 0., 0.],
        [2., 0., 0.],
        [0., 2., 0.],
        [0.5, 0.5, 3.],
        [0.5, 0.5, -3.],
    ];
    let mut complex = complex_of(&Delaunay3::build(&points.map(DVec3::from)).unwrap(), |_| {
        true
    });
    let [t, u] = complex.tets().collect::<Vec<_>>()[..] else {
        unreachable!("there are two tetrahedra")
    };
    let corners = complex.mesh().tet_vertices(t);
    let [a, b, c, d] = corners;
    let ghost = complex
        .mesh()
        .tets()
        .find(|&t| complex.mesh().is_ghost_tet(t))
        .unwrap();
    let [vertex, nine] = [0, 9].map(VertexId::new);
    let before = complex.mesh().clone();

    let wrong = [
        complex.replace(&[t, t], &[corners]),
        complex.replace(&[ghost], &[]),
        complex.replace(&[TetId::new(99)], &[]),
    ];
    let tets = [t, ghost, TetId::new(99)];
    assert_eq!(wrong, tets.map(|tet| Err(ComplexError::NoSuchTet { tet })));
    for stranger in [nine, VertexId::GHOST] {
        let error = complex.replace(&[t], &[[a, b, c, stranger]]);
        assert_eq!(error, Err(ComplexError::NoSuchVertex { vertex: stranger }));
        let error = complex.move_vertex(stranger, DVec3::ONE);
        assert_eq!(error, Err(ComplexError::NoSuchVertex { vertex: stranger }));
    }
    let left = [b, a, c, d];
    let error = complex.replace(&[t], &[left]);
    assert_eq!(error, Err(ComplexError::NotRightHanded { corners: left }));
    for made in [&[][..], &[corners, corners]] {
        assert_eq!(
            complex.replace(&[t], made),
            Err(ComplexError::OtherBoundary)
        );
    }
    let error = complex.move_vertex(vertex, DVec3::splat(0.01));
    assert_eq!(error, Err(ComplexError::OnBoundary { vertex }));
    for p in [DVec3::splat(9.0), DVec3::ZERO] {
        let error = complex.insert(&[t, u], p);
        assert!(matches!(error, Err(ComplexError::NotRightHanded { .. })));
    }
    for p in [DVec3::NAN, DVec3::splat(1e-60)] {
        assert!(matches!(
            complex.insert(&[t], p),
            Err(ComplexError::Coordinate(_))
        ));
        assert!(matches!(
            complex.move_vertex(vertex, p),
            Err(ComplexError::Coordinate(_))
        ));
    }
    assert_eq!((complex.mesh(), complex.vertex_count()), (&before, 5));
    assert_eq!(complex.points().len(), 5);

    let limit = 7;
    let texts = [
        ComplexError::NoSuchTet { tet: t },
        ComplexError::NoSuchVertex { vertex },
        ComplexError::OnBoundary { vertex },
        ComplexError::NotRightHanded { corners },
        ComplexError::OtherBoundary,
        ComplexError::TooManyVertices { limit },
        ComplexError::TooManyTets { limit },
    ];
    insta::assert_snapshot!(texts.map(|error| error.to_string()).join("\n"), @r"
    t0 is no tetrahedron inside, or is given twice
    there is no vertex v0
    v0 is on the boundary
    v1, v4, v0 and v2 are not right-handed
    the new tetrahedra do not have the boundary of the old ones
    there is no room for one more than 7 vertices
    there is no room for one more than 7 tetrahedra
    ");
}
