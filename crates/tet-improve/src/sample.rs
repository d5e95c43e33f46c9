//! Meshes to test on.

use crate::plan::Exchange;
use crate::records::Records;
use delaunay_core::geo_predicates::{Sign, orient3d};
use delaunay_core::measure::tetrahedron::signed_volume;
use delaunay_core::{Complex3, Delaunay3, Subcomplex3, TetId, VertexId};
use glam::DVec3;
use std::collections::BTreeMap;

/// Numbers that look random (Knuth's linear congruential generator).
pub(crate) struct Random(u64);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// From 0 up to 1.
    pub(crate) fn number(&mut self) -> f64 {
        let next = self.0.wrapping_mul(6_364_136_223_846_793_005);
        self.0 = next.wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// In the cube of side 1 round the origin.
    pub(crate) fn vector(&mut self) -> DVec3 {
        DVec3::from([(); 3].map(|()| self.number() - 0.5))
    }
}

/// A cube with a lattice of vertices on its faces and random ones inside, where slivers abound.
pub(crate) fn cube(side: u32, seed: u64) -> Complex3 {
    let mut random = Random::new(seed);
    let numbers = 0..=side;
    let all = numbers
        .clone()
        .flat_map(|x| numbers.clone().map(move |y| [x, y]));
    let all = all.flat_map(|[x, y]| numbers.clone().map(move |z| [x, y, z]));
    let points = all.map(|place| {
        let inside = place.iter().all(|&x| 0 < x && x < side);
        DVec3::from(place.map(f64::from)) + f64::from(u8::from(inside)) * 0.8 * random.vector()
    });
    let points: Vec<DVec3> = points.collect();
    let delaunay = Delaunay3::build(&points).unwrap();
    Complex3::from(Subcomplex3::of(&delaunay, |_| true))
}

/// Carries out what `plan` finds for each tetrahedron in turn, none of which may be refused; tells how many there were.
pub(crate) fn exercise(
    mut complex: Complex3,
    mut plan: impl FnMut(&Complex3, &Records, TetId) -> Option<Exchange>,
) -> usize {
    let frame = Frame::of(&complex);
    let mut records = Records::of(&complex);
    let mut count = 0;
    for t in complex.tets().collect::<Vec<_>>() {
        let is_there = complex.mesh().contains_tet(t) && !complex.mesh().is_ghost_tet(t);
        if let Some(plan) = is_there.then(|| plan(&complex, &records, t)).flatten() {
            let new = complex.replace(&plan.gone, &plan.made).unwrap();
            records.note_change(&complex, &plan.gone, &new);
            assert_eq!(records.worst(&new), plan.quality);
            frame.assert_holds(&complex);
            count += 1;
        }
    }
    count
}

/// What no change may change: facets of the boundary, and the volume up to rounding.
pub(crate) struct Frame {
    boundary: BTreeMap<[VertexId; 3], usize>,
    volume: f64,
}

impl Frame {
    pub(crate) fn of(complex: &Complex3) -> Self {
        let mut boundary = BTreeMap::new();
        for f in complex.boundary() {
            let mut corners = complex.mesh().facet_vertices(f);
            corners.sort_unstable();
            *boundary.entry(corners).or_insert(0) += 1;
        }
        let volumes = complex
            .tets()
            .map(|t| signed_volume(complex.tetrahedron(t)));
        Self {
            boundary,
            volume: volumes.sum(),
        }
    }

    /// Panics unless the mesh is one, right-handed, in this frame.
    pub(crate) fn assert_holds(&self, complex: &Complex3) {
        assert_eq!(complex.mesh().check(), Ok(()));
        for t in complex.tets() {
            let [a, b, c, d] = complex.tetrahedron(t);
            assert_eq!(orient3d(a, b, c, d), Sign::Positive);
        }
        let now = Self::of(complex);
        assert_eq!(now.boundary, self.boundary);
        assert!((now.volume / self.volume - 1.0).abs() < 1e-13);
    }
}
