//! Exact signs of orientation, in-circle and in-sphere determinants, with fast filters and symbolic perturbation.

pub mod coordinate;
pub mod filter;
pub mod perturb;
pub mod statistics;

mod diametral;
mod few_bits;
mod grid;
mod in_ball;
mod orient;
mod power;
mod sign;
mod unbounded;
mod wide;

pub use coordinate::{
    Axis, CoordinateError, WeightError, check_point2, check_point3, check_points2, check_points3,
    check_weights,
};
pub use diametral::{in_diametral_ball, in_diametral_circle, in_diametral_sphere};
pub use glam::{DVec2, DVec3};
pub use in_ball::{in_circle, in_sphere};
pub use orient::{orient2d, orient3d};
pub use perturb::{
    Lexicographic2, Lexicographic3, cocircular_inside, in_circle_perturbed, in_circle_perturbed_by,
    in_sphere_perturbed, in_sphere_perturbed_by, power_circle_perturbed, power_circle_perturbed_by,
    power_sphere_perturbed, power_sphere_perturbed_by,
};
pub use power::{WeightedPoint2, WeightedPoint3, power_circle, power_sphere};
pub use sign::Sign;
