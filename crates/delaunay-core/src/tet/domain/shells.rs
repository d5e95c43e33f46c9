//! The closed parts of a surface, and how much they enclose.

use super::build::Domain3;
use super::edges::Edges;
use crate::ids::VertexId;
use crate::measure::{Sum, facet};
use crate::tet::bounds::Bounds;
use glam::DVec3;

/// Triangles that hang together across edges.
#[derive(Clone, Debug, PartialEq)]
pub struct Shell {
    /// Their indices, in order.
    pub triangles: Vec<usize>,
    /// Their area, rounded.
    pub area: f64,
    /// The volume within, rounded: of a shell round a body positive, round a void negative. Without meaning for a shell that is not
    /// closed, or that separates regions.
    pub volume: f64,
}

impl Domain3 {
    /// The parts that hang together across edges, with any number of triangles on an edge, in the order of their first triangles.
    /// Parts that touch at a vertex are two. Takes n log n time.
    #[must_use]
    pub fn shells(&self) -> Vec<Shell> {
        let roots = self.roots();
        let mut number = vec![usize::MAX; roots.len()];
        let mut members: Vec<Vec<usize>> = Vec::new();
        for (triangle, &root) in roots.iter().enumerate() {
            // A root is the smallest index of its part, and so comes first.
            if root == triangle {
                number[root] = members.len();
                members.push(Vec::new());
            }
            members[number[root]].push(triangle);
        }
        members.into_iter().map(|part| self.shell(part)).collect()
    }

    /// By triangle, the smallest index in its part.
    fn roots(&self) -> Vec<usize> {
        let mut roots: Vec<usize> = (0..self.triangles().len()).collect();
        let edges = Edges::of(self.triangles().iter().copied().enumerate());
        for on_edge in edges.iter() {
            for pair in on_edge.windows(2) {
                let [one, two] = [pair[0], pair[1]].map(|side| root(&mut roots, side.triangle()));
                roots[one.max(two)] = one.min(two);
            }
        }
        for triangle in 0..roots.len() {
            roots[triangle] = root(&mut roots, triangle);
        }
        roots
    }

    fn shell(&self, triangles: Vec<usize>) -> Shell {
        let corners = |&triangle: &usize| self.triangles()[triangle].map(|v| self.place(v));
        let all = triangles.iter().map(corners);
        // Seen from the middle the parts of the sum are no larger than the whole needs.
        let middle = Bounds::of(all.clone().flatten()).middle();
        let (mut area, mut volume) = (Sum::default(), Sum::default());
        for corners in all {
            area.add(facet::area(corners));
            let [a, b, c] = corners.map(|corner| corner - middle);
            volume.add(a.cross(b).dot(c) / 6.0);
        }
        Shell {
            triangles,
            area: area.total(),
            volume: volume.total(),
        }
    }

    fn place(&self, v: VertexId) -> DVec3 {
        self.points()[v.index()]
    }
}

/// The root of a triangle's part. Makes the way there half as long.
fn root(roots: &mut [usize], mut triangle: usize) -> usize {
    while roots[triangle] != triangle {
        roots[triangle] = roots[roots[triangle]];
        triangle = roots[triangle];
    }
    triangle
}
