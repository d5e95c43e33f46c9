//! Optimization of a mesh (§3.6): bubbles push each other apart and adapt their sizes, then the nodes are triangulated anew.

use std::ops::ControlFlow;

use delaunay_core::progress::{Cancelled, Meter, Progress, silent};
use delaunay_core::{Subcomplex2, VertexId};

use super::bubbles::{Bubbles, Order};
use super::confine::Tether;
use super::contacts::Contacts;
use super::force::adjust_positions;
use super::generate::Mesh;
use super::nearby::Nearby;
use super::params::Params;
use super::resize::adjust_sizes;
use super::triangulate::triangulated;
use crate::bubble::Bubble;
use crate::error::OptimizeError;

/// An optimized mesh.
#[derive(Clone, Debug)]
pub struct Optimized {
    /// The triangles. Vertices have the ids that they had.
    pub region: Subcomplex2,
    /// The bubble of each node, by vertex, amplified as they are in the optimization.
    pub bubbles: Vec<Bubble>,
    /// How often positions and sizes were adjusted: as often as asked for, unless the report closure ended it.
    pub iterations: usize,
    /// Nodes of which at least one step was not made because it would have left the region.
    pub held: Vec<VertexId>,
}

/// The bubbles with which the optimization of a mesh starts: its node bubbles, amplified. Source: §3.1.
#[must_use]
pub fn initial_bubbles(mesh: &Mesh, params: &Params) -> Vec<Bubble> {
    let amplified = |bubble: &Bubble| Bubble {
        radius: params.amplification * bubble.radius,
        ..*bubble
    };
    mesh.bubbles().iter().map(amplified).collect()
}

/// The mesh with its interior nodes moved by the forces between bubbles. Boundary nodes keep their places and sizes.
///
/// In each iteration all nodes move by the forces between bubbles as they were, then all radii adapt to the new places. Takes
/// some ten pairs of bubbles per node and iteration, on the threads of the current rayon pool, and n log n time for
/// the triangulation. The same mesh gives the same result, bit for bit, on any number of threads.
///
/// `report` is told of every iteration and ends them by [`ControlFlow::Break`]; the nodes are triangulated where they are then.
/// When it breaks before the first, the mesh is as it was.
/// Source: §3.6, steps a–e.
///
/// # Errors
/// [`OptimizeError::Amplification`] and [`OptimizeError::Step`] when the numbers in `params` are none to work with;
/// [`OptimizeError::Triangulation`] when `report` stops the triangulation at the end.
pub fn optimize(
    mesh: &Mesh,
    params: &Params,
    report: &mut dyn FnMut(Progress) -> ControlFlow<()>,
) -> Result<Optimized, OptimizeError> {
    params.check()?;
    let Ok(mut relaxation) = Relaxation::start(mesh, params, report) else {
        return Ok(unmoved(mesh, params));
    };
    match relaxation.run(params, report) {
        Ok(()) => relaxation.finish(params.iterations, report),
        Err(iterations) => relaxation.finish(iterations, &mut silent),
    }
}

fn unmoved(mesh: &Mesh, params: &Params) -> Optimized {
    Optimized {
        region: mesh.region().clone(),
        bubbles: initial_bubbles(mesh, params),
        iterations: 0,
        held: Vec::new(),
    }
}

/// The bubbles on their way.
struct Relaxation<'a> {
    /// The mesh that was generated.
    region: &'a Subcomplex2,
    order: Order,
    bubbles: Bubbles,
    contacts: Contacts,
    /// By interior node.
    tethers: Vec<Tether>,
    /// All bubbles as they will be after the step.
    next: Vec<Bubble>,
}

impl<'a> Relaxation<'a> {
    /// Step a.
    ///
    /// # Errors
    /// When `report` stops it.
    fn start(
        mesh: &'a Mesh,
        params: &Params,
        report: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Self, Cancelled> {
        let (region, first) = (mesh.region(), mesh.boundary_nodes());
        let initial = initial_bubbles(mesh, params);
        let order = Order::breadth_first(region.mesh(), first, initial.len());
        let bubbles = Bubbles::in_order(&initial, &order, first);
        let nearby = Nearby::of(region.mesh(), &order, first, report)?;
        let interior = order.vertices[first..].iter();
        Ok(Self {
            region,
            contacts: Contacts::of(nearby, &bubbles),
            tethers: interior.map(|&node| Tether::of(region, node)).collect(),
            next: bubbles.all.clone(),
            bubbles,
            order,
        })
    }

    /// Steps b to d.
    ///
    /// # Errors
    /// How many iterations there were when `report` ended them.
    fn run(
        &mut self,
        params: &Params,
        report: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<(), usize> {
        let mut meter = Meter::start(report, "relax", params.iterations).map_err(|_| 0usize)?;
        for done in 1..=params.iterations {
            self.adjust_positions(params.step);
            self.adjust_sizes();
            meter.reach(done).map_err(|_| done)?;
        }
        Ok(())
    }

    /// Step b.
    fn adjust_positions(&mut self, step: f64) {
        let strayed = adjust_positions(
            &self.bubbles,
            &self.contacts,
            step,
            self.region,
            &mut self.tethers,
            &mut self.next[self.bubbles.boundary_nodes..],
        );
        self.adopt(strayed);
    }

    /// Step c.
    fn adjust_sizes(&mut self) {
        let interior = &mut self.next[self.bubbles.boundary_nodes..];
        let strayed = adjust_sizes(&self.bubbles, &self.contacts, interior);
        self.adopt(strayed);
    }

    /// Makes the next bubbles the present ones.
    fn adopt(&mut self, strayed: bool) {
        std::mem::swap(&mut self.bubbles.all, &mut self.next);
        if strayed {
            self.contacts.renew(&self.bubbles);
        }
    }

    /// Step e.
    fn finish(
        self,
        iterations: usize,
        report: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Optimized, OptimizeError> {
        let interior = &self.order.vertices[self.bubbles.boundary_nodes..];
        let nodes = interior.iter().zip(&self.tethers);
        let held = nodes.filter(|(_, tether)| tether.has_refused());
        let mut held: Vec<VertexId> = held.map(|(&node, _)| node).collect();
        held.sort_unstable();
        let mut bubbles = self.bubbles.by_vertex(&self.order);
        Ok(Optimized {
            region: triangulated(self.region, &mut bubbles, report)?,
            bubbles,
            iterations,
            held,
        })
    }
}
