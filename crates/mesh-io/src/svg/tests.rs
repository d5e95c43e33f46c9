use proptest::prelude::*;

use super::*;

fn one_panel(fill: impl FnOnce(&mut Layer)) -> Result<String, PictureError> {
    let mut panel = Panel::new(Window::new([0.0, 0.0], [2.0, 1.0])).width(200.0);
    fill(panel.layer("marks", Style::line(Stroke::thin(Color::INK))));
    Picture::new("").panel(panel).to_svg()
}

#[test]
fn y_points_up() {
    let svg = one_panel(|layer| {
        layer.polyline([[0.0, 0.0], [2.0, 1.0]]);
    });
    assert!(
        svg.unwrap()
            .contains("<path d=\"M0 100 200 0\" fill=\"none\"/>")
    );
}

#[test]
fn every_coordinate_that_is_not_finite_is_refused_with_its_mark() {
    for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300] {
        let refused = one_panel(|layer| {
            layer.dot([0.0, 0.0], 1.0).circle([1.0, value], 1.0);
        });
        match refused {
            Err(PictureError::Coordinate {
                panel: 0,
                layer,
                mark: 1,
                ..
            }) => assert_eq!(layer, "marks"),
            other => panic!("{value}: {other:?}"),
        }
    }
    assert!(
        one_panel(|layer| {
            layer.circle([0.0, 0.0], f64::NAN);
        })
        .is_err()
    );
}

#[test]
fn a_window_without_area_is_refused() {
    let empty = Window::around(Vec::<Point>::new());
    for window in [
        empty,
        Window::new([0.0, 0.0], [0.0, 1.0]),
        Window::new([f64::NAN, 0.0], [1.0, 1.0]),
    ] {
        let refused = Picture::new("").panel(Panel::new(window)).to_svg();
        assert!(
            matches!(refused, Err(PictureError::Window { panel: 0, .. })),
            "{refused:?}"
        );
    }
}

#[test]
fn an_error_names_panel_layer_mark_and_value() {
    let refused = one_panel(|layer| {
        layer.polygon([[0.0, f64::NAN]]);
    });
    assert_eq!(
        refused.unwrap_err().to_string(),
        "panel 0, layer `marks`, mark 0: NaN is not a drawable coordinate"
    );
}

#[test]
fn text_cannot_break_the_document() {
    let svg = one_panel(|layer| {
        layer.text([1.0, 0.5], [0.0, 0.0], Anchor::Middle, "a < b & \"c\"\u{0}");
    });
    assert!(
        svg.unwrap()
            .contains(">a &lt; b &amp; &quot;c&quot;\u{fffd}</text>")
    );
}

#[test]
fn polygons_of_one_class_share_a_path() {
    let map = ColorMap::new(0.0, 1.0);
    let squares = (0..100).map(|k| {
        let x = f64::from(k) / 50.0;
        ([[x, 0.0], [x + 0.02, 0.0], [x, 0.02]], f64::from(k % 2))
    });
    let svg = one_panel(|layer| {
        layer.colored_polygons(&map, squares);
    });
    assert_eq!(svg.unwrap().matches("<path").count(), 2);
}

#[test]
fn a_picture_without_panels_is_a_document() {
    assert!(
        Picture::new("nothing")
            .to_svg()
            .unwrap()
            .ends_with("</svg>\n")
    );
}

/// Numbers of all sorts, hostile ones among them.
fn number() -> impl Strategy<Value = f64> {
    prop_oneof![4 => -2.0..3.0, 1 => any::<f64>()]
}

fn point() -> impl Strategy<Value = Point> {
    [number(), number()]
}

fn mark(layer: &mut Layer, kind: u8, points: &[Point], text: &str) {
    let at = points[0];
    match kind {
        0 => layer.polyline(points.iter().copied()),
        1 => layer.polygon(points.iter().copied()),
        2 => layer.circle(at, points[1][0]),
        3 => layer.dot(at, points[1][0]),
        4 => layer.text(at, points[1], Anchor::Start, text),
        5 => layer.arrow(at, points[1]),
        _ => layer.colored_polygons(
            &ColorMap::new(at[0], at[1]),
            [(points.to_vec(), points[1][0])],
        ),
    };
}

proptest! {
    #[test]
    fn whatever_is_drawn_gives_an_error_or_well_formed_xml_with_finite_numbers(
        marks in prop::collection::vec((0u8..7, prop::collection::vec(point(), 2..6)), 0..8),
        text in any::<String>(),
        width in number(),
    ) {
        let mut panel = Panel::new(Window::new([0.0, 0.0], [1.0, 1.0])).width(100.0 * width).caption(&text);
        let layer = panel.layer(&text, Style::line(Stroke { width, ..Stroke::dotted(Color::RED) }));
        for (kind, points) in &marks {
            mark(layer, *kind, points, &text);
        }
        let bar = ColorBar { map: ColorMap::new(width, 1.0), title: text.clone(), ticks: vec![width], unit: text.clone() };
        if let Ok(svg) = Picture::new(&text).panel(panel.color_bar(bar)).key(&text, Sample::Dot(Color::INK)).to_svg() {
            let mut reader = quick_xml::Reader::from_str(&svg);
            while !matches!(reader.read_event().unwrap(), quick_xml::events::Event::Eof) {}
            prop_assert!(!svg.contains("=\"NaN") && !svg.contains("inf\""));
        }
    }
}
