//! What each element becomes, and what is refused.

use super::*;

/// A drawing of some elements, on a line of their own.
fn drawing(elements: &str) -> String {
    format!("<svg xmlns=\"http://www.w3.org/2000/svg\">\n{elements}\n</svg>\n")
}

fn graph(elements: &str) -> PlanarGraph {
    parse(drawing(elements).as_bytes()).unwrap()
}

fn error(elements: &str) -> String {
    parse(drawing(elements).as_bytes()).unwrap_err().to_string()
}

/// Points and segments, to be read.
fn shown(elements: &str) -> String {
    let graph = graph(elements);
    let points: Vec<String> = graph
        .points
        .iter()
        .map(|[x, y]| format!("({x} {y})"))
        .collect();
    let segments: Vec<String> = graph
        .segments
        .iter()
        .map(|[a, b]| format!("{a}-{b}"))
        .collect();
    format!("{} | {}", points.join(" "), segments.join(" "))
}

#[test]
fn straight_shapes_are_their_corners_with_y_up() {
    insta::assert_snapshot!(shown("<polygon points='0,0 2,0 2,1'/>"), @"(0 0) (2 0) (2 -1) | 0-1 1-2 2-0");
    insta::assert_snapshot!(shown("<polyline points='0 0 2 0 2 1'/>"), @"(0 0) (2 0) (2 -1) | 0-1 1-2");
    insta::assert_snapshot!(shown("<polyline points='0 0 2 0 2 1 0 0'/>"), @"(0 0) (2 0) (2 -1) | 0-1 1-2 2-0");
    insta::assert_snapshot!(shown("<rect x='1' y='2px' width='3' height='4'/>"), @"(1 -2) (4 -2) (4 -6) (1 -6) | 0-1 1-2 2-3 3-0");
    insta::assert_snapshot!(shown("<line x2='3' y2='-1'/>"), @"(0 0) (3 1) | 0-1");
    insta::assert_snapshot!(shown("<path d='m1 1h2v2H1zl-1-1M5 5L6 6'/>"), @"(1 -1) (3 -1) (3 -3) (1 -3) (0 0) (5 -5) (6 -6) | 0-1 1-2 2-3 3-0 0-4 5-6");
}

#[test]
fn places_are_points_and_segments_are_kept_once() {
    // Two squares that share a side, drawn twice the other way round; a corner said twice.
    insta::assert_snapshot!(shown("<path d='M0 0H1V1V1H0ZM1 0V1H2V0Z'/><line x1='1' y1='1' x2='1'/>"), @"(0 0) (1 0) (1 -1) (0 -1) (2 -1) (2 0) | 0-1 1-2 2-3 3-0 2-4 4-5 5-1");
    // A point alone has no segment, and zero has one sign.
    insta::assert_snapshot!(shown("<path d='M9 9M8 8zM0 -0L-0 1'/><line x2='0' y1='1'/>"), @"(0 0) (0 -1) | 0-1");
}

#[test]
fn no_chord_is_as_short_as_a_rounding_error() {
    let loops = [
        graph("<path d='m.1 .1l.2 0 0 .2-.2 0 0-.2z'/>"),
        graph("<path d='m.1 .1q.1 .3 .2 0c0 .3 .1 .3-.2 .2l0-.2z'/>"),
        graph("<rect x='.1' y='.7' width='.3' height='.1' rx='.2' ry='.03'/>"),
    ];
    for graph in loops {
        assert_eq!(graph.points.len(), graph.segments.len());
        for [a, b] in graph.segments {
            let ([ax, ay], [bx, by]) = (graph.points[a as usize], graph.points[b as usize]);
            assert!((bx - ax).hypot(by - ay) > 1e-3);
        }
    }
    // Whoever draws a short line means it.
    let graph = graph("<path d='M0 0H1V1L1e-9 1e-9z'/>");
    assert_eq!(graph.points.len(), 4);
}

#[test]
fn transforms_are_applied_from_the_inside() {
    insta::assert_snapshot!(shown("<g transform='translate(10 20)'><a transform='scale(2)'><line transform='matrix(0 1 1 0 0 0)' x1='1' x2='3'/></a></g><line x2='1'/>"), @"(10 -22) (10 -26) (0 0) (1 0) | 0-1 2-3");
    insta::assert_snapshot!(shown("<svg:svg transform='translate(1)'><switch><svg:line x2='1' transform=''/></switch></svg:svg>"), @"(1 0) (2 0) | 0-1");
}

#[test]
fn what_is_not_drawn_is_ignored() {
    let hidden = "<defs><path d='M0 0L1 1'/></defs><clipPath><g><rect width='1' height='1'/></g></clipPath><mask><circle r='1'/></mask>\
        <symbol><circle r='1'/></symbol><pattern><circle r='1'/></pattern><marker><circle r='bad'/></marker>\
        <g display='none'><line x2='1'/></g><g style='opacity:1;display: none'><line x2='1'/></g><line x2='1' style='display:none!important'/>\
        <text x='1'>word</text><image width='1' height='1'/><use href='#a'/><inkscape:path d='M0 0L1 1'/><path/><polygon/><circle r='0'/>\
        <rect width='0' height='1'/><metadata>&unknown; <![CDATA[<]]></metadata>";
    insta::assert_snapshot!(error(hidden), @"the drawing has no outline: no path, polygon, rect, circle or the like of any size");
    insta::assert_snapshot!(shown(&format!("{hidden}<line display='none' style='display:inline' x2='1'/>")), @"(0 0) (1 0) | 0-1");
}

/// The farthest that points of a curve, given by a parameter from 0 to 1, are from the segments.
fn strays(graph: &PlanarGraph, curve: impl Fn(f64) -> [f64; 2]) -> f64 {
    let distance = |[x, y]: [f64; 2], [a, b]: [u32; 2]| {
        let ([ax, ay], [bx, by]) = (graph.points[a as usize], graph.points[b as usize]);
        let (ux, uy) = (bx - ax, by - ay);
        let along = (((x - ax) * ux + (y - ay) * uy) / (ux * ux + uy * uy)).clamp(0.0, 1.0);
        (ax + along * ux - x).hypot(ay + along * uy - y)
    };
    (0..=2000)
        .map(|step| {
            let place = curve(f64::from(step) / 2000.0);
            let distances = graph
                .segments
                .iter()
                .map(|&segment| distance(place, segment));
            distances.fold(f64::INFINITY, f64::min)
        })
        .fold(0.0, f64::max)
}

#[test]
fn chords_stray_by_no_more_than_the_share_of_the_diagonal() {
    let turn = |t: f64| (t * std::f64::consts::TAU).sin_cos();
    let ellipse = |rx: f64, ry: f64| {
        move |t: f64| {
            let (sin, cos) = turn(t);
            [rx * cos, -ry * sin]
        }
    };
    let share = |graph: &PlanarGraph, stray: f64, width: f64, height: f64| {
        assert_eq!(graph.points.len(), graph.segments.len());
        let share = stray / width.hypot(height);
        assert!(share <= FLATNESS, "{share}");
        // Nor are there many more points than the share asks for.
        assert!(share >= 0.5 * FLATNESS, "{share}");
    };
    let circle = graph("<circle r='1e-7'/>");
    share(&circle, strays(&circle, ellipse(1e-7, 1e-7)), 2e-7, 2e-7);
    let flat = graph("<g transform='scale(1e3 1e-3)'><circle r='1'/></g>");
    assert!(strays(&flat, ellipse(1e3, 1e-3)) <= FLATNESS * 2e3);
    let arcs = graph("<path d='M3 0A3 2 0 0 1-3 0 3 2 0 1 1 3 0'/>");
    share(&arcs, strays(&arcs, ellipse(3.0, 2.0)), 6.0, 4.0);

    let cubic = graph("<path d='M0 0C0 4 3 4 3 0z'/>");
    let at = |t: f64| {
        [
            9.0 * (1.0 - t) * t * t + 3.0 * t * t * t,
            -12.0 * t * (1.0 - t),
        ]
    };
    share(&cubic, strays(&cubic, at), 3.0, 3.0);
    let quadratic = graph("<path d='M0 0Q1 2 2 0z'/>");
    let at = |t: f64| [2.0 * t, -4.0 * t * (1.0 - t)];
    share(&quadratic, strays(&quadratic, at), 2.0, 1.0);
}

#[test]
fn smooth_curves_continue_only_curves_of_their_kind() {
    let same = |one: &str, other: &str| {
        assert_eq!(
            graph(&format!("<path d='{one}'/>")),
            graph(&format!("<path d='{other}'/>"))
        );
    };
    same("M0 0C0 1 1 2 2 2S5 3 6 6", "M0 0C0 1 1 2 2 2C3 2 5 3 6 6");
    same("M0 0q1 2 2 0t2 0t2 0", "M0 0Q1 2 2 0Q3-2 4 0Q5 2 6 0");
    same("M0 0C0 1 1 2 2 2T4 4", "M0 0C0 1 1 2 2 2Q2 2 4 4");
    same("M0 0Q1 2 2 0s1 1 2 2", "M0 0Q1 2 2 0C2 0 3 1 4 2");
    same("M1 1a2 2 0 01 2 0", "M1 1A-2 2 0 0 1 3 1");
}

#[test]
fn arcs_without_size_are_straight_and_short_radii_grow() {
    insta::assert_snapshot!(shown("<path d='M0 0A0 0 0 0 1 1 0A0 5 0 0 1 2 0A5 5 0 0 1 2 0'/>"), @"(0 0) (1 0) (2 0) | 0-1 1-2");
    let grown = graph("<path d='M-1 0A.1 .1 0 0 1 1 0'/>");
    assert!(
        grown
            .points
            .iter()
            .all(|[x, y]| (x.hypot(*y) - 1.0).abs() < 1e-5)
    );
    assert!(grown.points.iter().any(|[_, y]| *y > 0.9));
}

#[test]
fn round_corners_are_no_wider_than_half_the_rect() {
    let ellipse = graph("<ellipse cx='3' cy='1' rx='3' ry='1'/>");
    let rect = graph("<rect width='6' height='2' rx='4' ry='1.5'/>");
    assert_eq!(rect.points.len(), ellipse.points.len());
    assert!(rect.points.contains(&[6.0, -1.0]) && ellipse.points.contains(&[6.0, -1.0]));
    let one = graph("<rect width='6' height='2' rx='.5'/>");
    assert_eq!(one, graph("<rect width='6' height='2' ry='.5' rx='auto'/>"));
    assert!(one.points.contains(&[0.5, 0.0]) && !one.points.contains(&[0.0, 0.0]));
}

#[test]
fn errors_name_line_and_element() {
    insta::assert_snapshot!(error("<path id='a' d='M0 0 L1'/>"), @"line 2: <path id=`a`>: d is not valid: unexpected end of stream");
    insta::assert_snapshot!(error("<path\nid='a' d='L1 1'/>"), @"line 2: <path id=`a`>: d is not valid: unexpected data at position 1");
    insta::assert_snapshot!(error("\n<path d='M0 0 L1 1e999'/>"), @"line 3: <path>: d is not valid: invalid number at position 9");
    insta::assert_snapshot!(error("<polygon points='1 2 3'/>"), @"line 2: <polygon>: points is not valid: 3 numbers make no points");
    insta::assert_snapshot!(error("<polyline points='1 2 x 4'/>"), @"line 2: <polyline>: points is not valid: invalid number at position 5");
    insta::assert_snapshot!(error("<rect width='wide'/>"), @"line 2: <rect>: width is not valid: `wide` is no number");
    insta::assert_snapshot!(error("<rect id='b' width='3mm'/>"), @"line 2: <rect id=`b`>: the unit of width in `3mm` is not supported");
    insta::assert_snapshot!(error("<circle r='-1'/>"), @"line 2: <circle>: r is -1, which is negative");
    insta::assert_snapshot!(error("<ellipse id='&lt;&#10;>' rx='1' ry='-1'/>"), @"line 2: <ellipse id=`<�>`>: ry is -1, which is negative");
    insta::assert_snapshot!(error("<g id='layer' transform='turn(3)'/>"), @"line 2: <g id=`layer`>: transform is not valid: unexpected data at position 1");
    insta::assert_snapshot!(error("<g transform='scale(1e300)'><line id='c' x2='1e300'/></g>"), @"line 2: <line id=`c`>: not all coordinates are finite numbers");
    insta::assert_snapshot!(error("<line x1='-1e308' x2='1e308'/>"), @"the bounding box of the drawing has no finite diagonal");
    insta::assert_snapshot!(error("<svg x='3'><line x2='1'/></svg>"), @"line 2: x of the nested <svg> is not supported");
    insta::assert_snapshot!(error("<g id='&mine;'><path d='&mine;'/></g>"), @"line 2: at 1..5: unrecognized entity `mine`");
    insta::assert_snapshot!(error(&"<g>".repeat(256)), @"line 2: <g>: nested deeper than 256 elements");
}

#[test]
fn documents_must_be_whole_and_svg() {
    let error = |text: &[u8]| parse(text).unwrap_err().to_string();
    insta::assert_snapshot!(error(b""), @"line 1: the file ends where an <svg> should follow");
    insta::assert_snapshot!(error(b"<svg>\n<g>"), @"line 2: the file ends where the end of an element should follow");
    insta::assert_snapshot!(error(b"<svg>\n<g></svg>"), @"line 2: ill-formed document: expected `</g>`, but `</svg>` was found");
    insta::assert_snapshot!(error(b"<svg><line x2='1/></svg>"), @"line 1: syntax error: attribute value not closed: `'` not found before end of input");
    insta::assert_snapshot!(error(b"<html/>"), @"line 1: expected an <svg>, found `html`");
    insta::assert_snapshot!(error(b"<svg/><svg/>"), @"line 1: expected nothing after </svg>, found `svg`");
    insta::assert_snapshot!(error(b"<svg/>\nmore"), @"line 1: expected nothing outside of <svg>, found `more`");
    insta::assert_snapshot!(error(b"<svg>\xff</svg>"), @"byte 5: not text in UTF-8");
    let dressed = "\u{feff}<?xml version='1.0'?>\n<!DOCTYPE svg [<!ENTITY a 'b'>]><!-- x --><svg a='&a;'><line x2='1'/></svg>\n";
    assert_eq!(parse(dressed.as_bytes()).unwrap().segments, [[0, 1]]);
}

#[test]
fn a_million_points_are_enough() {
    let zigzag = |points: usize| {
        let steps = "1 1 1-1 ".repeat(points / 2);
        parse(drawing(&format!("<path d='m0 0l{steps}'/>")).as_bytes())
    };
    assert_eq!(
        zigzag(MOST_POINTS - 2).unwrap().points.len(),
        MOST_POINTS - 1
    );
    insta::assert_snapshot!(zigzag(MOST_POINTS).unwrap_err(), @"the outlines have more than 1000000 points");
}
