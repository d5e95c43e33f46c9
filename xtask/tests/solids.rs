//! What the families of hard surfaces promise, for many seeds.

use std::sync::LazyLock;

use rustc_hash::FxHashMap;
use xtask::solids::check::{defect, defect_but_intersection};
use xtask::solids::{FAMILIES, Family, Size, Solid};

/// How many solids of every family are looked at: each size among them.
const LOOKED_AT: usize = 40;

/// Those with more triangles are tested for everything but intersections.
const FEW: usize = 3000;

/// The first ones of every family, made once for all tests.
static SOLIDS: LazyLock<Vec<(&'static Family, Vec<Solid>)>> = LazyLock::new(|| {
    let first = |family: &'static Family| {
        let solids = (0..LOOKED_AT).map(|number| family.solid(number, 11));
        (family, solids.collect())
    };
    FAMILIES.iter().map(first).collect()
});

fn every() -> impl Iterator<Item = &'static Solid> {
    SOLIDS.iter().flat_map(|(_, solids)| solids)
}

#[test]
fn every_surface_is_closed_without_degenerate_triangles_and_small_ones_without_intersections() {
    for solid in every() {
        let found = if solid.triangles.len() <= FEW {
            defect(solid)
        } else {
            defect_but_intersection(solid)
        };
        assert!(found.is_none(), "{}: {}", solid.name, found.unwrap());
    }
}

#[test]
fn triangles_agree_on_the_outside() {
    for solid in every() {
        let mut sides: FxHashMap<[u32; 2], i32> = FxHashMap::default();
        for &[a, b, c] in &solid.triangles {
            for [from, to] in [[a, b], [b, c], [c, a]] {
                *sides.entry([from.min(to), from.max(to)]).or_default() +=
                    if from < to { 1 } else { -1 };
            }
        }
        assert!(sides.values().all(|&sum| sum == 0), "{}", solid.name);
        let origin = solid.points[0];
        let six_volumes = solid.triangles.iter().map(|corners| {
            let [a, b, c] = corners.map(|v| solid.points[v as usize] - origin);
            a.cross(b).dot(c)
        });
        assert!(six_volumes.sum::<f64>() > 0.0, "{}", solid.name);
    }
}

#[test]
fn the_same_number_and_seed_give_the_same_bits_and_others_do_not() {
    for family in &FAMILIES {
        let bits = |solid: Solid| -> Vec<u64> {
            let coordinates = solid.points.iter().flat_map(glam::DVec3::to_array);
            coordinates.map(f64::to_bits).collect()
        };
        let all = |seed| -> Vec<(String, Vec<[u32; 3]>, Vec<u64>)> {
            let solids = (0..6).map(|number| family.solid(number, seed));
            solids
                .map(|solid| (solid.name.clone(), solid.triangles.clone(), bits(solid)))
                .collect()
        };
        assert_eq!(all(1), all(1), "{}", family.name);
        assert_ne!(all(1), all(2), "{}", family.name);
    }
}

#[test]
fn every_family_has_all_sizes_and_names_fit_for_files() {
    for (family, solids) in SOLIDS.iter() {
        let name = family.name;
        for solid in solids {
            let is_plain =
                |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || "-_".contains(c);
            assert!(solid.name.chars().all(is_plain), "{}", solid.name);
            assert!(solid.name.starts_with(name));
            let triangles = solid.triangles.len();
            assert!(
                (4..=300_000).contains(&triangles),
                "{}: {triangles}",
                solid.name
            );
        }
        let largest = solids.iter().map(|solid| solid.triangles.len()).max();
        assert!(largest >= Some(2000), "{name}: {largest:?}");
        let is_small = |(number, solid): &(usize, &Solid)| {
            Size::of(*number) == Size::Small && solid.triangles.len() <= 4000
        };
        let small = solids.iter().enumerate().filter(is_small).count();
        assert!(small >= 30, "{name}: {small}");
    }
}

#[test]
fn bodies_touch_along_edges_and_at_vertices_in_some_boxes() {
    let csg = FAMILIES.iter().find(|family| family.name == "csg").unwrap();
    let names: Vec<String> = (0..100).map(|number| csg.solid(number, 1).name).collect();
    for flag in ["-edge", "-vertex", "-edge-vertex"] {
        assert!(
            names.iter().filter(|name| name.ends_with(flag)).count() >= 3,
            "{flag}"
        );
    }
    assert!(
        names
            .iter()
            .any(|name| !name.contains("-edge") && !name.contains("-vertex"))
    );
}
