//! What an improvement did.

use crate::quality::min_sine;
use crate::records::Records;
use delaunay_core::measure::tetrahedron::dihedral_angles;
use delaunay_core::progress::Cancelled;
use delaunay_core::{Complex3, TetId};

/// An improved mesh, and how it came about.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// The mesh. Its boundary is the one given.
    pub solid: Complex3,
    /// Why no more changes were made.
    pub stop: Stop,
    /// Counts of changes made.
    pub counters: Counters,
    /// The dihedral angles of the mesh given; `None` when it has no tetrahedra.
    pub before: Option<Dihedrals>,
    /// Those of the mesh that comes out.
    pub after: Option<Dihedrals>,
    /// The tetrahedra that do not have the angles asked for, worst first.
    pub low: Vec<Low>,
}

/// A tetrahedron that does not have the dihedral angles asked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Low {
    /// The tetrahedron.
    pub tet: TetId,
    /// Its smallest dihedral angle, or 180° less its largest if that is smaller; degrees.
    pub angle: f64,
    /// How many of its corners are on the boundary, where they cannot move.
    pub fixed_corners: usize,
}

/// The tetrahedra whose quality is below `goal`, worst first.
pub(crate) fn low(solid: &Complex3, records: &Records, goal: f64) -> Vec<Low> {
    let below = solid.tets().filter(|&t| records.quality(t) < goal);
    let mut low: Vec<Low> = below
        .map(|tet| {
            let corners = solid.mesh().tet_vertices(tet).into_iter();
            Low {
                tet,
                angle: records.quality(tet).asin().to_degrees(),
                fixed_corners: corners.filter(|&v| records.is_on_boundary(v)).count(),
            }
        })
        .collect();
    low.sort_by(|a, b| a.angle.total_cmp(&b.angle).then(a.tet.cmp(&b.tet)));
    low
}

/// Why an improvement ended. The mesh is valid in every case.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stop {
    /// All tetrahedra have the dihedral angles asked for.
    AllGood,
    /// No change that was tried makes any of the others better.
    NothingHelps,
    /// The budget of changes is used up.
    OutOfChanges,
    /// The report closure stopped the work.
    Cancelled(Cancelled),
}

impl From<Cancelled> for Stop {
    fn from(cancelled: Cancelled) -> Self {
        Self::Cancelled(cancelled)
    }
}

/// Counts of changes made.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counters {
    /// Edges that gave way to facets.
    pub edges_removed: usize,
    /// Groups of facets that gave way to an edge.
    pub facets_removed: usize,
    /// Moves of a vertex.
    pub moves: usize,
    /// Edges contracted, each with one vertex less.
    pub contractions: usize,
    /// Vertices inserted.
    pub insertions: usize,
}

impl Counters {
    /// All changes.
    #[must_use]
    pub fn total(&self) -> usize {
        self.edges_removed + self.facets_removed + self.moves + self.contractions + self.insertions
    }
}

/// The extreme dihedral angles of a mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dihedrals {
    /// The smallest, degrees.
    pub min: f64,
    /// The largest, degrees.
    pub max: f64,
}

impl Dihedrals {
    /// Those of a mesh; `None` when it has no tetrahedra. Linear.
    #[must_use]
    pub fn of(solid: &Complex3) -> Option<Self> {
        let mut extremes: Option<Self> = None;
        // An angle with such a sine is beyond neither extreme.
        let mut bound = f64::INFINITY;
        for t in solid.tets() {
            let corners = solid.tetrahedron(t);
            if min_sine(corners) >= bound {
                continue;
            }
            for angle in dihedral_angles(corners) {
                let extremes = extremes.get_or_insert(Self {
                    min: angle,
                    max: angle,
                });
                extremes.min = extremes.min.min(angle);
                extremes.max = extremes.max.max(angle);
            }
            bound = match extremes {
                // A little more, for rounding.
                Some(Self { min, max }) if max > 90.0 => {
                    let [low, high] = [min, max].map(|angle| angle.to_radians().sin());
                    low.max(high) + 1e-9
                }
                _ => f64::INFINITY,
            };
        }
        extremes
    }
}
