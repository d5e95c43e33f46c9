//! What was found out about a surface, as JSON for programs and as lines for people.

use std::collections::BTreeMap;

use serde::Serialize;
use vide::delaunay_core::measure::Sum;
use vide::delaunay_core::{DefectKind, Domain3, DomainDefect, DomainDefects, Repairs, VertexId};

/// Defects of each kind that the terminal lists.
const LISTED: usize = 20;

/// The part of a report that only a check has.
#[derive(Serialize)]
pub(crate) struct Check {
    valid: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    solid: Option<Solid>,
    #[serde(skip_serializing_if = "Option::is_none")]
    repairs: Option<Repaired>,
    /// By kind.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    defects: BTreeMap<&'static str, Vec<Defect>>,
    /// Vertices round each hole.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    holes: Vec<Vec<usize>>,
    /// Whether there are more intersections than are listed.
    more_intersections: bool,
}

/// What a valid surface bounds.
#[derive(Serialize)]
struct Solid {
    /// Without points that are welded or dropped.
    vertices: usize,
    /// Parts that hang together across edges.
    shells: usize,
    area: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    bodies: Option<Bodies>,
}

/// What closed shells enclose; for regions it is not known.
#[derive(Serialize)]
struct Bodies {
    count: usize,
    voids: usize,
    volume: f64,
}

/// What has to be done to the surface; vertices and triangles as they are in the file.
#[derive(Serialize)]
struct Repaired {
    /// The vertex that stays, and the one that becomes it.
    welded: Vec<[usize; 2]>,
    dropped: Vec<usize>,
    turned: Vec<usize>,
}

/// One defect.
#[derive(Serialize)]
struct Defect {
    text: String,
    vertices: Vec<usize>,
    triangles: Vec<usize>,
    /// Of the vertices, or where to look.
    places: Vec<[f64; 3]>,
}

impl From<DomainDefect> for Defect {
    fn from(defect: DomainDefect) -> Self {
        Self {
            text: defect.to_string(),
            vertices: indices(&defect.vertices()),
            triangles: defect.triangles(),
            places: defect.places().into_iter().map(Into::into).collect(),
        }
    }
}

impl Check {
    /// What a valid surface is.
    pub(super) fn of(domain: &Domain3, repairs: &Repairs) -> Self {
        Self {
            valid: true,
            solid: Some(Solid::of(domain)),
            repairs: Some(Repaired {
                welded: repairs
                    .welded
                    .iter()
                    .map(|pair| pair.map(VertexId::index))
                    .collect(),
                dropped: indices(&repairs.dropped),
                turned: repairs.turned.clone(),
            }),
            defects: BTreeMap::new(),
            holes: Vec::new(),
            more_intersections: false,
        }
    }

    /// What is wrong with another.
    pub(super) fn failed(defects: &DomainDefects) -> Self {
        let there = DefectKind::ALL.into_iter();
        let there = there.filter(|&kind| defects.count_of(kind) > 0);
        let all = |kind: DefectKind| defects.of(kind).map(Defect::from).collect();
        let holes = defects.holes.iter().filter(|hole| hole.closed);
        Self {
            valid: false,
            solid: None,
            repairs: None,
            defects: there.map(|kind| (kind.name(), all(kind))).collect(),
            holes: holes.map(|hole| indices(&hole.vertices)).collect(),
            more_intersections: defects.more_intersections,
        }
    }

    /// What a valid surface bounds, in words, and what there is to repair.
    pub(super) fn words(&self) -> String {
        let solid = self.solid.as_ref().map(Solid::words);
        let repairs = self.repairs.as_ref().map(Repaired::words);
        solid.into_iter().chain(repairs).collect()
    }
}

impl Solid {
    fn of(domain: &Domain3) -> Self {
        let shells = domain.shells();
        let (mut area, mut volume) = (Sum::default(), Sum::default());
        for shell in &shells {
            area.add(shell.area);
            volume.add(shell.volume);
        }
        let voids = shells.iter().filter(|shell| shell.volume < 0.0).count();
        let bodies = Bodies {
            count: shells.len() - voids,
            voids,
            volume: volume.total(),
        };
        Self {
            vertices: domain.points().len(),
            shells: shells.len(),
            area: area.total(),
            bodies: Some(bodies).filter(|_| !domain.has_interfaces()),
        }
    }

    fn words(&self) -> String {
        let Self { area, .. } = self;
        match &self.bodies {
            Some(Bodies {
                count,
                voids,
                volume,
            }) => {
                let [bodies, voids] = [
                    counted(*count, "body", "bodies"),
                    counted(*voids, "void", "voids"),
                ];
                format!("valid: {bodies}, {voids}, volume {volume}, area {area}\n")
            }
            None => {
                let parts = counted(self.shells, "part", "parts");
                format!("valid: {parts} between regions, area {area}\n")
            }
        }
    }
}

impl Repaired {
    fn words(&self) -> String {
        let done = [
            (self.welded.len(), "point to weld", "points to weld"),
            (self.dropped.len(), "point to drop", "points to drop"),
            (self.turned.len(), "triangle to turn", "triangles to turn"),
        ];
        let done = done.into_iter().filter(|(count, ..)| *count > 0);
        let done: Vec<String> = done
            .map(|(count, one, many)| counted(count, one, many))
            .collect();
        match done.as_slice() {
            [] => "nothing to repair\n".to_owned(),
            done => format!("{}\n", done.join(", ")),
        }
    }
}

/// How many there are of each kind, in one line.
pub(super) fn summaries(defects: &DomainDefects) -> String {
    let all = DefectKind::ALL.into_iter();
    let all: Vec<String> = all.filter_map(|kind| defects.summary(kind)).collect();
    all.join(", ")
}

/// The first defects of each kind, a line each.
pub(super) fn listed(defects: &DomainDefects) -> String {
    let mut text = String::new();
    for kind in DefectKind::ALL {
        let Some(summary) = defects.summary(kind) else {
            continue;
        };
        text += &format!("{summary}{}\n", remedy(kind));
        for defect in defects.of(kind).take(LISTED) {
            text += &format!("  {defect}\n");
        }
        let count = defects.count_of(kind);
        if count > LISTED {
            text += &format!("  and {} more\n", count - LISTED);
        }
    }
    text
}

/// The option that repairs such defects.
fn remedy(kind: DefectKind) -> &'static str {
    match kind {
        DefectKind::Coincident => ", which --weld makes one",
        DefectKind::Unused => ", which --drop-unused leaves out",
        DefectKind::OddEdge => ", which --interfaces allows",
        _ => "",
    }
}

fn counted(count: usize, one: &str, many: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { many })
}

fn indices(vertices: &[VertexId]) -> Vec<usize> {
    vertices.iter().map(|v| v.index()).collect()
}
