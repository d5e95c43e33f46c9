//! The arrays that a VTU is written with.

use std::io::{self, Write};

use base64::engine::general_purpose::STANDARD;
use base64::write::EncoderWriter;
use quick_xml::escape::escape;

use super::{turn_wedge, vtk_type};
use crate::cell::{CellKind, Cells};

/// An array of the file.
pub(super) struct Array<'a> {
    pub(super) name: &'a str,
    pub(super) components: usize,
    pub(super) values: Values<'a>,
}

/// Numbers of the mesh, which are not copied.
#[derive(Clone, Copy)]
pub(super) enum Values<'a> {
    Points(&'a [[f64; 3]]),
    Doubles(&'a [f64]),
    Markers(&'a [i32]),
    /// The corners of all cells in VTK's order.
    Corners(&'a Cells, Width),
    /// Where the corners of each cell end in the list of all corners.
    Ends(&'a Cells, Width),
    /// VTK's numbers of the kinds of the cells.
    Types(&'a Cells),
    /// The same number of a kind for so many cells.
    Type(u8, usize),
    /// The numbers from 0 on, so many.
    Counted(usize, Width),
    Indices(&'a [u32], Width),
    /// Numbers that fit the width.
    Positions(&'a [u64], Width),
}

/// Bytes of an index.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Width {
    Four,
    Eight,
}

impl Width {
    /// The narrower one, where it can number everything up to `greatest`.
    pub(super) fn for_numbers_to(greatest: usize) -> Self {
        match i32::try_from(greatest) {
            Ok(_) => Self::Four,
            Err(_) => Self::Eight,
        }
    }

    const fn bytes(self) -> usize {
        match self {
            Self::Four => 4,
            Self::Eight => 8,
        }
    }
}

impl Array<'_> {
    /// The element: a header with the number of bytes, and the bytes, all in one run of base64.
    pub(super) fn write(&self, out: &mut impl Write) -> io::Result<()> {
        let (number, name) = (self.values.number(), escape(self.name));
        write!(out, "<DataArray type=\"{number}\" Name=\"{name}\"")?;
        if self.components != 1 {
            // Where it is written, some readers make a column of a scalar.
            write!(out, " NumberOfComponents=\"{}\"", self.components)?;
        }
        out.write_all(b" format=\"binary\">\n")?;
        self.write_base64(out)?;
        out.write_all(b"\n</DataArray>\n")
    }

    fn write_base64(&self, out: &mut impl Write) -> io::Result<()> {
        let mut encoder = EncoderWriter::new(out, &STANDARD);
        encoder.write_all(&self.values.bytes().to_le_bytes())?;
        self.values.write(&mut encoder)?;
        encoder.finish().map(drop)
    }
}

impl Values<'_> {
    /// VTK's name of the numbers.
    const fn number(self) -> &'static str {
        match self {
            Self::Points(_) | Self::Doubles(_) => "Float64",
            Self::Markers(_) => "Int32",
            Self::Corners(_, Width::Four) | Self::Ends(_, Width::Four) => "Int32",
            Self::Corners(_, Width::Eight) | Self::Ends(_, Width::Eight) => "Int64",
            Self::Counted(_, Width::Four)
            | Self::Indices(_, Width::Four)
            | Self::Positions(_, Width::Four) => "Int32",
            Self::Counted(_, Width::Eight)
            | Self::Indices(_, Width::Eight)
            | Self::Positions(_, Width::Eight) => "Int64",
            Self::Types(_) | Self::Type(..) => "UInt8",
        }
    }

    fn bytes(self) -> u64 {
        let bytes = match self {
            Self::Points(points) => size_of_val(points),
            Self::Doubles(values) => size_of_val(values),
            Self::Markers(values) => size_of_val(values),
            Self::Corners(cells, width) => cells.corners().len() * width.bytes(),
            Self::Ends(cells, width) => cells.len() * width.bytes(),
            Self::Types(cells) => cells.len(),
            Self::Type(_, count) => count,
            Self::Counted(count, width) => count * width.bytes(),
            Self::Indices(indices, width) => indices.len() * width.bytes(),
            Self::Positions(positions, width) => positions.len() * width.bytes(),
        };
        bytes as u64
    }

    fn write(self, out: &mut impl Write) -> io::Result<()> {
        match self {
            Self::Points(points) => write_each(out, points.as_flattened(), f64::to_le_bytes),
            Self::Doubles(values) => write_each(out, values, f64::to_le_bytes),
            Self::Markers(values) => write_each(out, values, i32::to_le_bytes),
            Self::Corners(cells, width) => write_corners(out, cells, width),
            Self::Ends(cells, width) => write_ends(out, cells, width),
            Self::Types(cells) => write_each(out, cells.kinds(), |kind| [vtk_type(kind)]),
            Self::Type(kind, count) => write_repeated(out, kind, count),
            Self::Counted(count, width) => write_positions(out, 0..count as u64, width),
            Self::Indices(indices, width) => write_indices(out, indices, width),
            Self::Positions(positions, width) => {
                write_positions(out, positions.iter().copied(), width)
            }
        }
    }
}

/// Numbers that are gathered before they are encoded: asked number by number, the encoder would take many times as long.
const GATHERED: usize = 3 << 10;

fn write_each<T: Copy, const N: usize>(
    out: &mut impl Write,
    values: &[T],
    bytes: impl Fn(T) -> [u8; N],
) -> io::Result<()> {
    let mut gathered = [[0; N]; GATHERED];
    for chunk in values.chunks(GATHERED) {
        let filled = &mut gathered[..chunk.len()];
        for (slot, &value) in filled.iter_mut().zip(chunk) {
            *slot = bytes(value);
        }
        out.write_all(filled.as_flattened())?;
    }
    Ok(())
}

fn write_repeated(out: &mut impl Write, byte: u8, count: usize) -> io::Result<()> {
    let gathered = [byte; GATHERED];
    for written in (0..count).step_by(GATHERED) {
        out.write_all(&gathered[..(count - written).min(GATHERED)])?;
    }
    Ok(())
}

fn write_corners(out: &mut impl Write, cells: &Cells, width: Width) -> io::Result<()> {
    if !cells.kinds().contains(&CellKind::Wedge) {
        return write_indices(out, cells.corners(), width);
    }
    let turned = cells.iter().flat_map(|cell| {
        let count = cell.corners().len();
        let mut corners = [0; 8];
        corners[..count].copy_from_slice(cell.corners());
        if cell.kind() == CellKind::Wedge {
            turn_wedge(&mut corners);
        }
        corners.into_iter().take(count)
    });
    write_indices(out, &turned.collect::<Vec<_>>(), width)
}

fn write_indices(out: &mut impl Write, indices: &[u32], width: Width) -> io::Result<()> {
    match width {
        Width::Four => write_each(out, indices, u32::to_le_bytes),
        Width::Eight => write_each(out, indices, |index| u64::from(index).to_le_bytes()),
    }
}

fn write_ends(out: &mut impl Write, cells: &Cells, width: Width) -> io::Result<()> {
    let kinds = cells.kinds().iter();
    let ends = kinds.scan(0, |end, kind| {
        *end += kind.corner_count() as u64;
        Some(*end)
    });
    write_positions(out, ends, width)
}

fn write_positions(
    out: &mut impl Write,
    mut positions: impl Iterator<Item = u64>,
    width: Width,
) -> io::Result<()> {
    loop {
        let chunk: Vec<u64> = positions.by_ref().take(GATHERED).collect();
        match width {
            _ if chunk.is_empty() => return Ok(()),
            // They fit: the width was chosen so.
            Width::Four => write_each(out, &chunk, |position| (position as u32).to_le_bytes())?,
            Width::Eight => write_each(out, &chunk, u64::to_le_bytes)?,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn indices_are_wide_only_where_they_must_be() {
        assert_eq!(Width::for_numbers_to(i32::MAX as usize), Width::Four);
        assert_eq!(Width::for_numbers_to(i32::MAX as usize + 1), Width::Eight);
    }

    #[test]
    fn wide_and_narrow_indices_are_the_same_numbers() {
        let cells = Cells::of_triangles(vec![[0, 1, 2], [7, 5, u32::MAX]]);
        let written = |values: Values<'_>| {
            let mut out = Vec::new();
            values.write(&mut out).unwrap();
            assert_eq!(out.len() as u64, values.bytes());
            out
        };
        for values in [Values::Corners, Values::Ends] {
            let narrow = written(values(&cells, Width::Four));
            let wide = written(values(&cells, Width::Eight));
            let narrow = narrow
                .as_chunks()
                .0
                .iter()
                .map(|&word| u64::from(u32::from_le_bytes(word)));
            let wide = wide
                .as_chunks()
                .0
                .iter()
                .map(|&word| u64::from_le_bytes(word));
            assert!(narrow.eq(wide));
        }
    }
}
