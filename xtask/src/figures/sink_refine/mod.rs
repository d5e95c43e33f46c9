//! Edelsbrunner & Guoy, *Sink-insertion for mesh improvement*.

mod classes;
mod cut;
mod flow;
mod flowers;
mod graph_of_phi;
mod graphs;
mod level_sets;
mod relation;
mod report;
mod solids;
mod usa;
mod watersheds;

use super::Figure;

/// Figures 1 to 11, and the flow and its sinks on a triangulation of our own.
pub const FIGURES: &[Figure] = &[
    Figure {
        name: "sinks_fig01_level_sets",
        caption: "Level sets of the square distances π, to the nearest point, and φ, to the nearest Delaunay circle, over the Voronoi \
                  diagram and the Delaunay triangulation. The lighter, the larger. The maxima of one are the minima of the other.",
        render: level_sets::figure,
    },
    Figure {
        name: "sinks_fig02_usa_sinks",
        caption: "The outline of the contiguous United States: triangles that contain their circumcentres are grey, the centres are the \
                  sinks. Bold edges bound the ancestor sets, the triangles from which the flow runs to one sink.",
        render: watersheds::figure,
    },
    Figure {
        name: "sinks_fig03_graph",
        caption: "The graph of φ over the same triangles, upside down: over each a piece of a paraboloid. The tops of the hills are the \
                  sinks.",
        render: graph_of_phi::figure,
    },
    Figure {
        name: "sinks_fig04_relation",
        caption: "A triangle precedes its neighbour when its circumcentre lies beyond their common edge; beyond an edge of the hull it \
                  precedes the dummy element outside.",
        render: relation::figure,
    },
    Figure {
        name: "sinks_fig05_flowers",
        caption: "The triangles whose circumcircles contain a point are its prestar, which becomes its star; their discs together are the \
                  flowers. That of the star is the larger.",
        render: flowers::figure,
    },
    Figure {
        name: "sinks_flow",
        caption: "From a triangle that does not contain its circumcentre the flow runs towards it, into the next triangle; it ends in \
              sinks, the centres of empty circles that lie in their own triangles, or outside. Triangles are coloured by their end.",
        render: flow::figure,
    },
    Figure {
        name: "sinks_fig06_first_sinks",
        caption: "The outline of the contiguous United States before any sink is inserted and after 4, 12 and 15: the worst triangles \
                  go first.",
        render: usa::first_sinks,
    },
    Figure {
        name: "sinks_fig07_usa",
        caption: "The same outline after sinks and after circumcentres were inserted in blocks. The boundary stays; near it some \
                  triangles of low quality are left.",
        render: usa::all_methods,
    },
    Figure {
        name: "sinks_fig08_cuboctahedron",
        caption: "Cuboctahedron: what a plane near the middle meets of the tetrahedra in a skin of twelve balls, a reconstruction of the \
                  paper's, before and after sinks are inserted. At first nearly all are of low quality and share a handful of sinks; \
                  the worst go first.",
        render: solids::cuboctahedron,
    },
    Figure {
        name: "sinks_fig09_paraboloid",
        caption: "Paraboloid: the same for a paraboloid under a flat lid, cut along its axis. The surface is finest in the middle of \
                  the lid, from where the worst tetrahedra hang.",
        render: solids::paraboloid,
    },
    Figure {
        name: "sinks_fig10_star",
        caption: "Star: the bore of a rocket motor with eleven fins, cut across. It is thin: at first only some five tetrahedra share \
                  a sink, and in the end the boundary test keeps some of low quality.",
        render: solids::star,
    },
    Figure {
        name: "sinks_fig11_head",
        caption: "Head: the propellant round the star, cut across. Long tetrahedra between bore and outer wall give way to nearly \
                  twice as many.",
        render: solids::head,
    },
];
