//! Numbers of element types, as Gmsh gives them.

use crate::cell::CellKind;

/// The element type of a kind of cell; both number the corners of first-order elements alike.
pub(super) const fn element_type(kind: CellKind) -> i32 {
    match kind {
        CellKind::Segment => 1,
        CellKind::Triangle => 2,
        CellKind::Quad => 3,
        CellKind::Tetrahedron => 4,
        CellKind::Hexahedron => 5,
        CellKind::Wedge => 6,
        CellKind::Pyramid => 7,
        CellKind::Vertex => 15,
    }
}

/// The kind of cell of an element type; `None` for elements of higher order and for unknown numbers.
pub(super) fn cell_kind(number: i32) -> Option<CellKind> {
    CellKind::ALL
        .into_iter()
        .find(|&kind| element_type(kind) == number)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kind_has_a_number_of_its_own() {
        for kind in CellKind::ALL {
            assert_eq!(cell_kind(element_type(kind)), Some(kind));
        }
        assert_eq!(
            (cell_kind(0), cell_kind(9), cell_kind(-1)),
            (None, None, None)
        );
    }
}
