//! The normal that stands before every triangle.

/// The unit normal on the side from which the corners turn counterclockwise, rounded; zero where the corners make none, which readers
/// understand as unknown.
pub(super) fn normal([a, b, c]: [[f64; 3]; 3]) -> [f64; 3] {
    let [u, v] = [b, c].map(|end| of_size_one([0, 1, 2].map(|k| end[k] / 2.0 - a[k] / 2.0)));
    let cross = [
        u[1] * v[2] - u[2] * v[1],
        u[2] * v[0] - u[0] * v[2],
        u[0] * v[1] - u[1] * v[0],
    ];
    let [x, y, z] = of_size_one(cross);
    let length = (x * x + y * y + z * z).sqrt();
    // Adding zero leaves no -0.0.
    let unit = [x, y, z].map(|coordinate| coordinate / length + 0.0);
    if unit.iter().all(|coordinate| coordinate.is_finite()) {
        unit
    } else {
        [0.0; 3]
    }
}

/// The vector with its greatest coordinate made one, so that no product leaves the range of doubles.
fn of_size_one(vector: [f64; 3]) -> [f64; 3] {
    let size = vector.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
    vector.map(|coordinate| coordinate / size)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_normal_has_length_one_or_is_zero() {
        for scale in [1.0, f64::MAX, 1e-300] {
            let triangle = [[0.0; 3], [scale, 0.0, 0.0], [0.0, scale, 0.0]];
            assert_eq!(normal(triangle), [0.0, 0.0, 1.0]);
        }
        let [x, y, z] = normal([[0.0; 3], [0.0, 3.0, 4.0], [1.0, 0.0, 0.0]]);
        assert_eq!([x, y, z], [0.0, 0.8, -0.6]);
        assert_eq!(normal([[1.0; 3], [2.0; 3], [4.0; 3]]), [0.0; 3]);
        assert_eq!(normal([[1.0; 3]; 3]), [0.0; 3]);
    }
}
