//! What was done to points and triangles to make a domain of them.

use crate::ids::VertexId;
use glam::DVec3;

use super::options::Domain3Options;
use super::patches::Patches;
use super::soup::Soup;

/// What was done to the points and triangles given. All triangles are kept, in the order given, so their numbers are the same.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Repairs {
    /// By point given, the vertex that it became; `None` when it was dropped.
    pub vertices: Vec<Option<VertexId>>,
    /// Points that became one with an earlier one at the same place, by id, as given: the earlier one and the point.
    pub welded: Vec<[VertexId; 2]>,
    /// Points that are no corners and were dropped, by id, as given.
    pub dropped: Vec<VertexId>,
    /// Triangles that were turned the other way, by index.
    pub turned: Vec<usize>,
}

impl Repairs {
    /// Whether points and triangles are as they were given.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.welded.is_empty() && self.dropped.is_empty() && self.turned.is_empty()
    }

    /// What is to be done, when nothing is wrong that is not repaired.
    pub(super) fn of(soup: &Soup<'_>, options: Domain3Options, patches: &Patches) -> Self {
        let all = (0..soup.points.len()).map(VertexId::new);
        // Points that are no corners but remain would be defects, unless they are where a corner is.
        let dropped = all.filter(|v| options.drop_unused && !soup.used[v.index()]);
        let turned = 0..soup.triangles.len();
        let mut repairs = Self {
            vertices: Vec::with_capacity(soup.points.len()),
            welded: soup.places.doubles().collect(),
            dropped: dropped.collect(),
            turned: turned.filter(|&i| patches.turned[i]).collect(),
        };
        repairs.number(soup);
        repairs
    }

    /// Numbers the vertices that remain, in the order given.
    fn number(&mut self, soup: &Soup<'_>) {
        let mut dropped = self.dropped.iter().peekable();
        let mut count = 0;
        for index in 0..soup.points.len() {
            let given = VertexId::new(index);
            let first = soup.places.first(given);
            let kept = if dropped.next_if_eq(&&given).is_some() {
                None
            } else if first == given {
                count += 1;
                Some(VertexId::new(count - 1))
            } else {
                // The first one at the place has its number by now.
                self.vertices[first.index()]
            };
            self.vertices.push(kept);
        }
    }

    /// The points that remain.
    pub(super) fn points(&self, soup: &Soup<'_>) -> Vec<DVec3> {
        let all = soup.points.iter().enumerate();
        let kept = all.filter(|&(index, _)| {
            let given = VertexId::new(index);
            self.vertices[index].is_some() && soup.places.first(given) == given
        });
        kept.map(|(_, &point)| point).collect()
    }

    /// The triangles between them, turned where they have to be.
    pub(super) fn triangles(&self, soup: &Soup<'_>) -> Vec<[VertexId; 3]> {
        // A corner is never dropped.
        let vertex = |v: VertexId| self.vertices[v.index()].unwrap_or(VertexId::GHOST);
        let named = soup.triangles.iter().map(|corners| corners.map(vertex));
        let mut triangles: Vec<[VertexId; 3]> = named.collect();
        for &turned in &self.turned {
            triangles[turned].swap(1, 2);
        }
        triangles
    }
}
