//! Weighted points of one place: the heaviest stands for all.

use crate::ids::VertexId;
use crate::tri::Duplicates;

/// Places of weighted points, each by the point that stands for it.
pub(crate) struct Heaviest {
    /// One for each place: the heaviest point there, of equally heavy ones the first; places in
    /// lexicographic order.
    pub(crate) vertices: Vec<VertexId>,
    /// The points that one of `vertices` stands for.
    pub(crate) duplicates: Duplicates,
}

impl Heaviest {
    /// Of points at `place(index)`, in which no zero is negative, with the given weights.
    pub(crate) fn of<const N: usize>(
        weights: &[f64],
        place: impl Fn(VertexId) -> [f64; N],
    ) -> Self {
        let mut order: Vec<VertexId> = (0..weights.len()).map(VertexId::new).collect();
        order.sort_unstable_by(|&a, &b| {
            let pairs = place(a).into_iter().zip(place(b));
            let mut differences = pairs.map(|(a, b)| a.total_cmp(&b));
            let first = differences.find(|order| order.is_ne());
            // Adding zero turns -0.0 into 0.0.
            let lighter = || (weights[b.index()] + 0.0).total_cmp(&(weights[a.index()] + 0.0));
            first.unwrap_or_else(|| lighter().then(a.cmp(&b)))
        });
        let mut vertices: Vec<VertexId> = Vec::new();
        let mut pairs = Vec::new();
        for v in order {
            match vertices.last() {
                Some(&heaviest) if place(heaviest) == place(v) => pairs.push((v, heaviest)),
                _ => vertices.push(v),
            }
        }
        Self {
            vertices,
            duplicates: Duplicates::from_pairs(pairs),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_heaviest_of_a_place_stands_for_the_others_and_the_first_of_equals() {
        let places = [[1.0], [0.0], [1.0], [0.0], [1.0]];
        let heaviest = Heaviest::of(&[2.0, 0.0, 3.0, -0.0, 3.0], |v| places[v.index()]);
        let [a, b, c, d, e] = [0, 1, 2, 3, 4].map(VertexId::new);
        assert_eq!(heaviest.vertices, [b, c]);
        let pairs: Vec<_> = heaviest.duplicates.iter().collect();
        assert_eq!(pairs, [(a, c), (d, b), (e, c)]);
    }
}
