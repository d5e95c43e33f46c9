//! What is repaired and what is allowed when triangles are judged.

/// What [`Domain3::build`](super::Domain3::build) repairs and allows. By default it repairs nothing and wants closed bodies.
///
/// ```
/// use delaunay_core::Domain3Options;
///
/// let options = Domain3Options { weld: true, ..Domain3Options::default() };
/// assert!(!options.interfaces);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Domain3Options {
    /// Whether points at exactly the same place become one, the first of them. Otherwise they are defects.
    pub weld: bool,
    /// Whether points that are no corners are dropped. Otherwise they are defects.
    pub drop_unused: bool,
    /// Whether the triangles may separate regions from each other, so that an edge may have any number of them from 2 on.
    /// Otherwise they bound bodies, and every edge must have an even number.
    pub interfaces: bool,
    /// Whether, with `interfaces`, an edge may also have one triangle: the surface may end within a region.
    pub dangling: bool,
    /// Most intersecting pairs of triangles to list: input of many equal triangles has a quadratic number of them.
    pub most_intersections: usize,
}

impl Default for Domain3Options {
    /// Repairs nothing, wants closed bodies, lists up to 10,000 intersections.
    fn default() -> Self {
        Self {
            weld: false,
            drop_unused: false,
            interfaces: false,
            dangling: false,
            most_intersections: 10_000,
        }
    }
}
