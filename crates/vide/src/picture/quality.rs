//! A block mesh with its cells coloured by quality.

use delaunay_core::measure::quad::{corner_angles, scaled_jacobian};
use glam::DVec2;
use medial_blocking::BlockMesh;
use mesh_io::svg::{Color, ColorBar, ColorMap, Panel, Stroke, Style};

use super::blocks::{WIDTH, draw_walls, window_of};

/// By what cells are coloured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CellQuality {
    /// The smallest corner angle in degrees, 90 for a rectangle.
    SmallestAngle,
    /// The scaled Jacobian, 1 for a rectangle, not positive when a cell is not convex.
    ScaledJacobian,
}

impl CellQuality {
    /// The value of a cell, corners counterclockwise.
    #[must_use]
    pub fn of(self, cell: [DVec2; 4]) -> f64 {
        match self {
            Self::SmallestAngle => corner_angles(cell)
                .into_iter()
                .fold(f64::INFINITY, f64::min),
            Self::ScaledJacobian => scaled_jacobian(cell),
        }
    }

    /// The step between ticks, the best value, and what follows the number at a tick.
    const fn scale(self) -> (f64, f64, &'static str) {
        match self {
            Self::SmallestAngle => (15.0, 90.0, "°"),
            Self::ScaledJacobian => (0.2, 1.0, ""),
        }
    }

    /// A colour bar from the tick below `worst` up to the best value.
    fn color_bar(self, worst: f64) -> ColorBar {
        let (step, best, unit) = self.scale();
        // Never below zero, where every cell is bad, and always an interval.
        let steps = ((best - worst.max(0.0)) / step)
            .ceil()
            .clamp(1.0, best / step);
        let low = best - steps * step;
        let ticks = (0..=steps as u32)
            .map(|k| low + f64::from(k) * step)
            .collect();
        let title = match self {
            Self::SmallestAngle => "angle",
            Self::ScaledJacobian => "Jacobian",
        };
        ColorBar {
            map: ColorMap::new(low, best),
            title: title.to_owned(),
            ticks,
            unit: unit.to_owned(),
        }
    }
}

/// The panel of a mesh with coloured cells and a colour bar.
#[must_use]
pub fn quality_panel(mesh: &BlockMesh, quality: CellQuality) -> Panel {
    let cells: Vec<([DVec2; 4], f64)> = mesh.cells().map(|cell| (cell, quality.of(cell))).collect();
    let worst = cells
        .iter()
        .map(|&(_, value)| value)
        .fold(f64::INFINITY, f64::min);
    let bar = quality.color_bar(worst);
    let mut panel = Panel::new(window_of(mesh)).width(WIDTH);
    panel
        .layer("cells", Style::default())
        .colored_polygons(&bar.map, cells);
    draw_walls(&mut panel, mesh.blocking());
    draw_block_borders(&mut panel, mesh);
    panel.color_bar(bar)
}

/// The outlines of the blocks, thin over the colours.
fn draw_block_borders(panel: &mut Panel, mesh: &BlockMesh) {
    let outlines = mesh.grids().iter().map(|grid| {
        let (n, m) = (grid.cells_across(), grid.cells_along());
        let there = (0..=m)
            .map(move |j| grid.node(0, j))
            .chain((1..=n).map(move |i| grid.node(i, m)));
        let back = (0..m)
            .rev()
            .map(move |j| grid.node(n, j))
            .chain((1..n).rev().map(move |i| grid.node(i, 0)));
        there.chain(back)
    });
    panel
        .layer("block borders", Style::line(Stroke::thin(Color::WHITE)))
        .polygons(outlines);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_bar_starts_at_the_tick_below_the_worst_cell() {
        let bar = CellQuality::SmallestAngle.color_bar(46.1);
        assert_eq!(bar.ticks, [45.0, 60.0, 75.0, 90.0]);
        assert_eq!((bar.map.low(), bar.map.high()), (45.0, 90.0));
    }

    #[test]
    fn the_bar_is_an_interval_whatever_the_cells_are() {
        for worst in [f64::NEG_INFINITY, -1.0, 0.0, 90.0, f64::INFINITY, f64::NAN] {
            let bar = CellQuality::SmallestAngle.color_bar(worst);
            assert!(
                bar.map.low() >= 0.0 && bar.map.low() < bar.map.high(),
                "{worst}: {bar:?}"
            );
        }
    }

    #[test]
    fn a_square_is_best_by_both_measures() {
        let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(DVec2::from);
        assert_eq!(CellQuality::SmallestAngle.of(square), 90.0);
        assert_eq!(CellQuality::ScaledJacobian.of(square), 1.0);
    }
}
