//! Areas coloured by a share of what is due to them: red and blue to either side of white, which is exactly their due.

use mesh_io::svg::{Color, Panel, Stroke, Style};

/// Shades between white and either end.
const STEPS: usize = 8;

/// Colours of the shares 0, 1, and 2 and more.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shades {
    /// Nothing.
    pub(super) none: Color,
    /// Twice the due and more.
    pub(super) twice: Color,
}

impl Shades {
    /// What lacks is red.
    pub(super) const LACK_IS_RED: Self = Self {
        none: Color([0xf0, 0xc2, 0xb8]),
        twice: Color([0xa9, 0xc8, 0xe8]),
    };
    /// What is too much is red.
    pub(super) const EXCESS_IS_RED: Self = Self {
        none: Self::LACK_IS_RED.twice,
        twice: Self::LACK_IS_RED.none,
    };

    /// Draws areas with their shares, one mark per shade.
    pub(super) fn draw<A>(self, panel: &mut Panel, name: &str, edge: Stroke, areas: &[(A, f64)])
    where
        A: AsRef<[glam::DVec2]>,
    {
        for step in 0..=2 * STEPS {
            let of_step = areas
                .iter()
                .filter(|&&(_, share)| step_of(share) == step)
                .map(|(corners, _)| corners.as_ref().iter().copied());
            let share = step as f64 / STEPS as f64;
            panel
                .layer(
                    &format!("{name} {share}"),
                    Style::line(edge).filled(self.color(share)),
                )
                .polygons(of_step);
        }
    }

    /// The colour of a share.
    fn color(self, share: f64) -> Color {
        if share < 1.0 {
            self.none.mixed(Color::WHITE, share)
        } else {
            Color::WHITE.mixed(self.twice, share - 1.0)
        }
    }
}

/// The step of a share, rounded; all above 2 are at the top.
fn step_of(share: f64) -> usize {
    (share * STEPS as f64).round().min(2.0 * STEPS as f64) as usize
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_share_has_a_step() {
        let steps = [0.0, 0.04, 0.5, 1.0, 1.99, 2.0, 1e300, f64::INFINITY].map(step_of);
        assert_eq!(steps, [0, 0, 4, 8, 16, 16, 16, 16]);
    }

    #[test]
    fn the_due_is_white_and_the_ends_are_pure() {
        let shades = Shades::LACK_IS_RED;
        assert_eq!(shades.color(0.0), shades.none);
        assert_eq!(shades.color(1.0), Color::WHITE);
        assert_eq!(shades.color(2.0), shades.twice);
    }
}
