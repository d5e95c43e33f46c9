//! Transfinite interpolation: the grid inside four curves (§3).
//!
//! ```text
//! x(ξ, η) = (1 − ξ) ξ0(η) + ξ ξ1(η) + (1 − η) η0(ξ) + η η1(ξ)
//!           − the bilinear surface through the corners
//! ```
//!
//! Where the η-curves are straight with equally spaced nodes, as in Algorithm 2, the last three
//! terms cancel and grid lines of constant η are straight too: then the grid folds only if a strip
//! between two of them does.

use glam::DVec2;

/// Nodes along the four curves of a block; opposite curves have the same number of nodes and the
/// ends meet.
#[derive(Clone, Copy, Debug)]
pub struct BoundaryNodes<'a> {
    /// At ξ = 0, by η.
    pub xi0: &'a [DVec2],
    /// At ξ = 1, by η.
    pub xi1: &'a [DVec2],
    /// At η = 0, by ξ.
    pub eta0: &'a [DVec2],
    /// At η = 1, by ξ.
    pub eta1: &'a [DVec2],
}

/// The nodes of the grid inside four curves, ξ fastest:
/// node (i, j) is entry `j (cells across + 1) + i`.
///
/// Boundary nodes are the given ones, bit for bit. O(nodes).
#[must_use]
pub fn transfinite_grid(boundary: &BoundaryNodes<'_>) -> Vec<DVec2> {
    let BoundaryNodes {
        xi0,
        xi1,
        eta0,
        eta1,
    } = *boundary;
    let (across, along) = (eta0.len().min(eta1.len()), xi0.len().min(xi1.len()));
    let mut nodes = Vec::with_capacity(across * along);
    for j in 0..along {
        let eta = fraction(j, along);
        for i in 0..across {
            nodes.push(match (i, j) {
                (0, _) => xi0[j],
                (_, 0) => eta0[i],
                _ if i + 1 == across => xi1[j],
                _ if j + 1 == along => eta1[i],
                _ => interpolated(boundary, (i, fraction(i, across)), (j, eta)),
            });
        }
    }
    nodes
}

fn interpolated(
    boundary: &BoundaryNodes<'_>,
    (i, xi): (usize, f64),
    (j, eta): (usize, f64),
) -> DVec2 {
    let BoundaryNodes {
        xi0,
        xi1,
        eta0,
        eta1,
    } = *boundary;
    let last = xi0.len() - 1;
    let corners = xi0[0]
        .lerp(xi1[0], xi)
        .lerp(xi0[last].lerp(xi1[last], xi), eta);
    xi0[j].lerp(xi1[j], xi) + (eta0[i].lerp(eta1[i], eta) - corners)
}

fn fraction(k: usize, nodes: usize) -> f64 {
    k as f64 / (nodes - 1) as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(from: DVec2, to: DVec2, nodes: usize) -> Vec<DVec2> {
        (0..nodes)
            .map(|k| from.lerp(to, fraction(k, nodes)))
            .collect()
    }

    #[test]
    fn a_rectangle_gets_equal_cells() {
        let [a, b, c, d] = [
            DVec2::ZERO,
            DVec2::new(4.0, 0.0),
            DVec2::new(4.0, 2.0),
            DVec2::new(0.0, 2.0),
        ];
        let (xi0, xi1, eta0, eta1) = (line(a, d, 3), line(b, c, 3), line(a, b, 5), line(d, c, 5));
        let grid = transfinite_grid(&BoundaryNodes {
            xi0: &xi0,
            xi1: &xi1,
            eta0: &eta0,
            eta1: &eta1,
        });
        for j in 0..3 {
            for i in 0..5 {
                assert_eq!(grid[j * 5 + i], DVec2::new(i as f64, j as f64));
            }
        }
    }

    #[test]
    fn a_bulge_of_one_curve_fades_towards_the_other() {
        let [a, b, c, d] = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y];
        let (xi0, mut xi1, eta0, eta1) =
            (line(a, d, 3), line(b, c, 3), line(a, b, 3), line(d, c, 3));
        xi1[1].x = 1.5;
        let grid = transfinite_grid(&BoundaryNodes {
            xi0: &xi0,
            xi1: &xi1,
            eta0: &eta0,
            eta1: &eta1,
        });
        assert_eq!(grid[3 + 1], DVec2::new(0.75, 0.5));
    }
}
