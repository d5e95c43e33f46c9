//! Forces between neighbours even out the places of nodes (Bossen and Heckbert 1996, with a force that needs no exponential).
//!
//! With u the length of an edge over the mean size of its ends, the ends repel each other where u is below 1 and attract each other above,
//! less and less where u grows. All forces are taken from the places before; after a few steps the mesh follows, and its
//! triangles are made Delaunay again.

use delaunay_core::progress::{Cancelled, Meter};
use delaunay_core::{Complex2, VertexId};
use glam::DVec2;
use rayon::prelude::*;
use std::collections::VecDeque;

/// Steps between two restorations of the Delaunay triangles.
const STRIDE: usize = 5;

/// How far the forces move a node.
const STEP: f64 = 0.2;

/// A move is halved so often before it is left out.
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
    let mut swarm = Swarm::of(complex, sizes);
    let mut step = 0;
    while step < steps && swarm.inner > 0 {
        complex.restore_delaunay();
        swarm.take(complex);
        let end = (step + STRIDE).min(steps);
        for step in step..end {
            // The last steps settle.
            swarm.step(if step < steps - steps / 3 {
                STEP
            } else {
                0.5 * STEP
            });
            for _ in 0..swarm.inner {
                meter.advance()?;
            }
        }
        swarm.put_back(complex);
        step = end;
    }
    complex.restore_delaunay();
    Ok(())
}

/// The nodes, the inner ones first, each kind in the order in which a breadth-first search meets them: what is near in the mesh is
/// near in memory.
struct Swarm {
    vertices: Vec<VertexId>,
    /// By vertex index.
    numbers: Vec<u32>,
    inner: usize,
    sizes: Vec<f64>,
    places: Vec<DVec2>,
    /// The places of the inner nodes after a step.
    next: Vec<DVec2>,
    /// By inner node, where the list of its neighbours ends.
    ends: Vec<u32>,
    neighbors: Vec<Neighbor>,
}

#[derive(Clone, Copy, Debug)]
struct Neighbor {
    number: u32,
    /// One over the square of the length at which the force is zero.
    scale: f64,
}

impl Swarm {
    fn of(complex: &Complex2, sizes: &[f64]) -> Self {
        let met = breadth_first(complex);
        let (mut vertices, fixed): (Vec<VertexId>, Vec<VertexId>) =
            met.into_iter().partition(|&v| complex.is_inner(v));
        let inner = vertices.len();
        vertices.extend(fixed);
        let mut numbers = vec![0; complex.points().len()];
        for (number, v) in (0..).zip(&vertices) {
            numbers[v.index()] = number;
        }
        Self {
            inner,
            sizes: vertices.iter().map(|v| sizes[v.index()]).collect(),
            places: vec![DVec2::ZERO; vertices.len()],
            next: vec![DVec2::ZERO; inner],
            ends: Vec::new(),
            neighbors: Vec::new(),
            vertices,
            numbers,
        }
    }

    /// Takes places and neighbours from the mesh.
    fn take(&mut self, complex: &Complex2) {
        self.ends.clear();
        self.neighbors.clear();
        for (place, &v) in self.places.iter_mut().zip(&self.vertices) {
            *place = complex.point(v);
        }
        for (&v, size) in self.vertices[..self.inner].iter().zip(&self.sizes) {
            let beside = complex.mesh().neighbors(v);
            self.neighbors.extend(beside.map(|w| {
                let number = self.numbers[w.index()];
                let rest = 0.5 * (size + self.sizes[number as usize]);
                let scale = 1.0 / (rest * rest);
                Neighbor { number, scale }
            }));
            self.ends.push(self.neighbors.len() as u32);
        }
    }

    /// Moves all inner nodes by the forces of their neighbours.
    fn step(&mut self, strength: f64) {
        let Self {
            places,
            next,
            ends,
            neighbors,
            ..
        } = self;
        next.par_chunks_mut(SHARE)
            .enumerate()
            .for_each(|(share, next)| {
                let first = share * SHARE;
                let mut start = first.checked_sub(1).map_or(0, |before| ends[before]) as usize;
                for (k, next) in (first..).zip(next) {
                    let end = ends[k] as usize;
                    let others = neighbors[start..end].iter();
                    let others = others.map(|other| (places[other.number as usize], other.scale));
                    *next = places[k] + strength * force_on(places[k], others);
                    start = end;
                }
            });
        places[..next.len()].copy_from_slice(next);
    }

    /// Moves the nodes of the mesh to their places, or where triangles would turn over one after the other and not all the way.
    fn put_back(&self, complex: &mut Complex2) {
        let (inner, places) = (&self.vertices[..self.inner], &self.places[..self.inner]);
        if complex.move_vertices(inner, places) {
            return;
        }
        for (&v, &place) in inner.iter().zip(places) {
            let here = complex.point(v);
            let shares = (0..=HALVINGS as i32).map(|halvings| 0.5_f64.powi(halvings));
            let mut tried = shares.map(|share| here.lerp(place, share));
            let _ = tried.any(|there| complex.move_vertex(v, there));
        }
    }
}

/// The sum of the forces on a node from others, each with one over the square of the length at which its force is zero.
#[inline]
fn force_on(here: DVec2, others: impl Iterator<Item = (DVec2, f64)>) -> DVec2 {
    let of = |(there, scale): (DVec2, f64)| {
        let arm = here - there;
        // With u = length / rest: close to (1 - u⁴) exp(-u⁴) / u.
        let u2 = (arm.length_squared() * scale).max(f64::MIN_POSITIVE);
        let u4 = u2 * u2;
        let fall = 1.0 + u4 * (1.0 + u4 * (0.5 + u4 / 6.0));
        (1.0 - u4) / (fall * u2.sqrt()) * arm
    };
    others.map(of).sum()
}

/// All vertices, each part of the mesh from one of them on.
fn breadth_first(complex: &Complex2) -> Vec<VertexId> {
    let mesh = complex.mesh();
    let mut met = vec![false; complex.points().len()];
    let mut order = Vec::with_capacity(met.len());
    let mut front = VecDeque::new();
    for start in (0..met.len()).map(VertexId::new) {
        if mesh.outgoing(start).is_some() {
            front.push_back(start);
        }
        while let Some(v) = front.pop_front() {
            if std::mem::replace(&mut met[v.index()], true) {
                continue;
            }
            order.push(v);
            let beside = mesh.neighbors(v).filter(|w| !w.is_ghost());
            front.extend(beside.filter(|w| !met[w.index()]));
        }
    }
    order
}
