//! Flips of tetrahedra: undone they leave no trace, legal ones keep space filled.

#![allow(clippy::unwrap_used)]

mod clouds;

use clouds::space::{cloud, hard_sets, lattice, rng, uniform};
use delaunay_core::geo_predicates::{Sign, in_sphere_perturbed, orient3d};
use delaunay_core::{Delaunay3, FacetId, FlipError, TetId, TetMesh, VertexId};
use glam::DVec3;
use proptest::prelude::*;
use rand::{Rng, RngExt};

/// A mesh and where its vertices are.
struct Placed {
    mesh: TetMesh,
    points: Vec<DVec3>,
}

impl Placed {
    fn delaunay(points: &[DVec3]) -> Self {
        Self {
            mesh: Delaunay3::build(points).unwrap().into_mesh(),
            points: points.to_vec(),
        }
    }

    fn place(&self) -> impl Fn(VertexId) -> DVec3 {
        |v: VertexId| self.points[v.index()]
    }

    fn real_tets(&self) -> Vec<[DVec3; 4]> {
        let real = self.mesh.tets().filter(|&t| !self.mesh.is_ghost_tet(t));
        real.map(|t| self.mesh.tet_vertices(t).map(self.place()))
            .collect()
    }

    fn volume(&self) -> f64 {
        let six_volumes = self.real_tets().into_iter();
        six_volumes
            .map(|[a, b, c, d]| (b - a).cross(c - a).dot(d - a))
            .sum()
    }

    fn is_right_handed(&self) -> bool {
        let mut tets = self.real_tets().into_iter();
        tets.all(|[a, b, c, d]| orient3d(a, b, c, d) == Sign::Positive)
    }

    /// Replaces the facet, or else an edge of it, if that is legal.
    fn flip_at(&mut self, f: FacetId) -> bool {
        self.flip_facet(f)
            || edges(&self.mesh, f)
                .into_iter()
                .any(|ends| self.flip_edge(f.tet(), ends))
    }

    fn flip_facet(&mut self, f: FacetId) -> bool {
        let flip = self.mesh.two_to_three(f).unwrap();
        flip.is_legal(self.place()) && self.mesh.flip(&flip).is_ok()
    }

    fn flip_edge(&mut self, tet: TetId, ends: [VertexId; 2]) -> bool {
        if let Ok(flip) = self.mesh.three_to_two(tet, ends) {
            return flip.is_legal(self.place()) && self.mesh.flip(&flip).is_ok();
        }
        let starts: Vec<VertexId> = self.mesh.tet_vertices(tet).into_iter().collect();
        starts.into_iter().any(|start| {
            let flip = self.mesh.four_to_four(tet, ends, start);
            flip.is_ok_and(|flip| flip.is_legal(self.place()) && self.mesh.flip(&flip).is_ok())
        })
    }

    /// Whether the vertex across `f` is inside the sphere of its tetrahedron.
    fn is_wrong(&self, f: FacetId) -> bool {
        let across = self.mesh.apex(self.mesh.twin(f));
        if across.is_ghost() || self.mesh.is_ghost_tet(f.tet()) {
            return false;
        }
        let [a, b, c, d] = self.mesh.tet_vertices(f.tet()).map(self.place());
        in_sphere_perturbed(a, b, c, d, self.place()(across))
    }

    /// Flips what is not locally Delaunay until nothing more can be done; gives the number of flips.
    fn lawson(&mut self) -> usize {
        let mut flips = 0;
        loop {
            let wrong: Vec<FacetId> = self.mesh.facets().filter(|&f| self.is_wrong(f)).collect();
            let before = flips;
            for f in wrong {
                let still_wrong = self.mesh.contains_tet(f.tet()) && self.is_wrong(f);
                flips += usize::from(still_wrong && self.flip_at(f));
            }
            if flips == before || flips > 10_000 {
                return flips;
            }
        }
    }
}

fn edges(mesh: &TetMesh, f: FacetId) -> [[VertexId; 2]; 3] {
    let [a, b, c] = mesh.facet_vertices(f);
    [[a, b], [b, c], [c, a]]
}

fn random_facet(mesh: &TetMesh, rng: &mut impl Rng) -> FacetId {
    let tets: Vec<TetId> = mesh.tets().collect();
    tets[rng.random_range(0..tets.len())].facet(rng.random_range(0..4))
}

#[test]
fn a_facet_flipped_to_an_edge_and_back_leaves_no_trace() {
    for (name, points) in hard_sets() {
        let mut placed = Placed::delaunay(&points);
        let before = placed.mesh.canonical();
        let facets: Vec<FacetId> = placed.mesh.facets().take(200).collect();
        for f in facets {
            let flip = placed.mesh.two_to_three(f).unwrap();
            let ends = [f, placed.mesh.twin(f)].map(|f| placed.mesh.apex(f));
            let Ok(made) = placed.mesh.flip(&flip) else {
                continue;
            };
            assert_eq!(placed.mesh.check(), Ok(()), "{name}");
            for (t, corners) in made.into_iter().zip(flip.made()) {
                assert_eq!(placed.mesh.tet_vertices(t), corners);
            }
            let back = placed.mesh.three_to_two(made[0], ends).unwrap();
            assert!(placed.mesh.flip(&back).is_ok(), "{name}: {f}");
            assert!(placed.mesh.canonical() == before, "{name}: {f}");
        }
    }
}

#[test]
fn an_edge_of_four_flipped_and_back_leaves_no_trace() {
    let mut flips = 0;
    for (name, points) in hard_sets() {
        let mut placed = Placed::delaunay(&points);
        let before = placed.mesh.canonical();
        let facets: Vec<FacetId> = placed.mesh.facets().take(200).collect();
        for f in facets {
            let (tet, ends) = (f.tet(), edges(&placed.mesh, f)[0]);
            let start = edges(&placed.mesh, f)[1][1];
            let Ok(flip) = placed.mesh.four_to_four(tet, ends, start) else {
                continue;
            };
            let Ok(made) = placed.mesh.flip(&flip) else {
                continue;
            };
            assert_eq!(placed.mesh.check(), Ok(()), "{name}");
            let new_ends = flip.new_edge().unwrap();
            let back = placed
                .mesh
                .four_to_four(made[0], new_ends, ends[0])
                .unwrap();
            assert!(placed.mesh.flip(&back).is_ok(), "{name}: {f}");
            assert!(placed.mesh.canonical() == before, "{name}: {f}");
            flips += 1;
        }
    }
    assert!(flips > 100, "{flips}");
}

#[test]
fn legal_flips_keep_space_filled() {
    for (name, points) in hard_sets() {
        let mut placed = Placed::delaunay(&points);
        let volume = placed.volume();
        let mut rng = rng(6);
        let flips = (0..300).filter(|_| {
            let f = random_facet(&placed.mesh, &mut rng);
            placed.flip_at(f)
        });
        // The triangulation between two lines is the only one.
        assert!(flips.count() > 20 || name == "skew lines", "{name}");
        assert_eq!(placed.mesh.check(), Ok(()), "{name}");
        assert!(placed.is_right_handed(), "{name}");
        let difference = (placed.volume() - volume).abs();
        let span = points
            .iter()
            .map(|p| p.abs().max_element())
            .fold(0.0, f64::max);
        assert!(difference <= 1e-12 * span.powi(3), "{name}: {difference}");
    }
}

/// Few flips away from the Delaunay triangulation, flipping what is wrong leads back to it.
#[test]
fn flipping_what_is_not_delaunay_leads_back() {
    let points = uniform(150, 12);
    let expected = Placed::delaunay(&points).mesh.canonical();
    let mut rng = rng(7);
    let mut restored = 0;
    for _ in 0..20 {
        let mut placed = Placed::delaunay(&points);
        for _ in 0..30 {
            let f = random_facet(&placed.mesh, &mut rng);
            placed.flip_at(f);
        }
        assert!(placed.lawson() > 0);
        assert_eq!(placed.mesh.check(), Ok(()));
        assert!(placed.is_right_handed());
        let wrong = placed.mesh.facets().any(|f| placed.is_wrong(f));
        // Flips may get stuck in space; where nothing is wrong the triangulation is unique.
        assert!(wrong || placed.mesh.canonical() == expected);
        restored += usize::from(!wrong);
    }
    assert!(restored >= 10, "{restored}");
}

#[test]
fn moved_vertices_are_followed_by_flips() {
    let mut placed = Placed::delaunay(&uniform(150, 13));
    let mut rng = rng(8);
    for v in 0..150 {
        let before = placed.points[v];
        let shift = DVec3::new(rng.random(), rng.random(), rng.random()) - 0.5;
        placed.points[v] += shift * 0.02;
        if !placed.is_right_handed() {
            placed.points[v] = before;
        }
    }
    let volume = placed.volume();
    assert!(placed.lawson() > 10);
    assert_eq!(
        (placed.mesh.check(), placed.is_right_handed()),
        (Ok(()), true)
    );
    assert!((placed.volume() - volume).abs() < 1e-9 * volume);
}

/// The 2-2 flip: the ring of a diagonal of a side of the cube holds two tetrahedra and two ghosts.
#[test]
fn the_diagonal_of_a_flat_hull_is_exchanged() {
    let mut placed = Placed::delaunay(&lattice([2, 2, 2]));
    let before = placed.mesh.canonical();
    let ghosts: Vec<TetId> = placed
        .mesh
        .tets()
        .filter(|&t| placed.mesh.is_ghost_tet(t))
        .collect();
    let mut flips = 0;
    for t in ghosts {
        if !placed.mesh.contains_tet(t) || !placed.mesh.is_ghost_tet(t) {
            continue;
        }
        for ends in edges(&placed.mesh, t.facet(3)) {
            let Ok(flip) = placed.mesh.four_to_four(t, ends, VertexId::GHOST) else {
                continue;
            };
            assert!(
                !flip.is_legal(placed.place()),
                "no edge leads out of the hull"
            );
            let start = placed
                .mesh
                .tet_vertices(t)
                .into_iter()
                .find(|v| !ends.contains(v) && !v.is_ghost());
            let flip = placed.mesh.four_to_four(t, ends, start.unwrap()).unwrap();
            if flip.is_legal(placed.place()) {
                let made = placed.mesh.flip(&flip).unwrap();
                assert_eq!((placed.volume(), placed.mesh.check()), (6.0, Ok(())));
                let new_ends = flip.new_edge().unwrap();
                let back = placed
                    .mesh
                    .four_to_four(made[0], new_ends, ends[0])
                    .unwrap();
                assert!(back.is_legal(placed.place()));
                assert!(placed.mesh.flip(&back).is_ok());
                assert!(placed.mesh.canonical() == before);
                flips += 1;
                break;
            }
        }
    }
    assert!(flips > 0);
}

#[test]
fn flips_that_would_break_the_complex_are_refused() {
    let mut mesh = Placed::delaunay(&[DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z]).mesh;
    let before = mesh.clone();
    let tet = mesh.tets().find(|&t| !mesh.is_ghost_tet(t)).unwrap();
    let ends = [0, 1].map(VertexId::new);
    let flip = mesh.two_to_three(tet.facet(0)).unwrap();
    insta::assert_snapshot!(mesh.flip(&flip).unwrap_err(), @"v0 and v∞ are joined already");
    let flip = mesh.three_to_two(tet, ends).unwrap();
    insta::assert_snapshot!(mesh.flip(&flip).unwrap_err(), @"v2, v3 and v∞ are the corners of a facet already");
    insta::assert_snapshot!(mesh.four_to_four(tet, ends, ends[0]).unwrap_err(), @"the edge from v0 to v1 has 3 tetrahedra round it instead of 4");
    let strange = [VertexId::new(0), VertexId::new(7)];
    insta::assert_snapshot!(mesh.three_to_two(tet, strange).unwrap_err(), @"there is no edge from v0 to v7 in t0");
    insta::assert_snapshot!(mesh.two_to_three(TetId::new(99).facet(1)).unwrap_err(), @"there is no facet t99.1");
    assert!(mesh == before);
}

#[test]
fn a_plan_is_refused_when_the_mesh_has_changed() {
    let mut placed = Placed::delaunay(&uniform(50, 14));
    let facets: Vec<FacetId> = placed.mesh.facets().collect();
    let plans = facets
        .into_iter()
        .map(|f| placed.mesh.two_to_three(f).unwrap());
    let plan = plans
        .into_iter()
        .find(|plan| placed.mesh.clone().flip(plan).is_ok())
        .unwrap();
    assert!(placed.mesh.flip(&plan).is_ok());
    let tet = plan.gone()[0];
    assert_eq!(placed.mesh.flip(&plan), Err(FlipError::Outdated { tet }));
}

proptest! {
    /// Without a look at coordinates, ghosts included.
    #[test]
    fn any_flips_that_are_not_refused_leave_a_sound_mesh(points in cloud(12), seed in any::<u64>()) {
        let Ok(delaunay) = Delaunay3::build(&points) else { return Ok(()) };
        let mut mesh = delaunay.into_mesh();
        let mut rng = rng(seed);
        for _ in 0..40 {
            let f = random_facet(&mesh, &mut rng);
            let ends = edges(&mesh, f)[rng.random_range(0..3)];
            let start = mesh.tet_vertices(f.tet())[rng.random_range(0..4)];
            let _ = match rng.random_range(0..3) {
                0 => mesh.two_to_three(f).and_then(|flip| mesh.flip(&flip)).map(|_| ()),
                1 => mesh.three_to_two(f.tet(), ends).and_then(|flip| mesh.flip(&flip)).map(|_| ()),
                _ => mesh.four_to_four(f.tet(), ends, start).and_then(|flip| mesh.flip(&flip)).map(|_| ()),
            };
            prop_assert_eq!(mesh.check(), Ok(()));
        }
    }
}
