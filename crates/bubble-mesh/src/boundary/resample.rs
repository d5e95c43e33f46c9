//! New nodes on a given boundary, as fine as the given ones but with sizes that change slowly.

use delaunay_core::VertexId;
use glam::DVec2;
use thiserror::Error;

use super::chains::chains;
use crate::curve::{CurveError, Sampling, SamplingError, Sizes, sample_sized};

/// How a boundary is sampled anew.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Resampling {
    /// Nodes where the boundary turns by more than this are corners, which stay; radians, π/6, from 0 on.
    pub crease: f64,
    /// How fast sizes may grow with the distance, along the boundary and from one part of it to another; 0.2, above 0.
    pub grade: f64,
    /// The longest edge; infinite for no limit.
    pub size: f64,
    /// At most this many nodes; a million.
    pub at_most: usize,
}

impl Default for Resampling {
    fn default() -> Self {
        Self {
            crease: std::f64::consts::FRAC_PI_6,
            grade: 0.2,
            size: f64::INFINITY,
            at_most: 1_000_000,
        }
    }
}

/// A boundary with new nodes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Resampled {
    /// The nodes, by vertex.
    pub points: Vec<DVec2>,
    /// The edges.
    pub segments: Vec<[VertexId; 2]>,
    /// By edge, an edge given that is in the same chain from corner to corner.
    pub parent_of: Vec<usize>,
    /// How many chains there are: pieces between corners, and loops without.
    pub chains: usize,
}

/// Why a boundary is not sampled anew.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum ResampleError {
    /// An edge names a vertex that does not exist.
    #[error("segment {segment} ends at {vertex}, which does not exist")]
    NoSuchVertex {
        /// Its index.
        segment: usize,
        /// As given.
        vertex: VertexId,
    },
    /// The turn at a corner is no angle.
    #[error("the crease {crease} is not an angle from 0 on")]
    Crease {
        /// As given, in radians.
        crease: f64,
    },
    /// No curve goes through the nodes from one corner to another.
    #[error("the boundary at segment {segment} is no curve: {error}")]
    Curve {
        /// An edge of it, by index.
        segment: usize,
        /// What is wrong with it.
        error: CurveError,
    },
    /// What is asked for makes no sense, or takes too many nodes.
    #[error(transparent)]
    Sampling(#[from] SamplingError),
}

/// Samples a boundary anew: between corners nodes are placed on the smooth curve through the given ones, where these are in line on the
/// line.
///
/// Edges are about as long as those given, but shorter where these would change faster than `grade` along the boundary or across a gap;
/// what is evenly spaced stays. A node where edges meet that are not `alike`, by their indices, is a corner too; so is one with other than two
/// edges. Loops without a corner keep their smallest node only. Points without edges are left out. Curves may stray from the
/// given edges by about as much as these stray from the curve that they stand for, so parts of the boundary that almost
/// touch may cross then; the triangulation of the result tells. Takes n log n time; the same on any number of threads.
///
/// ```
/// use bubble_mesh::{Resampling, resample};
/// use delaunay_core::VertexId;
/// use glam::DVec2;
///
/// // A square whose sides are one edge each, but for one with a short edge in it.
/// let points = [[0.0, 0.0], [1.0, 0.0], [1.1, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]].map(DVec2::from);
/// let segments: Vec<_> = (0..6).map(|i| [i, (i + 1) % 6].map(VertexId::new)).collect();
/// let resampled = resample(&points, &segments, |_, _| true, &Resampling::default())?;
/// assert_eq!(resampled.chains, 4);
/// let corner = |p: &DVec2| [0.0, 2.0].contains(&p.x) && [0.0, 2.0].contains(&p.y);
/// assert_eq!(resampled.points.iter().filter(|p| corner(p)).count(), 4);
/// assert!(resampled.segments.len() > 10);
/// # Ok::<(), bubble_mesh::ResampleError>(())
/// ```
///
/// # Errors
/// [`ResampleError`].
pub fn resample(
    points: &[DVec2],
    segments: &[[VertexId; 2]],
    alike: impl Fn(usize, usize) -> bool,
    resampling: &Resampling,
) -> Result<Resampled, ResampleError> {
    let ends = segments.iter().enumerate();
    let mut ends = ends.flat_map(|(segment, ends)| ends.map(|vertex| (segment, vertex)));
    if let Some((segment, vertex)) = ends.find(|(_, v)| v.index() >= points.len()) {
        return Err(ResampleError::NoSuchVertex { segment, vertex });
    }
    let crease = resampling.crease;
    if crease.is_nan() || crease < 0.0 {
        return Err(ResampleError::Crease { crease });
    }
    let chains = chains(points, segments, crease, alike);
    let curves = chains.iter().map(|chain| {
        let segment = chain.segment;
        let curve = chain.curve(points);
        curve.map_err(|error| ResampleError::Curve { segment, error })
    });
    let curves = curves.collect::<Result<Vec<_>, _>>()?;
    let sampling = Sampling {
        chord: f64::INFINITY,
        grade: resampling.grade,
        at_most: resampling.at_most,
        ..Sampling::new(resampling.size)
    };
    sampling.check_or_free()?;
    let sampled = sample_sized(&curves, &sampling, Sizes::OfStretches)?;
    let parents = sampled.curve_of.iter().map(|&curve| chains[curve].segment);
    Ok(Resampled {
        parent_of: parents.collect(),
        points: sampled.points,
        segments: sampled.segments,
        chains: chains.len(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    fn ring(count: usize, radius: f64, first: usize) -> (Vec<DVec2>, Vec<[VertexId; 2]>) {
        let node = |i: usize| radius * DVec2::from_angle(i as f64 * TAU / count as f64);
        let edge = |i: usize| [i, (i + 1) % count].map(|i| VertexId::new(first + i));
        (
            (0..count).map(node).collect(),
            (0..count).map(edge).collect(),
        )
    }

    #[test]
    fn what_is_even_stays_and_lies_on_the_curve() {
        let (points, segments) = ring(40, 3.0, 0);
        let found = resample(&points, &segments, |_, _| true, &Resampling::default()).unwrap();
        assert_eq!((found.points.len(), found.chains), (40, 1));
        for (new, old) in found.points.iter().zip(&points) {
            assert!(new.distance(*old) < 1e-6, "{new} {old}");
        }
    }

    #[test]
    fn a_coarse_wall_beside_a_fine_one_becomes_finer() {
        let (mut points, mut segments) = ring(16, 1.2, 0);
        let (more, edges) = ring(120, 1.0, 16);
        points.extend(more);
        segments.extend(edges);
        let resampling = Resampling::default();
        let found = resample(&points, &segments, |_, _| true, &resampling).unwrap();
        // Edges of 0.052 inside, and 0.2 from there they may be 0.04 longer: 81.
        let of = |parent: usize| found.parent_of.iter().filter(|&&p| p == parent).count();
        assert_eq!(of(16), 120);
        assert!((75..=100).contains(&of(0)), "{}", of(0));
    }

    #[test]
    fn kinds_of_edges_end_at_corners() {
        let (points, segments) = ring(40, 1.0, 0);
        let alike = |a: usize, b: usize| (a < 10) == (b < 10);
        let found = resample(&points, &segments, alike, &Resampling::default()).unwrap();
        assert_eq!(found.chains, 2);
        assert!(found.points.contains(&points[0]) && found.points.contains(&points[10]));
    }

    #[test]
    fn what_makes_no_sense_is_named() {
        let (mut points, mut segments) = ring(40, 1.0, 0);
        let error = |points: &[DVec2], segments: &[[VertexId; 2]], resampling: Resampling| {
            resample(points, segments, |_, _| true, &resampling)
                .unwrap_err()
                .to_string()
        };
        let usual = Resampling::default();
        let few = Resampling {
            at_most: 10,
            ..usual
        };
        let flat = Resampling {
            grade: 0.0,
            ..usual
        };
        let small = Resampling { size: 0.0, ..usual };
        let turned = Resampling {
            crease: f64::NAN,
            ..usual
        };
        let mut found = vec![
            error(&points, &segments, turned),
            error(&points, &segments, few),
            error(&points, &segments, flat),
            error(&points, &segments, small),
        ];
        points[7] = points[6];
        found.push(error(&points, &segments, usual));
        points[7].x = f64::NAN;
        found.push(error(&points, &segments, usual));
        segments[3][1] = VertexId::new(99);
        found.push(error(&points, &segments, usual));
        insta::assert_snapshot!(found.join("\n"));
    }
}
