//! The horizontal scale, the same for all panels: positions along the beam to page coordinates.

use super::ground::farthest;
use groundbeam::Model;

/// Width of a picture.
pub(super) const WIDTH: f64 = 960.0;
/// Width of a figure on paper, where the same text appears larger.
const NARROW: f64 = 720.0;
/// Width of the left margin, which contains the numbers of the axes.
pub(super) const LEFT: f64 = 86.0;
/// Width of the right margin.
const BESIDE: f64 = 24.0;

/// Ratio of the drawn margin to the distance of the farthest object outside the beam.
pub(super) const ROOM: f64 = 1.15;
/// Widths of the drawn ground outside the beam, relative to its length, if there are objects.
const STEPS: [f64; 2] = [0.3, 0.6];

/// Scale of x.
#[derive(Debug, Clone, Copy)]
pub(super) struct Frame {
    /// The beam's length.
    pub length: f64,
    /// Length of ground shown beyond each end.
    pub margin: f64,
    /// The width of the page.
    pub width: f64,
}

impl Frame {
    /// Shows the ground beyond the ends until its surface is almost level, within limits.
    pub fn of(model: &Model) -> Self {
        let length = model.beam.length;
        let reach = [0.0, length * (1.0 - f64::EPSILON)].map(|x| {
            let (spring, shear) = model.foundation.constants_at(x);
            3.0 * (shear / spring).sqrt()
        });
        let margin = reach[0].max(reach[1]).clamp(0.05 * length, 0.15 * length);
        // Objects outside the beam are shown up to half a beam length away. The margin changes in steps, so
        // that the picture does not move while an object is dragged.
        let wanted = ROOM * farthest(model, STEPS[1] * length / ROOM);
        let steps = [margin, STEPS[0] * length];
        let margin = steps.into_iter().find(|step| wanted <= *step).unwrap_or(STEPS[1] * length);
        Frame { length, margin, width: WIDTH }
    }

    /// The frame of a figure on paper.
    pub fn narrow(model: &Model) -> Self {
        Frame { width: NARROW, ..Frame::of(model) }
    }

    /// The frame on a page of another width.
    pub fn on_page(self, width: f64) -> Self {
        Frame { width, ..self }
    }

    /// Right end of the panels.
    pub fn right(&self) -> f64 {
        self.width - BESIDE
    }

    /// End of the axis name; on a narrow page it is beside the last number.
    pub fn end_of_axis(&self) -> f64 {
        if self.width < WIDTH { self.width - 4.0 } else { self.right() }
    }

    /// Page units per unit of length.
    pub fn scale(&self) -> f64 {
        (self.right() - LEFT) / (self.length + 2.0 * self.margin)
    }

    /// Page coordinate of a position.
    pub fn x(&self, x: f64) -> f64 {
        LEFT + (x + self.margin) * self.scale()
    }
}
