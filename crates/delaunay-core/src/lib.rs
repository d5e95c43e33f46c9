//! Delaunay triangulations: Bowyer–Watson kernel, half-edge mesh, Voronoi dual and the measures of mesh quality.
//!
//! ```
//! use delaunay_core::{Delaunay2, Location, VertexId};
//! use glam::DVec2;
//!
//! // A hexagon and its center.
//! let ring = [[2., 0.], [1., 2.], [-1., 2.], [-2., 0.], [-1., -2.], [1., -2.], [0., 0.]];
//! let mut delaunay = Delaunay2::build(&ring.map(DVec2::from))?;
//! assert_eq!(delaunay.faces().count(), 6);
//!
//! // Input point i is vertex i; the center sees the whole ring.
//! let center = VertexId::new(6);
//! assert_eq!(delaunay.mesh().neighbors(center).count(), 6);
//! assert!(matches!(delaunay.locate(DVec2::new(0.1, 1.0))?, Location::Face(_)));
//!
//! // Points come and go; the triangulation stays Delaunay, with exact signs.
//! let v = delaunay.insert(DVec2::new(0.0, 1.0))?.vertex();
//! delaunay.remove(v)?;
//! assert_eq!(delaunay.check(), Ok(()));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! The same in space, with tetrahedra and facets:
//!
//! ```
//! use delaunay_core::{BuildOptions, Delaunay3, VertexId, progress::silent};
//! use glam::DVec3;
//!
//! // An octahedron and its center, on two threads.
//! let axes = [DVec3::X, DVec3::Y, DVec3::Z];
//! let mut points: Vec<DVec3> = axes.into_iter().flat_map(|axis| [axis, -axis]).collect();
//! points.push(DVec3::ZERO);
//! let mut delaunay = Delaunay3::build_on(&points, BuildOptions::on_threads(2), &mut silent)?;
//! assert_eq!((delaunay.tets().count(), delaunay.hull().count()), (8, 8));
//! assert_eq!(delaunay.mesh().star(VertexId::new(6)).count(), 8);
//! let v = delaunay.insert(DVec3::splat(0.125))?.vertex();
//! delaunay.remove(v)?;
//! assert_eq!(delaunay.check(), Ok(()));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! - [`Delaunay2`] and [`Delaunay3`] are the triangulations, [`TriMesh`] and [`TetMesh`] their connectivity;
//!   data about elements live in a `Vec` beside the mesh, indexed by the `index()` of their ids.
//! - An [`Outline`] is a closed curve of segments in the plane; [`Outline::region`] finds the triangles that it encloses.
//! - A [`Surface`] is a closed surface of triangles; [`Surface::solid`] finds the tetrahedra that it encloses.
//! - A [`Domain3`] is triangles found to bound bodies, or regions; [`Domain3::build`] lists all that is wrong with others.
//! - [`Subcomplex2`] and [`Subcomplex3`] are parts of a triangulation with a boundary that no insertion inside changes; in a
//!   [`Complex3`] tetrahedra need not be Delaunay.
//! - Signs, ids, ghosts and the accepted coordinates are as in `docs/conventions.md`. All decisions about
//!   topology are made by the exact predicates of [`geo_predicates`], re-exported here.
//! - [`measure`] judges elements and sums up a mesh: angles, r/l, radius ratios, scaled Jacobian, statistics.
//! - [`progress`] reports from and cancels long loops; [`order`] puts points in spatial order.

pub mod measure;
pub mod order;
pub mod progress;

mod error;
mod guide;
mod heaviest;
mod hilbert;
mod ids;
mod memory;
mod options;
mod tet;
mod threads;
mod tri;

pub use error::{BuildError, InsertError, MoveError, RegularError, RemoveError};
pub use geo_predicates;
pub use ids::{FaceId, FacetId, HalfEdgeId, TetId, VertexId};
pub use options::BuildOptions;
pub use tet::{Across, Merge, WrappedTet, Wrapping};
pub use tet::{
    Cavity3, CellCarver, Clipper, Complex3, ComplexError, ConvexPolyhedron, Delaunay3,
    FACET_CORNERS, Flip, FlipError, HalfSpace, HalfSpaceError, Location3, Met, Moments, Patch,
    PolyhedronError, PolyhedronFace, Ring, Side, Star, Subcomplex3, TetMesh, Violation3, Voronoi3,
    VoronoiEdge3, VoronoiFacet3,
};
pub use tet::{
    Coincident, DefectKind, Domain3, Domain3Options, DomainDefect, DomainDefects, DomainError,
    Hole, Intersection, MarkerCount, NoArea, NoSuchCorner, OddEdge, OneSided, OpenEdge, Placed,
    Repairs, RepeatedCorner, RepeatedTriangle, Shell, UnusedPoint,
};
pub use tet::{Regular3, RegularViolation3};
pub use tet::{
    Solid, SolidError, Surface, SurfaceError, TetBoundary, TetsError, triangles_intersect,
};
pub use tri::{
    Around, Cavity, Complex2, ConvexPolygon, Delaunay2, Duplicates, Extent, Flat, Hull, Inserted,
    Location, PolygonError, RimEdge, TriMesh, Violation, Voronoi, VoronoiEdge,
};
pub use tri::{
    Components, ConstrainError, Constrained2, ConstrainedViolation, Crossing, Crossings, SeedError,
};
pub use tri::{Outline, OutlineError, Region, RegionError, segments_cross};
pub use tri::{Patch2, Piece2, Refilled, Subcomplex2};
pub use tri::{Regular2, RegularViolation2};
