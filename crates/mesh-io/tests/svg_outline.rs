//! Outlines of drawings as programs write them, and of drawings spoiled at random.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

mod spoiled;

use std::f64::consts::PI;
use std::time::{Duration, Instant};

use mesh_io::{PlanarGraph, read_planar_graph, svg_outline};
use proptest::prelude::*;
use spoiled::{spoiled, spoils};

/// A plate of 40 by 20 with round corners of 5, a round hole of radius 4 and a slot: half circles of radius 2 at the ends of
/// two lines of 6. All of it is turned, mirrored and enlarged by 1.5 in nested layers.
const PLATE: &str = r##"<?xml version="1.0" encoding="UTF-8" standalone="no"?>
<!-- Created with Inkscape (http://www.inkscape.org/) -->
<svg width="210mm" height="297mm" viewBox="0 0 210 297" version="1.1" id="svg5"
   xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape"
   xmlns:sodipodi="http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd"
   xmlns="http://www.w3.org/2000/svg">
  <sodipodi:namedview id="namedview7" pagecolor="#ffffff" inkscape:zoom="0.74"><inkscape:grid type="xygrid" /></sodipodi:namedview>
  <defs id="defs2"><clipPath id="clip"><rect width="1000" height="1000" /></clipPath></defs>
  <g inkscape:label="Construction" inkscape:groupmode="layer" id="layer2" style="display:none"><path d="M -500,-500 500,500" /></g>
  <g inkscape:label="Layer 1" inkscape:groupmode="layer" id="layer1" transform="translate(30,-12.5)">
    <g id="g88" transform="matrix(0.8660254037844386,0.5,-0.5,0.8660254037844386,10,20)">
      <rect style="fill:#80e5ff;stroke-width:0.26" id="rect31" transform="scale(-1.5,1.5)" x="-20" y="-10" width="40" height="20" ry="5" />
      <g transform="rotate(180) scale(1.5)" id="g90">
        <path id="path55" style="fill:#ffffff" sodipodi:type="arc" d="m 14,0 a 4,4 0 0 1 -4,4 4,4 0 0 1 -4,-4 4,4 0 0 1 4,-4 4,4 0 0 1 4,4 z" />
        <path id="path60" d="M -12,-2 H -6 A 2,2 0 0 1 -6,2 h -6 a 2,2 0 0 1 0,-4 z" />
      </g>
    </g>
  </g>
</svg>
"##;

/// The areas of loops that are drawn one after the other.
fn areas(graph: &PlanarGraph) -> Vec<f64> {
    let mut areas = Vec::new();
    let (mut twice, mut first) = (0.0, None);
    for &[from, to] in &graph.segments {
        let first = &mut first;
        let begin = *first.get_or_insert(from);
        let ([ax, ay], [bx, by]) = (graph.points[from as usize], graph.points[to as usize]);
        twice += ax * by - bx * ay;
        if to == begin {
            areas.push(f64::abs(twice) / 2.0);
            (twice, *first) = (0.0, None);
        }
    }
    assert_eq!(first, None, "the last loop is open");
    areas
}

#[test]
fn a_drawing_with_layers_keeps_its_areas() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("plate.svg");
    std::fs::write(&path, PLATE).unwrap();
    let graph = read_planar_graph(&path).unwrap();
    assert!(graph.holes.is_empty() && graph.regions.is_empty());
    assert!(graph.point_markers.is_none() && graph.segment_markers.is_none());

    // Area and perimeter of plate, hole and slot.
    let expected = [
        (
            40.0 * 20.0 - (4.0 - PI) * 25.0,
            2.0 * (30.0 + 10.0) + 10.0 * PI,
        ),
        (16.0 * PI, 8.0 * PI),
        (6.0 * 4.0 + 4.0 * PI, 12.0 + 4.0 * PI),
    ];
    let areas = areas(&graph);
    assert_eq!(areas.len(), expected.len());
    // No wider than the plate unturned.
    let stray = svg_outline::FLATNESS * 1.5 * f64::hypot(40.0, 20.0);
    for (area, (exact, perimeter)) in areas.into_iter().zip(expected) {
        let lost = exact * 2.25 - area;
        assert!(
            (0.0..=perimeter * 1.5 * stray).contains(&lost),
            "{area} {exact}"
        );
    }
    // The centre of the hole, 15 from that of the plate at 30 degrees, which is (40, 7.5) before the flip.
    let centre = [40.0 - 15.0 * 0.75_f64.sqrt(), 0.0];
    let hole = graph
        .points
        .iter()
        .filter(|[x, y]| ((x - centre[0]).hypot(y - centre[1]) - 6.0).abs() < 1e-3);
    assert!(hole.count() >= 12);
}

#[test]
fn hostile_drawings_are_answered_soon() {
    let soon = |elements: &str| {
        let start = Instant::now();
        let drawing = format!("<svg xmlns='http://www.w3.org/2000/svg'>{elements}</svg>");
        let answer = svg_outline::parse(drawing.as_bytes());
        let took = start.elapsed();
        assert!(took < Duration::from_secs(10), "{took:?}");
        answer
    };
    // Nested and wide; curves whose control points overflow; nothing that bends; arcs of all sizes.
    assert!(soon(&"<g>".repeat(1_000_000)).is_err());
    assert!(soon(&"<g><line x2='1'/></g>\n".repeat(100_000)).is_ok());
    assert!(
        soon(&format!(
            "<g {}><line x2='1'/></g>",
            "a='' ".repeat(100_000)
        ))
        .is_ok()
    );
    for size in ["1e-320", "1e-160", "1e-5", "1e150", "4e307"] {
        let d = format!(
            "M0 0C{size} 0 0 {size} {size} {size}q-{size} 0 -{size}-{size}a{size} 1 45 1 1 1 1A1 1e-9 0 0 1 {size} 0"
        );
        if let Ok(graph) = soon(&format!("<path d='{d}'/>")) {
            assert!(graph.points.len() < 2000, "{size}: {}", graph.points.len());
        }
    }
    assert!(
        soon(&format!(
            "<path d='M0 0{}'/>",
            "a1 1 0 0 1 2 0 1 1 0 0 1-2 0".repeat(100_000)
        ))
        .is_ok()
    );
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn spoiled_drawings_make_sound_graphs_or_errors(spoils in spoils()) {
        if let Ok(graph) = svg_outline::parse(&spoiled(PLATE.as_bytes(), &spoils)) {
            prop_assert_eq!(graph.as_mesh().check(), Ok(()));
            prop_assert!(graph.segments.iter().all(|[a, b]| a != b));
            let named: std::collections::HashSet<u32> = graph.segments.iter().flatten().copied().collect();
            prop_assert_eq!(named.len(), graph.points.len());
        }
    }

    #[test]
    fn any_path_data_make_a_graph_or_an_error(data in "([MmLlHhVvCcSsQqTtAaZz] ?([-+]?[0-9]{0,2}[.]?[0-9]{0,3}(e-?[0-9]{1,3})?[ ,é]?){0,7}){0,12}") {
        let drawing = format!("<svg><path d='M0 0L1 1 {data}'/></svg>");
        if let Ok(graph) = svg_outline::parse(drawing.as_bytes()) {
            prop_assert_eq!(graph.as_mesh().check(), Ok(()));
        }
    }
}
