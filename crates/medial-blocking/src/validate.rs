//! What is wrong with circles that should make a domain: all defects, found once, at the door.
//!
//! Two walls count as touching when their gap is below [`RESOLVED_GAP`] of the smaller radius, or
//! below 2^-36 of the largest coordinate: closer than that the circles' own rounding decides what
//! the gap looks like.

use glam::DVec2;
use rstar::primitives::{GeomWithData, Rectangle};
use rstar::{AABB, RTree};

use crate::domain::Domain;
use crate::error::{Defect, MAX_LISTED_DEFECTS};
use crate::wall::{Circle, Wall, WallId, WallImage, usable_coordinate, usable_length};

/// Smallest accepted gap between two walls, as a fraction of the smaller of their radii.
pub const RESOLVED_GAP: f64 = 1e-7;

/// The same bound as a fraction of the largest coordinate of the domain, 2^-36.
const RESOLVED_COORDINATE: f64 = 1.0 / (1u64 << 36) as f64;

impl Domain {
    /// Defects of single circles.
    pub(crate) fn circle_defects(&self) -> Vec<Defect> {
        let mut defects = Vec::new();
        if self.hole_count() == 0 {
            defects.push(Defect::NoHoles);
        }
        for (id, wall) in self.wall_ids().zip(self.walls()) {
            let Circle { center, radius } = wall.circle;
            for axis in (0..2).filter(|&axis| !usable_coordinate(center[axis])) {
                defects.push(Defect::Center {
                    wall: self.name(id),
                    axis: ['x', 'y'][axis],
                    value: center[axis],
                });
            }
            if !usable_length(radius) {
                defects.push(Defect::Radius {
                    wall: self.name(id),
                    radius,
                });
            }
        }
        defects
    }

    /// Defects of pairs of circles, in the order of their ids.
    pub(crate) fn pair_defects(&self) -> Vec<Defect> {
        let rounding = self.rounding();
        let mut defects = self.tiny_defects(rounding);
        defects.extend(self.bounding_defects(rounding));
        let tree = self.hole_boxes();
        for id in self.wall_ids().take(self.hole_count()) {
            let circle = self.wall(id).circle;
            let mut near: Vec<WallImage> = tree
                .locate_in_envelope_intersecting(inflated_box(circle, rounding))
                .map(|object| object.data)
                .filter(|image| (image.wall, image.shift.to_array()) > (id, [0, 0]))
                .collect();
            near.sort_by_key(|image| (image.wall, image.shift.to_array()));
            for image in near {
                defects.extend(self.pair_defect(id, image, rounding));
                if defects.len() >= MAX_LISTED_DEFECTS {
                    return defects;
                }
            }
        }
        defects
    }

    fn pair_defect(&self, first: WallId, image: WallImage, rounding: f64) -> Option<Defect> {
        let (a, b) = (self.wall(first).circle, self.wall_image(image).circle);
        let gap = a.center.distance(b.center) - a.radius - b.radius;
        if gap > smallest_gap(a.radius, b.radius, rounding) {
            return None;
        }
        let (first, second, shift) = (
            self.name(first),
            self.name(image.wall),
            image.shift.to_array(),
        );
        Some(if a == b {
            Defect::Duplicate { first, second }
        } else {
            Defect::Gap {
                first,
                second,
                shift,
                gap,
            }
        })
    }

    /// Circles so small beside the coordinates that their points would be rounded together.
    fn tiny_defects(&self, rounding: f64) -> Vec<Defect> {
        let tiny = |&(_, wall): &(WallId, &Wall)| wall.circle.radius <= rounding;
        self.wall_ids()
            .zip(self.walls())
            .filter(tiny)
            .map(|(id, wall)| Defect::Tiny {
                wall: self.name(id),
                radius: wall.circle.radius,
            })
            .take(MAX_LISTED_DEFECTS)
            .collect()
    }

    fn bounding_defects(&self, rounding: f64) -> Vec<Defect> {
        let Some(bounding) = self.bounding() else {
            return Vec::new();
        };
        let outer = self.wall(bounding).circle;
        self.wall_ids()
            .take(self.hole_count())
            .filter_map(|id| {
                let hole = self.wall(id).circle;
                let gap = outer.radius - outer.center.distance(hole.center) - hole.radius;
                let inside = gap > smallest_gap(outer.radius, hole.radius, rounding);
                (!inside).then(|| Defect::Outside {
                    hole: self.name(id),
                    gap,
                })
            })
            .take(MAX_LISTED_DEFECTS)
            .collect()
    }

    /// Boxes of the holes and, in a periodic domain, of their eight nearest images.
    fn hole_boxes(&self) -> RTree<GeomWithData<Rectangle<[f64; 2]>, WallImage>> {
        let boxes = self.wall_ids().take(self.hole_count()).flat_map(|wall| {
            self.near_shifts().map(move |shift| {
                let image = WallImage { wall, shift };
                GeomWithData::new(
                    Rectangle::from_aabb(inflated_box(self.wall_image(image).circle, 0.0)),
                    image,
                )
            })
        });
        RTree::bulk_load(boxes.collect())
    }

    /// A gap below this cannot be told from rounding.
    fn rounding(&self) -> f64 {
        self.largest_number() * RESOLVED_COORDINATE
    }
}

fn smallest_gap(r1: f64, r2: f64, rounding: f64) -> f64 {
    (RESOLVED_GAP * r1.min(r2)).max(rounding)
}

fn inflated_box(circle: Circle, by: f64) -> AABB<[f64; 2]> {
    let half = DVec2::splat(circle.radius * (1.0 + RESOLVED_GAP) + by);
    AABB::from_corners(
        (circle.center - half).to_array(),
        (circle.center + half).to_array(),
    )
}
