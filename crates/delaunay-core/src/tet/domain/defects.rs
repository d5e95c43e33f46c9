//! All that is wrong with triangles, by kind.

use super::defect::{
    Coincident, DomainDefect, Intersection, NoArea, NoSuchCorner, OddEdge, OneSided, OpenEdge,
    RepeatedCorner, RepeatedTriangle, UnusedPoint,
};
use super::holes::Hole;
use super::kind::DefectKind;
use geo_predicates::CoordinateError;
use std::fmt;
use thiserror::Error;

/// All that is wrong with triangles: a list for each kind, each in the order of the elements.
///
/// One cause makes one defect, as far as can be told: points at one place count as one in all other questions, triangles given
/// twice count once, and triangles with a corner twice are no triangles to their neighbours.
///
/// Prints a line for each kind, with the number and the first few.
#[derive(Clone, Debug, Default, PartialEq, Error)]
pub struct DomainDefects {
    /// Points with a coordinate that is not accepted.
    pub coordinates: Vec<CoordinateError>,
    /// Corners that are no points.
    pub no_such_corners: Vec<NoSuchCorner>,
    /// Triangles with a corner twice.
    pub repeated_corners: Vec<RepeatedCorner>,
    /// Triangles without area.
    pub no_area: Vec<NoArea>,
    /// Points where another is.
    pub coincident: Vec<Coincident>,
    /// Points that are no corners.
    pub unused: Vec<UnusedPoint>,
    /// Triangles with the corners of another.
    pub repeated_triangles: Vec<RepeatedTriangle>,
    /// Edges with one triangle.
    pub open_edges: Vec<OpenEdge>,
    /// The same edges as they follow one another round holes. Not defects beyond the edges.
    pub holes: Vec<Hole>,
    /// Edges with an odd number of triangles, but not one.
    pub odd_edges: Vec<OddEdge>,
    /// Patches with one side.
    pub one_sided: Vec<OneSided>,
    /// Pairs of triangles that intersect, up to [`most_intersections`](super::Domain3Options::most_intersections).
    pub intersections: Vec<Intersection>,
    /// Whether there are more intersecting pairs than are listed.
    pub more_intersections: bool,
}

impl DomainDefects {
    /// Whether nothing is wrong.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.count() == 0 && !self.more_intersections
    }

    /// The number of defects listed.
    #[must_use]
    pub fn count(&self) -> usize {
        let counts = DefectKind::ALL.map(|kind| self.count_of(kind));
        counts.iter().sum()
    }

    /// The number of defects of one kind listed.
    #[must_use]
    pub fn count_of(&self, kind: DefectKind) -> usize {
        match kind {
            DefectKind::Coordinate => self.coordinates.len(),
            DefectKind::NoSuchCorner => self.no_such_corners.len(),
            DefectKind::RepeatedCorner => self.repeated_corners.len(),
            DefectKind::NoArea => self.no_area.len(),
            DefectKind::Coincident => self.coincident.len(),
            DefectKind::Unused => self.unused.len(),
            DefectKind::RepeatedTriangle => self.repeated_triangles.len(),
            DefectKind::OpenEdge => self.open_edges.len(),
            DefectKind::OddEdge => self.odd_edges.len(),
            DefectKind::OneSided => self.one_sided.len(),
            DefectKind::Intersection => self.intersections.len(),
        }
    }

    /// Every defect, kind by kind.
    pub fn iter(&self) -> impl Iterator<Item = DomainDefect> + '_ {
        DefectKind::ALL.into_iter().flat_map(|kind| self.of(kind))
    }

    /// The defects of one kind, in the order of the elements.
    #[must_use]
    pub fn of(&self, kind: DefectKind) -> Box<dyn Iterator<Item = DomainDefect> + '_> {
        match kind {
            DefectKind::Coordinate => each(&self.coordinates),
            DefectKind::NoSuchCorner => each(&self.no_such_corners),
            DefectKind::RepeatedCorner => each(&self.repeated_corners),
            DefectKind::NoArea => each(&self.no_area),
            DefectKind::Coincident => each(&self.coincident),
            DefectKind::Unused => each(&self.unused),
            DefectKind::RepeatedTriangle => each(&self.repeated_triangles),
            DefectKind::OpenEdge => each(&self.open_edges),
            DefectKind::OddEdge => each(&self.odd_edges),
            DefectKind::OneSided => each(&self.one_sided),
            DefectKind::Intersection => each(&self.intersections),
        }
    }

    /// How many defects of a kind there are, in words, such as `3 open edges round 1 hole`; `None` for none.
    #[must_use]
    pub fn summary(&self, kind: DefectKind) -> Option<String> {
        let count = self.count_of(kind);
        let more = kind == DefectKind::Intersection && self.more_intersections;
        if count == 0 && !more {
            return None;
        }
        let least = if more { "at least " } else { "" };
        // One more was found than is listed.
        let count = count + usize::from(more);
        let round = match kind {
            DefectKind::OpenEdge => self.round_holes(),
            _ => String::new(),
        };
        Some(format!("{least}{count} {}{round}", kind.words(count)))
    }

    fn round_holes(&self) -> String {
        match self.holes.iter().filter(|hole| hole.closed).count() {
            0 => String::new(),
            1 => " round 1 hole".to_owned(),
            holes => format!(" round {holes} holes"),
        }
    }
}

fn each<T: Clone + Into<DomainDefect>>(
    defects: &[T],
) -> Box<dyn Iterator<Item = DomainDefect> + '_> {
    Box::new(defects.iter().cloned().map(Into::into))
}

impl fmt::Display for DomainDefects {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        const SHOWN: usize = 3;
        f.write_str("the surface has defects:")?;
        for kind in DefectKind::ALL {
            let Some(summary) = self.summary(kind) else {
                continue;
            };
            write!(f, "\n{summary}")?;
            for (index, defect) in self.of(kind).take(SHOWN).enumerate() {
                let mark = if index == 0 { ':' } else { ';' };
                write!(f, "{mark} {defect}")?;
            }
            if self.count_of(kind) > SHOWN {
                write!(f, "; and so on")?;
            }
        }
        Ok(())
    }
}
