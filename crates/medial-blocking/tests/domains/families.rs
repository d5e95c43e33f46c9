//! Families of domains that are hard in one way each: very unequal radii, tiny gaps, lattices, rings, chains of nearly
//! tangent holes, long periods.

use std::f64::consts::{PI, TAU};

use glam::DVec2;
use medial_blocking::Circle;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// What holes are cut from.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Frame {
    Circle(Circle),
    Period(DVec2),
}

/// Circles before they are checked, with the name of their family.
#[derive(Clone, Debug)]
pub(crate) struct Case {
    pub(crate) family: &'static str,
    pub(crate) frame: Frame,
    pub(crate) holes: Vec<Circle>,
}

type Family = fn(&mut ChaCha8Rng) -> (Frame, Vec<Circle>);

const FAMILIES: [(&str, Family); 12] = [
    ("unequal holes", unequal_holes),
    ("unequal holes, periodic", unequal_periodic),
    ("chain of nearly tangent holes", tangent_chain),
    ("ring", ring),
    ("square lattice", square_lattice),
    ("hexagonal lattice", hexagonal_lattice),
    ("square lattice, periodic", square_periodic),
    ("hexagonal lattice, periodic", hexagonal_periodic),
    ("one hole", one_hole),
    ("a tiny hole beside the wall", tiny_beside_wall),
    ("dense packing", dense_packing),
    ("long period", long_period),
];

/// Case number `seed`, the families in turn.
pub(crate) fn case(seed: u64) -> Case {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let (family, make) = FAMILIES[(seed % FAMILIES.len() as u64) as usize];
    let (frame, holes) = make(&mut rng);
    Case {
        family,
        frame,
        holes,
    }
}

fn power(rng: &mut ChaCha8Rng, low: f64, high: f64) -> f64 {
    10f64.powf(rng.random_range(low..high))
}

fn unit() -> Frame {
    Frame::Circle(Circle::new(DVec2::ZERO, 1.0))
}

/// Holes thrown until they fit with gaps of at least `gap`; a new hole often ends just that far from the nearest.
fn thrown(rng: &mut ChaCha8Rng, frame: Frame, tries: usize, smallest: f64) -> Vec<Circle> {
    let gap = power(rng, -6.0, -1.0);
    let mut holes: Vec<Circle> = Vec::new();
    for _ in 0..tries {
        let center = match frame {
            Frame::Circle(outer) => {
                let p = DVec2::new(rng.random_range(-1.0..1.0), rng.random_range(-1.0..1.0));
                outer.center + outer.radius * p
            }
            Frame::Period(period) => {
                period * DVec2::new(rng.random_range(0.0..1.0), rng.random_range(0.0..1.0))
            }
        };
        let room = room(frame, &holes, center) - gap;
        let wished = power(rng, smallest, -0.4);
        let radius = if rng.random_bool(0.5) {
            wished.min(room)
        } else {
            wished
        };
        if radius <= room && radius > 10f64.powf(smallest) {
            holes.push(Circle::new(center, radius));
        }
    }
    holes
}

/// The largest radius that fits at `center`.
fn room(frame: Frame, holes: &[Circle], center: DVec2) -> f64 {
    let distance = |other: DVec2| match frame {
        Frame::Circle(_) => other.distance(center),
        Frame::Period(period) => {
            let offset = other - center;
            (offset - (offset / period).round() * period).length()
        }
    };
    let outer = match frame {
        Frame::Circle(outer) => outer.radius - outer.center.distance(center),
        Frame::Period(period) => period.min_element() / 2.0,
    };
    holes
        .iter()
        .map(|hole| distance(hole.center) - hole.radius)
        .fold(outer, f64::min)
}

fn unequal_holes(rng: &mut ChaCha8Rng) -> (Frame, Vec<Circle>) {
    let tries = power(rng, 0.5, 2.5) as usize;
    let smallest = rng.random_range(-4.0..-1.0);
    (unit(), thrown(rng, unit(), tries, smallest))
}

fn unequal_periodic(rng: &mut ChaCha8Rng) -> (Frame, Vec<Circle>) {
    let frame = Frame::Period(DVec2::new(1.0, rng.random_range(0.2..3.0)));
    let tries = power(rng, 0.5, 2.5) as usize;
    let smallest = rng.random_range(-4.0..-1.0);
    (frame, thrown(rng, frame, tries, smallest))
}

fn tangent_chain(rng: &mut ChaCha8Rng) -> (Frame, Vec<Circle>) {
    let mut holes = vec![Circle::new(DVec2::ZERO, power(rng, -2.0, -0.5))];
    for _ in 0..rng.random_range(1..40) {
        let from = holes[rng.random_range(0..holes.len())];
        let radius = power(rng, -3.0, -0.5);
        let apart = from.radius + radius + radius.min(from.radius) * power(rng, -6.0, -1.0);
        let center = from.center + DVec2::from_angle(rng.random_range(0.0..TAU)) * apart;
        if room(unit(), &holes, center) > radius * (1.0 + 1e-6) {
            holes.push(Circle::new(center, radius));
        }
    }
    (unit(), holes)
}

fn ring(rng: &mut ChaCha8Rng) -> (Frame, Vec<Circle>) {
    let n = rng.random_range(2..60);
    let radius = rng.random_range(0.05..0.95) * (PI / f64::from(n)).sin();
    let jitter = if rng.random_bool(0.5) {
        0.0
    } else {
        power(rng, -16.0, -2.0) * radius
    };
    let mut holes: Vec<Circle> = (0..n)
        .map(|k| {
            let at = DVec2::from_angle(TAU * f64::from(k) / f64::from(n));
            Circle::new(
                at + DVec2::splat(jitter * rng.random_range(-1.0..1.0)),
                radius * 0.95,
            )
        })
        .collect();
    if rng.random_bool(0.5) && n > 2 {
        holes.push(Circle::new(
            DVec2::ZERO,
            rng.random_range(0.01..0.99) * (1.0 - radius),
        ));
    }
    (
        Frame::Circle(Circle::new(
            DVec2::ZERO,
            1.0 + radius + power(rng, -4.0, 1.0),
        )),
        holes,
    )
}

fn lattice(nx: i32, ny: i32, step: [DVec2; 2], radius: f64) -> Vec<Circle> {
    (0..nx)
        .flat_map(|x| (0..ny).map(move |y| (f64::from(x), f64::from(y))))
        .map(|(x, y)| Circle::new(x * step[0] + y * step[1], radius))
        .collect()
}

fn enclosed(holes: Vec<Circle>, margin: f64) -> (Frame, Vec<Circle>) {
    let center = holes.iter().map(|hole| hole.center).sum::<DVec2>() / holes.len() as f64;
    let reach = |hole: &Circle| hole.center.distance(center) + hole.radius;
    let radius = holes.iter().map(reach).fold(0.0, f64::max) + margin;
    (Frame::Circle(Circle::new(center, radius)), holes)
}

fn square_lattice(rng: &mut ChaCha8Rng) -> (Frame, Vec<Circle>) {
    let (nx, ny) = (rng.random_range(1..12), rng.random_range(1..12));
    let radius = rng.random_range(0.01..0.499);
    enclosed(
        lattice(nx, ny, [DVec2::X, DVec2::Y], radius),
        power(rng, -3.0, 1.0),
    )
}

const HEXAGONAL: [DVec2; 2] = [DVec2::X, DVec2::new(0.5, 0.866_025_403_784_438_6)];

fn hexagonal_lattice(rng: &mut ChaCha8Rng) -> (Frame, Vec<Circle>) {
    let (nx, ny) = (rng.random_range(1..10), rng.random_range(1..10));
    let radius = rng.random_range(0.01..0.4999);
    enclosed(lattice(nx, ny, HEXAGONAL, radius), power(rng, -3.0, 1.0))
}

fn square_periodic(rng: &mut ChaCha8Rng) -> (Frame, Vec<Circle>) {
    let (nx, ny) = (rng.random_range(1..6), rng.random_range(1..6));
    let radius = rng.random_range(0.01..0.499);
    let offset = DVec2::new(rng.random_range(-1.0..1.0), rng.random_range(-1.0..1.0));
    let holes = lattice(nx, ny, [DVec2::X, DVec2::Y], radius);
    let moved = holes
        .iter()
        .map(|hole| Circle::new(hole.center + offset, radius));
    (
        Frame::Period(DVec2::new(f64::from(nx), f64::from(ny))),
        moved.collect(),
    )
}

fn hexagonal_periodic(rng: &mut ChaCha8Rng) -> (Frame, Vec<Circle>) {
    let (nx, ny) = (rng.random_range(1..6), rng.random_range(1..6));
    let period = DVec2::new(1.0, 2.0 * HEXAGONAL[1].y);
    let radius = rng.random_range(0.01..0.4999);
    let row = |by| {
        lattice(
            nx,
            ny,
            [DVec2::new(1.0, 0.0), DVec2::new(0.0, period.y)],
            radius,
        )
        .into_iter()
        .map(move |hole| Circle::new(hole.center + by, radius))
    };
    let holes = row(DVec2::ZERO).chain(row(HEXAGONAL[1])).collect();
    (
        Frame::Period(period * DVec2::new(f64::from(nx), f64::from(ny))),
        holes,
    )
}

fn one_hole(rng: &mut ChaCha8Rng) -> (Frame, Vec<Circle>) {
    let radius = if rng.random_bool(0.5) {
        1.0 - power(rng, -4.0, -0.1)
    } else {
        power(rng, -4.0, -0.1)
    };
    let off =
        (1.0 - radius) * [0.0, rng.random_range(0.0..1.0), 1.0 - 1e-3][rng.random_range(0..3)];
    let center = DVec2::from_angle(rng.random_range(0.0..TAU)) * off;
    (unit(), vec![Circle::new(center, radius)])
}

fn tiny_beside_wall(rng: &mut ChaCha8Rng) -> (Frame, Vec<Circle>) {
    let radius = power(rng, -5.0, -1.0);
    let gap = radius * power(rng, -5.0, 1.0);
    let tiny = Circle::new(
        DVec2::from_angle(rng.random_range(0.0..TAU)) * (1.0 - radius - gap),
        radius,
    );
    let big = Circle::new(DVec2::new(-0.1, 0.05), rng.random_range(0.05..0.8));
    (unit(), vec![big, tiny])
}

/// A shaken hexagonal lattice whose holes grow until they nearly touch: area fractions up to 0.8.
fn dense_packing(rng: &mut ChaCha8Rng) -> (Frame, Vec<Circle>) {
    let n = rng.random_range(2..7);
    let shake = power(rng, -3.0, -0.7);
    let period = DVec2::new(1.0, 2.0 * HEXAGONAL[1].y) * f64::from(n);
    let mut holes: Vec<Circle> = Vec::new();
    for by in [DVec2::ZERO, HEXAGONAL[1]] {
        for hole in lattice(n, n, [DVec2::X, DVec2::new(0.0, 2.0 * HEXAGONAL[1].y)], 0.0) {
            let shaken =
                DVec2::new(rng.random_range(-1.0..1.0), rng.random_range(-1.0..1.0)) * shake;
            holes.push(Circle::new(hole.center + by + shaken, 0.0));
        }
    }
    for k in 0..holes.len() {
        let own = holes.swap_remove(k);
        let closest = holes.iter().map(|hole| if hole.radius > 0.0 { 1.0 } else { 0.5 } * (room(Frame::Period(period), std::slice::from_ref(hole), own.center)));
        let radius = closest.fold(0.499, f64::min) * (1.0 - power(rng, -6.0, -1.0));
        holes.push(Circle::new(own.center, radius));
        let last = holes.len() - 1;
        holes.swap(k, last);
    }
    (Frame::Period(period), holes)
}

fn long_period(rng: &mut ChaCha8Rng) -> (Frame, Vec<Circle>) {
    let aspect = power(rng, 0.0, 2.3);
    let period = if rng.random_bool(0.5) {
        DVec2::new(1.0, aspect)
    } else {
        DVec2::new(aspect, 1.0)
    };
    let frame = Frame::Period(period);
    let tries = rng.random_range(1..20);
    (frame, thrown(rng, frame, tries, -2.0))
}
