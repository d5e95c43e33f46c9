//! Cells: which points they join, and in which order.

/// Shape of a cell; the order of its corners is that of Gmsh, and of VTK but for the wedge, which VTK turns round.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum CellKind {
    /// One point.
    Vertex,
    /// Two points.
    Segment,
    /// Three points, in cyclic order.
    Triangle,
    /// Four points, in cyclic order.
    Quad,
    /// Triangle `0 1 2`, and the apex 3 on the side from which they turn counterclockwise.
    Tetrahedron,
    /// Quad `0 1 2 3`, and the apex 4.
    Pyramid,
    /// Triangles `0 1 2` and `3 4 5`, corner `k` joined to `k + 3`; counterclockwise seen from the second.
    Wedge,
    /// Quads `0 1 2 3` and `4 5 6 7`, corner `k` joined to `k + 4`.
    Hexahedron,
}

impl CellKind {
    /// Every kind, in declaration order.
    pub const ALL: [Self; 8] = [
        Self::Vertex,
        Self::Segment,
        Self::Triangle,
        Self::Quad,
        Self::Tetrahedron,
        Self::Pyramid,
        Self::Wedge,
        Self::Hexahedron,
    ];

    /// Number of corners, 1 to 8.
    #[must_use]
    pub const fn corner_count(self) -> usize {
        match self {
            Self::Vertex => 1,
            Self::Segment => 2,
            Self::Triangle => 3,
            Self::Quad | Self::Tetrahedron => 4,
            Self::Pyramid => 5,
            Self::Wedge => 6,
            Self::Hexahedron => 8,
        }
    }

    /// Topological dimension, 0 to 3.
    #[must_use]
    pub const fn dimension(self) -> usize {
        match self {
            Self::Vertex => 0,
            Self::Segment => 1,
            Self::Triangle | Self::Quad => 2,
            Self::Tetrahedron | Self::Pyramid | Self::Wedge | Self::Hexahedron => 3,
        }
    }

    /// The English word for the kind.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Vertex => "vertex",
            Self::Segment => "segment",
            Self::Triangle => "triangle",
            Self::Quad => "quad",
            Self::Tetrahedron => "tetrahedron",
            Self::Pyramid => "pyramid",
            Self::Wedge => "wedge",
            Self::Hexahedron => "hexahedron",
        }
    }
}

/// A cell: its kind and the indices of its corners, counted from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(
    missing_docs,
    reason = "the variants are those of `CellKind`, which are documented"
)]
pub enum Cell {
    Vertex([u32; 1]),
    Segment([u32; 2]),
    Triangle([u32; 3]),
    Quad([u32; 4]),
    Tetrahedron([u32; 4]),
    Pyramid([u32; 5]),
    Wedge([u32; 6]),
    Hexahedron([u32; 8]),
}

impl Cell {
    /// The cell of this kind with these corners; `None` when their number is not [`CellKind::corner_count`].
    #[must_use]
    pub fn new(kind: CellKind, corners: &[u32]) -> Option<Self> {
        match kind {
            CellKind::Vertex => corners.try_into().map(Self::Vertex),
            CellKind::Segment => corners.try_into().map(Self::Segment),
            CellKind::Triangle => corners.try_into().map(Self::Triangle),
            CellKind::Quad => corners.try_into().map(Self::Quad),
            CellKind::Tetrahedron => corners.try_into().map(Self::Tetrahedron),
            CellKind::Pyramid => corners.try_into().map(Self::Pyramid),
            CellKind::Wedge => corners.try_into().map(Self::Wedge),
            CellKind::Hexahedron => corners.try_into().map(Self::Hexahedron),
        }
        .ok()
    }

    /// The kind of this cell.
    #[must_use]
    pub const fn kind(&self) -> CellKind {
        match self {
            Self::Vertex(_) => CellKind::Vertex,
            Self::Segment(_) => CellKind::Segment,
            Self::Triangle(_) => CellKind::Triangle,
            Self::Quad(_) => CellKind::Quad,
            Self::Tetrahedron(_) => CellKind::Tetrahedron,
            Self::Pyramid(_) => CellKind::Pyramid,
            Self::Wedge(_) => CellKind::Wedge,
            Self::Hexahedron(_) => CellKind::Hexahedron,
        }
    }

    /// Indices of the corners, in the order of [`CellKind`].
    #[must_use]
    pub const fn corners(&self) -> &[u32] {
        match self {
            Self::Vertex(corners) => corners,
            Self::Segment(corners) => corners,
            Self::Triangle(corners) => corners,
            Self::Quad(corners) | Self::Tetrahedron(corners) => corners,
            Self::Pyramid(corners) => corners,
            Self::Wedge(corners) => corners,
            Self::Hexahedron(corners) => corners,
        }
    }
}

/// A list of cells of any kinds, in a stable order, stored flat.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Cells {
    kinds: Vec<CellKind>,
    corners: Vec<u32>,
}

impl Cells {
    /// An empty list.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            kinds: Vec::new(),
            corners: Vec::new(),
        }
    }

    /// Triangles alone, from the corners of each; copies no corner.
    #[must_use]
    pub fn of_triangles(corners: Vec<[u32; 3]>) -> Self {
        Self {
            kinds: vec![CellKind::Triangle; corners.len()],
            corners: corners.into_flattened(),
        }
    }

    /// Tetrahedra alone, from the corners of each; copies no corner.
    #[must_use]
    pub fn of_tetrahedra(corners: Vec<[u32; 4]>) -> Self {
        Self {
            kinds: vec![CellKind::Tetrahedron; corners.len()],
            corners: corners.into_flattened(),
        }
    }

    /// Appends a cell. Amortised O(1).
    pub fn push(&mut self, cell: Cell) {
        self.kinds.push(cell.kind());
        self.corners.extend_from_slice(cell.corners());
    }

    /// Number of cells.
    #[must_use]
    pub const fn len(&self) -> usize {
        self.kinds.len()
    }

    /// Whether there are no cells.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.kinds.is_empty()
    }

    /// The kind of every cell, in order.
    #[must_use]
    pub fn kinds(&self) -> &[CellKind] {
        &self.kinds
    }

    /// The corners of all cells, one cell after the other.
    #[must_use]
    pub fn corners(&self) -> &[u32] {
        &self.corners
    }

    /// Every cell, in order.
    pub fn iter(&self) -> impl Iterator<Item = Cell> + '_ {
        let mut rest = self.corners.as_slice();
        self.kinds.iter().map_while(move |&kind| {
            let (corners, after) = rest.split_at_checked(kind.corner_count())?;
            rest = after;
            Cell::new(kind, corners)
        })
    }
}

impl FromIterator<Cell> for Cells {
    fn from_iter<I: IntoIterator<Item = Cell>>(cells: I) -> Self {
        let mut list = Self::new();
        list.extend(cells);
        list
    }
}

impl Extend<Cell> for Cells {
    fn extend<I: IntoIterator<Item = Cell>>(&mut self, cells: I) {
        for cell in cells {
            self.push(cell);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_list_gives_back_its_cells_in_order() {
        let cells = [
            Cell::Triangle([0, 1, 2]),
            Cell::Vertex([7]),
            Cell::Hexahedron([0, 1, 2, 3, 4, 5, 6, 7]),
        ];
        assert!(Cells::from_iter(cells).iter().eq(cells));
    }

    #[test]
    fn simplices_at_once_are_those_one_by_one() {
        let [triangles, tetrahedra] = [vec![[0, 1, 2], [2, 1, 3]], vec![[4, 5, 6], [7, 8, 9]]];
        let one_by_one = triangles.iter().copied().map(Cell::Triangle).collect();
        assert_eq!(Cells::of_triangles(triangles), one_by_one);
        let tetrahedra: Vec<[u32; 4]> = tetrahedra.iter().map(|&[a, b, c]| [a, b, c, 0]).collect();
        let one_by_one = tetrahedra.iter().copied().map(Cell::Tetrahedron).collect();
        assert_eq!(Cells::of_tetrahedra(tetrahedra), one_by_one);
    }

    #[test]
    fn every_kind_asks_for_its_own_number_of_corners() {
        for kind in CellKind::ALL {
            let corners = [0; 9];
            for count in 0..9 {
                let cell = Cell::new(kind, &corners[..count]);
                assert_eq!(
                    cell.map(|cell| cell.corners().len()),
                    (count == kind.corner_count()).then_some(count)
                );
            }
        }
    }
}
