//! Guoy & Erickson, *Automatic blocking scheme for structured meshing in 2D multiphase flow simulation*.

mod angle_lemma;
mod blocking2d;
mod correspondence;
mod delaunay;
mod ink;
mod medial_axis;
mod meshes;
mod scheme;
mod small;
mod voronoi;

use super::Figure;

/// Figures 2 to 9 and 12 to 14.
pub const FIGURES: &[Figure] = &[
    Figure {
        name: "blocking_fig02_medial_axis",
        caption: "The medial axis collects the centres of maximal empty circles. Most touch the walls in two points; the one round a \
                  vertex touches three.",
        render: medial_axis::figure,
    },
    Figure {
        name: "blocking_fig03_delaunay",
        caption: "Delaunay triangulation of samples of the walls, and of the domain: the triangles that lie inside. Interior triangles \
                  have no edge on a wall.",
        render: delaunay::figure,
    },
    Figure {
        name: "blocking_fig04_voronoi",
        caption: "Voronoi diagram of the samples, and of the domain: the edges that cross edges inside the domain.",
        render: voronoi::figure,
    },
    Figure {
        name: "blocking_fig05_correspondence",
        caption: "A vertex of the medial axis is the circumcentre of an interior triangle; an arc is a sequence of triangles between two \
                  of them (Algorithm 1).",
        render: correspondence::figure,
    },
    Figure {
        name: "blocking_fig06_blocks",
        caption: "A block between a medial arc and a wall with its four bounding curves, and the whole blocking scheme.",
        render: scheme::blocks,
    },
    Figure {
        name: "blocking_fig07_blocking2d",
        caption: "States of Algorithm 2 at line 3, where a pair of blocks begins, and at line 8, some triangles later.",
        render: blocking2d::figure,
    },
    Figure {
        name: "blocking_fig08_mesh",
        caption: "The multiblock structured mesh of the same domain, by transfinite interpolation inside each block.",
        render: scheme::mesh,
    },
    Figure {
        name: "blocking_fig09_angle_lemma",
        caption: "Angle Lemma: the six block corners at a medial vertex have the angles of its interior triangle, and why: the angle \
                  at the centre is twice the angle at the circumference, and the medial axis halves it.",
        render: angle_lemma::figure,
    },
    Figure {
        name: "blocking_fig12_hexagon",
        caption: "Hexagon: seven holes in hexagonal packing, 36 blocks; on the right the cells coloured by their smallest angle.",
        render: meshes::hexagon,
    },
    Figure {
        name: "blocking_fig13_bubble",
        caption: "Bubble: twenty circles in a periodic square, 120 blocks that tile the plane; on the right the cells coloured by \
                  their smallest angle.",
        render: meshes::bubble,
    },
    Figure {
        name: "blocking_fig14_lattice",
        caption: "Lattice: twelve large and nine small holes, 120 blocks; on the right the cells coloured by their smallest angle.",
        render: meshes::lattice,
    },
];
