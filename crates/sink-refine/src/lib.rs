//! Delaunay refinement by sink insertion (Edelsbrunner and Guoy).
