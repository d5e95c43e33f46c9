//! Where does a point lie relative to the line `y = x`? Rounded and exact answers side by side.
//!
//! The points (0.5 + i u, 0.5 + j u), with `u` the distance of neighbouring doubles, are tested
//! against the line through (12, 12) and (24, 24): `+` left, `-` right, `0` on the line. After
//! Kettner et al., "Classroom examples of robustness problems in geometric computations".
//!
//! `cargo run -p geo-predicates --example float_versus_exact`

// An example may print.
#![allow(clippy::print_stdout)]

use geo_predicates::{DVec2, Sign, orient2d};

const SIZE: i32 = 24;

fn main() {
    println!("{:SIZE$}   exact", "rounded", SIZE = SIZE as usize);
    for j in (0..SIZE).rev() {
        let row = |sign: fn(DVec2, DVec2, DVec2) -> Sign| -> String {
            (0..SIZE)
                .map(|i| symbol(sign(grid(i, j), DVec2::splat(12.0), DVec2::splat(24.0))))
                .collect()
        };
        println!("{}   {}", row(rounded), row(orient2d));
    }
}

fn grid(i: i32, j: i32) -> DVec2 {
    let unit = f64::EPSILON / 2.0;
    DVec2::new(0.5 + f64::from(i) * unit, 0.5 + f64::from(j) * unit)
}

/// The determinant in doubles, as a textbook writes it.
fn rounded(a: DVec2, b: DVec2, c: DVec2) -> Sign {
    Sign::of((b - a).perp_dot(c - a))
}

fn symbol(sign: Sign) -> char {
    match sign {
        Sign::Negative => '-',
        Sign::Zero => '0',
        Sign::Positive => '+',
    }
}
