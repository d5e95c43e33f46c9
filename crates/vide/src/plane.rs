//! The region of the plane that a planar graph describes: its triangles before anything is done to them.

use std::ops::ControlFlow;

use delaunay_core::progress::{Cancelled, Progress};
use delaunay_core::{
    BuildOptions, Components, ConstrainError, Constrained2, Crossings, FaceId, Outline,
    OutlineError, SeedError, Subcomplex2, VertexId,
};
use glam::DVec2;
use mesh_io::PlanarGraph;

use crate::polygons::covered;

/// The triangles of a planar graph: its constrained triangulation, and which parts of it are inside.
///
/// Points are vertices with the same numbers. Where the graph has seeds of holes or of regions, the parts with holes' seeds are
/// not inside and all others that segments enclose are, as in `Triangle`'s files. Without any seed, a graph drawn as polygons is
/// what they cover, each without the holes that its own rings make; in any other one each closed outline within another one is a
/// hole, and one within that is inside again. Segments with the inside on both sides are kept too.
#[derive(Clone, Debug)]
pub struct GivenRegion {
    triangulation: Constrained2,
    components: Components,
    /// By part.
    inside: Vec<bool>,
}

/// Why a planar graph describes no region.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum GivenRegionError {
    /// Its points or segments have no triangulation.
    #[error(transparent)]
    Constrain(#[from] ConstrainError),
    /// Its segments enclose nothing, as they are no closed outline.
    #[error(transparent)]
    Outline(#[from] OutlineError),
    /// All that the segments enclose is a hole.
    #[error("all parts that the segments enclose are holes")]
    AllHoles,
    /// The polygons cover nothing.
    #[error("the polygons cover nothing")]
    NothingCovered,
    /// Two points are at one place.
    #[error("{first} and {second} are at one place")]
    CoincidentVertices {
        /// The point with the smaller number.
        first: VertexId,
        /// The other.
        second: VertexId,
    },
    /// A point is outside.
    #[error("{vertex} is neither inside nor on an outline")]
    Outside {
        /// The first such point.
        vertex: VertexId,
    },
    /// The seed of a hole names no part.
    #[error("hole {}", seed_text(.0))]
    Hole(SeedError),
    /// The report closure stopped the work.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

impl GivenRegion {
    /// The region that a graph describes. Takes the time of [`Constrained2::build`].
    ///
    /// # Errors
    /// The first [`GivenRegionError`], in the order of the segments, the holes and the points.
    pub fn of(
        graph: &PlanarGraph,
        crossings: Crossings,
        options: BuildOptions,
        report: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Self, GivenRegionError> {
        let points: Vec<DVec2> = graph.points.iter().copied().map(DVec2::from).collect();
        let segments = graph.segments.iter();
        let segments = segments.map(|ends| ends.map(|v| VertexId::new(v as usize)));
        let segments: Vec<[VertexId; 2]> = segments.collect();
        let triangulation = Constrained2::build(&points, &segments, crossings, options, report)?;
        if let Some((second, first)) = triangulation.duplicates().iter().next() {
            return Err(GivenRegionError::CoincidentVertices { first, second });
        }
        let components = triangulation.components(report)?;
        if components.count() == 1 {
            Outline::with_interior(points, segments.clone())?;
        }
        let inside = inside(graph, &segments, &triangulation, &components)?;
        let region = Self {
            triangulation,
            components,
            inside,
        };
        let mut vertices = (0..graph.points.len()).map(VertexId::new);
        match vertices.find(|&v| !region.touches(v)) {
            Some(vertex) => Err(GivenRegionError::Outside { vertex }),
            None => Ok(region),
        }
    }

    /// The triangulation of all points, inside and outside.
    #[must_use]
    pub fn triangulation(&self) -> &Constrained2 {
        &self.triangulation
    }

    /// The parts that the segments separate.
    #[must_use]
    pub fn components(&self) -> &Components {
        &self.components
    }

    /// Whether a triangle is inside; ghosts are not.
    #[must_use]
    pub fn is_inside(&self, f: FaceId) -> bool {
        self.inside[self.components.of(f)]
    }

    /// Whether a part that the segments separate is inside.
    ///
    /// # Panics
    /// When there is no such part.
    #[must_use]
    pub fn has_inside(&self, part: usize) -> bool {
        self.inside[part]
    }

    /// What is inside, cut apart along inner segments. Takes linear time.
    #[must_use]
    pub fn subcomplex(&self) -> Subcomplex2 {
        self.triangulation.subcomplex(|f| self.is_inside(f))
    }

    fn touches(&self, v: VertexId) -> bool {
        let mut star = self.triangulation.mesh().star(v);
        star.any(|f| self.is_inside(f))
    }
}

/// By part, whether it is inside.
fn inside(
    graph: &PlanarGraph,
    segments: &[[VertexId; 2]],
    triangulation: &Constrained2,
    components: &Components,
) -> Result<Vec<bool>, GivenRegionError> {
    let parts = 0..components.count();
    if graph.holes.is_empty() && graph.regions.is_empty() {
        if let Some(rings) = &graph.polygons {
            let inside = covered(segments, rings, triangulation, components);
            return match inside.contains(&true) {
                true => Ok(inside),
                false => Err(GivenRegionError::NothingCovered),
            };
        }
        return Ok(parts.map(|part| components.depth(part) % 2 == 1).collect());
    }
    let seeds: Vec<DVec2> = graph.holes.iter().copied().map(DVec2::from).collect();
    let holes = triangulation.parts_at(components, &seeds);
    let holes = holes.map_err(GivenRegionError::Hole)?;
    let inside: Vec<bool> = parts
        .map(|part| part > 0 && !holes.contains(&part))
        .collect();
    match inside.contains(&true) {
        true => Ok(inside),
        false => Err(GivenRegionError::AllHoles),
    }
}

/// The error without the first word.
pub(crate) fn seed_text(error: &SeedError) -> String {
    let text = error.to_string();
    text.strip_prefix("seed ")
        .map_or(text.clone(), str::to_owned)
}

#[cfg(test)]
mod tests {
    use super::*;
    use delaunay_core::progress::silent;
    use mesh_io::Region;

    fn square(s: f64) -> [[f64; 2]; 4] {
        [[-s, -s], [s, -s], [s, s], [-s, s]]
    }

    /// Squares in each other.
    fn nested(sizes: &[f64]) -> PlanarGraph {
        let loops =
            (0..4 * sizes.len() as u32).map(|i| [i, if i % 4 == 3 { i - 3 } else { i + 1 }]);
        PlanarGraph {
            points: sizes.iter().flat_map(|&s| square(s)).collect(),
            segments: loops.collect(),
            ..PlanarGraph::default()
        }
    }

    fn area(graph: &PlanarGraph) -> Result<f64, String> {
        let options = BuildOptions::default();
        let region = GivenRegion::of(graph, Crossings::Refuse, options, &mut silent);
        let region = region.map_err(|error| error.to_string())?.subcomplex();
        let areas = region.faces().map(|f| {
            let [a, b, c] = region.triangle(f);
            (b - a).perp_dot(c - a) / 2.0
        });
        Ok(areas.sum())
    }

    #[test]
    fn without_seeds_outlines_are_holes_in_turn() {
        assert_eq!(area(&nested(&[3.0, 2.0, 1.0])), Ok(36.0 - 16.0 + 4.0));
    }

    #[test]
    fn seeds_name_the_holes_and_all_else_is_inside() {
        let mut graph = nested(&[3.0, 2.0, 1.0]);
        graph.regions.push(Region {
            seed: [1.5, 0.0],
            attribute: 1.0,
            max_area: None,
        });
        assert_eq!(area(&graph), Ok(36.0));
        graph.holes.push([0.0, 0.0]);
        assert_eq!(area(&graph), Ok(32.0));
    }

    /// The area of polygons, each of rings that are closed here.
    fn area_of(polygons: &[&[&[[f64; 2]]]]) -> Result<f64, String> {
        let ring = |ring: &&[[f64; 2]]| {
            let closed = ring.iter().chain(ring.first());
            let places: Vec<String> = closed.map(|[x, y]| format!("[{x},{y}]")).collect();
            format!("[{}]", places.join(","))
        };
        let polygon = |rings: &&[&[[f64; 2]]]| {
            let rings: Vec<String> = rings.iter().map(ring).collect();
            format!("[{}]", rings.join(","))
        };
        let polygons: Vec<String> = polygons.iter().map(polygon).collect();
        let text = format!(
            r#"{{"type":"MultiPolygon","coordinates":[{}]}}"#,
            polygons.join(",")
        );
        area(&mesh_io::geojson::parse(text.as_bytes()).unwrap())
    }

    #[test]
    fn a_country_that_its_neighbours_surround_is_no_hole() {
        let (outer, inner) = (square(3.0), square(1.0));
        let ring: &[&[[f64; 2]]] = &[&outer, &inner];
        assert_eq!(area_of(&[ring]), Ok(32.0));
        assert_eq!(area_of(&[ring, &[&inner]]), Ok(36.0));
        // The two halves of the ring, with the middle and without it.
        let left = [
            [-3.0, -3.0],
            [0.0, -3.0],
            [0.0, -1.0],
            [-1.0, -1.0],
            [-1.0, 1.0],
            [0.0, 1.0],
            [0.0, 3.0],
            [-3.0, 3.0],
        ];
        let right = left.map(|[x, y]| [-x, y]);
        assert_eq!(area_of(&[&[&left], &[&right]]), Ok(32.0));
        // The corners in the middle of the halves are not those of the whole, so that edges of one lie on those of the other.
        assert_eq!(area_of(&[&[&left], &[&right], &[&inner]]), Ok(36.0));
    }

    #[test]
    fn polygons_in_each_other_or_given_twice_cover_what_any_covers() {
        let (outer, inner) = (square(3.0), square(1.0));
        assert_eq!(area_of(&[&[&outer], &[&inner]]), Ok(36.0));
        assert_eq!(area_of(&[&[&inner], &[&inner]]), Ok(4.0));
        assert_eq!(
            area_of(&[&[&inner, &inner]]),
            Err("the polygons cover nothing".to_owned())
        );
    }

    #[test]
    fn defects_are_named() {
        let with = |change: &dyn Fn(&mut PlanarGraph)| {
            let mut graph = nested(&[3.0, 2.0]);
            change(&mut graph);
            area(&graph).unwrap_err()
        };
        let hole = |place: [f64; 2]| with(&move |graph| graph.holes.push(place));
        insta::assert_snapshot!(hole([9.0, 0.0]), @"hole 0 at (9, 0) is outside");
        insta::assert_snapshot!(hole([2.0, 0.0]), @"hole 0 at (2, 0) is on segment 5");
        insta::assert_snapshot!(with(&|graph| graph.holes.extend([[0.0, 0.0], [2.5, 0.0]])), @"all parts that the segments enclose are holes");
        insta::assert_snapshot!(with(&|graph| graph.points.push([9.0, 9.0])), @"v8 is neither inside nor on an outline");
        insta::assert_snapshot!(with(&|graph| graph.points.push([3.0, 3.0])), @"v2 and v8 are at one place");
        insta::assert_snapshot!(with(&|graph| graph.segments.retain(|ends| *ends != [0, 1])), @"v0 is neither inside nor on an outline");
        insta::assert_snapshot!(with(&|graph| graph.segments.extend([[4, 6], [5, 7]])), @"segments 8 and 9 cross near (0, 0)");
    }
}
