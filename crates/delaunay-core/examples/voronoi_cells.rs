//! Points in a box step to the centers of their Voronoi cells: the cells become round and alike.
//!
//! `cargo run --release -p delaunay-core --example voronoi_cells`

#![allow(clippy::print_stdout)]

use delaunay_core::{ConvexPolyhedron, Delaunay3, Side};
use glam::DVec3;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let window = ConvexPolyhedron::cuboid(DVec3::ZERO, DVec3::ONE)?;
    // Fractions of multiples of irrational numbers: scattered, and the same on every machine.
    let steps = DVec3::new(2f64.sqrt(), 3f64.sqrt(), 5f64.sqrt());
    let mut points: Vec<DVec3> = (1..=500)
        .map(|i| (f64::from(i * i) * steps).fract())
        .collect();

    println!("round     energy  smallest cell  largest cell");
    for round in 0..10 {
        let delaunay = Delaunay3::build(&points)?;
        let mut carver = delaunay.voronoi().carver(&window);
        let (mut energy, mut smallest, mut largest) = (0.0, f64::INFINITY, 0.0_f64);
        for v in delaunay.vertices() {
            let moments = carver.cell(v).moments();
            energy += moments.second;
            smallest = smallest.min(moments.volume);
            largest = largest.max(moments.volume);
            points[v.index()] += moments.first / moments.volume;
        }
        println!("{round:5}  {energy:9.6}  {smallest:13.6}  {largest:12.6}");
    }

    let delaunay = Delaunay3::build(&points)?;
    let middle = delaunay.nearest_vertex(DVec3::splat(0.5))?;
    let cell = delaunay.voronoi().cell(middle, &window);
    println!("the cell of {middle}, volume {:.6}:", cell.volume());
    for face in cell.faces() {
        if let Side::Neighbor(u) = face.side() {
            println!(
                "  {u}: {} corners, area {:.6}",
                face.corners().count(),
                face.area()
            );
        }
    }
    Ok(())
}
