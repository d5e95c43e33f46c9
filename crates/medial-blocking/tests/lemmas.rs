//! The properties that the paper claims, on random domains.

mod domains;

use delaunay_core::geo_predicates::orient2d;
use domains::{Domains, hexagon};
use glam::DVec2;
use medial_blocking::{
    BlockSide, Blocking, BlockingError, CellCounts, Domain, NodeMatching, Params, mesh,
};
use proptest::prelude::*;

/// Coordinates in the random domains are of size 1, touching points and vertices are exact to this.
const ROUNDING: f64 = 1e-9;

fn expected_blocks(domain: &Domain) -> usize {
    match (domain.bounding(), domain.hole_count()) {
        (Some(_), 1) => 8,
        (Some(_), holes) => 6 * (holes - 1),
        (None, holes) => 6 * holes,
    }
}

fn angle_at(apex: DVec2, p: DVec2, q: DVec2) -> f64 {
    (p - apex).angle_to(q - apex).abs().to_degrees()
}

#[test]
fn seven_holes_in_hexagonal_packing_give_36_blocks() {
    assert_eq!(Blocking::of(&hexagon()).unwrap().blocks().len(), 36);
}

proptest! {
    #[test]
    fn the_number_of_blocks_depends_on_the_number_of_holes_alone(domain in Domains::any()) {
        let blocking = Blocking::of(&domain).unwrap();
        prop_assert_eq!(blocking.blocks().len(), expected_blocks(&domain));
        prop_assert_eq!(blocking.arcs().len() * 2, blocking.blocks().len());
    }

    #[test]
    fn every_block_talks_to_three_neighbours_which_answer(domain in Domains::any()) {
        let blocking = Blocking::of(&domain).unwrap();
        for id in blocking.block_ids() {
            let block = blocking.block(id);
            let (mate, shift) = block.neighbours.xi0;
            prop_assert_eq!(blocking.block(mate).neighbours.xi0, (id, -shift));
            prop_assert_eq!(blocking.block(mate).arc, block.arc);
            prop_assert_eq!(blocking.block(block.neighbours.eta1).neighbours.eta0, id);
            prop_assert_eq!(blocking.block(block.neighbours.eta0).neighbours.eta1, id);
            prop_assert_eq!(blocking.block(block.neighbours.eta1).wall, block.wall);
        }
    }

    #[test]
    fn shared_curves_have_the_same_nodes_bit_for_bit(domain in Domains::any(), n in 4u32..9) {
        let mesh = mesh(&domain, &Params { cells: CellCounts::PerBlock(n), ..Params::default() }).unwrap();
        let blocking = mesh.blocking();
        for id in blocking.block_ids() {
            let (block, grid) = (blocking.block(id), mesh.grid(id));
            let (mate, shift) = block.neighbours.xi0;
            let by = domain.translation(shift);
            let (along, across) = (grid.cells_along(), grid.cells_across());
            for j in 0..=along {
                prop_assert_eq!(grid.node(0, j) + by, mesh.grid(mate).node(0, along - j));
            }
            let next = mesh.grid(block.neighbours.eta1);
            for i in 0..=across {
                prop_assert_eq!(grid.node(i, along), next.node(i, 0));
            }
        }
    }

    #[test]
    fn wall_nodes_lie_on_their_circle_and_eta_lines_meet_it_at_right_angles(domain in Domains::any()) {
        let mesh = mesh(&domain, &Params { cells: CellCounts::PerBlock(4), ..Params::default() }).unwrap();
        let blocking = mesh.blocking();
        for id in blocking.block_ids() {
            let (block, grid) = (blocking.block(id), mesh.grid(id));
            let wall = blocking.wall_of(block);
            for j in 0..=4 {
                prop_assert!(wall.distance(grid.node(4, j)).abs() < 1e-14);
            }
            for j in [0, 4] {
                let (ray, radius) = (grid.node(4, j) - grid.node(0, j), grid.node(4, j) - wall.circle.center);
                let sine = ray.perp_dot(radius) / (ray.length() * radius.length());
                // What is left is the rounding of the ray's ends, so it counts against the ray's
                // length.
                prop_assert!(sine.abs() * ray.length() < 1e-12, "{sine:e} over {}", ray.length());
            }
        }
    }

    #[test]
    fn boundary_corners_are_shared_by_two_blocks_and_interior_corners_by_six(domain in Domains::any()) {
        let blocking = Blocking::of(&domain).unwrap();
        let mut at_vertex = vec![0; blocking.vertices().len()];
        let mut at_ray = vec![[0; 3]; blocking.vertices().len()];
        for block in blocking.blocks() {
            for corner in [block.start, block.end] {
                at_vertex[corner.vertex.index()] += 1;
                at_ray[corner.vertex.index()][usize::from(corner.touch)] += 1;
            }
        }
        for (k, vertex) in blocking.vertices().iter().enumerate() {
            prop_assert_eq!(at_vertex[k], 2 * vertex.touches.len());
            prop_assert!(at_ray[k][..vertex.touches.len()].iter().all(|&blocks| blocks == 2));
        }
    }

    /// Lemma 1. The angle between arc and η-curve at an interior corner is half the angle that the
    /// arc's two touching points make at the medial vertex, and so the angle of the interior
    /// triangle opposite them.
    #[test]
    fn interior_corner_angles_equal_the_triangle_angles(domain in Domains::any()) {
        let blocking = Blocking::of(&domain).unwrap();
        for id in blocking.block_ids() {
            let block = blocking.block(id);
            let vertex = blocking.vertex(block.start.vertex);
            if vertex.touches.len() < 3 {
                continue;
            }
            let corner = blocking.inner_corner(&block.start);
            let arc_tangent = (blocking.curve(id, BlockSide::Xi0, 1e-5) - corner).normalize_or_zero();
            if blocking.arc_length(block.arc) < 1e-3 * vertex.clearance {
                continue;
            }
            let at_corner = angle_at(DVec2::ZERO, arc_tangent, blocking.wall_corner(block, &block.start) - corner);
            let touching: Vec<DVec2> = vertex
                .touches
                .iter()
                .map(|touch| domain.wall_image(touch.image).point_towards(touch.direction))
                .collect();
            let mate = blocking.block(block.neighbours.xi0.0);
            let (own, other) = (usize::from(block.start.touch), usize::from(mate.end.touch));
            let opposite = 3 - own - other;
            let of_triangle = angle_at(touching[opposite], touching[own], touching[other]);
            prop_assert!((at_corner - of_triangle).abs() < 0.1, "{at_corner} {of_triangle}");
        }
    }

    #[test]
    fn no_cell_is_folded(domain in Domains::any(), matched in any::<bool>(), n in 1u32..17) {
        let matching = if matched { NodeMatching::EmptyCircle } else { NodeMatching::EqualSpacing };
        let mesh = match mesh(&domain, &Params { cells: CellCounts::PerBlock(n), matching }) {
            Err(BlockingError::TooFewCells { .. }) if n < 4 => return Ok(()),
            mesh => mesh.unwrap(),
        };
        let thin: Vec<_> = mesh.blocking().thin_arcs(1e-6).collect();
        for (block, grid) in mesh.blocks() {
            if thin.contains(&block.arc) {
                continue;
            }
            for corners in grid.cells() {
                for k in 0..4 {
                    let turn = orient2d(corners[k], corners[(k + 1) % 4], corners[(k + 2) % 4]);
                    prop_assert!(turn.is_positive(), "{corners:?}");
                }
            }
        }
    }

    #[test]
    fn empty_circles_touch_their_walls_and_no_other(domain in Domains::any()) {
        let blocking = Blocking::of(&domain).unwrap();
        for vertex in blocking.vertices() {
            for touch in &vertex.touches {
                let distance = domain.wall_image(touch.image).distance(vertex.center);
                prop_assert!((distance - vertex.clearance).abs() < 1e-12);
            }
            for wall in domain.wall_ids() {
                for x in -2..=2 {
                    for y in -2..=2 {
                        let shift = medial_blocking::Shift::new(x, y);
                        if domain.period().is_none() && shift != medial_blocking::Shift::ZERO {
                            continue;
                        }
                        let image = medial_blocking::WallImage { wall, shift };
                        let distance = domain.wall_image(image).distance(vertex.center);
                        prop_assert!(distance > vertex.clearance * (1.0 - 1e-8));
                    }
                }
            }
        }
    }

    /// The area between the polygons of the walls' nodes is that of the cells: none is missing or counted twice.
    #[test]
    fn the_blocks_cover_the_domain_once(domain in Domains::any()) {
        let params = Params { cells: CellCounts::PerBlock(16), ..Params::default() };
        let mesh = mesh(&domain, &params).unwrap();
        let meshed: f64 = mesh.cells().map(|[a, b, c, d]| 0.5 * (c - a).perp_dot(d - b)).sum();
        let period = domain.period().map_or(0.0, |period| period.x * period.y);
        // Along the walls the domain is on the left, so holes count against the area.
        let walls: f64 = mesh
            .blocks()
            .map(|(block, grid)| {
                let center = domain.wall(block.wall).circle.center;
                let at = |j| grid.node(16, j) - center;
                (0..16).map(|j| 0.5 * at(j).perp_dot(at(j + 1))).sum::<f64>()
            })
            .sum();
        prop_assert!((meshed - (period + walls)).abs() < 1e-9, "{meshed} {}", period + walls);
    }

    #[test]
    fn arcs_keep_equally_far_from_both_their_walls(domain in Domains::any()) {
        let blocking = Blocking::of(&domain).unwrap();
        for arc in blocking.arcs() {
            for k in 0..=4 {
                let p = arc.curve.point(f64::from(k) / 4.0);
                let [right, left] = [arc.right, arc.left].map(|image| domain.wall_image(image).distance(p));
                prop_assert!((right - left).abs() < ROUNDING);
            }
        }
    }
}
