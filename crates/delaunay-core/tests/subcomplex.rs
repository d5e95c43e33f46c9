//! Parts of triangulations with a fixed boundary: what insertion and removal do to them, and what they leave alone.

#![allow(clippy::unwrap_used)]

mod clouds;

use clouds::space;
use delaunay_core::geo_predicates::{Sign, orient3d};
use delaunay_core::measure::tetrahedron::signed_volume;
use delaunay_core::{Cavity3, Delaunay3, Merge, Subcomplex3, TetId, VertexId};
use glam::DVec3;
use proptest::prelude::*;
use std::collections::BTreeMap;

/// How often each boundary facet comes, by its corners in order.
fn boundary(solid: &Subcomplex3) -> BTreeMap<[VertexId; 3], usize> {
    let mut facets = BTreeMap::new();
    for f in solid.boundary() {
        let mut corners = solid.mesh().facet_vertices(f);
        corners.sort_unstable();
        *facets.entry(corners).or_insert(0) += 1;
    }
    facets
}

fn volume(solid: &Subcomplex3) -> f64 {
    let volumes = solid.tets().map(|t| signed_volume(solid.tetrahedron(t)));
    volumes.sum()
}

/// Twins are mutual with opposite corners, also those of ghosts, and tetrahedra have volume.
fn assert_sound(solid: &Subcomplex3) {
    let mesh = solid.mesh();
    for f in mesh.facets() {
        let twin = mesh.twin(f);
        assert!(twin != f && mesh.twin(twin) == f);
        let [a, b, c] = mesh.facet_vertices(f);
        assert!([[a, c, b], [c, b, a], [b, a, c]].contains(&mesh.facet_vertices(twin)));
    }
    for t in solid.tets() {
        let [a, b, c, d] = solid.tetrahedron(t);
        assert_eq!(orient3d(a, b, c, d), Sign::Positive);
    }
}

/// Tetrahedra are Delaunay across inner facets.
fn assert_delaunay(solid: &Subcomplex3) {
    let mesh = solid.mesh();
    for f in solid.tets().flat_map(TetId::facets) {
        let apex = mesh.apex(mesh.twin(f));
        assert!(apex.is_ghost() || !solid.in_conflict(solid.point(apex), f.tet()));
    }
}

proptest! {
    /// Without a part left out the triangulation stays Delaunay, too.
    #[test]
    fn points_come_and_go_inside_a_fixed_boundary(
        points in prop::collection::vec(space::place(), 8..60),
        keep in prop_oneof![Just(vec![true]), prop::collection::vec(prop::bool::weighted(0.8), 40)],
        shares in prop::collection::vec([0.05..1.0, 0.05..1.0, 0.05..1.0, 0.05..1.0_f64], 12),
    ) {
        let Ok(delaunay) = Delaunay3::build(&points) else { return Ok(()) };
        let mut solid = Subcomplex3::of(&delaunay, |t| keep[t.index() % keep.len()]);
        assert_sound(&solid);
        let (facets, size) = (boundary(&solid), volume(&solid));
        let mut cavity = Cavity3::default();
        let mut inserted = Vec::new();
        for (i, shares) in shares.iter().enumerate() {
            let Some(seed) = solid.tets().nth(i * 7) else { continue };
            let total: f64 = shares.iter().sum();
            let corners = solid.tetrahedron(seed).into_iter().zip(shares);
            let p: DVec3 = corners.map(|(corner, share)| corner * (share / total)).sum();
            if solid.in_conflict(p, seed) && solid.dig(p, seed, &mut cavity) {
                inserted.push(solid.fill(p, &mut cavity).unwrap());
                assert_sound(&solid);
            }
        }
        if keep == [true] {
            assert_delaunay(&solid);
        }
        prop_assert_eq!(&boundary(&solid), &facets);
        prop_assert!((volume(&solid) - size).abs() <= 1e-12 * size);
        let vertices = solid.vertex_count();
        let mut removed = 0;
        for &v in &inserted {
            if let Some(patch) = solid.patch(v) && solid.remove(&patch).is_some() {
                removed += 1;
                assert_sound(&solid);
            }
        }
        prop_assert_eq!(solid.vertex_count() + removed, vertices);
        prop_assert_eq!(&boundary(&solid), &facets);
        prop_assert!((volume(&solid) - size).abs() <= 1e-12 * size);
    }
}

#[test]
fn a_whole_triangulation_is_restored_when_its_points_go() {
    let points = space::uniform(300, 5);
    let delaunay = Delaunay3::build(&points).unwrap();
    let mut solid = Subcomplex3::of(&delaunay, |_| true);
    let before = solid.mesh().canonical();
    let mut cavity = Cavity3::default();
    let mut added = Vec::new();
    for t in solid.tets().step_by(9).collect::<Vec<_>>() {
        if solid.mesh().contains_tet(t) && !solid.mesh().is_ghost_tet(t) {
            let corners = solid.tetrahedron(t);
            let p = corners.into_iter().sum::<DVec3>() / 4.0;
            assert!(solid.dig(p, t, &mut cavity));
            added.push(solid.fill(p, &mut cavity).unwrap());
        }
    }
    assert!(added.len() > 50);
    for v in added.into_iter().rev() {
        let patch = solid.patch(v).unwrap();
        assert!(solid.remove(&patch).is_some());
    }
    let after = solid.mesh().canonical();
    let corners = |mesh: &delaunay_core::TetMesh| -> Vec<_> {
        mesh.tets().map(|t| mesh.tet_vertices(t)).collect()
    };
    assert_eq!(corners(&after), corners(&before));
}

#[test]
fn what_is_not_inside_cannot_be_inserted() {
    let cube: Vec<DVec3> = (0..8_u32)
        .map(|i| DVec3::new(f64::from(i & 1), f64::from(i >> 1 & 1), f64::from(i >> 2)))
        .collect();
    let solid = Subcomplex3::of(&Delaunay3::build(&cube).unwrap(), |_| true);
    let mut cavity = Cavity3::default();
    for seed in solid.tets() {
        for p in [DVec3::ZERO, DVec3::splat(2.0), DVec3::new(0.5, 0.5, 0.0)] {
            assert!(!solid.dig(p, seed, &mut cavity), "{p}");
        }
    }
    assert!(solid.patch(VertexId::new(0)).is_none());
}

/// The tetrahedra of a solid by their corners in order.
fn tets(solid: &Subcomplex3) -> BTreeMap<[VertexId; 4], TetId> {
    let corners = |t: TetId| {
        let mut corners = solid.mesh().tet_vertices(t);
        corners.sort_unstable();
        corners
    };
    solid.tets().map(|t| (corners(t), t)).collect()
}

/// Two vertices in the middle of a cloud, the solid with one in their place, and the exchange that leads there.
fn merged(points: &[DVec3]) -> Option<(Subcomplex3, [VertexId; 2], Subcomplex3, Merge)> {
    let delaunay = Delaunay3::build(points).ok()?;
    let before = Subcomplex3::of(&delaunay, |_| true);
    let inner = |v: &VertexId| before.patch(*v).is_some();
    let u = (0..points.len()).map(VertexId::new).find(inner)?;
    let v = before.mesh().neighbors(u).find(inner)?;
    let point = before.point(u).lerp(before.point(v), 0.4);
    let mut after = before.clone();
    for vertex in [v, u] {
        let patch = after.patch(vertex)?;
        after.remove(&patch)?;
    }
    let mut cavity = Cavity3::default();
    let seed = after.tets().find(|&t| after.in_conflict(point, t))?;
    assert!(after.dig(point, seed, &mut cavity));
    // The vertex removed last gives its id.
    assert_eq!(after.fill(point, &mut cavity), Some(u));
    let (old, new) = (tets(&before), tets(&after));
    let gone = old
        .iter()
        .filter(|(corners, _)| corners.contains(&u) || !new.contains_key(*corners));
    let made = new
        .iter()
        .filter(|(corners, _)| corners.contains(&u) || !old.contains_key(*corners));
    let merge = Merge {
        point,
        gone: gone.map(|(_, &t)| t).collect(),
        made: made.map(|(_, &t)| after.mesh().tet_vertices(t)).collect(),
    };
    Some((before, [u, v], after, merge))
}

proptest! {
    #[test]
    fn two_vertices_become_one_as_if_both_were_removed_and_one_inserted(
        points in prop::collection::vec(space::place(), 20..60),
    ) {
        let Some((mut solid, pair, expected, merge)) = merged(&points) else { return Ok(()) };
        let new = solid.merge(pair, &merge).unwrap();
        prop_assert_eq!(new.len(), merge.made.len());
        assert_sound(&solid);
        assert_delaunay(&solid);
        prop_assert_eq!(solid.mesh().check(), Ok(()));
        prop_assert!(tets(&solid).keys().eq(tets(&expected).keys()));
        prop_assert_eq!(solid.point(pair[0]), merge.point);
        prop_assert_eq!(solid.vertex_count(), expected.vertex_count());
        // The id of the vertex that has gone is given out again.
        prop_assert!(solid.mesh().home(pair[1]).is_none());
    }

    #[test]
    fn an_exchange_that_is_not_that_of_delaunay_changes_nothing(
        points in prop::collection::vec(space::place(), 20..60),
    ) {
        let Some((before, pair, _, merge)) = merged(&points) else { return Ok(()) };
        let mut solid = before.clone();
        let away = Merge { point: merge.point + DVec3::splat(1e3), ..merge.clone() };
        let nowhere = Merge { point: DVec3::NAN, ..merge.clone() };
        let [mut less_gone, mut less_made, mut twice] = [merge.clone(), merge.clone(), merge.clone()];
        less_gone.gone.pop();
        less_made.made.pop();
        twice.gone.push(merge.gone[0]);
        for wrong in [away, nowhere, less_gone, less_made, twice, Merge::default()] {
            prop_assert_eq!(solid.merge(pair, &wrong), None);
            prop_assert!(solid.mesh() == before.mesh() && solid.points() == before.points());
        }
        prop_assert_eq!(solid.merge([pair[1], pair[0]], &merge), None);
        prop_assert!(solid.mesh() == before.mesh());
    }
}

#[test]
fn a_patch_is_given_up_at_a_tetrahedron_that_is_not_open() {
    let grid = |i: usize| DVec3::from([i % 3, i / 3 % 3, i / 9].map(|x| x as f64));
    let mut points: Vec<DVec3> = (0..27).map(grid).collect();
    points[13] += DVec3::new(0.01, 0.02, 0.03);
    let solid = Subcomplex3::of(&Delaunay3::build(&points).unwrap(), |_| true);
    let v = VertexId::new(13);
    let patch = solid.patch(v).unwrap();
    assert!(
        solid
            .patch_within(v, |corners| !corners.contains(&v))
            .is_some()
    );
    let mut asked = 0;
    let none = solid.patch_within(v, |_| {
        asked += 1;
        false
    });
    assert!(none.is_none() && asked == 1 && patch.made().len() > 1);
}
