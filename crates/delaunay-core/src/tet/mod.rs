//! Triangulations of space.
//!
//! | step | file |
//! |---|---|
//! | connectivity, surgery | `mesh.rs`, `around.rs`, `exchange.rs`, `flip.rs`, `canonical.rs` |
//! | the triangulation and read access | `delaunay.rs` |
//! | one point: locate, cavity, star | `insert.rs`, `locate.rs`, `cavity.rs`, `sight.rs`, `star.rs`, `table.rs` |
//! | all points | `build.rs`, `simplex.rs`, `bulk/`; a few `grow.rs` |
//! | one point less, or elsewhere | `remove.rs`, `movement.rs`, `wrapping.rs` |
//! | a closed surface and what it encloses | `surface.rs`, `places.rs`, `region.rs`, `sweep.rs`, `intersection.rs`, `projection.rs` |
//! | triangles judged, all that is wrong with them | `domain/`, `bounds.rs` |
//! | tetrahedra made elsewhere | `boundary_of_tets.rs` |
//! | a part with a boundary of its own | `subcomplex.rs`, `boundary_cavity.rs`, `patch.rs`, `merge.rs`; not Delaunay `complex.rs` |
//! | weighted points | `regular/` |
//! | points on a plane | `coplanar.rs` |
//! | questions | `nearest.rs`, `hull.rs` |
//! | the Voronoi diagram | `dual.rs`, `carve.rs` |
//! | convex polyhedra | `polyhedron.rs`, `half_space.rs`, `face_plane.rs`, `clip.rs`, `rim.rs`, `climb.rs`, `face.rs`, `moments.rs` |
//! | invariants | `check.rs` |

mod around;
mod boundary_cavity;
mod boundary_of_tets;
mod bounds;
mod build;
mod bulk;
mod canonical;
mod carve;
mod cavity;
mod check;
mod climb;
mod clip;
mod complex;
mod coplanar;
mod delaunay;
mod domain;
mod dual;
mod exchange;
mod face;
mod face_plane;
mod flip;
mod grow;
mod half_space;
mod hull;
mod insert;
mod intersection;
mod locate;
mod merge;
mod mesh;
mod moments;
mod movement;
mod nearest;
mod patch;
mod places;
mod polyhedron;
mod projection;
mod region;
mod regular;
mod remove;
mod rim;
mod sight;
mod simplex;
mod star;
mod subcomplex;
mod surface;
mod sweep;
mod table;
mod wrapping;

pub use around::{Ring, Star};
pub use boundary_cavity::Met;
pub use boundary_of_tets::{TetBoundary, TetsError};
pub use carve::CellCarver;
pub use cavity::Cavity3;
pub use check::Violation3;
pub use complex::{Complex3, ComplexError};
pub use delaunay::Delaunay3;
pub use domain::{
    Coincident, DefectKind, Domain3, Domain3Options, DomainDefect, DomainDefects, DomainError,
    Hole, Intersection, MarkerCount, NoArea, NoSuchCorner, OddEdge, OneSided, OpenEdge, Placed,
    Repairs, RepeatedCorner, RepeatedTriangle, Shell, UnusedPoint,
};
pub use dual::{Voronoi3, VoronoiEdge3, VoronoiFacet3};
pub use face::PolyhedronFace;
pub use flip::{Flip, FlipError};
pub use half_space::{HalfSpace, HalfSpaceError};
pub use intersection::triangles_intersect;
pub use locate::Location3;
pub use merge::Merge;
pub use mesh::{FACET_CORNERS, TetMesh};
pub use moments::Moments;
pub use patch::Patch;
pub use polyhedron::{ConvexPolyhedron, PolyhedronError, Side};
pub use region::{Solid, SolidError};
pub use regular::{Regular3, RegularViolation3};
pub use rim::Clipper;
pub use subcomplex::Subcomplex3;
pub use surface::{Surface, SurfaceError};
pub use wrapping::{Across, WrappedTet, Wrapping};
