//! What was made, as JSON for programs and as lines for people.

use std::collections::BTreeMap;
use std::io::Write;

use serde::Serialize;
use vide::mesh_io::WriteError;
use vide::quality::Measured;
use vide::sink_refine;

use super::bubble::Bubbles;
use super::check::Check;
use super::refine::{Improvement, Refinement};

/// The report of any subcommand; what a command does not make is left out.
#[derive(Default, Serialize)]
pub(crate) struct Report {
    /// Of the triangulation, 2 or 3.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) dimension: Option<usize>,
    pub(crate) vertices: usize,
    pub(crate) elements: usize,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) blocks: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) medial_vertices: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) medial_arcs: Option<usize>,
    /// Arcs so short that their blocks are empty: co-circular holes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) collapsed_arcs: Option<usize>,
    /// Arcs whose nodes are not equally spaced because a cell would have folded.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) leaning_arcs: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) duplicates: Option<usize>,
    /// Weighted points without a cell.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) hidden: Option<usize>,
    /// Vertices on the border of the convex hull, those that are no corners included.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) hull_vertices: Option<usize>,
    /// Edges of the hull in the plane, facets in space.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) hull_sides: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) angle: Option<Angle>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) refinement: Option<Refinement>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) improvement: Option<Improvement>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) bubbles: Option<Bubbles>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) check: Option<Check>,
    pub(crate) quality: BTreeMap<String, Spread>,
    pub(crate) seconds: BTreeMap<String, f64>,
    pub(crate) stop: Stop,
}

/// Why the work ended.
#[derive(Clone, Copy, Default, Serialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Stop {
    /// It was done.
    #[default]
    Finished,
    /// No element of low quality is left.
    AllGood,
    /// For no element of low quality that is left can a point be inserted.
    NothingToInsert,
    /// No more vertices may be added.
    OutOfVertices,
    /// Ids are used up.
    OutOfIds,
    /// Somewhere no size is asked for that is one.
    UnusableSize,
    /// Somebody stopped it.
    Cancelled,
}

impl From<sink_refine::Stop> for Stop {
    fn from(stop: sink_refine::Stop) -> Self {
        match stop {
            sink_refine::Stop::AllGood => Self::AllGood,
            sink_refine::Stop::NothingToInsert => Self::NothingToInsert,
            sink_refine::Stop::OutOfVertices => Self::OutOfVertices,
            sink_refine::Stop::OutOfIds => Self::OutOfIds,
            sink_refine::Stop::UnusableSize(_) => Self::UnusableSize,
            sink_refine::Stop::Cancelled(_) => Self::Cancelled,
        }
    }
}

/// The four angle figures of the blocking paper, in degrees.
#[derive(Serialize)]
pub(crate) struct Angle {
    min: f64,
    max: f64,
    mean_smallest: f64,
    mean_largest: f64,
}

/// How the values of a measure spread.
#[derive(Serialize)]
pub(crate) struct Spread {
    min: f64,
    p01: f64,
    mean: f64,
    p99: f64,
    max: f64,
}

impl Report {
    /// Takes in what was measured.
    pub(crate) fn measure(&mut self, measured: &[Measured]) {
        for Measured {
            name, statistics, ..
        } in measured
        {
            let spread = Spread {
                min: statistics.min(),
                p01: statistics.percentile(1.0),
                mean: statistics.mean(),
                p99: statistics.percentile(99.0),
                max: statistics.max(),
            };
            self.quality.insert(name.clone(), spread);
        }
    }

    /// The angle figures of measured quads.
    pub(crate) fn angle_of_quads(&self) -> Option<Angle> {
        let smallest = self.quality.get("quad.min_angle")?;
        let largest = self.quality.get("quad.max_angle")?;
        Some(Angle {
            min: smallest.min,
            max: largest.max,
            mean_smallest: smallest.mean,
            mean_largest: largest.mean,
        })
    }

    /// Writes the report as JSON.
    pub(crate) fn write(&self, out: &mut impl Write) -> Result<(), WriteError> {
        serde_json::to_writer_pretty(&mut *out, self).map_err(std::io::Error::from)?;
        Ok(writeln!(out)?)
    }

    /// A table of all measures, a line each; nothing when nothing was measured.
    pub(crate) fn quality_table(&self) -> String {
        if self.quality.is_empty() {
            return String::new();
        }
        let mut table = format!(
            "{:30} {:>10} {:>10} {:>10} {:>10} {:>10}\n",
            "measure", "min", "p01", "mean", "p99", "max"
        );
        for (name, spread) in &self.quality {
            let Spread {
                min,
                p01,
                mean,
                p99,
                max,
            } = spread;
            let row =
                format!("{name:30} {min:10.4} {p01:10.4} {mean:10.4} {p99:10.4} {max:10.4}\n");
            table.push_str(&row);
        }
        table
    }
}
