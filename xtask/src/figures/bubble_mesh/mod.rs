//! Luo, *Automatic Delaunay mesh generation method and physically-based mesh optimization method on two-dimensional regions*.

mod boundary;
mod graded;
mod histogram;
mod insertion;
mod nearby;
mod outline;
mod regions;

use super::Figure;

/// Figures 1 to 6, the bubbles of a boundary of our own, and the regions of the figures beyond the paper.
pub const FIGURES: &[Figure] = &[
    Figure {
        name: "bubbles_fig01_insertion",
        caption: "A node at the centroid p of a triangle: three triangles have it in their circumcircles, but only those that hang together \
                  with its own make way for its star. What lies across the boundary stays as it is.",
        render: insertion::figure,
    },
    Figure {
        name: "bubbles_boundary",
        caption: "The nodes of a boundary have bubbles as large as its edges ask for; they give bubbles to the triangles between them. Where \
                  bubbles cover little of a triangle a node is missing. Nodes are added until the bubbles of the triangles have the area \
                  of the region.",
        render: boundary::figure,
    },
    Figure {
        name: "bubbles_fig02_nearby",
        caption: "A node and the nodes nearby: those one, two and three edges away in the mesh that was generated.",
        render: nearby::figure,
    },
    Figure {
        name: "bubbles_fig03_circle",
        caption: "A circle: the mesh as generated and after 200 iterations of the optimization, the bubbles of its nodes before and after, \
                  and how many triangles have which radius ratio.",
        render: regions::circle,
    },
    Figure {
        name: "bubbles_fig04_square",
        caption: "The same for a square with a finer round hole. Where fine and coarse edges are near each other some triangles of low \
                  quality are left.",
        render: regions::square,
    },
    Figure {
        name: "bubbles_fig05_rectangle",
        caption: "The same for a rectangle with two finer round holes.",
        render: regions::rectangle,
    },
    Figure {
        name: "bubbles_fig06_arbitrary",
        caption: "The same for a region of no simple form with two holes.",
        render: regions::arbitrary,
    },
    Figure {
        name: "bubbles_graded_circle",
        caption: "The circle of figure 3 by the paper's method and beyond it: nodes placed layer by layer, forces, then the shapes themselves \
                  optimized. The numbers also tell what a search of the connectivity and other boundary nodes give.",
        render: graded::circle,
    },
    Figure {
        name: "bubbles_graded_square",
        caption: "The same for the square with a hole of figure 4.",
        render: graded::square,
    },
    Figure {
        name: "bubbles_graded_rectangle",
        caption: "The same for the rectangle with two holes of figure 5.",
        render: graded::rectangle,
    },
    Figure {
        name: "bubbles_graded_arbitrary",
        caption: "The same for the arbitrary region of figure 6.",
        render: graded::arbitrary,
    },
];
