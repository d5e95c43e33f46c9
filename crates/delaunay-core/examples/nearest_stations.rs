//! Stations in a town: whose district is a house in, and how large are the districts?
//!
//! `cargo run -p delaunay-core --example nearest_stations`

#![allow(clippy::print_stdout)]

use delaunay_core::{ConvexPolygon, Delaunay2};
use glam::DVec2;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let stations = [
        [2.0, 1.0],
        [7.5, 1.5],
        [5.0, 4.0],
        [1.5, 6.5],
        [8.0, 7.0],
        [4.5, 8.5],
    ]
    .map(DVec2::from);
    let town = ConvexPolygon::rectangle(DVec2::ZERO, DVec2::splat(10.0))?;
    let mut delaunay = Delaunay2::build(&stations)?;

    let house = DVec2::new(6.0, 5.5);
    println!("nearest to the house: {}", delaunay.nearest_vertex(house)?);

    // A new station takes its district from its new neighbours.
    let station = delaunay.insert(house)?.vertex();
    for v in delaunay.vertices() {
        let district = delaunay.voronoi().cell(v, &town);
        let neighbors = delaunay.mesh().neighbors(v).filter(|u| !u.is_ghost());
        println!(
            "{v}: area {:6.3}, {} neighbours",
            district.area(),
            neighbors.count()
        );
    }
    delaunay.remove(station)?;
    assert_eq!(delaunay.check(), Ok(()));
    Ok(())
}
