//! Meshes optimised by centroidal Voronoi tessellation (Du and Wang).
