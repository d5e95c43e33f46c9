//! The pass that takes slivers away, after refinement.

use serde::Serialize;
use vide::convert::complex_mesh;
use vide::delaunay_core::Subcomplex3;
use vide::mesh_io::Mesh;
use vide::tet_improve::{Dihedrals, ImproveError, Outcome, Params, improve};

use crate::cli::progress::Watch;

/// Parses the value of `--min-dihedral`.
///
/// # Errors
/// What is wrong with it.
pub(super) fn parse(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(angle) if angle > 0.0 && angle <= 70.0 => Ok(angle),
        _ => Err("an angle is a number of degrees above 0 and at most 70".to_owned()),
    }
}

/// The part of a report about that pass.
#[derive(Serialize)]
pub(crate) struct Improvement {
    asked_for: f64,
    before: Option<Extremes>,
    after: Option<Extremes>,
    changes: Changes,
    /// Tetrahedra that do not have the angles asked for.
    left: usize,
}

/// Dihedral angles in degrees.
#[derive(Serialize)]
struct Extremes {
    min: f64,
    max: f64,
}

impl From<Dihedrals> for Extremes {
    fn from(Dihedrals { min, max }: Dihedrals) -> Self {
        Self { min, max }
    }
}

/// How often what was done.
#[derive(Serialize)]
struct Changes {
    edges_removed: usize,
    facets_removed: usize,
    moves: usize,
    contractions: usize,
    insertions: usize,
}

/// Improves a solid, and tells what that did.
///
/// # Errors
/// Those of [`improve`].
pub(super) fn run(
    solid: &Subcomplex3,
    angle: f64,
    watch: &mut Watch,
) -> Result<(Mesh, Improvement), ImproveError> {
    let params = Params {
        goal: angle,
        vertices_below: angle,
        ..Params::default()
    };
    let outcome = watch.stage("improve", |watch| {
        improve(solid.clone(), &params, &mut |progress| {
            watch.report(progress)
        })
    })?;
    let improvement = told(angle, &outcome);
    Ok((complex_mesh(&outcome.solid), improvement))
}

fn told(asked_for: f64, outcome: &Outcome) -> Improvement {
    let counters = outcome.counters;
    Improvement {
        asked_for,
        before: outcome.before.map(Extremes::from),
        after: outcome.after.map(Extremes::from),
        changes: Changes {
            edges_removed: counters.edges_removed,
            facets_removed: counters.facets_removed,
            moves: counters.moves,
            contractions: counters.contractions,
            insertions: counters.insertions,
        },
        left: outcome.low.len(),
    }
}

impl Improvement {
    /// One line for people.
    pub(super) fn summary(&self) -> String {
        let text = |extremes: &Option<Extremes>| match extremes {
            Some(Extremes { min, max }) => format!("{min:.2} to {max:.2}"),
            None => "none".to_owned(),
        };
        let left = match self.left {
            0 => "all as asked for".to_owned(),
            left => format!("{left} not as asked for"),
        };
        let [before, after] = [&self.before, &self.after].map(text);
        format!("improved: dihedral angles {after} degrees instead of {before}, {left}\n")
    }
}
