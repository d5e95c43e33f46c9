//! Distance from a point to the nearest walls: how large an empty circle fits there.
//!
//! Holes lie in an R-tree, in a periodic domain with their eight nearest images; the bounding
//! circle is compared on the side. A query costs O(log n) for n holes.

use glam::DVec2;
use rstar::{AABB, PointDistance, RTree, RTreeObject};

use crate::domain::Domain;
use crate::wall::{Shift, Wall, WallId, WallImage};

/// Answers which walls are nearest to a point.
pub(crate) struct Clearance<'a> {
    domain: &'a Domain,
    holes: RTree<HoleImage>,
}

/// A wall and its distance from the point asked for.
#[derive(Clone, Copy, Debug)]
pub(crate) struct NearWall {
    pub(crate) image: WallImage,
    pub(crate) distance: f64,
}

#[derive(Clone, Copy)]
struct HoleImage {
    wall: Wall,
    image: WallImage,
}

impl RTreeObject for HoleImage {
    type Envelope = AABB<[f64; 2]>;

    fn envelope(&self) -> Self::Envelope {
        let half = DVec2::splat(self.wall.circle.radius);
        let center = self.wall.circle.center;
        AABB::from_corners((center - half).to_array(), (center + half).to_array())
    }
}

impl PointDistance for HoleImage {
    fn distance_2(&self, point: &[f64; 2]) -> f64 {
        self.wall
            .distance(DVec2::from_array(*point))
            .max(0.0)
            .powi(2)
    }
}

impl<'a> Clearance<'a> {
    pub(crate) fn new(domain: &'a Domain) -> Self {
        let images = domain
            .wall_ids()
            .take(domain.hole_count())
            .flat_map(|wall| {
                domain.near_shifts().map(move |shift| {
                    let image = WallImage { wall, shift };
                    HoleImage {
                        wall: domain.wall_image(image),
                        image,
                    }
                })
            });
        Self {
            domain,
            holes: RTree::bulk_load(images.collect()),
        }
    }

    /// The nearest wall to `p` that `admit` lets pass; `None` when no wall does.
    ///
    /// In a periodic domain `p` may lie anywhere: it is moved into the rectangle and the answer
    /// back.
    pub(crate) fn nearest(
        &self,
        p: DVec2,
        mut admit: impl FnMut(WallImage) -> bool,
    ) -> Option<NearWall> {
        let home = self.home(p);
        let query = (p - self.domain.translation(home)).to_array();
        let hole = self.holes.nearest_neighbor_iter(query).find_map(|hole| {
            let image = WallImage {
                wall: hole.image.wall,
                shift: hole.image.shift + home,
            };
            admit(image).then(|| NearWall {
                image,
                distance: hole.wall.distance(DVec2::from_array(query)),
            })
        });
        let bounding = self.bounding(p).filter(|near| admit(near.image));
        match (hole, bounding) {
            (Some(hole), Some(bounding)) => Some(if bounding.distance < hole.distance {
                bounding
            } else {
                hole
            }),
            (hole, bounding) => hole.or(bounding),
        }
    }

    /// Every wall nearer to `p` than `reach`, in no particular order.
    pub(crate) fn within(&self, p: DVec2, reach: f64) -> impl Iterator<Item = NearWall> + use<'_> {
        let home = self.home(p);
        let query = p - self.domain.translation(home);
        let holes = self
            .holes
            .locate_within_distance(query.to_array(), reach * reach)
            .map(move |hole| NearWall {
                image: WallImage {
                    wall: hole.image.wall,
                    shift: hole.image.shift + home,
                },
                distance: hole.wall.distance(query),
            });
        holes.chain(self.bounding(p).filter(move |near| near.distance < reach))
    }

    fn bounding(&self, p: DVec2) -> Option<NearWall> {
        self.domain.bounding().map(|wall| self.measured(wall, p))
    }

    fn measured(&self, wall: WallId, p: DVec2) -> NearWall {
        NearWall {
            image: WallImage {
                wall,
                shift: Shift::ZERO,
            },
            distance: self.domain.wall(wall).distance(p),
        }
    }

    /// The periods that lead from the rectangle to `p`.
    fn home(&self, p: DVec2) -> Shift {
        self.domain
            .period()
            .map_or(Shift::ZERO, |period| (p / period).floor().as_ivec2())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::wall::Circle;

    #[test]
    fn the_nearest_image_is_found_across_the_border() {
        let holes = [
            Circle::new(DVec2::new(0.05, 0.5), 0.02),
            Circle::new(DVec2::new(0.5, 0.5), 0.1),
        ];
        let domain = Domain::periodic(DVec2::ONE, &holes).unwrap();
        let near = Clearance::new(&domain)
            .nearest(DVec2::new(2.95, -0.5), |_| true)
            .unwrap();
        assert_eq!(
            (near.image.wall, near.image.shift),
            (WallId(0), Shift::new(3, -1))
        );
        assert!((near.distance - 0.08).abs() < 1e-12);
    }

    #[test]
    fn the_bounding_circle_counts_as_a_wall() {
        let domain = Domain::in_circle(
            Circle::new(DVec2::ZERO, 1.0),
            &[Circle::new(DVec2::ZERO, 0.1)],
        )
        .unwrap();
        let near = Clearance::new(&domain)
            .nearest(DVec2::new(0.9, 0.0), |_| true)
            .unwrap();
        assert_eq!(Some(near.image.wall), domain.bounding());
    }
}
