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
