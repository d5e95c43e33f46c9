//! The growing triangulation: records, slots, and the loop over all points.

use super::arena::{Arena, Site};
use super::circumsphere::{Circumsphere, arm};
use super::inserter::{Inserter, Outcome, is_wide};
use super::pile::Pile;
use super::star::Star;
use crate::error::BuildError;
use crate::ids::{FacetId, TetId, VertexId};
use crate::memory::{prefer_huge_pages, vec_with_capacity};
use crate::options::BuildOptions;
use crate::order::Order;
use crate::progress::Meter;
use crate::tet::mesh::{Tet, TetMesh};
use crate::tet::sight::Places;
use crate::tet::simplex::{FlatCause, first_simplex, glue_simplex};
use geo_predicates::filter::{Filter3, StaticFilter3};
use glam::DVec3;

/// Slots reserved per point: uniform points have 6.77 tetrahedra each.
const SLOTS_PER_POINT: usize = 7;

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
    let mut growth = Growth::of_simplex(points, sites, simplex, options);
    growth.insert_rest(simplex, meter)?;
    Ok(growth.finish())
}

/// The points in insertion order behind the ghost; `-0.0` becomes `0.0`.
fn sites_in_order(points: &[DVec3], order: &[u32], options: BuildOptions) -> Vec<Site> {
    let mut sites = vec_with_capacity(points.len() + 1, options.huge_pages);
    sites.push(Site::GHOST);
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
struct Growth {
    tets: Vec<Tet>,
    spheres: Vec<Circumsphere>,
    sites: Vec<Site>,
    filter: Filter3,
    box_filter: StaticFilter3,
    huge_pages: bool,
    free: Vec<TetId>,
    stamp: u32,
    last: TetId,
    duplicates: Vec<(VertexId, VertexId)>,
}

impl Growth {
    /// The triangulation of four of the sites.
    fn of_simplex(
        points: &[DVec3],
        sites: Vec<Site>,
        simplex: [VertexId; 4],
        options: BuildOptions,
    ) -> Self {
        let mut mesh = TetMesh::default();
        glue_simplex(&mut mesh, simplex);
        let room = (SLOTS_PER_POINT * points.len() + 64).min(TetId::LIMIT);
        let mut tets = vec_with_capacity(room, options.huge_pages);
        tets.extend_from_slice(&mesh.tets);
        let mut spheres = vec_with_capacity(room, options.huge_pages);
        spheres.extend(tets.iter().map(|tet| sphere_of(&sites, tet)));
        let nowhere = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        let (least, greatest) = points
            .iter()
            .fold(nowhere, |(low, high), &p| (low.min(p), high.max(p)));
        Self {
            tets,
            spheres,
            sites,
            filter: Filter3::for_points(points),
            box_filter: StaticFilter3::of_box(least, greatest),
            huge_pages: options.huge_pages,
            free: Vec::new(),
            stamp: 0,
            last: TetId::new(0),
            duplicates: Vec::new(),
        }
    }

    /// Inserts every vertex but those of `simplex`.
    fn insert_rest(
        &mut self,
        simplex: [VertexId; 4],
        meter: &mut Meter<'_>,
    ) -> Result<(), BuildError> {
        let mut inserter = self.inserter();
        let slots = self.sites.len();
        let mut slot = 1;
        while slot < slots {
            let v = VertexId::from_slot(slot);
            if !simplex.contains(&v) {
                let p = inserter.arena.place(v);
                let next = inserter
                    .arena
                    .place(VertexId::from_slot((slot + 1).min(slots - 1)));
                match inserter.insert(v, p, next) {
                    Outcome::Inserted => {}
                    Outcome::Duplicate(vertex) => self.duplicates.push((v, vertex)),
                    Outcome::Full | Outcome::Late => {
                        self.take_back(inserter);
                        self.make_room()?;
                        inserter = self.inserter();
                        continue;
                    }
                }
            }
            slot += 1;
            meter.advance()?;
        }
        self.take_back(inserter);
        Ok(())
    }

    /// Who inserts points on this thread alone.
    fn inserter(&mut self) -> Inserter<false> {
        let used = self.tets.len();
        // SAFETY: until `take_back`, `tets`, `spheres` and `sites` are left alone by everyone else.
        let arena = unsafe { Arena::over(&mut self.tets, &mut self.spheres, &mut self.sites) };
        Inserter {
            arena,
            filter: self.filter,
            box_filter: self.box_filter,
            part: 0,
            is_wide: is_wide(),
            fresh: used..arena.room().min(TetId::LIMIT),
            free: std::mem::take(&mut self.free),
            stamp: self.stamp,
            last: self.last,
            dug: Pile::new(TetId::from_raw(0)),
            outer: Pile::new(FacetId::from_raw(0)),
            inner: Pile::new(FacetId::from_raw(0)),
            star: Star::boxed(),
            aim: 0,
        }
    }

    /// Takes over what an inserter has done.
    fn take_back(&mut self, inserter: Inserter<false>) {
        self.free = inserter.free;
        self.stamp = inserter.stamp;
        self.last = inserter.last;
        let used = inserter.fresh.start;
        debug_assert!(used <= self.tets.capacity() && used <= self.spheres.capacity());
        // SAFETY: slots below `used` were taken from the fresh ones in order and written, and lie
        // within both capacities.
        unsafe {
            self.tets.set_len(used);
            self.spheres.set_len(used);
        }
    }

    /// Makes room for half as many slots again.
    fn make_room(&mut self) -> Result<(), BuildError> {
        let tets = self.tets.len();
        let more = (tets / 2 + 4096).min(TetId::LIMIT - tets);
        let full = BuildError::TooManyTets { tets };
        if more == 0
            || self.tets.try_reserve_exact(more).is_err()
            || self.spheres.try_reserve_exact(more).is_err()
        {
            return Err(full);
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
            vacant: Vec::new(),
            homes: Vec::new(),
        };
        for t in self.free {
            mesh.vacate(t);
        }
        mesh.fill_gaps();
        Grown {
            mesh,
            duplicates: self.duplicates,
        }
    }
}

fn sphere_of(sites: &[Site], tet: &Tet) -> Circumsphere {
    let [p, a, b, c] = tet.vertex.map(|v| sites[v.slot()].place);
    Circumsphere::through(p, &arm(a, p), &arm(b, p), &arm(c, p))
}
