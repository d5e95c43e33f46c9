//! Writes a `.poly`.

use std::io::{self, Write};

use crate::error::WriteError;
use crate::piecewise_complex::PiecewiseComplex;
use crate::triangle::rows::{attribute_count, write_attributes, write_marker};

/// Writes a complex, counted from 1, so that reading gives the same bits. Point data become attributes, whose names the format does not
/// keep. O(size of the complex).
///
/// # Errors
/// What [`PiecewiseComplex::check`] answers.
pub fn write_poly(out: &mut impl Write, complex: &PiecewiseComplex) -> Result<(), WriteError> {
    complex.check()?;
    write_points(out, complex)?;
    write_facets(out, complex)?;
    writeln!(out, "{}", complex.holes.len())?;
    write_holes(out, &complex.holes)?;
    if !complex.regions.is_empty() {
        writeln!(out, "{}", complex.regions.len())?;
    }
    for (index, region) in complex.regions.iter().enumerate() {
        let ([x, y, z], attribute) = (region.seed, region.attribute);
        let bound = region.max_volume.unwrap_or(-1.0);
        writeln!(
            out,
            "{} {x:?} {y:?} {z:?} {attribute:?} {bound:?}",
            index + 1
        )?;
    }
    Ok(())
}

fn write_points(out: &mut impl Write, complex: &PiecewiseComplex) -> io::Result<()> {
    let attributes = attribute_count(&complex.point_data);
    let markers = complex.point_markers.as_deref();
    let marked = u8::from(markers.is_some());
    writeln!(out, "{} 3 {attributes} {marked}", complex.points.len())?;
    for (index, [x, y, z]) in complex.points.iter().enumerate() {
        write!(out, "{} {x:?} {y:?} {z:?}", index + 1)?;
        write_attributes(out, &complex.point_data, index)?;
        write_marker(out, markers, index)?;
    }
    Ok(())
}

fn write_facets(out: &mut impl Write, complex: &PiecewiseComplex) -> io::Result<()> {
    let markers = complex.facet_markers.as_deref();
    writeln!(
        out,
        "{} {}",
        complex.facets.len(),
        u8::from(markers.is_some())
    )?;
    for (index, facet) in complex.facets.iter().enumerate() {
        write!(out, "{} {}", facet.polygons.len(), facet.holes.len())?;
        write_marker(out, markers, index)?;
        for polygon in &facet.polygons {
            write!(out, "{}", polygon.len())?;
            for &corner in polygon {
                write!(out, " {}", u64::from(corner) + 1)?;
            }
            writeln!(out)?;
        }
        write_holes(out, &facet.holes)?;
    }
    Ok(())
}

fn write_holes(out: &mut impl Write, holes: &[[f64; 3]]) -> io::Result<()> {
    let mut numbered = (1..).zip(holes);
    numbered
        .try_for_each(|(number, [x, y, z]): (u64, _)| writeln!(out, "{number} {x:?} {y:?} {z:?}"))
}
