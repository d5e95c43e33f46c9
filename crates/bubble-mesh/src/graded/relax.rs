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

/// Fewer nodes are not worth another thread.
const LEAST_SHARE: usize = 2048;

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
    let mut moves = vec![DVec2::ZERO; inner.len()];
    for step in 0..steps {
        // The last steps settle.
        let strength = if 3 * step < 2 * steps {
            STEP
        } else {
            0.5 * STEP
        };
        let settled = &*complex;
        let force = |v: VertexId| strength * force_on(settled, sizes, v);
        let shares = moves
            .par_chunks_mut(LEAST_SHARE)
            .zip(inner.par_chunks(LEAST_SHARE));
        shares.for_each(|(moves, inner)| {
            for (place, &v) in moves.iter_mut().zip(inner) {
                *place = force(v);
            }
        });
        for (&v, &by) in inner.iter().zip(&moves) {
            meter.advance()?;
            shift(complex, v, by);
        }
        if (step + 1) % STRIDE == 0 || step + 1 == steps {
            complex.restore_delaunay();
        }
    }
    Ok(())
}

/// Moves a node, by less when its triangles would turn over.
fn shift(complex: &mut Complex2, v: VertexId, mut by: DVec2) {
    let here = complex.point(v);
    for _ in 0..=HALVINGS {
        if complex.move_vertex(v, here + by) {
            return;
        }
        by *= 0.5;
    }
}

/// The sum of the forces of the neighbours on a node.
fn force_on(complex: &Complex2, sizes: &[f64], v: VertexId) -> DVec2 {
    let (here, size) = (complex.point(v), sizes[v.index()]);
    let of = |w: VertexId| {
        let arm = here - complex.point(w);
        let rest = 0.5 * (size + sizes[w.index()]);
        let squared = arm.length_squared() / (rest * rest);
        let u4 = squared * squared;
        // Close to (1 - u⁴) exp(-u⁴).
        let pull = (1.0 - u4) / (1.0 + u4 * (1.0 + u4 * (0.5 + u4 / 6.0)));
        pull * rest / arm.length() * arm
    };
    complex.mesh().neighbors(v).map(of).sum()
}
