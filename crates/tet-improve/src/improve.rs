//! The driver, and what it answers.

use crate::error::ImproveError;
use crate::improver::Improver;
use crate::outcome::{Dihedrals, Outcome, Stop, low};
use crate::params::Params;
use crate::quality::sine_of_degrees;
use delaunay_core::Complex3;
use delaunay_core::progress::{Meter, Progress};
use std::ops::ControlFlow;

/// Improves the tetrahedra of `solid`. The boundary stays as it is.
///
/// One tetrahedron after the other, the worst first, is given the first change that makes the worst tetrahedron touched
/// better. So the list of all qualities in ascending order becomes greater with every change, in the order of a dictionary;
/// as there are finitely many meshes between numbers of 64 bits, the work ends. The smallest quality never falls. The same
/// input gives the same mesh, bit for bit. Whatever the reason to stop, the mesh is valid.
///
/// # Errors
/// [`ImproveError::Angle`] when an angle is not in its range; [`ImproveError::Cancelled`] when `report` stops the work
/// before it has begun. Later it ends with [`Stop::Cancelled`].
///
/// ```
/// use delaunay_core::{Delaunay3, Subcomplex3, progress::silent};
/// use glam::DVec3;
/// use tet_improve::{Params, Stop, improve};
///
/// // An octahedron with its center much too high.
/// let axes = [DVec3::X, DVec3::Y, DVec3::Z];
/// let mut points: Vec<DVec3> = axes.into_iter().flat_map(|axis| [axis, -axis]).collect();
/// points.push(DVec3::new(0.1, 0.2, 0.6));
/// let solid = Subcomplex3::of(&Delaunay3::build(&points)?, |_| true);
/// let outcome = improve(solid, &Params { goal: 40.0, ..Params::default() }, &mut silent)?;
/// assert_eq!((outcome.stop, outcome.solid.boundary().count()), (Stop::AllGood, 8));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn improve(
    solid: impl Into<Complex3>,
    params: &Params,
    report: &mut dyn FnMut(Progress) -> ControlFlow<()>,
) -> Result<Outcome, ImproveError> {
    let &Params {
        goal,
        vertices_below,
        max_changes,
    } = params;
    let angles = [(goal, goal > 0.0), (vertices_below, vertices_below >= 0.0)];
    if let Some(&(angle, _)) = angles
        .iter()
        .find(|(angle, above)| !(*above && *angle <= 70.0))
    {
        return Err(ImproveError::Angle { angle });
    }
    let meter = Meter::start(report, "improve", 0)?;
    let solid = solid.into();
    let before = Dihedrals::of(&solid);
    let mut improver = Improver::new(solid, max_changes, meter);
    let [goal, vertices_below] = [goal, vertices_below].map(sine_of_degrees);
    let ended = improver.run(goal, vertices_below);
    let low = low(
        &improver.complex,
        &improver.records,
        goal.max(vertices_below),
    );
    let stop = match ended {
        Err(stop) => stop,
        Ok(()) if low.is_empty() => Stop::AllGood,
        Ok(()) => Stop::NothingHelps,
    };
    let Improver {
        complex, counters, ..
    } = improver;
    Ok(Outcome {
        after: Dihedrals::of(&complex),
        solid: complex,
        stop,
        counters,
        before,
        low,
    })
}
