//! `.ele`: triangles (or tetrahedra) between the points of a `.node`.

use std::io::Write;

use super::node::Nodes;
use super::rows::{Rows, attribute_count, check_number, point_index, write_attributes};
use crate::cell::{Cell, CellKind, Cells};
use crate::error::{ReadError, ReadProblem, WriteError, WriteProblem};
use crate::format::Format;
use crate::lines::Lines;
use crate::mesh::Mesh;

/// The mesh of an `.ele` over the points of its `.node`; attributes become cell data.
///
/// # Errors
/// Counts and numbers that do not hold, corners that do not exist, elements of other than 3 or 4 corners; each with its line.
/// O(file).
pub fn parse_ele(bytes: &[u8], nodes: Nodes) -> Result<Mesh, ReadError> {
    let mut lines = Lines::new(bytes)?;
    let mut header = lines.due(format_args!("the number of elements"))?;
    let count: usize = header.number(format_args!("the number of elements"))?;
    let corners: usize = header.number(format_args!("the number of corners per element"))?;
    let attributes = header.number(format_args!("the number of attributes per element"))?;
    header.end(format_args!("the counts of elements"))?;
    if !(3..=4).contains(&corners) {
        return Err(header.problem(ReadProblem::Unsupported(format!(
            "{corners} corners per element"
        ))));
    }
    let mut rows = Rows::new(attributes, false);
    let mut cells = Cells::new();
    for index in 0..count {
        let mut line = lines.due(format_args!("element {index} of {count}"))?;
        check_number(&mut line, "element", index, nodes.base)?;
        let mut corner = |end| {
            point_index(
                &mut line,
                ("element", index),
                end,
                (nodes.base, nodes.points.len()),
            )
        };
        let (a, b, c) = (corner(0)?, corner(1)?, corner(2)?);
        cells.push(if corners == 3 {
            Cell::Triangle([a, b, c])
        } else {
            Cell::Tetrahedron([a, b, c, corner(3)?])
        });
        rows.read(&mut line, "element", index)?;
    }
    lines.end()?;
    let (cell_data, _) = rows.finish();
    Ok(Mesh {
        cells,
        cell_data,
        ..nodes.into()
    })
}

/// Writes the cells of a mesh, counted from 1. Markers become the first attribute, data the others; the format does not keep names.
///
/// # Errors
/// [`WriteProblem::Unsupported`] when not all cells are triangles, or all tetrahedra.
pub fn write_ele(out: &mut impl Write, mesh: &Mesh) -> Result<(), WriteError> {
    mesh.check()?;
    let kind = mesh
        .cells
        .kinds()
        .first()
        .copied()
        .unwrap_or(CellKind::Triangle);
    check_kinds(&mesh.cells, kind)?;
    let attributes = attribute_count(&mesh.cell_data) + usize::from(mesh.cell_markers.is_some());
    writeln!(
        out,
        "{} {} {attributes}",
        mesh.cells.len(),
        kind.corner_count()
    )?;
    for (index, cell) in mesh.cells.iter().enumerate() {
        let mut digits = itoa::Buffer::new();
        out.write_all(digits.format(index + 1).as_bytes())?;
        for &corner in cell.corners() {
            out.write_all(b" ")?;
            out.write_all(digits.format(u64::from(corner) + 1).as_bytes())?;
        }
        if let Some(marker) = mesh
            .cell_markers
            .as_ref()
            .and_then(|markers| markers.get(index))
        {
            write!(out, " {marker}")?;
        }
        write_attributes(out, &mesh.cell_data, index)?;
        writeln!(out)?;
    }
    Ok(())
}

fn check_kinds(cells: &Cells, first: CellKind) -> Result<(), WriteError> {
    let allowed =
        |kind| kind == first && matches!(kind, CellKind::Triangle | CellKind::Tetrahedron);
    match cells
        .kinds()
        .iter()
        .enumerate()
        .find(|&(_, &kind)| !allowed(kind))
    {
        None => Ok(()),
        Some((_, kind)) if *kind == first => refuse(format!("cell 0, a {}", kind.name())),
        Some((index, kind)) => refuse(format!(
            "both a {} and, cell {index}, a {}",
            first.name(),
            kind.name()
        )),
    }
}

fn refuse(what: String) -> Result<(), WriteError> {
    Err(WriteProblem::Unsupported {
        format: Format::TriangleEle,
        what,
    }
    .into())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::DataArray;
    use crate::triangle::parse_node;

    const NODES: &[u8] = b"3 2 0 0\n0 0 0\n1 1 0\n2 0 1\n";

    fn error(text: &str) -> String {
        parse_ele(text.as_bytes(), parse_node(NODES).unwrap())
            .unwrap_err()
            .to_string()
    }

    #[test]
    fn elements_count_from_where_the_points_do() {
        let mesh = parse_ele(b"1 3 1\n0 2 0 1 2.5", parse_node(NODES).unwrap()).unwrap();
        assert_eq!(mesh.cells.iter().next(), Some(Cell::Triangle([2, 0, 1])));
        assert_eq!(
            mesh.cell_data,
            [DataArray::scalar("attribute 0", vec![2.5])]
        );
    }

    #[test]
    fn errors_name_line_and_element() {
        insta::assert_snapshot!(error("1 6 0"), @"line 1: 6 corners per element is not supported");
        insta::assert_snapshot!(error("1 3 0\n1 0 1 2"), @"line 2: expected 0 as the number of the element, found `1`");
        insta::assert_snapshot!(error("1 3 0\n0 0 1 3"), @"line 2: element 0: there is no point 3");
        insta::assert_snapshot!(error("1 3 0\n0 0 1 -1"), @"line 2: element 0: there is no point -1");
        insta::assert_snapshot!(error("1 3 0\n0 0 1"), @"line 2: expected point 2 of element 0, found the end of the line");
        insta::assert_snapshot!(error("99999999999 3 0\n0 0 1 2"), @"line 2: the file ends where element 1 of 99999999999 should follow");
    }

    #[test]
    fn only_one_kind_of_simplex_is_written() {
        let error = |cells: &[Cell]| {
            let mesh = Mesh::new(vec![[0.0; 3]], cells.iter().copied().collect());
            write_ele(&mut Vec::new(), &mesh).unwrap_err()
        };
        let (triangle, quad) = (Cell::Triangle([0; 3]), Cell::Quad([0; 4]));
        insta::assert_snapshot!(error(&[quad]), @"Triangle .ele cannot hold cell 0, a quad");
        insta::assert_snapshot!(error(&[triangle, quad]), @"Triangle .ele cannot hold both a triangle and, cell 1, a quad");
    }
}
