//! All points, round by round.

use super::super::mesh::Face;
use super::arena::Arena;
use super::part::{Part, Stretches, Whole, stretch_of_slots};
use super::share::{Share, work_on};
use super::triangle::put_triangle;
use super::worker::Worker;
use crate::ids::{HalfEdgeId, VertexId};
use crate::memory::vec_with_capacity;
use crate::options::BuildOptions;
use crate::order::Order;
use crate::progress::{Cancelled, Meter};
use crate::threads;
use geo_predicates::filter::Filter2;
use glam::DVec2;
use std::ops::Range;

/// Points between two reports of a thread that is alone.
const STRIDE: usize = 4096;

/// Faces over points in insertion order.
pub(in super::super) struct Bulk {
    /// Those of duplicates are vacant.
    pub(super) faces: Vec<Face>,
    /// Pairs (duplicate, the vertex in its place).
    pub(super) duplicates: Vec<(VertexId, VertexId)>,
}

impl Bulk {
    /// Triangulates points given by vertex slot, the ghost in front. The first three turn counterclockwise; the others
    /// are in `order`.
    ///
    /// A thread more than one gets at least `least_share` points of a round.
    pub(in super::super) fn of(
        coords: &[DVec2],
        order: &Order,
        options: BuildOptions,
        least_share: usize,
        meter: &mut Meter<'_>,
    ) -> Result<Self, Cancelled> {
        let count = 2 * coords.len() - 4;
        let mut faces = vec_with_capacity(count, options.huge_pages);
        let arena = Arena::new(faces.spare_capacity_mut(), coords);
        put_triangle(&arena);
        let filter = Filter2::for_points(&coords[1..]);
        let stretch_of = match options.threads.get() {
            1 => Vec::new(),
            _ => stretch_of_slots(order, coords.len()),
        };
        let mut rounds = Rounds {
            order,
            stretch_of: &stretch_of,
            alone: Worker::new(&arena, Whole, filter, HalfEdgeId::new(0)),
            done: 3,
        };
        for round in 0..order.rounds.len() {
            let shares = order.rounds[round].len() / least_share;
            let parts = shares.min(options.threads.get()).min(Order::STRETCHES / 2);
            if parts < 2 || round == 0 {
                rounds.insert_alone(vertices(&order.rounds[round]), meter)?;
            } else {
                rounds.insert_in_parts(round, parts, least_share, meter)?;
            }
        }
        assert_eq!(rounds.done, coords.len() - 1, "a vertex was left out");
        let duplicates = rounds.alone.duplicates;
        // SAFETY: the first three vertices have written four faces, each other vertex its two: all are done.
        unsafe { faces.set_len(count) };
        Ok(Self { faces, duplicates })
    }
}

/// A build between two rounds.
struct Rounds<'a> {
    order: &'a Order,
    /// The stretch of the curve that each vertex is on, by slot; empty when one thread does all.
    stretch_of: &'a [u8],
    alone: Worker<'a, Whole>,
    /// Points inserted or found to be duplicates.
    done: usize,
}

impl<'a> Rounds<'a> {
    /// Inserts vertices on this thread.
    fn insert_alone(
        &mut self,
        vertices: impl ExactSizeIterator<Item = VertexId>,
        meter: &mut Meter<'_>,
    ) -> Result<(), Cancelled> {
        let mut vertices = vertices.peekable();
        let worker = &mut self.alone;
        // SAFETY: no other thread has the arena now, so all faces are of this thread's part.
        worker.start = unsafe { worker.real_side(worker.start) };
        while vertices.len() > 0 {
            let before = vertices.len();
            let start = worker.start;
            let limit = STRIDE - self.done % STRIDE;
            // SAFETY: as above; a walk does not leave the whole.
            unsafe { worker.insert_some(&mut vertices, limit, |_| start) };
            self.done += before - vertices.len();
            if self.done.is_multiple_of(STRIDE) {
                meter.reach(self.done)?;
            }
        }
        Ok(())
    }

    /// Inserts a round on several threads, each in its part of the plane; what touches two parts comes later, in
    /// parts with other borders, and what is left then on this thread.
    fn insert_in_parts(
        &mut self,
        round: usize,
        parts: usize,
        least_share: usize,
        meter: &mut Meter<'_>,
    ) -> Result<(), Cancelled> {
        let cuts = self.order.cuts(round, parts);
        let ranges = cuts.windows(2).map(|cut| vertices(&(cut[0]..cut[1])));
        let shares = self.shares(round, ranges.collect(), 0);
        let mut postponed = self.work_on(shares, meter)?;
        let half = Order::STRETCHES / parts / 2;
        let parts = parts.min(postponed.len() / least_share);
        if parts > 1 {
            let shifted = parts_of_curve(self.stretch_of, parts, half);
            let of_part = |part: &Stretches<'_>| {
                // SAFETY: these are vertices of the points.
                let mine = postponed
                    .iter()
                    .copied()
                    .filter(|&v| unsafe { part.holds(v) });
                mine.collect::<Vec<VertexId>>().into_iter()
            };
            let lists = shifted.iter().map(of_part).collect();
            let shares = self.shares(round, lists, half);
            postponed = self.work_on(shares, meter)?;
            postponed.sort_unstable();
        }
        self.insert_alone(postponed.into_iter(), meter)
    }

    /// One share for each list of vertices, in parts shifted by so many stretches.
    fn shares<I>(&self, round: usize, lists: Vec<I>, shift: usize) -> Vec<Share<'a, I>>
    where
        I: ExactSizeIterator<Item = VertexId> + Send,
    {
        let parts = parts_of_curve(self.stretch_of, lists.len(), shift);
        let (arena, filter, order) = (self.alone.arena, self.alone.filter, self.order);
        let tasks: Vec<_> = parts.into_iter().zip(lists).collect();
        threads::map(tasks, |(part, list)| {
            Share::new(arena, filter, part, list, order, round)
        })
    }

    /// Works on shares in disjoint parts; gives the vertices that come later.
    fn work_on<I>(
        &mut self,
        shares: Vec<Share<'a, I>>,
        meter: &mut Meter<'_>,
    ) -> Result<Vec<VertexId>, Cancelled>
    where
        I: ExactSizeIterator<Item = VertexId> + Send,
    {
        let before = self.done;
        let report = |settled| {
            self.done = before + settled;
            meter.reach(self.done)
        };
        // SAFETY: the parts are disjoint pieces of the curve, and this thread does nothing meanwhile.
        let settled = unsafe { work_on(shares, report)? };
        self.alone.duplicates.extend(settled.duplicates);
        Ok(settled.postponed)
    }
}

/// Equal parts of the curve, as stretches, the first of which starts at stretch `shift`.
fn parts_of_curve(stretch_of: &[u8], parts: usize, shift: usize) -> Vec<Stretches<'_>> {
    let cut = |part: usize| part * Order::STRETCHES / parts;
    let part = |part| Stretches {
        stretch_of,
        first: (cut(part) + shift) as u8,
        others: (cut(part + 1) - cut(part) - 1) as u8,
    };
    (0..parts).map(part).collect()
}

/// The vertices of these ranks, but the first three of all.
fn vertices(
    ranks: &Range<usize>,
) -> impl ExactSizeIterator<Item = VertexId> + Clone + Send + use<> {
    let slots = (ranks.start + 1).max(4)..ranks.end + 1;
    slots.map(VertexId::from_slot)
}

#[cfg(test)]
mod tests {
    use super::super::finish::Finish;
    use super::super::triangle::bring_triangle_to_front;
    use super::*;
    use crate::progress::silent;

    fn scattered(count: usize) -> Vec<DVec2> {
        let number = |i: usize, step: f64| (i as f64 * step).fract();
        let point = |i| {
            DVec2::new(
                number(i, 0.754_877_666_246_693),
                number(i, 0.569_840_290_998_053),
            )
        };
        (1..=count).map(point).collect()
    }

    fn built(points: &[DVec2], threads: usize) -> Finish {
        let mut order = Order::of(points, BuildOptions::on_threads(threads));
        let mut coords = vec![DVec2::NAN];
        coords.extend(order.indices.iter().map(|&index| points[index as usize]));
        assert!(bring_triangle_to_front(&mut coords, &mut order.indices));
        let mut quiet = silent;
        let mut meter = Meter::start(&mut quiet, "test", points.len()).unwrap();
        let options = BuildOptions::on_threads(threads);
        let bulk = Bulk::of(&coords, &order, options, 1, &mut meter).unwrap();
        let mut memory = vec![0; coords.len()];
        bulk.finish(&order.indices, &mut memory, options)
    }

    /// With a share of one point, all rounds but the first are cut into parts.
    fn assert_same_on_all_threads(points: &[DVec2]) {
        let alone = built(points, 1);
        let expected = (alone.mesh.canonical(), alone.duplicates.len());
        for threads in [2, 3, 8, 16, 1000] {
            let together = built(points, threads);
            assert_eq!(together.mesh.check(), Ok(()), "{threads}");
            let found = (together.mesh.canonical(), together.duplicates.len());
            assert!(found == expected, "{threads}");
            assert!(built(points, threads).mesh == together.mesh, "{threads}");
        }
    }

    #[test]
    fn scattered_points_have_one_triangulation_for_any_number_of_threads() {
        assert_same_on_all_threads(&scattered(20_000));
    }

    /// More than two rounds, of which the one in the middle once lost points.
    #[test]
    fn many_points_have_one_triangulation_for_any_number_of_threads() {
        for turn in 0..6 {
            let turn = DVec2::from_angle(f64::from(turn));
            let points: Vec<DVec2> = scattered(70_000).iter().map(|&p| turn.rotate(p)).collect();
            let [alone, together] = [1, 3].map(|threads| built(&points, threads));
            assert_eq!(together.mesh.check(), Ok(()));
            assert!(together.mesh.canonical() == alone.mesh.canonical());
        }
    }

    #[test]
    fn a_lattice_has_one_triangulation_for_any_number_of_threads() {
        let lattice = (0..20_000_u32).map(|i| DVec2::new(f64::from(i % 150), f64::from(i / 150)));
        assert_same_on_all_threads(&lattice.collect::<Vec<_>>());
    }

    #[test]
    fn a_circle_has_one_triangulation_for_any_number_of_threads() {
        let circle = (0..20_000).map(|i| DVec2::from_angle(f64::from(i) * 3e-4));
        assert_same_on_all_threads(&circle.collect::<Vec<_>>());
    }

    /// The middle comes when about half of the circle is there, so its cavity outgrows the buffers more than once.
    #[test]
    fn the_middle_of_a_circle_sees_all_of_it() {
        let circle = (0..1000).map(|i| DVec2::from_angle(f64::from(i) * 6.283e-3));
        let points: Vec<DVec2> = circle.chain([DVec2::ZERO]).collect();
        let mesh = built(&points, 1).mesh;
        assert_eq!(mesh.check(), Ok(()));
        assert_eq!(mesh.neighbors(VertexId::new(1000)).count(), 1000);
    }

    /// Cavities of all sizes, so that some fill the buffers exactly.
    #[test]
    fn a_cavity_may_fill_its_buffers_to_the_last_place() {
        for count in 60..320 {
            for phase in 0..3 {
                let angle =
                    |i| f64::from(i) * std::f64::consts::TAU / f64::from(count) + f64::from(phase);
                let circle = (0..count).map(|i| DVec2::from_angle(angle(i)));
                let points: Vec<DVec2> = circle.chain([DVec2::ZERO]).collect();
                let mesh = built(&points, 1).mesh;
                let center = VertexId::new(count as usize);
                assert_eq!(mesh.neighbors(center).count(), count as usize);
            }
        }
    }

    #[test]
    fn clusters_and_their_copies_have_one_triangulation_for_any_number_of_threads() {
        let centers = [
            DVec2::ZERO,
            DVec2::ONE,
            DVec2::new(0.3, 0.9),
            DVec2::new(1e3, 7.0),
        ];
        let scale = [1e-9, 1e-3, 1e-14, 1.0];
        let mut points: Vec<DVec2> = scattered(12_000);
        for (i, p) in points.iter_mut().enumerate() {
            *p = centers[i % 4] + *p * scale[i % 4];
        }
        points.extend_from_within(..6000);
        assert_same_on_all_threads(&points);
    }

    #[test]
    fn points_on_two_lines_have_one_triangulation_for_any_number_of_threads() {
        let point = |i: u32| DVec2::new(f64::from(i), f64::from(i % 2) * f64::from(i));
        assert_same_on_all_threads(&(0..10_000).map(point).collect::<Vec<_>>());
    }
}
