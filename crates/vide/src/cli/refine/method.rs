//! Which method the options name, and which of them contradict each other.

use clap::error::ErrorKind;
use clap::{Args, Command, ValueEnum};
use vide::sink_refine::{self as sinks, Boundary, Coarsening, Method};

use super::RefineArgs;

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum Candidate {
    /// For each tetrahedron the best of several, then others where all were rejected: fewest points
    Economical,
    /// The sinks of its flow, as in the paper
    Sink,
    /// Its circumcenter
    Circumcenter,
}

#[derive(Clone, Copy, ValueEnum)]
pub(super) enum Schedule {
    /// One tetrahedron after the other, the worst first
    Incremental,
    /// In blocks of points whose spheres are orthogonal or farther apart
    Block,
    /// In rounds of points that do not meddle with each other, on all threads
    Parallel,
}

#[derive(Clone, Copy, ValueEnum)]
pub(super) enum Coarsen {
    /// They stay
    None,
    /// They are removed one by one
    Removal,
    /// Two at a time also become one: some tenth fewer tetrahedra for several times the time
    Merging,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum AtBoundary {
    /// No edge and no triangle of it is touched
    Keep,
    /// What is in the way of good elements is divided
    Split,
}

impl RefineArgs {
    /// What may happen to the boundary, which is smooth where it turns by up to `usual` degrees unless said otherwise.
    pub(super) fn boundary(&self, usual: f64) -> Boundary {
        match self.boundary {
            AtBoundary::Keep => Boundary::Keep,
            AtBoundary::Split => Boundary::Split {
                crease: self.crease.unwrap_or(usual),
            },
        }
    }

    /// The method that the options name.
    ///
    /// # Errors
    /// A usage error where an option belongs to another method.
    pub(crate) fn method(&self) -> Result<Method, clap::Error> {
        if self.crease.is_some() && self.boundary == AtBoundary::Keep {
            let problem =
                "--crease belongs to --boundary split: a boundary that is kept has no new vertices";
            return Err(usage(problem));
        }
        let candidate = match self.candidate {
            Candidate::Economical => return self.economical(),
            Candidate::Sink => sinks::Candidate::Sink,
            Candidate::Circumcenter => sinks::Candidate::Circumcenter,
        };
        if self.coarsen.is_some() {
            let problem = "--coarsen belongs to --candidate economical: vertices that sinks and circumcenters \
                           have become stay";
            return Err(usage(problem));
        }
        let schedule = match self.schedule {
            None | Some(Schedule::Incremental) => sinks::Schedule::Incremental,
            Some(Schedule::Block) => sinks::Schedule::Block,
            Some(Schedule::Parallel) => sinks::Schedule::Parallel,
        };
        Ok(Method::Paper {
            candidate,
            schedule,
        })
    }

    fn economical(&self) -> Result<Method, clap::Error> {
        if self.schedule.is_some() {
            let problem = "--schedule belongs to --candidate sink or circumcenter: the economical method has an \
                           order of its own";
            return Err(usage(problem));
        }
        Ok(Method::Economical(match self.coarsen {
            Some(Coarsen::None) => Coarsening::None,
            None | Some(Coarsen::Removal) => Coarsening::Removal,
            Some(Coarsen::Merging) => Coarsening::Merging,
        }))
    }
}

fn usage(problem: &str) -> clap::Error {
    let mut command = RefineArgs::augment_args(Command::new("vide refine"));
    command.error(ErrorKind::ArgumentConflict, problem)
}
