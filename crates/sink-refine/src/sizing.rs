//! How large elements may be, beyond the paper: a sizing field, and limits of regions.

use glam::{DVec2, DVec3};
use std::fmt;

/// How large elements may be, by place and by region. [`Sizing::default`] asks for nothing.
///
/// A size h is the length that edges should have. An element is *too large* when its circumradius exceeds that of the regular
/// element with edges of this length: h/√3 for a triangle, h√6/4 for a tetrahedron. So what is not too large has edges of at
/// most 2h/√3 = 1.15 h or h√6/2 = 1.22 h. Elements that are too large are of low quality, whatever their ratio.
///
/// A sink or circumcenter inserted for such an element is farther from all vertices than that circumradius, since along the
/// flow spheres grow; the off-centers of the economical method are tested to be. So where all sizes are at least h, the paper's
/// methods make no edges shorter than the shortest one given or 0.57 h (0.61 h in space), whichever is less; an eighth of that
/// where the boundary may be divided. So insertion ends, after a number of points that grows as 1/h² (1/h³ in space); the
/// phases that follow in the economical method end as they do without sizes.
/// [`Params::max_new_vertices`](crate::Params::max_new_vertices) and the report closure guard against sizes that are too small
/// to wait for.
///
/// A boundary that is [kept](crate::Boundary::Keep) may be coarser than the size asked for: what lies on such a part of it stays
/// too large, and is listed with that reason.
///
/// ```
/// use delaunay_core::{Delaunay2, Subcomplex2, progress::silent};
/// use glam::DVec2;
/// use sink_refine::{Params, Sizing, Stop, refine2_sized};
///
/// // A square with ten edges on each side, that may be coarser away from the left one.
/// let sides = (0..10).map(f64::from).flat_map(|t| [[t, 0.0], [10.0, t], [10.0 - t, 10.0], [0.0, 10.0 - t]]);
/// let points: Vec<DVec2> = sides.map(DVec2::from).collect();
/// let region = Subcomplex2::of(&Delaunay2::build(&points)?, |_| true);
/// let field = |place: DVec2| 1.1 + 0.2 * place.x;
/// let sizing = Sizing { field: Some(&field), regions: &[] };
/// let outcome = refine2_sized(region, &Params::default(), &sizing, &mut silent)?;
/// assert_eq!(outcome.stop, Stop::AllGood);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Default)]
pub struct Sizing<'a, V> {
    /// The size asked for at a place: a positive number, or infinity for no limit. Asked at centroids of elements, on several
    /// threads, of some places several times; the same place has to give the same size, or else the mesh is not the same each time,
    /// though valid, and what is listed may not be what was found too large. Any other answer ends the refinement with
    /// [`Stop::UnusableSize`](crate::Stop::UnusableSize); a panic goes through to the caller.
    pub field: Option<&'a (dyn Fn(V) -> f64 + Sync)>,
    /// Limits of regions. Where there are several, or a field, the least size counts.
    pub regions: &'a [RegionLimit<V>],
}

/// Sizes in the plane.
pub type Sizing2<'a> = Sizing<'a, DVec2>;

/// Sizes in space.
pub type Sizing3<'a> = Sizing<'a, DVec3>;

/// The size of all elements of a region: of those that are connected across edges or facets that are no boundary.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RegionLimit<V> {
    /// A point in the region, or on its boundary, with coordinates that points of meshes may have. Where it is on the boundary
    /// of several regions, one of them is meant.
    pub seed: V,
    /// The size: a positive number; infinity asks for nothing, and the seed may be anywhere then.
    pub size: f64,
}

/// A size that a field has given and that is no size: no number, or none above zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UnusableSize {
    /// Where it was asked for: the centroid of an element. In the plane z is 0.
    pub place: DVec3,
    /// What the field answers when it is asked there again.
    pub size: f64,
}

impl<V> Sizing<'_, V> {
    /// Whether it asks for nothing, at no place.
    pub(crate) fn is_empty(&self) -> bool {
        self.field.is_none() && self.regions.is_empty()
    }
}

impl<V: fmt::Debug> fmt::Debug for Sizing<'_, V> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Sizing")
            .field("field", &self.field.map(|_| "closure"))
            .field("regions", &self.regions)
            .finish()
    }
}
