//! What an improvement is asked for.

/// What an improvement is asked for: two angles that divide the tetrahedra into three kinds, and a bound on the work.
///
/// An angle here stands for two: it is the least dihedral angle, and 180° less it the greatest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Params {
    /// Tetrahedra below this angle are made better by exchanges and by moves of vertices; degrees, above 0 and at most 70.
    ///
    /// The regular tetrahedron has 70.5°. The nearer the goal is to that, the more tetrahedra there are to work on, and the
    /// fewer of them reach it: 20 is quick, 30 thorough.
    pub goal: f64,
    /// For tetrahedra below this angle vertices are removed and inserted inside, too; degrees, from 0 on.
    ///
    /// 0 keeps the vertices; then slivers stay where the domain is so thin that all vertices are on the boundary. From
    /// about 20 on the number of tetrahedra grows there, from 30 on everywhere.
    pub vertices_below: f64,
    /// The most changes that may be made.
    pub max_changes: usize,
}

impl Default for Params {
    /// 20° by all means.
    fn default() -> Self {
        Self {
            goal: 20.0,
            vertices_below: 20.0,
            max_changes: usize::MAX,
        }
    }
}
