//! What the sections are called, and how many words stand in them for each element.

use crate::cell::CellKind;

/// The sections of cells that are written, in this order.
pub(super) const CELLS: [(&str, CellKind); 7] = [
    ("Edges", CellKind::Segment),
    ("Triangles", CellKind::Triangle),
    ("Quadrilaterals", CellKind::Quad),
    ("Tetrahedra", CellKind::Tetrahedron),
    ("Pyramids", CellKind::Pyramid),
    ("Prisms", CellKind::Wedge),
    ("Hexahedra", CellKind::Hexahedron),
];

/// The cells in a section, where it holds some.
pub(super) fn kind_of(section: &str) -> Option<CellKind> {
    match section {
        // Both spellings are in use.
        "Hexaedra" => Some(CellKind::Hexahedron),
        _ => {
            let mut known = CELLS.into_iter();
            let found = known.find(|(name, _)| *name == section);
            found.map(|(_, kind)| kind)
        }
    }
}

/// How many words each element has in a section that is passed over; `None` for a section that is not known.
pub(super) fn words_each(section: &str, dimension: usize) -> Option<usize> {
    Some(match section {
        "Corners"
        | "Ridges"
        | "RequiredVertices"
        | "RequiredEdges"
        | "RequiredTriangles"
        | "RequiredQuadrilaterals"
        | "ParallelVertices"
        | "ParallelEdges"
        | "ParallelTriangles" => 1,
        "NormalAtVertices"
        | "TangentAtVertices"
        | "VertexOnGeometricVertex"
        | "EdgeOnGeometricEdge" => 2,
        "NormalAtTriangleVertices"
        | "NormalAtQuadrilateralVertices"
        | "TangentAtEdges"
        | "VertexOnGeometricEdge" => 3,
        "SubDomainFromMesh" | "SubDomainFromGeom" => 4,
        "Normals" | "Tangents" => dimension,
        _ => return None,
    })
}
