//! The point of a convex hull that is nearest to the origin (Wolfe 1976, *Finding the nearest point in a polytope*).
//!
//! For gradients of functions it is the direction in which the least of them rises fastest.

use glam::{DMat2, DMat3, DVec2, DVec3};

/// Steps at most; in three dimensions a handful is usual.
const STEPS: usize = 32;

/// The point of the convex hull of `points` with the least norm; zero when the origin is inside, or there are no points.
///
/// A simplex of the points, on whose face of lowest dimension the answer lies, takes in the point that is farthest towards
/// the origin, and loses corners that have no share any more, until no point is nearer to the origin.
pub(crate) fn min_norm_point(points: &[DVec3]) -> DVec3 {
    let nearest = |&p: &&DVec3, &q: &&DVec3| p.length_squared().total_cmp(&q.length_squared());
    let Some(&first) = points.iter().min_by(|p, q| nearest(p, q)) else {
        return DVec3::ZERO;
    };
    let mut simplex = Simplex {
        corners: [first; 4],
        shares: [1.0, 0.0, 0.0, 0.0],
        len: 1,
    };
    let mut best = first;
    for _ in 0..STEPS {
        let lowest = points
            .iter()
            .min_by(|p, q| p.dot(best).total_cmp(&q.dot(best)));
        let Some(&lowest) = lowest else { break };
        let size = best.length_squared();
        if lowest.dot(best) >= size * (1.0 - 1e-9) || simplex.len == 4 {
            break;
        }
        simplex.push(lowest);
        let next = simplex.reduce();
        // Only rounding can keep the norm from falling.
        if next.length_squared() >= size {
            break;
        }
        best = next;
    }
    best
}

/// Points with shares that add up to 1.
struct Simplex {
    corners: [DVec3; 4],
    shares: [f64; 4],
    len: usize,
}

impl Simplex {
    fn push(&mut self, point: DVec3) {
        self.corners[self.len] = point;
        self.shares[self.len] = 0.0;
        self.len += 1;
    }

    /// Goes towards the point of least norm in the plane of the corners. On the way corners may lose their share: the first
    /// one that does is dropped, and so on until that point is inside.
    fn reduce(&mut self) -> DVec3 {
        while self.len > 1 {
            let Some(wanted) = self.affine_shares() else {
                // The newest corner is in line with the others.
                self.len -= 1;
                continue;
            };
            let lost = (0..self.len).filter(|&i| wanted[i] <= 0.0);
            let lost = lost.map(|i| (i, self.time_to_lose(i, wanted[i])));
            let Some((first, time)) = lost.min_by(|a, b| a.1.total_cmp(&b.1)) else {
                self.shares = wanted;
                break;
            };
            for (share, wanted) in self.shares.iter_mut().zip(wanted) {
                *share += time * (wanted - *share);
            }
            self.len -= 1;
            self.corners[first] = self.corners[self.len];
            self.shares[first] = self.shares[self.len];
        }
        if self.len == 1 {
            self.shares[0] = 1.0;
        }
        let corners = self.corners.iter().zip(self.shares).take(self.len);
        corners.map(|(&corner, share)| share * corner).sum()
    }

    /// When the share of a corner is 0 on the way to `wanted`, which is not positive; 1 is at the end of the way.
    fn time_to_lose(&self, corner: usize, wanted: f64) -> f64 {
        let share = self.shares[corner].max(0.0);
        match share > 0.0 {
            true => share / (share - wanted),
            false => 0.0,
        }
    }

    /// The shares of the point of least norm on the line, in the plane or in the space through the corners; `None` when
    /// they are not in general position.
    fn affine_shares(&self) -> Option<[f64; 4]> {
        let base = self.corners[0];
        let [e, f, g] = [1, 2, 3].map(|i| self.corners[i] - base);
        let found = match self.len {
            2 => [-e.dot(base) / e.length_squared(), 0.0, 0.0],
            3 => {
                let ef = e.dot(f);
                let gram = DMat2::from_cols_array(&[e.dot(e), ef, ef, f.dot(f)]);
                let shares = gram.inverse() * DVec2::new(-e.dot(base), -f.dot(base));
                [shares.x, shares.y, 0.0]
            }
            _ => {
                let shares = DMat3::from_cols(e, f, g).inverse() * -base;
                shares.to_array()
            }
        };
        let [x, y, z] = found;
        let shares = [1.0 - x - y - z, x, y, z];
        shares.iter().all(|s| s.is_finite()).then_some(shares)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::dvec3;

    #[test]
    fn the_nearest_point_may_be_a_corner_or_on_an_edge_or_a_face_or_the_origin() {
        let [x, y, z] = DVec3::AXES;
        assert_eq!(min_norm_point(&[]), DVec3::ZERO);
        assert_eq!(min_norm_point(&[3.0 * x, 2.0 * x + y, x]), x);
        let edge = min_norm_point(&[x + y, x - y, 4.0 * x + z]);
        assert!(edge.distance(x) < 1e-12);
        let face = min_norm_point(&[x, y, z, DVec3::ONE]);
        assert!(face.distance(DVec3::splat(1.0 / 3.0)) < 1e-12);
        assert!(min_norm_point(&[x, y, z, -DVec3::ONE]).length() < 1e-12);
    }

    /// The answer is the nearest exactly when no point is beyond the plane through it across the line to the origin.
    #[test]
    fn no_point_is_nearer_than_the_plane_of_the_answer() {
        let mut state = 1_u64;
        let mut random = || {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1);
            (state >> 11) as f64 / (1_u64 << 53) as f64
        };
        for round in 0..2000 {
            let count = 1 + round % 13;
            let shift = DVec3::splat(f64::from(round as u32 % 5) * 0.3);
            let points: Vec<DVec3> = (0..count)
                .map(|_| dvec3(random(), random(), random()) - 0.5 + shift)
                .collect();
            let nearest = min_norm_point(&points);
            let size = nearest.length_squared();
            for p in points {
                assert!(p.dot(nearest) >= size - 1e-7, "{round}");
            }
        }
    }
}
