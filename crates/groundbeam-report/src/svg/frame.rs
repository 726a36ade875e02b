//! The scale from positions along the beam to the width of the page, the same for all panels.

use super::ground::farthest;
use groundbeam::Model;

/// The width of a picture.
pub(super) const WIDTH: f64 = 960.0;
/// The width of a figure on paper, where the same words stand larger.
const NARROW: f64 = 720.0;
/// Left of this stand the numbers of the axes.
pub(super) const LEFT: f64 = 86.0;
/// Kept free beside where panels end.
const BESIDE: f64 = 24.0;

/// What stands beside the beam stands so much nearer than where the picture ends.
pub(super) const ROOM: f64 = 1.15;
/// How far a picture shows ground beside the beam, in lengths of the beam, where something stands there.
const STEPS: [f64; 2] = [0.3, 0.6];

/// The scale of x.
#[derive(Debug, Clone, Copy)]
pub(super) struct Frame {
    /// The beam's length.
    pub length: f64,
    /// How much ground is shown beyond each end.
    pub margin: f64,
    /// The width of the page.
    pub width: f64,
}

impl Frame {
    /// Shows as much ground beyond the ends as it takes to level out, within reason.
    pub fn of(model: &Model) -> Self {
        let length = model.beam.length;
        let reach = [0.0, length * (1.0 - f64::EPSILON)].map(|x| {
            let (spring, shear) = model.foundation.constants_at(x);
            3.0 * (shear / spring).sqrt()
        });
        let margin = reach[0].max(reach[1]).clamp(0.05 * length, 0.15 * length);
        // What stands beside the beam is shown up to half its length away; in steps, so that the picture stays where it is
        // while something is dragged.
        let wanted = ROOM * farthest(model, STEPS[1] * length / ROOM);
        let steps = [margin, STEPS[0] * length];
        let margin = steps.into_iter().find(|step| wanted <= *step).unwrap_or(STEPS[1] * length);
        Frame { length, margin, width: WIDTH }
    }

    /// The same for a figure on paper.
    pub fn narrow(model: &Model) -> Self {
        Frame { width: NARROW, ..Frame::of(model) }
    }

    /// The same on a page of another width.
    pub fn on_page(self, width: f64) -> Self {
        Frame { width, ..self }
    }

    /// Where panels end.
    pub fn right(&self) -> f64 {
        self.width - BESIDE
    }

    /// Where the name of the axis ends: on a narrow page beside the last number.
    pub fn end_of_axis(&self) -> f64 {
        if self.width < WIDTH { self.width - 4.0 } else { self.right() }
    }

    /// Page units for one unit of length.
    pub fn scale(&self) -> f64 {
        (self.right() - LEFT) / (self.length + 2.0 * self.margin)
    }

    /// The position on the page.
    pub fn x(&self, x: f64) -> f64 {
        LEFT + (x + self.margin) * self.scale()
    }
}
