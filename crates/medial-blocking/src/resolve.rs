//! Samples the walls until the triangulation has the topology of the medial axis.
//!
//! Two things can be wrong with a sampling, and each tells where to sample more: pieces of wall
//! that are no side of the triangulation, and interior triangles whose tangent circle is not empty,
//! because four walls are nearly co-circular and the samples chose the wrong diagonal. The first
//! are halved; to the second are added the points where the circle touches its walls and the
//! nearest point of the wall that intrudes, which together rule the triangle out.

use glam::DVec2;

use crate::Report;
use crate::clearance::{Clearance, NearWall};
use crate::corner::wall_image;
use crate::domain::Domain;
use crate::error::BlockingError;
use crate::medial_axis::SampledAxis;
use crate::medial_graph::{MedialVertex, Touch};
use crate::sample::{SampleId, Samples};
use crate::tangent_circle::{inward, tangent_circle};
use crate::triangulation::{DomainTriangulation, TooCoarse, TriangleId};
use crate::wall::{Wall, WallId};

/// Rounds of sampling; each halves the pieces at fault, so doubles are used up before the rounds
/// are.
const MAX_ROUNDS: usize = 60;

/// A wall that reaches this deep into a tangent circle, relative to its radius, is touching it:
/// such vertices are co-circular.
const COCIRCULAR: f64 = 1e-9;

/// Samples of a domain of size about 1 do not tell apart circles that differ by less: 2^-46.
const ROUNDING: f64 = 1.0 / (1u64 << 46) as f64;

/// Samples, the triangulation of the domain, and the exact medial vertex of every interior triangle
/// in the triangulation's order.
pub(crate) struct Resolved {
    pub(crate) samples: Samples,
    pub(crate) triangulation: DomainTriangulation,
    pub(crate) vertices: Vec<MedialVertex>,
}

/// More directions at which to sample walls.
type Refinement = Vec<(WallId, DVec2)>;

impl Resolved {
    /// Samples `domain` until every piece of wall is a side and every tangent circle is empty.
    pub(crate) fn of(domain: &Domain, report: &mut Report<'_>) -> Result<Self, BlockingError> {
        let (unit, size) = domain.at_unit_size();
        Ok(Self::at_unit_size(&unit, report)?.scaled(size))
    }

    fn at_unit_size(domain: &Domain, report: &mut Report<'_>) -> Result<Self, BlockingError> {
        let clearance = Clearance::new(domain);
        let mut samples = Samples::by_local_gap(domain, &clearance, report)?;
        for _ in 0..MAX_ROUNDS {
            let refinement = match DomainTriangulation::of(domain, &samples, report)? {
                Err(TooCoarse(pieces)) => halved(&samples, pieces),
                Ok(triangulation) => {
                    let axis = SampledAxis {
                        domain,
                        samples: &samples,
                        triangulation: &triangulation,
                    };
                    match medial_vertices(&axis, &clearance) {
                        Ok(vertices) => {
                            return Ok(Self {
                                samples,
                                triangulation,
                                vertices,
                            });
                        }
                        Err(refinement) => refinement,
                    }
                }
            };
            samples = samples.with(domain, &refinement)?;
        }
        Err(BlockingError::Unresolved)
    }

    fn scaled(self, size: f64) -> Self {
        let vertices = self.vertices.into_iter().map(|vertex| MedialVertex {
            center: vertex.center * size,
            clearance: vertex.clearance * size,
            ..vertex
        });
        Self {
            samples: self.samples.scaled(size),
            triangulation: self.triangulation,
            vertices: vertices.collect(),
        }
    }
}

fn halved(samples: &Samples, pieces: Vec<SampleId>) -> Refinement {
    pieces
        .into_iter()
        .map(|piece| (samples.wall(piece), samples.direction_after(piece)))
        .collect()
}

/// The medial vertex of every interior triangle, or where to sample more.
fn medial_vertices(
    axis: &SampledAxis<'_>,
    clearance: &Clearance<'_>,
) -> Result<Vec<MedialVertex>, Refinement> {
    let mut refinement = Vec::new();
    let mut vertices = Vec::new();
    for triangle in axis.triangulation.interior() {
        match medial_vertex(axis, clearance, triangle) {
            Ok(vertex) => vertices.push(vertex),
            Err(more) => refinement.extend(more),
        }
    }
    if refinement.is_empty() {
        Ok(vertices)
    } else {
        Err(refinement)
    }
}

/// The circle that touches the three walls of a triangle's corners, if no other wall reaches into
/// it.
fn medial_vertex(
    axis: &SampledAxis<'_>,
    clearance: &Clearance<'_>,
    triangle: TriangleId,
) -> Result<MedialVertex, Refinement> {
    let images = axis
        .triangulation
        .triangle(triangle)
        .corners
        .map(|corner| wall_image(axis.samples, corner));
    let walls = images.map(|image| axis.domain.wall_image(image));
    let start = axis.circumcenter(triangle, crate::wall::Shift::ZERO);
    let Some(circle) = tangent_circle(&walls, start) else {
        return Err(pieces_at(axis, triangle));
    };
    let touches: Vec<Touch> = images
        .iter()
        .zip(&walls)
        .map(|(&image, wall)| Touch::of(image, wall, circle.center))
        .collect();
    match clearance.nearest(circle.center, |image| !images.contains(&image)) {
        Some(near) if near.distance < circle.radius * (1.0 - COCIRCULAR) - ROUNDING => {
            let mut more: Refinement = touches
                .iter()
                .map(|touch| (touch.image.wall, touch.direction))
                .collect();
            more.push(intrusion(axis.domain, near, circle.center));
            more.extend(pieces_at(axis, triangle));
            Err(more)
        }
        _ => {
            let center = axis.domain.snap(circle.center);
            Ok(MedialVertex {
                center,
                clearance: circle.radius,
                touches,
            })
        }
    }
}

/// The point of the intruding wall that lies deepest in the circle.
fn intrusion(domain: &Domain, near: NearWall, center: DVec2) -> (WallId, DVec2) {
    let wall: Wall = domain.wall_image(near.image);
    (near.image.wall, inward(&wall, center) * wall.turn())
}

/// Halves the pieces of wall on both sides of each corner of a triangle.
fn pieces_at(axis: &SampledAxis<'_>, triangle: TriangleId) -> Refinement {
    let samples = axis.samples;
    let corners = axis
        .triangulation
        .triangle(triangle)
        .corners
        .map(|corner| corner.sample);
    halved(
        samples,
        corners
            .iter()
            .flat_map(|&sample| [samples.previous(sample), sample])
            .collect(),
    )
}

#[cfg(test)]
mod tests {
    use delaunay_core::progress::silent;

    use super::*;
    use crate::example_domains::{four_co_circular_holes, three_holes, two_periodic_holes};

    #[test]
    fn the_circle_of_every_vertex_touches_its_three_walls_and_holds_no_other() {
        for domain in [
            three_holes(),
            two_periodic_holes(),
            four_co_circular_holes(),
        ] {
            let resolved = Resolved::of(&domain, &mut silent).unwrap();
            let clearance = Clearance::new(&domain);
            for vertex in &resolved.vertices {
                for touch in &vertex.touches {
                    let distance = domain.wall_image(touch.image).distance(vertex.center);
                    assert!((distance - vertex.clearance).abs() < 1e-14);
                }
                let nearest = clearance.nearest(vertex.center, |_| true).unwrap();
                assert!(nearest.distance >= vertex.clearance - 1e-14);
            }
        }
    }

    #[test]
    fn co_circular_holes_share_their_vertex() {
        let resolved = Resolved::of(&four_co_circular_holes(), &mut silent).unwrap();
        let middle = |vertex: &&MedialVertex| vertex.center.length() < 1e-12;
        assert_eq!(resolved.vertices.iter().filter(middle).count(), 2);
    }
}
