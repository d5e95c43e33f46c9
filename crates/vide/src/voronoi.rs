//! Voronoi diagrams as polygons and polyhedra for files: cells clipped to a window, each with its site.

use delaunay_core::{
    ConvexPolygon, ConvexPolyhedron, Delaunay2, Delaunay3, PolygonError, PolyhedronError, VertexId,
};
use glam::{DVec2, DVec3};
use mesh_io::{DataArray, Polytopes};
use rayon::prelude::*;

/// How far a window reaches beyond the points, in parts of their longest extent.
const PADDING: f64 = 0.1;

/// Sites that one thread takes at a time.
const SITES: usize = 1 << 10;

/// The bounding box of the points, a tenth of its longest side wider all round.
///
/// # Errors
/// [`PolygonError`] when the box leaves the range of coordinates or has no width.
pub fn window_of_plane(points: &[DVec2]) -> Result<ConvexPolygon, PolygonError> {
    let low = points.iter().copied().fold(DVec2::INFINITY, DVec2::min);
    let high = points.iter().copied().fold(DVec2::NEG_INFINITY, DVec2::max);
    let margin = DVec2::splat(PADDING * (high - low).max_element());
    ConvexPolygon::rectangle(low - margin, high + margin)
}

/// The same in space.
///
/// # Errors
/// [`PolyhedronError`] when the box leaves the range of coordinates or has no width.
pub fn window_of_space(points: &[DVec3]) -> Result<ConvexPolyhedron, PolyhedronError> {
    let low = points.iter().copied().fold(DVec3::INFINITY, DVec3::min);
    let high = points.iter().copied().fold(DVec3::NEG_INFINITY, DVec3::max);
    let margin = DVec3::splat(PADDING * (high - low).max_element());
    ConvexPolyhedron::cuboid(low - margin, high + margin)
}

/// The Voronoi cells of the plane, by site: the polygons with `site`, the index of the point, and `area`.
///
/// Sites with nothing inside the window are left out. `done` hears of every few thousand sites how many there are so
/// far. Runs on the threads of the current pool; what comes out does not depend on their number.
pub fn voronoi_polygons(
    delaunay: &Delaunay2,
    window: &ConvexPolygon,
    done: &mut dyn FnMut(usize),
) -> Polytopes {
    let voronoi = delaunay.voronoi();
    gathered(delaunay.vertices(), "area", done, |sites| {
        let mut cells = Cells::default();
        for &site in sites {
            let cell = voronoi.cell(site, window);
            if !cell.is_empty() {
                let corners = cell
                    .corners()
                    .iter()
                    .map(|corner| [corner.x, corner.y, 0.0]);
                cells.polytopes.push_polygon(corners);
                cells.describe(site, cell.area());
            }
        }
        cells
    })
}

/// The Voronoi cells of space, by site: the polyhedra with `site`, the index of the point, and `volume`.
///
/// As [`voronoi_polygons`]. Faces that rounding left without area are left out.
pub fn voronoi_polyhedra(
    delaunay: &Delaunay3,
    window: &ConvexPolyhedron,
    done: &mut dyn FnMut(usize),
) -> Polytopes {
    gathered(delaunay.vertices(), "volume", done, |sites| {
        let voronoi = delaunay.voronoi();
        let mut carver = voronoi.carver(window);
        let mut cells = Cells::default();
        let mut solid = Solid::default();
        for &site in sites {
            let cell = carver.cell(site);
            solid.gather(cell);
            if !solid.faces.is_empty() {
                cells
                    .polytopes
                    .push_polyhedron(&solid.corners, &solid.faces);
                cells.describe(site, cell.volume());
            }
        }
        cells
    })
}

/// Cells with what is known of each.
#[derive(Default)]
struct Cells {
    polytopes: Polytopes,
    sites: Vec<f64>,
    sizes: Vec<f64>,
}

impl Cells {
    fn describe(&mut self, site: VertexId, size: f64) {
        self.sites.push(site.index() as f64);
        self.sizes.push(size);
    }
}

/// The cells of all sites, joined in the order of the sites.
fn gathered(
    sites: impl Iterator<Item = VertexId>,
    size: &str,
    done: &mut dyn FnMut(usize),
    cells_of: impl Fn(&[VertexId]) -> Cells + Sync,
) -> Polytopes {
    const TURNS: usize = 16;
    let sites: Vec<VertexId> = sites.collect();
    let mut all = Cells::default();
    for turn in sites.chunks(TURNS * SITES) {
        let parts: Vec<Cells> = turn.par_chunks(SITES).map(&cells_of).collect();
        for part in parts {
            all.polytopes.append(&part.polytopes);
            all.sites.extend(part.sites);
            all.sizes.extend(part.sizes);
        }
        done(all.sites.len());
    }
    all.polytopes.data = vec![
        DataArray::scalar("site", all.sites),
        DataArray::scalar(size, all.sizes),
    ];
    all.polytopes
}

/// A polyhedron as corners and faces that name them.
#[derive(Default)]
struct Solid {
    /// In lexicographic order, each place once.
    corners: Vec<[f64; 3]>,
    faces: Vec<Vec<u32>>,
}

impl Solid {
    fn gather(&mut self, cell: &ConvexPolyhedron) {
        // Adding 0.0 turns -0.0 into 0.0: one place has one writing.
        let place = |corner: DVec3| (corner + DVec3::ZERO).to_array();
        self.corners.clear();
        self.corners.extend(cell.corners().map(place));
        self.corners.sort_unstable_by(lexicographic);
        self.corners.dedup();
        let number = |corner: DVec3| {
            let found = self
                .corners
                .binary_search_by(|other| lexicographic(other, &place(corner)));
            found.ok().map(|number| number as u32)
        };
        let faces = cell
            .faces()
            .map(|face| face.corners().filter_map(number).collect());
        self.faces.clear();
        self.faces
            .extend(faces.filter(|face: &Vec<u32>| face.len() >= 3));
    }
}

fn lexicographic(a: &[f64; 3], b: &[f64; 3]) -> std::cmp::Ordering {
    let mut pairs = a.iter().zip(b).map(|(a, b)| a.total_cmp(b));
    pairs
        .find(|order| order.is_ne())
        .unwrap_or(std::cmp::Ordering::Equal)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sum(cells: &Polytopes, name: &str) -> f64 {
        let data = cells.data.iter().find(|data| data.name == name);
        data.unwrap().values.iter().sum()
    }

    #[test]
    fn the_cells_of_the_plane_tile_the_window() {
        let points: Vec<DVec2> = (0..200)
            .map(|i| DVec2::new(f64::from(i * 7 % 31), f64::from(i * 11 % 29)))
            .collect();
        let delaunay = Delaunay2::build(&points).unwrap();
        let window = window_of_plane(&points).unwrap();
        let mut seen = 0;
        let cells = voronoi_polygons(&delaunay, &window, &mut |done| seen = done);
        assert_eq!((cells.len(), seen), (200, 200));
        assert!((sum(&cells, "area") - 36.0 * 34.0).abs() < 1e-9);
    }

    #[test]
    fn the_cells_of_a_grid_are_cubes_with_six_faces() {
        let grid = |i: u32| DVec3::new(f64::from(i % 3), f64::from(i / 3 % 3), f64::from(i / 9));
        let points: Vec<DVec3> = (0..27).map(grid).collect();
        let delaunay = Delaunay3::build(&points).unwrap();
        let window = window_of_space(&points).unwrap();
        let cells = voronoi_polyhedra(&delaunay, &window, &mut |_| ());
        assert_eq!(cells.len(), 27);
        assert!((sum(&cells, "volume") - 2.4f64.powi(3)).abs() < 1e-12);
        // A face is written as its number of corners and four of them.
        assert_eq!(cells.points().len(), 27 * 8);
        assert_eq!(cells.faces().len(), 27 * (1 + 6 * 5));
    }

    #[test]
    fn every_edge_of_a_polyhedron_runs_both_ways() {
        let place = |i: u32| [i * 7 % 31, i * 11 % 29, i * 13 % 23].map(f64::from);
        let points: Vec<DVec3> = (0..300).map(|i| DVec3::from(place(i))).collect();
        let delaunay = Delaunay3::build(&points).unwrap();
        let window = window_of_space(&points).unwrap();
        let cells = voronoi_polyhedra(&delaunay, &window, &mut |_| ());
        assert_eq!(cells.len(), delaunay.vertex_count());
        let mut edges = std::collections::BTreeSet::new();
        let mut rest = cells.faces();
        while let Some((&faces, after)) = rest.split_first() {
            rest = after;
            for _ in 0..faces {
                let (face, after) = rest[1..].split_at(rest[0] as usize);
                rest = after;
                edges.extend((0..face.len()).map(|i| (face[i], face[(i + 1) % face.len()])));
            }
        }
        assert!(edges.iter().all(|&(a, b)| edges.contains(&(b, a))));
    }
}
