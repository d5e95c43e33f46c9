//! Figures 8 to 11: the paper's four solids, refined by sinks and by circumcentres in parallel rounds (§5.3 to §5.6).

use std::error::Error;

use delaunay_core::progress::silent;
use delaunay_core::{BuildOptions, Subcomplex3, Surface, VertexId};
use fixtures::surfaces::{self, Triangles};
use mesh_io::svg::{Color, Picture, Stroke};
use sink_refine::{Candidate, Coarsening, Method, Outcome3, Params, Round, Schedule, refine3};

use super::cut::{self, Plane};
use super::graphs;
use super::report::{Printed, PrintedRow, report};
use crate::figures::plot::{Graph, Scale};
use crate::figures::table::grouped;
use crate::figures::{Render, Rendered};

/// Figure 8.
pub(super) fn cuboctahedron() -> Render {
    render(&Example {
        title: "Figure 8: Cuboctahedron",
        surface: surfaces::cuboctahedron,
        plane: Plane::Z(0.0123),
        paper: Printed {
            init: PrintedRow("14,670", "-", ["0.71", "7.29", "22.80"]),
            sink: PrintedRow("15,948", "-", ["0.63", "1.27", "2.00"]),
            circ: PrintedRow("15,066", "-", ["0.64", "1.29", "2.00"]),
            minutes: [6, 121],
        },
    })
}

/// Figure 9.
pub(super) fn paraboloid() -> Render {
    render(&Example {
        title: "Figure 9: Paraboloid",
        surface: surfaces::paraboloid,
        plane: Plane::Y(0.0123),
        paper: Printed {
            init: PrintedRow("10,050", "-", ["0.87", "18.77", "90.75"]),
            sink: PrintedRow("14,793", "-", ["0.65", "1.24", "2.00"]),
            circ: PrintedRow("13,639", "-", ["0.64", "1.28", "2.00"]),
            minutes: [7, 176],
        },
    })
}

/// Figure 10.
pub(super) fn star() -> Render {
    render(&Example {
        title: "Figure 10: Star",
        surface: surfaces::star,
        plane: Plane::Z(2.0123),
        paper: Printed {
            init: PrintedRow("78,114", "58,147", ["0.68", "2.40", "14.09"]),
            sink: PrintedRow("118,633", "481", ["0.62", "1.27", "2.11"]),
            circ: PrintedRow("119,442", "1,867", ["0.63", "1.27", "2.17"]),
            minutes: [12, 58],
        },
    })
}

/// Figure 11.
pub(super) fn head() -> Render {
    render(&Example {
        title: "Figure 11: Head",
        surface: surfaces::head,
        plane: Plane::Z(2.0123),
        paper: Printed {
            init: PrintedRow("100,454", "79,238", ["0.67", "4.11", "8.67"]),
            sink: PrintedRow("190,269", "245", ["0.62", "1.24", "2.21"]),
            circ: PrintedRow("183,027", "104", ["0.62", "1.27", "2.15"]),
            minutes: [38, 177],
        },
    })
}

/// One of the paper's examples.
struct Example {
    title: &'static str,
    surface: fn() -> Triangles,
    /// Where the picture cuts it, through no vertex.
    plane: Plane,
    paper: Printed,
}

fn render(example: &Example) -> Render {
    let solid = solid((example.surface)())?;
    let runs = Runs::of(&solid)?;
    Ok(Rendered {
        svg: picture(example, &solid, &runs.sinks).to_svg()?,
        summary: report(example.title, &example.paper, &runs),
    })
}

/// The tetrahedra inside a surface.
fn solid(set: Triangles) -> Result<Subcomplex3, Box<dyn Error>> {
    let triangles = set.triangles.iter().map(|t| t.map(VertexId::new));
    let surface = Surface::new(set.points, triangles.collect())?;
    let solid = surface.solid(BuildOptions::default(), &mut silent)?;
    Ok(Subcomplex3::of(solid.delaunay(), |t| solid.is_inside(t)))
}

/// The same solid refined in three ways.
pub(super) struct Runs {
    pub(super) sinks: Outcome3,
    pub(super) circumcenters: Outcome3,
    pub(super) economical: Outcome3,
}

impl Runs {
    fn of(solid: &Subcomplex3) -> Result<Self, Box<dyn Error>> {
        let refined = |method| {
            let params = Params {
                method,
                ..Params::default()
            };
            refine3(solid.clone(), &params, &mut silent)
        };
        let in_parallel = |candidate| Method::Paper {
            candidate,
            schedule: Schedule::Parallel,
        };
        Ok(Self {
            sinks: refined(in_parallel(Candidate::Sink))?,
            circumcenters: refined(in_parallel(Candidate::Circumcenter))?,
            economical: refined(Method::Economical(Coarsening::Removal))?,
        })
    }
}

fn picture(example: &Example, before: &Subcomplex3, after: &Outcome3) -> Picture {
    let caption = |solid: &Subcomplex3| grouped(solid.tets().count());
    let [first, last] = [before, &after.solid].map(caption);
    let picture = Picture::new(example.title)
        .panel(cut::panel(
            before,
            example.plane,
            &format!("a cut through the {first} tetrahedra inside the surface"),
        ))
        .panel(cut::panel(
            &after.solid,
            example.plane,
            &format!("and through the {last} after sinks were inserted"),
        ))
        .panel(graphs::panel(&graphs(&after.rounds), "round by round"));
    cut::RATIOS.keyed(picture)
}

fn graphs(rounds: &[Round]) -> [Graph; 3] {
    let of = |value: fn(&Round) -> f64| rounds.iter().map(value);
    let [blue, red] = [Color::BLUE, Color::RED].map(Stroke::medium);
    [
        Graph::new(Scale::Linear)
            .line("tetrahedra", blue, of(|round| round.elements as f64))
            .line("of low quality", red, of(|round| round.low as f64)),
        Graph::new(Scale::Log)
            .line("their sinks", blue, of(|round| round.candidates as f64))
            .line("independent", red, of(|round| round.inserted as f64)),
        graphs::ratios(rounds, 2.0),
    ]
}
