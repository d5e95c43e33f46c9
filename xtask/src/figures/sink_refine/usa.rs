//! Figures 6 and 7: the outline of the contiguous United States, refined by a few sinks, then by all methods (§5.2).

use std::error::Error;

use delaunay_core::measure::triangle::radius_edge_ratio;
use delaunay_core::progress::silent;
use delaunay_core::{BuildOptions, Delaunay2, Outline, Region, Subcomplex2, VertexId};
use fixtures::outlines;
use glam::DVec2;
use mesh_io::svg::{Color, Panel, Picture, Sample, Stroke, Style, Window};
use sink_refine::tri::stable_faces;
use sink_refine::{Candidate, Coarsening, Method, Outcome2, Params, Round, Schedule, refine2};

use super::classes::{Class, Classes};
use super::graphs;
use super::report::mesh;
use crate::figures::plot::{Graph, Scale};
use crate::figures::table::{Table, grouped};
use crate::figures::{Render, Rendered};

/// Numbers of sinks after which the paper shows the mesh.
const SINKS: [usize; 3] = [4, 12, 15];

/// Good triangles are blue, those of low quality yellow to red.
const RATIOS: Classes = Classes {
    all: &[
        Class {
            bound: 1.0,
            color: Color::SKY,
            text: "r/l up to 1",
        },
        Class {
            bound: 2.0,
            color: Color([0xf6, 0xe6, 0xbd]),
            text: "of low quality: 1 to 2",
        },
        Class {
            bound: 4.0,
            color: Color([0xe3, 0xb5, 0x57]),
            text: "2 to 4",
        },
        Class {
            bound: f64::INFINITY,
            color: Color::RED,
            text: "above 4",
        },
    ],
    edge: Stroke {
        color: Color::INK,
        width: 0.4,
        dotted: false,
    },
};

/// Figure 6.
pub(super) fn first_sinks() -> Render {
    let given = region()?;
    let mut picture = RATIOS
        .keyed(Picture::new("Figure 6: the first sinks"))
        .panel(panel(&given, &format!("{} triangles", count(&given))));
    let mut table = Table::new(
        "Figure 6: the first sinks, worst triangles first",
        ["sinks", "triangles", "of low quality", "max r/l"],
    );
    for sinks in SINKS {
        let method = paper(Candidate::Sink, Schedule::Incremental);
        let outcome = refined(&given, method, sinks)?;
        let caption = format!("after {sinks} sinks: {} triangles", count(&outcome.region));
        let mut panel = panel(&outcome.region, &caption);
        let new = outcome.region.points().iter().skip(given.points().len());
        let dots = panel.layer("sinks inserted", Style::area(Color::INK));
        for &point in new {
            dots.dot(point, 2.5);
        }
        picture = picture.panel(panel);
        let round = last(&outcome);
        table = table.row([
            sinks.to_string(),
            grouped(round.elements),
            grouped(round.low),
            format!("{:.3}", round.max_ratio),
        ]);
    }
    Ok(Rendered {
        svg: picture
            .key("sink inserted", Sample::Dot(Color::INK))
            .to_svg()?,
        summary: table.to_string(),
    })
}

/// Figure 7.
pub(super) fn all_methods() -> Render {
    let given = region()?;
    let run = |method| refined(&given, method, usize::MAX);
    let sinks = run(paper(Candidate::Sink, Schedule::Block))?;
    let circumcenters = run(paper(Candidate::Circumcenter, Schedule::Block))?;
    let meshes = [(&sinks, "sinks"), (&circumcenters, "circumcentres")];
    let mut picture = Picture::new("Figure 7: USA");
    for (outcome, name) in meshes {
        let caption = format!(
            "{} triangles after {name}, in blocks",
            count(&outcome.region)
        );
        picture = picture.panel(panel(&outcome.region, &caption));
    }
    let picture = picture.panel(graphs::panel(
        &graphs(&sinks.rounds),
        "block by block, sinks",
    ));

    let initial = sinks.rounds.first().copied().unwrap_or_default();
    let header = [
        "",
        "triangles",
        "of low quality",
        "min r/l",
        "mean",
        "max",
        "tested",
    ];
    let mut table = Table::new("Figure 7: USA", header)
        .row(row("init", &initial, "-"))
        .row(["  paper", "229", "-", "0.61", "2.36", "17.23", "-"]);
    for (candidate, schedule, name, printed) in [
        (
            Candidate::Sink,
            Schedule::Block,
            "sink, block",
            ["879", "-", "0.58", "0.76", "2.58"],
        ),
        (
            Candidate::Circumcenter,
            Schedule::Block,
            "circ, block",
            ["941", "-", "0.58", "0.75", "3.54"],
        ),
        (
            Candidate::Sink,
            Schedule::Incremental,
            "sink, incr",
            ["841", "-", "0.58", "0.77", "3.06"],
        ),
        (
            Candidate::Circumcenter,
            Schedule::Incremental,
            "circ, incr",
            ["997", "-", "0.58", "0.76", "3.54"],
        ),
    ] {
        let outcome = run(paper(candidate, schedule))?;
        let [count, low, min, mean, max] = printed;
        table = table
            .row(row(
                name,
                &last(&outcome),
                &grouped(outcome.counters.tested),
            ))
            .row(["  paper", count, low, min, mean, max, "-"]);
    }
    for (coarsening, name) in [
        (Coarsening::Removal, "economical"),
        (Coarsening::Merging, "with merging"),
    ] {
        let outcome = run(Method::Economical(coarsening))?;
        table = table.row(row(
            name,
            &last(&outcome),
            &grouped(outcome.counters.tested),
        ));
    }
    Ok(Rendered {
        svg: RATIOS.keyed(picture).to_svg()?,
        summary: table.to_string(),
    })
}

/// The outline and the triangles inside.
pub(super) fn triangulated() -> Result<Region, Box<dyn Error>> {
    let usa = outlines::usa();
    let points = usa.points.into_iter().map(DVec2::from).collect();
    let segments = usa.segments.iter();
    let segments = segments.map(|ends| ends.map(|v| VertexId::new(v as usize)));
    let outline = Outline::new(points, segments.collect())?;
    Ok(outline.region(BuildOptions::default(), &mut silent)?)
}

/// The triangulation of the corners, of which the segments of the outline are edges as it is.
pub(super) fn delaunay(region: &Region) -> Result<Delaunay2, Box<dyn Error>> {
    let delaunay = region.triangulation().as_delaunay();
    delaunay.ok_or_else(|| "the outline is not Delaunay".into())
}

/// The maximal stable subcomplex of the triangles inside (§5.1).
pub(super) fn stable(region: &Region) -> Result<Subcomplex2, Box<dyn Error>> {
    let delaunay = delaunay(region)?;
    let stays = stable_faces(&delaunay, |f| region.is_inside(f));
    Ok(Subcomplex2::of(&delaunay, |f| stays[f.index()]))
}

/// The triangles inside the outline.
fn region() -> Result<Subcomplex2, Box<dyn Error>> {
    let region = triangulated()?;
    Ok(region.subcomplex())
}

fn paper(candidate: Candidate, schedule: Schedule) -> Method {
    Method::Paper {
        candidate,
        schedule,
    }
}

fn refined(
    region: &Subcomplex2,
    method: Method,
    max_new_vertices: usize,
) -> Result<Outcome2, Box<dyn Error>> {
    let params = Params {
        ratio: 1.0,
        method,
        max_new_vertices,
        ..Params::default()
    };
    Ok(refine2(region.clone(), &params, &mut silent)?)
}

fn count(region: &Subcomplex2) -> usize {
    region.faces().count()
}

/// The mesh that came out.
fn last(outcome: &Outcome2) -> Round {
    outcome.rounds.last().copied().unwrap_or_default()
}

fn row(name: &str, round: &Round, tested: &str) -> [String; 7] {
    let [name, elements, low, min, mean, max] = mesh(name, Some(round));
    [name, elements, low, min, mean, max, tested.to_owned()]
}

/// Triangles coloured by their ratio.
fn panel(region: &Subcomplex2, caption: &str) -> Panel {
    let window = Window::around(region.points().iter().copied()).widened(0.02);
    let mut panel = Panel::new(window).caption(caption);
    let triangles = region.faces().map(|f| region.triangle(f));
    let pieces: Vec<(f64, Vec<DVec2>)> = triangles
        .map(|corners| (radius_edge_ratio(corners), corners.to_vec()))
        .collect();
    RATIOS.draw(&mut panel, &pieces);
    panel
}

fn graphs(rounds: &[Round]) -> [Graph; 2] {
    let of = |value: fn(&Round) -> f64| rounds.iter().map(value);
    let [ink, blue, red] = [Color::INK, Color::BLUE, Color::RED].map(Stroke::medium);
    [
        Graph::new(Scale::Log)
            .line("low quality", red, of(|round| round.low as f64))
            .line("sinks", blue, of(|round| round.candidates as f64))
            .line(
                "passing",
                Stroke::medium(Color::OCHRE),
                of(|round| round.passed as f64),
            )
            .line("block", ink, of(|round| round.inserted as f64)),
        graphs::ratios(rounds, 1.0),
    ]
}
