//! Exact signs of orientation, in-circle and in-sphere determinants, with fast filters and symbolic perturbation.
