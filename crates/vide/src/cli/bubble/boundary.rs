//! What becomes of the outline's nodes before the region is meshed.

use clap::error::ErrorKind;
use clap::{Args, Command, ValueEnum};
use vide::bubble_mesh::{Domain, Resampling, resample};
use vide::delaunay_core::{Crossings, VertexId};
use vide::glam::DVec2;
use vide::marks::Marks;
use vide::mesh_io::PlanarGraph;
use vide::plane::GivenRegion;

use super::BubbleArgs;
use crate::cli::Common;
use crate::cli::failure::Failure;
use crate::cli::progress::Watch;

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum AtBoundary {
    /// All nodes stay
    Fixed,
    /// Nodes slide along the smooth curve through them where that makes better triangles; corners stay
    Slide,
    /// Nodes are placed anew on the smooth curves through them, as finely as given but with edges that change slowly; corners stay
    Resample,
}

#[derive(Clone, Copy, ValueEnum)]
pub(super) enum AtCrossings {
    /// They are an error
    Refuse,
    /// They are divided where they meet
    Divide,
}

/// More divisions of segments that cross are an error.
const MOST_DIVISIONS: usize = 1_000_000;

/// How fast edges of an outline sampled anew grow, unless it is said.
const GRADE: f64 = 0.2;

impl BubbleArgs {
    /// Whether the options go together.
    ///
    /// # Errors
    /// A usage error where they contradict each other.
    pub(crate) fn check(&self) -> Result<(), clap::Error> {
        let problem = match (self.boundary, self.crossings) {
            (AtBoundary::Slide, _) if self.paper => {
                "--boundary slide is not of the paper: its boundary nodes stay"
            }
            (AtBoundary::Resample, AtCrossings::Divide) => {
                "--boundary resample needs an outline without crossings: there --crossings divide has nothing to do"
            }
            _ => return Ok(()),
        };
        let mut command = Self::augment_args(Command::new("vide bubble"));
        Err(command.error(ErrorKind::ArgumentConflict, problem))
    }
}

/// What is to be meshed.
pub(super) struct Region {
    pub(super) domain: Domain,
    pub(super) marks: Marks,
}

/// The domain of an outline, whose nodes are placed anew where that is asked for.
pub(super) fn region(
    args: &BubbleArgs,
    outline: &PlanarGraph,
    watch: &mut Watch,
) -> Result<Region, Failure> {
    let region = triangulated(args, outline, watch)?;
    if args.boundary != AtBoundary::Resample {
        return Ok(region);
    }
    let outline = resampled(args, outline)?;
    triangulated(args, &outline, watch).map_err(|error| {
        let problem = format!("with its nodes placed anew: {error}");
        Failure::input(&args.input, problem)
    })
}

fn triangulated(
    args: &BubbleArgs,
    outline: &PlanarGraph,
    watch: &mut Watch,
) -> Result<Region, Failure> {
    let failed = |error: &dyn std::fmt::Display| Failure::input(&args.input, error);
    let crossings = match args.crossings {
        AtCrossings::Refuse => Crossings::Refuse,
        AtCrossings::Divide => Crossings::Divide {
            at_most: MOST_DIVISIONS,
        },
    };
    let mut report = |progress| watch.report(progress);
    let region = GivenRegion::of(outline, crossings, Common::build_options(), &mut report);
    let region = region.map_err(|error| failed(&error))?;
    let marks = Marks::of(outline, &region);
    let marks = marks.map_err(|error| failed(&error))?;
    let domain = Domain::of(region.subcomplex()).map_err(|error| failed(&error))?;
    Ok(Region { domain, marks })
}

/// The outline with other nodes. Where the markers of segments change there are corners.
fn resampled(args: &BubbleArgs, outline: &PlanarGraph) -> Result<PlanarGraph, Failure> {
    let usual = Resampling::default();
    let resampling = Resampling {
        crease: args.crease.to_radians(),
        grade: args.grade.unwrap_or(GRADE),
        size: args.size.unwrap_or(usual.size),
        at_most: args.max_nodes,
    };
    let points: Vec<DVec2> = outline.points.iter().copied().map(DVec2::from).collect();
    let segments = outline.segments.iter();
    let segments = segments.map(|ends| ends.map(|v| VertexId::new(v as usize)));
    let segments: Vec<[VertexId; 2]> = segments.collect();
    let markers = outline.segment_markers.as_deref();
    let marker = |segment: usize| markers.and_then(|markers| markers.get(segment));
    let alike = |a: usize, b: usize| marker(a) == marker(b);
    let anew = resample(&points, &segments, alike, &resampling);
    let anew = anew.map_err(|error| Failure::input(&args.input, error))?;
    let number = |v: VertexId| v.index() as u32;
    let parents = anew.parent_of.iter();
    let polygons = outline.polygons.as_ref();
    Ok(PlanarGraph {
        points: anew.points.iter().map(DVec2::to_array).collect(),
        segments: anew.segments.iter().map(|ends| ends.map(number)).collect(),
        segment_markers: markers
            .map(|markers| parents.clone().map(|&parent| markers[parent]).collect()),
        polygons: polygons
            .map(|polygons| parents.map(|&parent| polygons[parent].clone()).collect()),
        holes: outline.holes.clone(),
        regions: outline.regions.clone(),
        ..PlanarGraph::default()
    })
}
