//! Boundary nodes that move along the smooth curve through them and their neighbours.

use delaunay_core::VertexId;
use glam::DVec2;

use super::chains::chains;
use crate::curve::{Curve, CurveError};
use crate::domain::Domain;

/// A node moves by at most this share of an edge of the chain at once.
const LONGEST_STEP: f64 = 0.3;

/// The curves that boundary nodes move on, and where on them they are.
#[derive(Clone, Debug)]
pub(crate) struct Rails {
    curves: Vec<Curve>,
    /// By vertex, its curve and how many edges of the chain are before it.
    stations: Vec<Option<Station>>,
}

#[derive(Clone, Copy, Debug)]
struct Station {
    curve: usize,
    at: f64,
}

impl Rails {
    /// The rails of a domain's boundary, whose corners turn by more than `crease`, in radians; they stay.
    ///
    /// # Errors
    /// Coordinates that are not accepted on a curve.
    pub(crate) fn of(domain: &Domain, crease: f64) -> Result<Self, CurveError> {
        let points = domain.region().points();
        let segments: Vec<[VertexId; 2]> = domain.segments().collect();
        let mut rails = Self {
            curves: Vec::new(),
            stations: vec![None; points.len()],
        };
        for chain in chains(points, &segments, crease, |_, _| true) {
            let inner = match chain.is_loop {
                true => 0..chain.nodes.len(),
                false => 1..chain.nodes.len() - 1,
            };
            if inner.is_empty() {
                continue;
            }
            for k in inner {
                rails.stations[chain.nodes[k].index()] = Some(Station {
                    curve: rails.curves.len(),
                    at: k as f64,
                });
            }
            rails.curves.push(chain.curve(points)?);
        }
        Ok(rails)
    }

    /// The nodes that may move, by id.
    pub(crate) fn vertices(&self) -> impl Iterator<Item = VertexId> + '_ {
        let seated = (0..)
            .zip(&self.stations)
            .filter(|(_, station)| station.is_some());
        seated.map(|(v, _)| VertexId::new(v))
    }

    /// The direction in which a node may move, of length one; `None` for nodes that stay.
    pub(crate) fn direction(&self, v: VertexId) -> Option<DVec2> {
        let Station { curve, at } = self.station(v)?;
        self.curves[curve].velocity(at).try_normalize()
    }

    /// Where a node is after a step of a length along its curve, as what can be given to [`Rails::seat`].
    pub(crate) fn ahead(&self, v: VertexId, step: f64) -> Option<(f64, DVec2)> {
        let Station { curve, at } = self.station(v)?;
        let curve = &self.curves[curve];
        let share = step / curve.velocity(at).length();
        let at = at + share.clamp(-LONGEST_STEP, LONGEST_STEP);
        let count = curve.stretch_count();
        let at = match curve.is_closed() {
            true => at.rem_euclid(count),
            false => at.clamp(0.0, count),
        };
        let place = curve.point(at);
        (at.is_finite() && place.is_finite()).then_some((at, place))
    }

    /// Notes where a node is now.
    pub(crate) fn seat(&mut self, v: VertexId, at: f64) {
        if let Some(Some(station)) = self.stations.get_mut(v.index()) {
            station.at = at;
        }
    }

    fn station(&self, v: VertexId) -> Option<Station> {
        self.stations.get(v.index()).copied().flatten()
    }
}
