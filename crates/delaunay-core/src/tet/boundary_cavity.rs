//! The cavity of a point that is to become a vertex of the boundary of a subcomplex.
//!
//! ```text
//!     ghosts         Tetrahedra in conflict with the point, and the ghosts on a disk of boundary
//!    ___p___         facets round it. The star of the point that takes their place has ghosts on the
//!   \  / \  /        triangles between the point and the rim of the disk: the new boundary.
//!    \/   \/
//! ```
//!
//! A boundary facet of the disk whose tetrahedron is not in conflict with a point outside keeps it, and gets another one on
//! top, as a facet of the convex hull does.
//!
//! Where the disk is flat and the point in its plane, the solid stays what it is. Otherwise it gains or loses what lies
//! between the disk and the new triangles.

use super::cavity::Cavity3;
use super::mesh::TetMesh;
use super::sight::Sight3;
use super::subcomplex::Subcomplex3;
use crate::ids::{FacetId, TetId, VertexId};
use geo_predicates::Sign;
use glam::DVec3;
use rustc_hash::{FxHashMap, FxHashSet};

/// A boundary facet met on the way from facet to facet.
#[derive(Clone, Copy, Debug)]
pub struct Met {
    /// The facet.
    pub facet: FacetId,
    /// The edge across which it was met; `None` of the facets given.
    pub across: Option<[VertexId; 2]>,
    /// Whether the tetrahedron inside gives way too. If not, the point is strictly outside the facet, and there will be a
    /// tetrahedron between the two.
    pub opens: bool,
}

impl Subcomplex3 {
    /// Fills `cavity` with what has to give way when `p` becomes a vertex of the boundary: the tetrahedra in conflict with it,
    /// and the ghosts on a disk of boundary facets. `p` must be an accepted point.
    ///
    /// The disk has the boundary facets `first`, one or two that share an edge, and those that hang together with them, as far
    /// as `joins` says yes of them; of `first` it must say so too. The tetrahedra are those that hang together with that of the
    /// first facet.
    ///
    /// The boundary may hide tetrahedra from the point: round a corner, or behind a wall. The cavity shrinks to those that
    /// the point sees, so that it sees every facet round it strictly from inside. Answers whether [`fill`](Self::fill) may
    /// follow: there is such a cavity, and no vertex would be lost. The cavity is of no use otherwise. Whether
    /// the new triangles meet others of the boundary is not known here, see
    /// [`triangles_intersect`](super::triangles_intersect). Exact. Takes time proportional to the size of the cavity, and to its
    /// square where it has to shrink.
    #[must_use]
    pub fn dig_on(
        &self,
        p: DVec3,
        first: &[FacetId],
        mut joins: impl FnMut(Met) -> bool,
        cavity: &mut Cavity3,
    ) -> bool {
        let sight = Sight3::new(self.coords.as_slice(), self.filter, p);
        let mesh = &self.mesh;
        let conflicts = |t: TetId| {
            let corners = mesh.tet_vertices(t);
            !corners[3].is_ghost() && sight.in_real_conflict(corners)
        };
        let is_unseen = |f: FacetId| {
            let corners = mesh.facet_vertices(f);
            let real = !corners.iter().any(|v| v.is_ghost());
            real && sight.side(corners) != Sign::Positive
        };
        let Some(seed) = first.first().map(|f| f.tet()) else {
            return false;
        };
        cavity.assign(&[], &[]);
        if conflicts(seed) {
            cavity.dig(mesh, &self.coords, seed, conflicts);
        }
        loop {
            let joins = |met: Met| (met.opens || !is_unseen(met.facet)) && joins(met);
            let Some(disk) = self.disk(cavity, first, joins) else {
                return false;
            };
            let facets = disk.len();
            open(mesh, cavity, disk);
            let outer = cavity.boundary.iter().copied();
            let unseen = outer.filter(|&f| is_unseen(f));
            let hidden: FxHashSet<TetId> = unseen.map(|f| mesh.twin(f).tet()).collect();
            if hidden.is_empty() {
                return is_sphere_round_all(mesh, cavity, facets);
            }
            if hidden.contains(&seed) {
                return false;
            }
            shrink(mesh, cavity, seed, &hidden);
        }
    }

    /// The ghosts on the disk; `None` when not all of `first` join it.
    fn disk(
        &self,
        cavity: &Cavity3,
        first: &[FacetId],
        mut joins: impl FnMut(Met) -> bool,
    ) -> Option<Vec<TetId>> {
        let ghost_on = |f: FacetId| self.mesh.twin(f).tet();
        let outside: FxHashSet<TetId> = cavity.boundary.iter().map(|f| f.tet()).collect();
        let mut joins = |facet, across| {
            joins(Met {
                facet,
                across,
                opens: outside.contains(&ghost_on(facet)),
            })
        };
        if !first.iter().all(|&f| joins(f, None)) {
            return None;
        }
        let mut disk = first.to_vec();
        let mut on_disk: FxHashSet<FacetId> = disk.iter().copied().collect();
        let mut next = 0;
        while let Some(&f) = disk.get(next) {
            next += 1;
            for (edge, beyond) in self.across_edges(f) {
                if !on_disk.contains(&beyond) && joins(beyond, Some(edge)) {
                    on_disk.insert(beyond);
                    disk.push(beyond);
                }
            }
        }
        Some(disk.into_iter().map(ghost_on).collect())
    }
}

/// Adds the ghosts of a disk to a cavity that ends at them.
fn open(mesh: &TetMesh, cavity: &mut Cavity3, disk: Vec<TetId>) {
    let on_disk: FxHashSet<TetId> = disk.iter().copied().collect();
    let opened: FxHashSet<TetId> = cavity.boundary.iter().map(|f| f.tet()).collect();
    cavity
        .boundary
        .retain(|outer| !on_disk.contains(&outer.tet()));
    for ghost in &disk {
        let [sides @ .., base] = ghost.facets().map(|side| mesh.twin(side));
        let round = sides
            .into_iter()
            .filter(|outer| !on_disk.contains(&outer.tet()));
        cavity.boundary.extend(round);
        if !opened.contains(ghost) {
            cavity.boundary.push(base);
        }
    }
    cavity.tets.extend(disk);
}

/// Leaves of a cavity the tetrahedra that are not `hidden` and hang together with `seed`.
fn shrink(mesh: &TetMesh, cavity: &mut Cavity3, seed: TetId, hidden: &FxHashSet<TetId>) {
    let all = cavity.tets.iter().copied();
    let mut open: FxHashSet<TetId> = all
        .filter(|t| !hidden.contains(t) && !mesh.is_ghost_tet(*t))
        .collect();
    cavity.tets.clear();
    cavity.boundary.clear();
    let mut inside: FxHashSet<TetId> = FxHashSet::default();
    let mut pending: Vec<TetId> = open.take(&seed).into_iter().collect();
    inside.extend(&pending);
    while let Some(t) = pending.pop() {
        cavity.tets.push(t);
        for across in t.facets().map(|f| mesh.neighbor(t, f.corner())) {
            if open.remove(&across) {
                inside.insert(across);
                pending.push(across);
            }
        }
    }
    let facets = cavity.tets.iter().flat_map(|t| t.facets());
    let outer = facets.map(|f| mesh.twin(f));
    let outer = outer.filter(|outer| !inside.contains(&outer.tet()));
    cavity.boundary.extend(outer);
}

/// Whether the facets round the cavity make one sphere, and have all vertices of the cavity on them, those of the boundary with
/// a ghost: then the cone from a point over that sphere can take its place, and no vertex is lost or leaves the boundary.
///
/// Edges with two facets each make a surface, up to vertices where parts of it touch. When it is connected, Euler's
/// characteristic is 2 for a sphere only: handles make it less, and so do vertices where it touches itself. For the same reason the
/// facets that go, all corners of which are on their rim, are a disk when the rim has two edges more than there are facets: a
/// handle, which the new vertex would close, makes it shorter.
fn is_sphere_round_all(mesh: &TetMesh, cavity: &Cavity3, disk: usize) -> bool {
    let mut facets_on: FxHashMap<[VertexId; 2], Vec<usize>> = FxHashMap::default();
    let mut vertices: FxHashSet<VertexId> = FxHashSet::default();
    let mut on_rim: FxHashSet<VertexId> = FxHashSet::default();
    let mut rim = 0;
    for (index, &outer) in cavity.boundary.iter().enumerate() {
        let [a, b, c] = mesh.facet_vertices(outer);
        vertices.extend([a, b, c]);
        if [a, b, c].iter().any(|v| v.is_ghost()) {
            rim += 1;
            on_rim.extend([a, b, c]);
        }
        for [u, v] in [[a, b], [b, c], [c, a]] {
            let edge = [u.min(v), u.max(v)];
            facets_on.entry(edge).or_default().push(index);
        }
    }
    let keeps = |t: TetId| {
        let corners = mesh.tet_vertices(t);
        let rim = if mesh.is_ghost_tet(t) {
            &on_rim
        } else {
            &vertices
        };
        corners.iter().all(|v| rim.contains(v))
    };
    let keeps_all = cavity.tets.iter().all(|&t| keeps(t));
    let is_surface = facets_on.values().all(|facets| facets.len() == 2);
    let faces = cavity.boundary.len();
    let is_spherical = vertices.len() + faces == facets_on.len() + 2;
    keeps_all
        && rim == disk + 2
        && is_surface
        && is_spherical
        && is_connected(faces, facets_on.values())
}

/// Whether so many facets hang together by the pairs that share an edge.
fn is_connected<'a>(faces: usize, pairs: impl Iterator<Item = &'a Vec<usize>>) -> bool {
    let mut around = vec![Vec::new(); faces];
    for pair in pairs {
        if let [f, g] = pair[..] {
            around[f].push(g);
            around[g].push(f);
        }
    }
    let mut reached = vec![false; faces];
    let mut pending = vec![0];
    let mut count = 0;
    while let Some(f) = pending.pop() {
        if !std::mem::replace(&mut reached[f], true) {
            count += 1;
            pending.extend_from_slice(&around[f]);
        }
    }
    count == faces
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tet::Delaunay3;

    /// A cube and the facets of its bottom.
    fn cube() -> (Subcomplex3, Vec<FacetId>) {
        let corner = |i: usize| DVec3::new((i & 1) as f64, (i >> 1 & 1) as f64, (i >> 2) as f64);
        let points: Vec<DVec3> = (0..8).map(corner).collect();
        let cube = Subcomplex3::of(&Delaunay3::build(&points).unwrap(), |_| true);
        let is_bottom = |f: &FacetId| cube.triangle(*f).iter().all(|p| p.z == 0.0);
        let bottom = cube.boundary().filter(is_bottom).collect();
        (cube, bottom)
    }

    #[test]
    fn a_point_of_a_flat_side_becomes_a_vertex_of_the_boundary() {
        let (mut cube, bottom) = cube();
        let mut cavity = Cavity3::default();
        let p = DVec3::new(0.5, 0.5, 0.0);
        let joins = |met: Met| bottom.contains(&met.facet);
        assert!(cube.dig_on(p, &bottom[..1], joins, &mut cavity));
        let v = cube.fill(p, &mut cavity).unwrap();
        assert_eq!(cube.mesh().check(), Ok(()));
        let at = |f: &FacetId| cube.mesh().facet_vertices(*f).contains(&v);
        assert_eq!(cube.boundary().filter(at).count(), 4);
        assert_eq!(cube.boundary().count(), 14);
    }

    #[test]
    fn a_point_of_an_edge_needs_the_facets_on_both_sides() {
        let (mut cube, bottom) = cube();
        let mut cavity = Cavity3::default();
        let p = DVec3::new(0.5, 0.0, 0.0);
        let on_edge = |f: &FacetId| {
            let ends = [DVec3::ZERO, DVec3::X];
            ends.iter().all(|end| cube.triangle(*f).contains(end))
        };
        let both: Vec<FacetId> = cube.boundary().filter(on_edge).collect();
        assert_eq!(both.len(), 2);
        let one: Vec<FacetId> = both
            .iter()
            .copied()
            .filter(|f| bottom.contains(f))
            .collect();
        assert!(!cube.dig_on(p, &one, |met| one.contains(&met.facet), &mut cavity));
        let is_on_a_side = |met: Met| {
            let corners = cube.triangle(met.facet);
            corners.iter().all(|p| p.y == 0.0) || corners.iter().all(|p| p.z == 0.0)
        };
        assert!(cube.dig_on(p, &both, is_on_a_side, &mut cavity));
        cube.fill(p, &mut cavity).unwrap();
        assert_eq!(cube.mesh().check(), Ok(()));
        assert_eq!(cube.boundary().count(), 14);
    }

    #[test]
    fn a_point_outside_the_circumsphere_comes_on_top() {
        let (mut cube, bottom) = cube();
        let mut cavity = Cavity3::default();
        let p = DVec3::new(0.5, 0.5, -1.0);
        let tets = cube.tets().count();
        assert!(!cube.dig_on(p, &bottom[..1], |met| met.opens, &mut cavity));
        let joins = |met: Met| !met.opens && bottom.contains(&met.facet);
        assert!(cube.dig_on(p, &bottom[..1], joins, &mut cavity));
        cube.fill(p, &mut cavity).unwrap();
        assert_eq!(cube.mesh().check(), Ok(()));
        assert_eq!(cube.boundary().count(), 14);
        assert_eq!(cube.tets().count(), tets + 2);
    }

    #[test]
    fn no_vertex_is_lost() {
        let (mut cube, bottom) = cube();
        let mut cavity = Cavity3::default();
        let p = DVec3::new(0.5, 0.5, 0.0);
        let joins = |met: Met| bottom.contains(&met.facet);
        assert!(cube.dig_on(p, &bottom[..1], joins, &mut cavity));
        let v = cube.fill(p, &mut cavity).unwrap();
        // Pulled out, a point would swallow the vertex in the middle with all facets round it.
        let round: Vec<FacetId> = cube
            .boundary()
            .filter(|&f| cube.mesh().facet_vertices(f).contains(&v))
            .collect();
        let out = DVec3::new(0.5, 0.5, -0.01);
        assert!(!cube.dig_on(
            out,
            &round[..1],
            |met| round.contains(&met.facet),
            &mut cavity
        ));
    }
}
