//! The growing triangulation: records, slots, and the loop over all points.

use super::arena::{Arena, Site};
use super::circumsphere::{Circumsphere, arm};
use super::inserter::{Inserter, is_wide};
use super::pile::Pile;
use super::star::Star;
use crate::error::BuildError;
use crate::ids::{FacetId, TetId, VertexId};
use crate::memory::{prefer_huge_pages, try_vec_with_capacity, vec_with_capacity};
use crate::options::BuildOptions;
use crate::order::Order;
use crate::progress::Meter;
use crate::tet::mesh::{Tet, TetMesh};
use crate::tet::sight::Places;
use crate::tet::simplex::{FlatCause, first_simplex, glue_simplex};
use geo_predicates::filter::{Filter3, StaticFilter3};
use glam::DVec3;
use std::ops::Range;

/// Slots reserved per point: uniform points have 6.77 tetrahedra each.
const SLOTS_PER_POINT: usize = 8;

/// Slots that a part has for tetrahedra beyond what is to be expected.
const SLACK: usize = 2048;

/// Points inserted between two looks at the stamps, of which there are two for each in 32 bits.
pub(super) const MOST_POINTS: usize = 1 << 30;

/// A triangulation of points numbered in the order of their insertion.
pub(in crate::tet) struct Grown {
    pub(in crate::tet) mesh: TetMesh,
    /// Pairs (duplicate, its vertex).
    pub(in crate::tet) duplicates: Vec<(VertexId, VertexId)>,
}

/// Why there is no triangulation.
pub(in crate::tet) enum NotGrown {
    Flat(FlatCause),
    Failed(BuildError),
}

impl From<BuildError> for NotGrown {
    fn from(error: BuildError) -> Self {
        Self::Failed(error)
    }
}

/// Triangulates `points` in the order given, on as many threads as the options say.
pub(in crate::tet) fn grow(
    points: &[DVec3],
    order: &Order,
    options: BuildOptions,
    meter: &mut Meter<'_>,
) -> Result<Grown, NotGrown> {
    let sites = sites_in_order(points, &order.indices, options);
    let simplex = first_simplex(sites.as_slice(), sites.len()).map_err(NotGrown::Flat)?;
    let mut growth = Growth::of_simplex(points, sites, simplex, options)?;

    for round in 0..order.rounds.len() {
        growth.insert_round(order, round, options.threads.get(), meter)?;
    }
    Ok(growth.finish())
}

/// The points in insertion order behind the ghost; `-0.0` becomes `0.0`.
fn sites_in_order(points: &[DVec3], order: &[u32], options: BuildOptions) -> Vec<Site> {
    let mut sites = vec_with_capacity(points.len() + 1, options.huge_pages);
    sites.push(Site::ghost());
    let places = order.iter().map(|&index| points[index as usize]);
    sites.extend(places.map(|p| Site::at(p + DVec3::ZERO)));
    sites
}

impl Places for &[Site] {
    fn place(self, v: VertexId) -> DVec3 {
        self[v.slot()].place
    }
}

/// The records while points come in.
pub(super) struct Growth {
    tets: Vec<Tet>,
    spheres: Vec<Circumsphere>,
    sites: Vec<Site>,
    /// The vertices that were there from the start.
    simplex: [VertexId; 4],
    filter: Filter3,
    box_filter: StaticFilter3,
    huge_pages: bool,
    free: Vec<TetId>,
    stamp: u32,
    last: TetId,
    /// Points that are in, duplicates among them.
    done: usize,
    duplicates: Vec<(VertexId, VertexId)>,
}

impl Growth {
    /// The triangulation of four of the sites.
    fn of_simplex(
        points: &[DVec3],
        sites: Vec<Site>,
        simplex: [VertexId; 4],
        options: BuildOptions,
    ) -> Result<Self, BuildError> {
        let mut mesh = TetMesh::default();
        glue_simplex(&mut mesh, simplex);
        let slack = if options.threads.get() > 1 {
            2 * SLACK * options.threads.get()
        } else {
            64
        };
        let room = (SLOTS_PER_POINT * points.len() + slack).min(TetId::LIMIT);
        let no_memory = |_| BuildError::TooManyTets { tets: 0 };
        let mut tets = try_vec_with_capacity(room, options.huge_pages).map_err(no_memory)?;
        tets.extend_from_slice(&mesh.tets);
        let mut spheres = try_vec_with_capacity(room, options.huge_pages).map_err(no_memory)?;
        spheres.extend(tets.iter().map(|tet| sphere_of(&sites, tet)));
        let nowhere = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        let (least, greatest) = points
            .iter()
            .fold(nowhere, |(low, high), &p| (low.min(p), high.max(p)));
        Ok(Self {
            tets,
            spheres,
            sites,
            simplex,
            filter: Filter3::for_points(points),
            box_filter: StaticFilter3::of_box(least, greatest),
            huge_pages: options.huge_pages,
            free: Vec::new(),
            stamp: 0,
            last: TetId::new(0),
            done: 4,
            duplicates: Vec::new(),
        })
    }

    /// Whether `v` was there from the start.
    pub(super) fn is_in_simplex(&self, v: VertexId) -> bool {
        self.simplex.contains(&v)
    }

    /// The tetrahedra, vacant slots included.
    pub(super) fn tets(&self) -> &[Tet] {
        &self.tets
    }

    /// The part to which `v`, a real vertex, was given.
    pub(super) fn part_of(&self, v: VertexId) -> u16 {
        self.sites[v.slot()].part()
    }

    /// Gives the vertices of a range of slots to `part`.
    pub(super) fn set_part(&mut self, slots: Range<usize>, part: u16) {
        for site in &mut self.sites[slots] {
            site.set_part(part);
        }
    }

    /// Inserts `points` on this thread.
    pub(super) fn insert_all(
        &mut self,
        points: &[VertexId],
        meter: &mut Meter<'_>,
    ) -> Result<(), BuildError> {
        let mut rest = points;
        while !rest.is_empty() {
            let some = &rest[..rest.len().min(MOST_POINTS)];
            self.refresh_stamps(some.len());
            let mut inserter: Inserter<false> = self.inserter(0);
            let outcome = inserter.insert_while_room(some, meter, &mut self.duplicates);
            self.free = inserter.free;
            self.stamp = inserter.stamp;
            self.last = inserter.last;
            // SAFETY: slots below the first fresh one were taken in order and written.
            unsafe { self.set_used(inserter.fresh.start) };
            let done = outcome?;
            self.done += done;
            rest = &rest[done..];
            if done < some.len() {
                // More than there is, in case one star alone needs it.
                let free = self.room() - self.tets.len();
                self.make_room(free + self.tets.len() / 2 + SLACK)?;
            }
        }
        Ok(())
    }

    /// Inserters for parts with these numbers of points, with slots for as many tetrahedra as points had
    /// so far, and some more.
    pub(super) fn inserters(&mut self, sizes: &[usize]) -> Vec<Inserter<true>> {
        self.refresh_stamps(sizes.iter().sum());
        let per_point = 1.03 * self.tets.len() as f64 / self.done as f64;
        let slots = |points: usize| (per_point * points as f64) as usize + SLACK;
        let wanted: usize = sizes.iter().map(|&points| slots(points)).sum();
        // Where there is less room than wanted, points come late, and what is too much then is an error.
        let _ = self.make_room(wanted);
        let room = self.room().min(TetId::LIMIT);
        let (mut start, mut stamp) = (self.tets.len(), self.stamp);
        let free = std::mem::take(&mut self.free);
        let mut shares = free.chunks(free.len() / sizes.len() + 1);
        let parts = sizes.iter().enumerate().map(|(part, &points)| {
            let mut inserter = self.inserter(part as u16);
            inserter.free = shares.next().unwrap_or_default().to_vec();
            inserter.fresh = start.min(room)..(start + slots(points)).min(room);
            inserter.stamp = stamp;
            start += slots(points);
            stamp += 2 * points as u32;
            inserter
        });
        parts.collect()
    }

    /// Takes over what the parts have done: `done` points are in.
    pub(super) fn take_back(&mut self, inserters: Vec<Inserter<true>>, done: usize) {
        self.done += done;
        let parts = inserters.len();
        for (part, inserter) in inserters.into_iter().enumerate() {
            self.free.extend(inserter.free);
            self.stamp = self.stamp.max(inserter.stamp);
            if inserter.has_start {
                self.last = inserter.last;
            }
            let left_over = inserter
                .fresh
                .clone()
                .map(|slot| TetId::from_raw(slot as u32));
            if part + 1 < parts {
                for t in left_over {
                    inserter.arena.put(t, Tet::VACANT, Circumsphere::UNKNOWN);
                    self.free.push(t);
                }
            } else {
                // SAFETY: slots below the first fresh one of the last part were written by a part, or
                // just now.
                unsafe { self.set_used(inserter.fresh.start) };
            }
        }
    }

    /// An inserter over all slots in use, with what is free and fresh.
    fn inserter<const SHARED: bool>(&mut self, part: u16) -> Inserter<SHARED> {
        let used = self.tets.len();
        // SAFETY: until the inserter is taken back, the vectors are left alone by everyone else.
        let arena = unsafe { Arena::over(&mut self.tets, &mut self.spheres, &mut self.sites) };
        Inserter {
            arena,
            filter: self.filter,
            box_filter: self.box_filter,
            part,
            is_wide: is_wide(),
            fresh: used..arena.room().min(TetId::LIMIT),
            free: std::mem::take(&mut self.free),
            stamp: self.stamp,
            has_start: !SHARED,
            last: self.last,
            dug: Pile::new(TetId::from_raw(0)),
            outer: Pile::new(FacetId::from_raw(0)),
            inner: Pile::new(FacetId::from_raw(0)),
            star: Star::boxed(),
            aim: 0,
        }
    }

    /// Makes sure that stamps for `points` insertions more are greater than all given out.
    fn refresh_stamps(&mut self, points: usize) {
        if self.stamp as usize + 2 * points + 2 < u32::MAX as usize {
            return;
        }
        self.stamp = 0;
        self.spheres.iter_mut().for_each(|sphere| sphere.stamp = 0);
        let real = self.sites.iter_mut().skip(1);
        real.for_each(Site::clear_stamp);
    }

    /// Counts the slots up to `used` as in use.
    ///
    /// # Safety
    /// They must be within the capacity and written, tetrahedra and spheres.
    unsafe fn set_used(&mut self, used: usize) {
        debug_assert!(used <= self.tets.capacity() && used <= self.spheres.capacity());
        // SAFETY: as the caller promises.
        unsafe {
            self.tets.set_len(used);
            self.spheres.set_len(used);
        }
    }

    /// The slots that there is memory for.
    fn room(&self) -> usize {
        self.tets.capacity().min(self.spheres.capacity())
    }

    /// Makes room for so many tetrahedra more.
    fn make_room(&mut self, more: usize) -> Result<(), BuildError> {
        let tets = self.tets.len();
        let room = self.room() - tets;
        if more <= room {
            return Ok(());
        }
        let more = more.min(TetId::LIMIT - tets);
        if more <= room
            || self.tets.try_reserve_exact(more).is_err()
            || self.spheres.try_reserve_exact(more).is_err()
        {
            return Err(BuildError::TooManyTets { tets });
        }
        if self.huge_pages {
            prefer_huge_pages(self.tets.spare_capacity_mut());
            prefer_huge_pages(self.spheres.spare_capacity_mut());
        }
        Ok(())
    }

    /// The finished mesh, without gaps and without homes.
    fn finish(self) -> Grown {
        drop((self.spheres, self.sites));
        let mut mesh = TetMesh {
            tets: self.tets,
            vacant: self.free,
            homes: Vec::new(),
        };
        mesh.fill_gaps();
        Grown {
            mesh,
            duplicates: self.duplicates,
        }
    }

    /// Notes pairs (duplicate, its vertex).
    pub(super) fn note_duplicates(&mut self, pairs: Vec<(VertexId, VertexId)>) {
        self.duplicates.extend(pairs);
    }
}

fn sphere_of(sites: &[Site], tet: &Tet) -> Circumsphere {
    let [p, a, b, c] = tet.vertex.map(|v| sites[v.slot()].place);
    Circumsphere::through(p, &arm(a, p), &arm(b, p), &arm(c, p))
}
