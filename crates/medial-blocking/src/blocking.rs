//! The blocking scheme of a domain: medial axis and blocks, before any node is placed (§3).

use std::ops::ControlFlow;

use delaunay_core::progress::{Progress, silent};
use glam::DVec2;

use crate::block::{ArcSide, Block, BlockCorner, BlockId, BlockSide, blocks_of};
use crate::blocking2d::block_pairs;
use crate::domain::Domain;
use crate::error::BlockingError;
use crate::medial_axis::SampledAxis;
use crate::medial_graph::{ArcId, MedialArc, MedialVertex, MedialVertexId, medial_arcs, ring};
use crate::resolve::Resolved;
use crate::sample::Samples;
use crate::triangulation::DomainTriangulation;
use crate::wall::{Wall, WallId};

/// An arc shorter than this in units of its clearance is what rounding leaves of a vertex shared by
/// four or more walls; see [`Blocking::thin_arcs`].
pub const COLLAPSED: f64 = 1e-6;

/// A domain cut into blocks.
///
/// `h ≥ 2` holes in a circle give 2 (h − 1) medial vertices and 6 (h − 1) blocks, `h` holes in a
/// periodic rectangle 2 h and 6 h. A single hole in a circle gives 8 blocks, its closed medial axis
/// being cut four times.
#[derive(Clone, Debug)]
pub struct Blocking {
    domain: Domain,
    samples: Samples,
    triangulation: DomainTriangulation,
    vertices: Vec<MedialVertex>,
    arcs: Vec<MedialArc>,
    blocks: Vec<Block>,
}

impl Blocking {
    /// Cuts `domain` into blocks.
    ///
    /// # Errors
    /// [`BlockingError::Unresolved`] or [`BlockingError::TooManySamples`] when double precision or
    /// 32-bit ids do not resolve the gaps.
    ///
    /// O(s log s) for s boundary samples; s is proportional to the number of holes while gaps are
    /// of the size of the holes. Source: Guoy & Erickson, Algorithms 1 and 2.
    pub fn of(domain: &Domain) -> Result<Self, BlockingError> {
        Self::of_with(domain, &mut silent)
    }

    /// The same as [`Blocking::of`], reporting progress to `report`, which may stop the work.
    ///
    /// # Errors
    /// As [`Blocking::of`], and [`BlockingError::Cancelled`].
    pub fn of_with(
        domain: &Domain,
        report: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Self, BlockingError> {
        let Resolved {
            samples,
            triangulation,
            vertices,
        } = Resolved::of(domain, report)?;
        let (vertices, arcs) = match domain.bounding() {
            Some(bounding) if vertices.is_empty() => ring(domain, WallId(0), bounding),
            _ => {
                let axis = SampledAxis {
                    domain,
                    samples: &samples,
                    triangulation: &triangulation,
                };
                let arcs = medial_arcs(&axis, &vertices, &block_pairs(&axis));
                (vertices, arcs)
            }
        };
        let blocks = blocks_of(&arcs);
        Ok(Self {
            domain: domain.clone(),
            samples,
            triangulation,
            vertices,
            arcs,
            blocks,
        })
    }

    /// The domain.
    #[must_use]
    pub const fn domain(&self) -> &Domain {
        &self.domain
    }

    /// The boundary samples, their triangulation and the sampled medial axis: §2 as the paper has
    /// it.
    #[must_use]
    pub const fn sampled_axis(&self) -> SampledAxis<'_> {
        SampledAxis {
            domain: &self.domain,
            samples: &self.samples,
            triangulation: &self.triangulation,
        }
    }

    /// The medial vertices.
    #[must_use]
    pub fn vertices(&self) -> &[MedialVertex] {
        &self.vertices
    }

    /// The vertex with this id.
    #[must_use]
    pub fn vertex(&self, id: MedialVertexId) -> &MedialVertex {
        &self.vertices[id.index()]
    }

    /// The medial arcs.
    #[must_use]
    pub fn arcs(&self) -> &[MedialArc] {
        &self.arcs
    }

    /// The arc with this id.
    #[must_use]
    pub fn arc(&self, id: ArcId) -> &MedialArc {
        &self.arcs[id.index()]
    }

    /// The ids of all arcs.
    pub fn arc_ids(&self) -> impl Iterator<Item = ArcId> + use<> {
        (0..self.arcs.len() as u32).map(ArcId)
    }

    /// The blocks, two per arc.
    #[must_use]
    pub fn blocks(&self) -> &[Block] {
        &self.blocks
    }

    /// The block with this id.
    #[must_use]
    pub fn block(&self, id: BlockId) -> &Block {
        &self.blocks[id.index()]
    }

    /// The ids of all blocks.
    pub fn block_ids(&self) -> impl Iterator<Item = BlockId> + use<> {
        (0..self.blocks.len() as u32).map(BlockId)
    }

    /// Where a medial vertex lies as a corner of a block. Exact: see [`Domain::periodic`].
    #[must_use]
    pub fn inner_corner(&self, corner: &BlockCorner) -> DVec2 {
        self.vertex(corner.vertex).center + self.domain.translation(corner.shift)
    }

    /// Where the empty circle at a corner of a block touches the block's wall.
    #[must_use]
    pub fn wall_corner(&self, block: &Block, corner: &BlockCorner) -> DVec2 {
        self.wall_of(block)
            .point_towards(self.touch_direction(corner))
    }

    /// The point at `t` in [0, 1] of a bounding curve of a block, `t` growing with ξ or η.
    ///
    /// Along ξ0 equal steps of `t` turn the ray from the driving hole by equal angles; along ξ1
    /// they are equal lengths of wall.
    #[must_use]
    pub fn curve(&self, id: BlockId, side: BlockSide, t: f64) -> DVec2 {
        let block = self.block(id);
        let ray = |corner| {
            self.inner_corner(corner)
                .lerp(self.wall_corner(block, corner), t)
        };
        match side {
            BlockSide::Xi0 => {
                let u = if block.side == ArcSide::Right {
                    t
                } else {
                    1.0 - t
                };
                self.arc(block.arc).curve.point(u) + self.domain.translation(block.arc_shift)
            }
            BlockSide::Xi1 => {
                let turned = DVec2::from_angle(t * self.wall_sweep(id));
                self.wall_of(block)
                    .point_towards(turned.rotate(self.touch_direction(&block.start)))
            }
            BlockSide::Eta0 => ray(&block.start),
            BlockSide::Eta1 => ray(&block.end),
        }
    }

    /// Radians of wall from η = 0 to η = 1, counterclockwise positive: at most 0 on holes, at least
    /// 0 on the bounding circle.
    #[must_use]
    pub fn wall_sweep(&self, id: BlockId) -> f64 {
        let block = self.block(id);
        let wall = self.wall_of(block);
        // The touching point moves steadily along the wall, so following it in a few steps loses no
        // turn.
        const STEPS: usize = 16;
        let direction = |k: usize| match k {
            0 => self.touch_direction(&block.start),
            STEPS => self.touch_direction(&block.end),
            _ => {
                let p = self.curve(id, BlockSide::Xi0, k as f64 / STEPS as f64);
                (p - wall.circle.center).normalize_or(self.touch_direction(&block.start))
            }
        };
        (0..STEPS)
            .map(|k| direction(k).angle_to(direction(k + 1)))
            .sum()
    }

    /// The wall of a block, at home.
    #[must_use]
    pub fn wall_of(&self, block: &Block) -> &Wall {
        self.domain.wall(block.wall)
    }

    /// Unit vector from the centre of the wall's circle to the touching point at a corner.
    #[must_use]
    pub fn touch_direction(&self, corner: &BlockCorner) -> DVec2 {
        self.vertex(corner.vertex).touches[usize::from(corner.touch)].direction
    }

    /// The arcs shorter than `ratio` times the clearance at the narrower of their ends: their
    /// blocks are thin, or empty where four walls are co-circular.
    ///
    /// Source: §4.2; `ratio` [`COLLAPSED`] finds what rounding leaves of co-circular holes, 0.2 what a
    /// picture shows as thin.
    pub fn thin_arcs(&self, ratio: f64) -> impl Iterator<Item = ArcId> + '_ {
        self.arc_ids().filter(move |&id| self.is_thin(id, ratio))
    }

    pub(crate) fn is_thin(&self, id: ArcId, ratio: f64) -> bool {
        let arc = self.arc(id);
        let clearance = self
            .vertex(arc.start.vertex)
            .clearance
            .min(self.vertex(arc.end.vertex).clearance);
        self.arc_length(id) < ratio * clearance
    }
}
