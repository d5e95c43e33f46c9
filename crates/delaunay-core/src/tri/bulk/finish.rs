//! From numbers in insertion order to the caller's.

use super::super::mesh::{Face, TriMesh};
use super::fill::faces_of;
use super::rounds::Bulk;
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::memory::vec_of;
use crate::options::BuildOptions;
use crate::threads;

/// A mesh over the caller's points.
pub(in super::super) struct Finish {
    pub(in super::super) mesh: TriMesh,
    /// Pairs (duplicate, its vertex).
    pub(in super::super) duplicates: Vec<(VertexId, VertexId)>,
}

impl Bulk {
    /// Passes from vertex slots in insertion order to the caller's numbers, given in that order; of equal
    /// points the smallest number stands for all. Uses `memory` for one number per vertex slot.
    pub(in super::super) fn finish(
        mut self,
        order: &[u32],
        memory: &mut [u64],
        options: BuildOptions,
    ) -> Finish {
        self.close_gaps();
        let names = Name::all_in(&mut memory[..=order.len()]);
        names[0] = Name::new(VertexId::GHOST);
        for (name, &index) in names[1..].iter_mut().zip(order) {
            *name = Name::new(VertexId::new(index as usize));
        }
        self.name_duplicates(names);
        let mut outgoing = vec_of(HalfEdgeId::NONE, names.len(), options.huge_pages);
        match options.threads.get() {
            1 => name_corners(&mut self.faces, names, &mut outgoing),
            threads => name_corners_together(&mut self.faces, names, &mut outgoing, threads),
        }
        Finish {
            mesh: TriMesh {
                faces: self.faces,
                outgoing,
            },
            duplicates: self.duplicates,
        }
    }

    /// Gives the smallest of the names at one place to the vertex there.
    fn name_duplicates(&mut self, names: &mut [Name]) {
        for (duplicate, vertex) in &self.duplicates {
            if names[duplicate.slot()].vertex < names[vertex.slot()].vertex {
                names.swap(duplicate.slot(), vertex.slot());
            }
        }
        for pair in &mut self.duplicates {
            *pair = (names[pair.0.slot()].vertex, names[pair.1.slot()].vertex);
        }
    }

    /// Moves all faces behind the vacant ones of duplicates to the front.
    fn close_gaps(&mut self) {
        if self.duplicates.is_empty() {
            return;
        }
        let mut vacant: Vec<u32> = vec![0; self.faces.len()];
        for &(duplicate, _) in &self.duplicates {
            for f in faces_of(duplicate) {
                vacant[f.index()] = 1;
            }
        }
        // From here on: how many faces before each are vacant.
        let mut before = 0;
        for count in &mut vacant {
            before += std::mem::replace(count, before);
        }
        let moved = |h: HalfEdgeId| {
            let f = FaceId::new(h.face().index() - vacant[h.face().index()] as usize);
            f.half_edge(h.corner())
        };
        self.faces.retain(|face| *face != Face::VACANT);
        for face in &mut self.faces {
            face.twin = face.twin.map(moved);
        }
    }
}

/// What a vertex slot in insertion order stands for. Name and half-edge are side by side, because a pass over the
/// corners needs them together.
#[derive(Clone, Copy)]
struct Name {
    vertex: VertexId,
    /// A half-edge that leaves the vertex, when found.
    outgoing: HalfEdgeId,
}

impl Name {
    fn new(vertex: VertexId) -> Self {
        let outgoing = HalfEdgeId::NONE;
        Self { vertex, outgoing }
    }

    /// Names of anything in memory that is used for something else before and after.
    fn all_in(memory: &mut [u64]) -> &mut [Self] {
        const { assert!(size_of::<Self>() == 8 && align_of::<Self>() <= align_of::<u64>()) };
        let names = memory.as_mut_ptr().cast();
        // SAFETY: a name is two numbers of 32 bits, for which any bits are valid, and fits in one of 64; the memory
        // is borrowed as long as the names.
        unsafe { std::slice::from_raw_parts_mut(names, memory.len()) }
    }
}

/// Gives each corner the name in its slot, and `outgoing` the half-edge with the smallest id that leaves each vertex, by
/// its new slot.
fn name_corners(faces: &mut [Face], names: &mut [Name], outgoing: &mut [HalfEdgeId]) {
    for (index, face) in faces.iter_mut().enumerate().rev() {
        let f = FaceId::new(index);
        bring_origins_back(face);
        for corner in (0..3).rev() {
            let name = &mut names[face.origin[corner].slot()];
            name.outgoing = f.half_edge(corner);
            face.origin[corner] = name.vertex;
        }
    }
    for name in names {
        outgoing[name.vertex.slot()] = name.outgoing;
    }
}

/// From apexes in the place of origins, as the [arena](super::arena::Arena) keeps them, to origins.
#[inline(always)]
fn bring_origins_back(face: &mut Face) {
    face.origin.rotate_left(1);
}

/// As [`name_corners`], on several threads, each of which looks at a share of the faces.
///
/// Each has a list of half-edges of its own for all vertices, so there are at most four.
fn name_corners_together(
    faces: &mut [Face],
    names: &[Name],
    outgoing: &mut [HalfEdgeId],
    threads: usize,
) {
    let share = threads::share(faces.len(), threads.min(4));
    let shares = faces.chunks_mut(share).enumerate().collect();
    let lists = threads::map(shares, |(number, faces)| {
        let mut first = vec![HalfEdgeId::NONE; names.len()];
        for (index, face) in faces.iter_mut().enumerate().rev() {
            let f = FaceId::new(number * share + index);
            bring_origins_back(face);
            for corner in (0..3).rev() {
                let slot = face.origin[corner].slot();
                first[slot] = f.half_edge(corner);
                face.origin[corner] = names[slot].vertex;
            }
        }
        first
    });
    let first = |slot: usize| {
        let found = lists.iter().map(|first| first[slot]);
        let mut found = found.filter(|&h| h != HalfEdgeId::NONE);
        found.next().unwrap_or(HalfEdgeId::NONE)
    };
    let places = outgoing.len();
    let target = Scattered(outgoing.as_mut_ptr());
    let share = threads::share(names.len(), threads);
    let shares = names.chunks(share).enumerate().collect();
    threads::for_each(shares, |(number, names)| {
        for (slot, name) in (number * share..).zip(names) {
            debug_assert!(name.vertex.slot() < places);
            // SAFETY: names are the slots of `outgoing` in another order, so each place is there and is written
            // once, by one thread.
            unsafe { target.place(name.vertex.slot()).write(first(slot)) };
        }
    });
}

/// An array that several threads write to, each at other places.
struct Scattered(*mut HalfEdgeId);

// SAFETY: all it does is to tell addresses.
unsafe impl Sync for Scattered {}

impl Scattered {
    fn place(&self, slot: usize) -> *mut HalfEdgeId {
        self.0.wrapping_add(slot)
    }
}
