//! Domains that are hard on purpose: co-circular holes, near-tangent gaps, one hole, extreme sizes
//! and scales.

use glam::DVec2;
use medial_blocking::{
    BlockMesh, Blocking, BlockingError, CellCounts, Circle, Domain, NodeMatching, Params, mesh,
};

fn circle(x: f64, y: f64, radius: f64) -> Circle {
    Circle::new(DVec2::new(x, y), radius)
}

fn params(cells: u32) -> Params {
    Params {
        cells: CellCounts::PerBlock(cells),
        matching: NodeMatching::EqualSpacing,
    }
}

/// Twice the area of every cell that does not lie in a block left by co-circular walls.
fn cell_areas(mesh: &BlockMesh) -> Vec<f64> {
    let thin: Vec<_> = mesh.blocking().thin_arcs(1e-6).collect();
    mesh.blocks()
        .filter(|(block, _)| !thin.contains(&block.arc))
        .flat_map(|(_, grid)| grid.cells())
        .map(|[a, b, c, d]| (c - a).perp_dot(d - b))
        .collect()
}

#[test]
fn one_hole_gives_eight_blocks_wherever_it_lies() {
    for x in [0.0, 0.3, 0.69] {
        let domain = Domain::in_circle(circle(0.0, 0.0, 1.0), &[circle(x, 0.1, 0.25)]).unwrap();
        let mesh = mesh(&domain, &params(8)).unwrap();
        assert_eq!(mesh.blocking().blocks().len(), 8);
        assert!(cell_areas(&mesh).iter().all(|&area| area > 0.0));
    }
}

#[test]
fn two_holes_give_six_blocks_even_of_very_unequal_size() {
    for radius in [0.3, 1e-2, 1e-4] {
        let domain = Domain::in_circle(
            circle(0.0, 0.0, 1.0),
            &[circle(-0.4, 0.0, 0.4), circle(0.5, 0.2, radius)],
        )
        .unwrap();
        let mesh = mesh(&domain, &params(8)).unwrap();
        assert_eq!(mesh.blocking().blocks().len(), 6);
        assert!(cell_areas(&mesh).iter().all(|&area| area > 0.0), "{radius}");
    }
}

#[test]
fn co_circular_holes_leave_thin_blocks_and_nothing_folds() {
    for n in 4..=40u32 {
        let holes: Vec<Circle> = (0..n)
            .map(|k| {
                Circle::new(
                    DVec2::from_angle(f64::from(k) * std::f64::consts::TAU / f64::from(n)),
                    2.0 / f64::from(n),
                )
            })
            .collect();
        let domain = Domain::in_circle(circle(0.0, 0.0, 2.0), &holes).unwrap();
        let mesh = mesh(&domain, &params(6)).unwrap();
        assert_eq!(mesh.blocking().blocks().len(), 6 * (n as usize - 1));
        // n − 2 interior triangles share the circle in the middle: n − 3 arcs between them have no
        // length.
        assert_eq!(
            mesh.blocking().thin_arcs(1e-6).count(),
            n as usize - 3,
            "{n}"
        );
        assert!(cell_areas(&mesh).iter().all(|&area| area > 0.0), "{n}");
    }
}

#[test]
fn periodic_square_lattices_are_tiled_whatever_the_number_of_holes() {
    for n in 1..=4 {
        let holes: Vec<Circle> = (0..n * n)
            .map(|k| circle(0.1 + f64::from(k % n), 0.7 + f64::from(k / n), 0.3))
            .collect();
        let domain = Domain::periodic(DVec2::splat(f64::from(n)), &holes).unwrap();
        let mesh = mesh(&domain, &params(4)).unwrap();
        assert_eq!(mesh.blocking().blocks().len(), 6 * holes.len());
        assert_eq!(mesh.blocking().thin_arcs(1e-6).count(), holes.len());
        assert!(cell_areas(&mesh).iter().all(|&area| area > 0.0));
    }
}

#[test]
fn a_long_thin_period_is_tiled() {
    for aspect in [10.0, 100.0] {
        let domain = Domain::periodic(DVec2::new(1.0, aspect), &[circle(0.5, 0.3, 0.2)]).unwrap();
        let blocking = Blocking::of(&domain).unwrap();
        assert_eq!(blocking.blocks().len(), 6);
    }
}

#[test]
fn near_tangent_walls_are_resolved() {
    for gap in [1e-2, 1e-4, 1e-6] {
        let holes = [
            circle(-0.5 - gap / 2.0, 0.0, 0.5),
            circle(0.5 + gap / 2.0, 0.0, 0.5),
            circle(0.0, 1.2, 0.3),
        ];
        let domain = Domain::in_circle(circle(0.0, 0.0, 2.0), &holes).unwrap();
        let mesh = mesh(&domain, &params(16)).unwrap();
        assert_eq!(mesh.blocking().blocks().len(), 12);
        assert!(cell_areas(&mesh).iter().all(|&area| area > 0.0), "{gap}");
    }
}

#[test]
fn scales_from_tiny_to_huge_give_the_same_blocks() {
    let holes = [
        circle(-0.5, 0.0, 0.25),
        circle(0.5, 0.125, 0.25),
        circle(0.0, 0.75, 0.125),
    ];
    let outer = circle(0.0, 0.25, 1.5);
    let at = |scale: f64| {
        let scaled = |c: Circle| Circle::new(c.center * scale, c.radius * scale);
        let domain = Domain::in_circle(scaled(outer), &holes.map(scaled)).unwrap();
        let mesh = mesh(&domain, &params(4)).unwrap();
        mesh.cells()
            .map(|cell| cell.map(|node| node / scale))
            .collect::<Vec<_>>()
    };
    let cells = at(1.0);
    for exponent in [-120, -60, 60, 180] {
        assert_eq!(at(2f64.powi(exponent)), cells, "2^{exponent}");
    }
}

#[test]
fn ten_thousand_holes_in_a_grid_are_blocked() {
    let holes: Vec<Circle> = (0..10_000)
        .map(|k| {
            circle(
                f64::from(k % 100) + 0.1 * f64::from(k % 7) / 7.0,
                f64::from(k / 100),
                0.3,
            )
        })
        .collect();
    let domain = Domain::in_circle(circle(50.0, 50.0, 80.0), &holes).unwrap();
    assert_eq!(Blocking::of(&domain).unwrap().blocks().len(), 6 * 9_999);
}

#[test]
fn absurd_cell_counts_are_refused() {
    let domain = Domain::in_circle(circle(0.0, 0.0, 1.0), &[circle(0.0, 0.0, 0.5)]).unwrap();
    let refused = |cells| {
        mesh(
            &domain,
            &Params {
                cells,
                ..Params::default()
            },
        )
        .unwrap_err()
    };
    assert!(matches!(
        refused(CellCounts::PerBlock(0)),
        BlockingError::NoCells { .. }
    ));
    assert!(matches!(
        refused(CellCounts::PerBlock(1_000_000_000)),
        BlockingError::TooManyCells { .. }
    ));
    assert!(matches!(
        refused(CellCounts::Size(1e-12)),
        BlockingError::TooManyCells { .. }
    ));
    for size in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(
            refused(CellCounts::Size(size)),
            BlockingError::CellSize { .. }
        ));
    }
    let each = CellCounts::Each {
        along_arc: vec![1; 3],
        across_wall: vec![1; 2],
    };
    assert!(matches!(
        refused(each),
        BlockingError::CountsLength {
            given: 3,
            expected: 4,
            ..
        }
    ));
}
