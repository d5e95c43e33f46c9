//! Forces between neighbours even out the places of nodes (Bossen and Heckbert 1996, with a force that needs no exponential).
//!
//! With u the length of an edge over the mean size of its ends, the ends repel each other where u is below 1 and attract each other above,
//! less and less where u grows. All forces are taken from the places before; after a few steps the triangles are made
//! Delaunay again.

use delaunay_core::progress::{Cancelled, Meter};
use delaunay_core::{Complex2, VertexId};
use glam::DVec2;
use rayon::prelude::*;

/// Steps between two restorations of the Delaunay triangles.
const STRIDE: usize = 5;

/// How far the forces move a node.
const STEP: f64 = 0.2;

/// A step is halved so often before it is left out.
const HALVINGS: usize = 3;

/// Nodes that one thread works on at a time.
const SHARE: usize = 2048;

/// Moves the inner nodes so many times; `sizes` are by vertex. The same on any number of threads.
///
/// # Errors
/// When the meter stops it; the mesh is valid then too.
pub(super) fn relax(
    complex: &mut Complex2,
    sizes: &[f64],
    steps: usize,
    meter: &mut Meter<'_>,
) -> Result<(), Cancelled> {
    let inner: Vec<VertexId> = complex.inner_vertices().collect();
    let mut neighbors = Neighbors::default();
    let mut places = vec![DVec2::ZERO; inner.len()];
    for step in 0..steps {
        if step % STRIDE == 0 {
            complex.restore_delaunay();
            neighbors.list(complex, &inner);
        }
        // The last steps settle.
        let strength = if 3 * step < 2 * steps {
            STEP
        } else {
            0.5 * STEP
        };
        neighbors.push(complex, sizes, strength, &inner, &mut places);
        if !complex.move_vertices(&inner, &places) {
            for (&v, &place) in inner.iter().zip(&places) {
                shift(complex, v, place);
            }
        }
        for _ in &inner {
            meter.advance()?;
        }
    }
    complex.restore_delaunay();
    Ok(())
}

/// Moves a node towards a place, not all the way when its triangles would turn over.
fn shift(complex: &mut Complex2, v: VertexId, place: DVec2) {
    let here = complex.point(v);
    let mut share = 1.0;
    for _ in 0..=HALVINGS {
        if complex.move_vertex(v, here.lerp(place, share)) {
            return;
        }
        share *= 0.5;
    }
}

/// The neighbours of the inner nodes, one list after the other.
#[derive(Debug, Default)]
struct Neighbors {
    /// By inner node, where its list ends.
    ends: Vec<u32>,
    vertices: Vec<VertexId>,
}

impl Neighbors {
    fn list(&mut self, complex: &Complex2, inner: &[VertexId]) {
        self.ends.clear();
        self.vertices.clear();
        for &v in inner {
            self.vertices.extend(complex.mesh().neighbors(v));
            self.ends.push(self.vertices.len() as u32);
        }
    }

    /// Writes where the forces of the neighbours push the inner nodes.
    fn push(
        &self,
        complex: &Complex2,
        sizes: &[f64],
        strength: f64,
        inner: &[VertexId],
        places: &mut [DVec2],
    ) {
        let shares = places.par_chunks_mut(SHARE).enumerate();
        shares.for_each(|(share, places)| {
            let first = share * SHARE;
            let mut start = first.checked_sub(1).map_or(0, |before| self.ends[before]) as usize;
            for (k, place) in (first..).zip(places) {
                let end = self.ends[k] as usize;
                let v = inner[k];
                let force = force_on(complex, sizes, v, &self.vertices[start..end]);
                *place = complex.point(v) + strength * force;
                start = end;
            }
        });
    }
}

/// The sum of the forces of the neighbours on a node.
#[inline]
fn force_on(complex: &Complex2, sizes: &[f64], v: VertexId, neighbors: &[VertexId]) -> DVec2 {
    let (here, size) = (complex.point(v), sizes[v.index()]);
    let of = |&w: &VertexId| {
        let arm = here - complex.point(w);
        let rest = 0.5 * (size + sizes[w.index()]);
        let (length, rest_squared) = (arm.length_squared(), rest * rest);
        // With u = length / rest: close to (1 - u⁴) exp(-u⁴).
        let u2 = length / rest_squared;
        let u4 = u2 * u2;
        let pull = (1.0 - u4) / (1.0 + u4 * (1.0 + u4 * (0.5 + u4 / 6.0)));
        pull * (rest_squared / length).sqrt() * arm
    };
    neighbors.iter().map(of).sum()
}
