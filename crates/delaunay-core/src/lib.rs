//! Delaunay triangulations: Bowyer–Watson kernel, half-edge mesh, Voronoi dual and the measures of mesh quality.
