//! Markers and regions of a planar graph, carried to a mesh of what it describes.
//!
//! Whatever a method did inside, the boundary of its mesh has the given vertices with their numbers, and between two of them perhaps new
//! ones. So an edge on the way from one given vertex to the next is part of the segment between them, and a triangle belongs to the
//! region on the side of the segments that it hangs together with.

use std::collections::BTreeMap;

use delaunay_core::{FaceId, HalfEdgeId, SeedError, TriMesh, VertexId};
use glam::DVec2;
use mesh_io::{Cell, DataArray, Mesh, PlanarGraph};

use crate::plane::{GivenRegion, seed_text};

/// The name of the numbers that regions carry, in files.
pub const ATTRIBUTE: &str = "region";

/// What a graph says of its vertices, segments and regions.
#[derive(Clone, Debug)]
pub struct Marks {
    /// How many vertices are given, those where segments were divided included.
    given: usize,
    points: Option<Vec<i32>>,
    segments: Option<Vec<i32>>,
    /// By ends, what lies along a segment with the triangles inside on its left.
    sides: BTreeMap<[VertexId; 2], Side>,
    /// By part, the number of its region.
    attributes: Option<Vec<f64>>,
}

#[derive(Clone, Copy, Debug)]
struct Side {
    segment: usize,
    part: usize,
}

/// Why the regions of a graph are not known.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum MarksError {
    /// The seed of a region names no part.
    #[error("region {}", seed_text(.0))]
    Seed(SeedError),
    /// The seed of a region is in a hole.
    #[error("the point of region {region} is in a hole")]
    InHole {
        /// Its index.
        region: usize,
    },
    /// Two regions with different numbers are one, as no segments separate them.
    #[error("regions {first} and {second} are not separated, but have different numbers")]
    SamePart {
        /// The index of one.
        first: usize,
        /// That of the other.
        second: usize,
    },
}

impl Marks {
    /// The marks of a graph, where it has any. Takes n log n time.
    ///
    /// # Errors
    /// The first region whose seed names no part, or one that is a hole or has another number already.
    pub fn of(graph: &PlanarGraph, region: &GivenRegion) -> Result<Self, MarksError> {
        let (triangulation, components) = (region.triangulation(), region.components());
        let mesh = triangulation.mesh();
        let is_inside =
            |h: &HalfEdgeId| !mesh.is_ghost_face(h.face()) && region.is_inside(h.face());
        let sides = mesh.half_edges().filter(is_inside).filter_map(|h| {
            let segment = triangulation.segment_of(h)?;
            let part = components.of(h.face());
            Some(([mesh.origin(h), mesh.target(h)], Side { segment, part }))
        });
        let sides = sides.collect();
        let seeds: Vec<DVec2> = graph
            .regions
            .iter()
            .map(|region| region.seed.into())
            .collect();
        let parts = triangulation.parts_at(components, &seeds);
        let parts = parts.map_err(MarksError::Seed)?;
        let mut first: Vec<Option<usize>> = vec![None; components.count()];
        for (index, &part) in parts.iter().enumerate() {
            if !region.has_inside(part) {
                return Err(MarksError::InHole { region: index });
            }
            let first = *first[part].get_or_insert(index);
            if graph.regions[first].attribute != graph.regions[index].attribute {
                let second = index;
                return Err(MarksError::SamePart { first, second });
            }
        }
        let attribute = |first: &Option<usize>| first.map_or(0.0, |i| graph.regions[i].attribute);
        let attributes = (!seeds.is_empty()).then(|| first.iter().map(attribute).collect());
        Ok(Self {
            given: triangulation.points().len(),
            points: graph.point_markers.clone(),
            segments: graph.segment_markers.clone(),
            sides,
            attributes,
        })
    }

    /// Gives a mesh of the region, as [`region_mesh`](crate::convert::region_mesh) makes it from the triangles of `triangles`, the markers
    /// of points, 0 inside, and the numbers of regions: as cell data, and as cell markers where they are whole.
    ///
    /// Where segments have markers the answer is the mesh with the edges of the boundary, and those between regions, as further
    /// cells with these markers; they follow the triangles, sorted by their ends. Takes n log n time.
    pub fn mark(&self, mesh: &mut Mesh, faces: &[FaceId], triangles: &TriMesh) -> Option<Mesh> {
        let used = (0..)
            .map(VertexId::new)
            .filter(|&v| triangles.outgoing(v).is_some());
        let vertices: Vec<VertexId> = used.take(mesh.points.len()).collect();
        let edges = self.edges(triangles);
        if let Some(points) = &self.points {
            let marker = |v: &VertexId| points.get(v.index()).copied().unwrap_or(0);
            mesh.point_markers = Some(vertices.iter().map(marker).collect());
        }
        if let Some(attributes) = &self.attributes {
            let parts = parts(triangles, &edges);
            let of = |f: &FaceId| parts[f.index()].map_or(0.0, |part| attributes[part]);
            let values: Vec<f64> = faces.iter().map(of).collect();
            let whole = |value: &f64| {
                let marker = *value as i32;
                (f64::from(marker) == *value).then_some(marker)
            };
            mesh.cell_markers = values.iter().map(whole).collect();
            mesh.cell_data.push(DataArray::scalar(ATTRIBUTE, values));
        }
        let segments = self.segments.as_ref()?;
        let number = |v: VertexId| vertices.partition_point(|&w| w < v) as u32;
        let marked = edges.iter().map(|&(h, side)| {
            let [a, b] = [triangles.origin(h), triangles.target(h)].map(number);
            let marker = segments.get(side.segment).copied().unwrap_or(0);
            ([a.min(b), a.max(b)], marker)
        });
        Some(with_edges(mesh, &marked.collect()))
    }

    /// The half-edges on the boundary from inside, with what lies along their segments.
    fn edges(&self, triangles: &TriMesh) -> Vec<(HalfEdgeId, Side)> {
        let is_given = |v: VertexId| v.index() < self.given;
        let is_boundary = |h: HalfEdgeId| triangles.is_ghost_face(triangles.twin(h).face());
        let inside = triangles
            .half_edges()
            .filter(|h| !triangles.is_ghost_face(h.face()));
        let mut found = Vec::new();
        for first in inside.filter(|&h| is_boundary(h) && is_given(triangles.origin(h))) {
            let (start, before) = (triangles.origin(first), found.len());
            let mut here = first;
            let mut on_the_way = vec![here];
            while !is_given(triangles.target(here)) {
                here = here.next();
                while !is_boundary(here) {
                    here = triangles.twin(here).next();
                }
                on_the_way.push(here);
            }
            if let Some(&side) = self.sides.get(&[start, triangles.target(here)]) {
                found.extend(on_the_way.into_iter().map(|h| (h, side)));
            }
            debug_assert!(found.len() > before, "a boundary edge is part of a segment");
        }
        found
    }
}

/// A mesh with segments as further cells, each with its marker.
fn with_edges(mesh: &Mesh, edges: &BTreeMap<[u32; 2], i32>) -> Mesh {
    let mut marked = mesh.clone();
    for &ends in edges.keys() {
        marked.cells.push(Cell::Segment(ends));
    }
    let markers = marked.cell_markers.take();
    let mut markers = markers.unwrap_or_else(|| vec![0; mesh.cells.len()]);
    markers.extend(edges.values());
    marked.cell_markers = Some(markers);
    for data in &mut marked.cell_data {
        data.values
            .resize(marked.cells.len() * data.components, 0.0);
    }
    marked
}

/// By face, its part; `edges` are on the boundary of all of them.
fn parts(triangles: &TriMesh, edges: &[(HalfEdgeId, Side)]) -> Vec<Option<usize>> {
    let mut parts = vec![None; triangles.face_count()];
    let mut pending = Vec::new();
    for (h, side) in edges {
        let first = h.face();
        if parts[first.index()].is_some() {
            continue;
        }
        parts[first.index()] = Some(side.part);
        pending.push(first);
        while let Some(f) = pending.pop() {
            for across in f.half_edges().map(|h| triangles.twin(h).face()) {
                if !triangles.is_ghost_face(across) && parts[across.index()].is_none() {
                    parts[across.index()] = Some(side.part);
                    pending.push(across);
                }
            }
        }
    }
    parts
}
