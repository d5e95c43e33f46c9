//! Reads a file section by section.

use super::facets::{Facets, poly_facets, smesh_facets};
use crate::error::{ReadError, ReadProblem};
use crate::lines::Lines;
use crate::piecewise_complex::{PiecewiseComplex, SolidRegion};
use crate::triangle::Nodes;
use crate::triangle::node::section;
use crate::triangle::seeds::{RegionSeed, holes, regions};

/// The complex of a `.poly` of space. When the file has no points of its own, they are those of the `.node` beside it, which `beside`
/// answers.
///
/// A region of negative bound, or without one, has none. A facet without a marker among others that have one has 0.
///
/// # Errors
/// Counts and numbers that do not hold, points that do not exist, coordinates that are not finite, points of the plane; each with its
/// line. What `beside` answers. O(file).
pub fn parse_poly(
    bytes: &[u8],
    beside: impl FnOnce() -> Result<Nodes, ReadError>,
) -> Result<PiecewiseComplex, ReadError> {
    parse(bytes, beside, poly_facets)
}

/// The complex of a `.smesh`, as [`parse_poly`].
///
/// # Errors
/// As [`parse_poly`]. O(file).
pub fn parse_smesh(
    bytes: &[u8],
    beside: impl FnOnce() -> Result<Nodes, ReadError>,
) -> Result<PiecewiseComplex, ReadError> {
    parse(bytes, beside, smesh_facets)
}

/// Whether the header of a `.poly` says that its points are of space.
pub(crate) fn is_of_space(bytes: &[u8]) -> bool {
    let header = Lines::new(bytes).ok().and_then(|mut lines| lines.next());
    header.is_some_and(|mut header| {
        let _count = header.word();
        header.word() == Some("3")
    })
}

fn parse(
    bytes: &[u8],
    beside: impl FnOnce() -> Result<Nodes, ReadError>,
    facets: impl FnOnce(&mut Lines<'_>, &Nodes) -> Result<Facets, ReadError>,
) -> Result<PiecewiseComplex, ReadError> {
    let mut lines = Lines::new(bytes)?;
    let own = section(&mut lines)?;
    let nodes = if own.points.is_empty() {
        beside()?
    } else {
        own
    };
    if nodes.dimension != 3 {
        return Err(ReadProblem::Unsupported("a complex with points of the plane".into()).into());
    }
    let (facets, facet_markers) = facets(&mut lines, &nodes)?;
    let holes = if lines.is_at_end() {
        Vec::new()
    } else {
        holes(&mut lines)?
    };
    let regions = regions(&mut lines, "volume")?;
    lines.end()?;
    Ok(PiecewiseComplex {
        points: nodes.points,
        point_markers: nodes.markers,
        point_data: nodes.data,
        facets,
        facet_markers,
        holes,
        regions: regions.into_iter().map(region).collect(),
    })
}

fn region(seed: RegionSeed<3>) -> SolidRegion {
    SolidRegion {
        seed: seed.place,
        attribute: seed.attribute,
        max_volume: seed.bound,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::triangle::parse_node;

    /// A cube with a hole through its floor, as the manual writes such a file.
    const PLATE: &str = "\
        # Part 1 - the node list\n8 3 0 1\n\
        1 0 0 0 1\n2 4 0 0 1\n3 4 4 0 1\n4 0 4 0 1\n5 1 1 0 1\n6 2 1 0 1\n7 2 2 0 1\n8 1 2 0 1\n\
        # Part 2 - the facet list\n3 1\n\
        2 1 5  # two polygons, one hole, marker 5\n4  1 2 3 4\n4  5 6\n     7 8\n1  1.5 1.5 0\n\
        1 0 6\n3  1 2 3\n\
        1\n2  1 3\n\
        # Part 3 - the hole list\n1\n1  9 9 9\n\
        # Part 4 - the region list\n2\n1  0.5 0.5 0.5  10  0.1\n2  3 3 3  20\n";

    fn none() -> Result<Nodes, ReadError> {
        Err(ReadProblem::UnknownFormat.into())
    }

    #[test]
    fn polygons_holes_markers_and_seeds_are_kept() {
        let complex = parse_poly(PLATE.as_bytes(), none).unwrap();
        assert_eq!(complex.check(), Ok(()));
        assert_eq!(complex.points[2], [4.0, 4.0, 0.0]);
        assert_eq!(complex.point_markers, Some(vec![1; 8]));
        let [plate, triangle, segment] = &complex.facets[..] else {
            panic!("{:?}", complex.facets);
        };
        assert_eq!(plate.polygons, [[0, 1, 2, 3], [4, 5, 6, 7]]);
        assert_eq!(plate.holes, [[1.5, 1.5, 0.0]]);
        assert_eq!(triangle.polygons, [[0, 1, 2]]);
        assert_eq!(segment.polygons, [[0, 2]]);
        assert_eq!(complex.facet_markers, Some(vec![5, 6, 0]));
        assert_eq!(complex.holes, [[9.0; 3]]);
        let bounds: Vec<_> = complex
            .regions
            .iter()
            .map(|r| (r.attribute, r.max_volume))
            .collect();
        assert_eq!(bounds, [(10.0, Some(0.1)), (20.0, None)]);
    }

    #[test]
    fn a_smesh_has_a_polygon_a_line_and_may_end_after_its_facets() {
        let nodes = || parse_node(b"4 3 0 0\n0 0 0 0\n1 1 0 0\n2 0 1 0\n3 0 0 1\n");
        let text = "0 3 0 0\n2 1\n3 0 1 2 -7\n4 0 1\n 3 2\n";
        let complex = parse_smesh(text.as_bytes(), nodes).unwrap();
        let corners: Vec<_> = complex
            .facets
            .iter()
            .map(|facet| &facet.polygons[0])
            .collect();
        assert_eq!(corners, [&vec![0, 1, 2], &vec![0, 1, 3, 2]]);
        assert_eq!(complex.facet_markers, Some(vec![-7, 0]));
        insta::assert_snapshot!(complex.into_mesh().unwrap_err(), @"facet 1 is no triangle: it has 4 corners");
        let error = |text: &str| parse_smesh(text.as_bytes(), nodes).unwrap_err();
        insta::assert_snapshot!(error("0 3 0 0\n1 0\n3 0 1 4\n"), @"line 3: facet 0: there is no point 4");
        insta::assert_snapshot!(error("0 3 0 0\n1 0\n3 0 1 2 9\n"), @"line 3: expected nothing after facet 0, found `9`");
        insta::assert_snapshot!(error("0 3 0 0\n1 1\n3 0 1 2 x\n"), @"line 3: expected the marker of facet 0, found `x`");
        insta::assert_snapshot!(error("0 3 0 0\n1 0\n3 0 1\n"), @"line 3: the file ends where point 2 of facet 0 should follow");
        insta::assert_snapshot!(error("0 3 0 0\n1 0\n0\n"), @"line 3: expected a polygon with corners in facet 0, found `0`");
    }

    #[test]
    fn errors_name_line_and_element() {
        let error = |from: &str, to: &str| {
            assert!(PLATE.contains(from), "{from}");
            parse_poly(PLATE.replacen(from, to, 1).as_bytes(), none).unwrap_err()
        };
        insta::assert_snapshot!(error("8 3 0 1", "8 2 0 1"), @"line 3: expected nothing after point 0, found `1`");
        insta::assert_snapshot!(error("7 8", "7 9"), @"line 16: facet 0: there is no point 9");
        insta::assert_snapshot!(error("7 8", "7 8 1"), @"line 16: expected nothing after polygon 1 of facet 0, found `1`");
        insta::assert_snapshot!(error("1.5 1.5 0", "1.5 inf 0"), @"line 17: hole 0: y is inf, which is not a finite number");
        insta::assert_snapshot!(error("2 1 5", "-2 1 5"), @"line 13: expected the number of polygons of facet 0, found `-2`");
        insta::assert_snapshot!(error("3 1\n", "4 1\n"), @"line 24: facet 3: there is no point 9");
        insta::assert_snapshot!(error("10  0.1", "10  nan"), @"line 27: expected the largest volume of region 0, found `nan`");
        let plane = parse_poly(b"1 2 0 0\n1 0 0\n0 0\n0", none).unwrap_err();
        insta::assert_snapshot!(plane, @"a complex with points of the plane is not supported");
    }

    #[test]
    fn counts_that_nothing_backs_cost_nothing() {
        let huge = "1 3 0 0\n1 0 0 0\n999999999999 0\n999999999999 999999999999\n999999999999 1\n";
        insta::assert_snapshot!(parse_poly(huge.as_bytes(), none).unwrap_err(), @"line 5: the file ends where point 1 of facet 0 should follow");
    }
}
