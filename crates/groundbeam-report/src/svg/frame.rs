//! Converts positions along the beam to page coordinates, with one scale for all panels. Computes the beam's drawn depth.

use super::ground::farthest;
use groundbeam::{Model, solution::Side};
use groundbeam_file::Depth;

/// Width of a picture.
pub(super) const WIDTH: f64 = 960.0;
/// Width of a figure on paper. It is smaller than [`WIDTH`], so that the text appears larger.
const NARROW: f64 = 720.0;
/// Width of the left margin, which contains the numbers of the axes.
pub(super) const LEFT: f64 = 86.0;
/// Width of the right margin.
const BESIDE: f64 = 24.0;

/// The ground is drawn beyond each end of the beam for at least this multiple of the distance between the
/// beam and the farthest object outside the beam.
pub(super) const ROOM: f64 = 1.15;
/// Possible widths of the ground drawn beyond each end of the beam, relative to the beam length, if objects
/// lie outside the beam.
const STEPS: [f64; 2] = [0.3, 0.6];

/// Largest drawn depth of a beam with varying depth, relative to the drawn depth of a uniform beam.
const DEEPEST: f64 = 1.5;
/// Smallest drawn depth of a beam with varying depth, relative to the drawn depth of a uniform beam.
const SLIMMEST: f64 = 0.3;
/// Number of steps between the ends of a stretch on which the beam's depth varies.
const STEPS_OF_DEPTH: u32 = 16;

/// Horizontal scale of a picture, and relative depths of the drawn beam.
#[derive(Debug, Clone, Copy)]
pub(super) struct Frame<'a> {
    /// The beam's length.
    pub length: f64,
    /// Length of the ground drawn beyond each end of the beam.
    pub margin: f64,
    /// The width of the page.
    pub width: f64,
    /// Depths of the beam's cross-section; empty if the depth does not vary.
    depths: &'a [Depth],
    /// Largest depth of the beam's cross-section.
    largest: f64,
}

impl<'a> Frame<'a> {
    /// Returns the frame for a model. The ground is drawn over 5 % to 15 % of the beam length beyond each end. Objects
    /// outside the beam increase this to at most 60 %.
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
        Frame { length, margin, width: WIDTH, depths: &[], largest: 0.0 }
    }

    /// The frame of a figure on paper.
    pub fn narrow(model: &Model) -> Self {
        Frame { width: NARROW, ..Frame::of(model) }
    }

    /// The frame on a page of another width.
    pub fn on_page(self, width: f64) -> Self {
        Frame { width, ..self }
    }

    /// Returns the frame with the depths of the beam's cross-section.
    pub fn with_depths(self, depths: &'a [Depth]) -> Self {
        let largest = depths.iter().map(|stretch| stretch.depth.largest()).fold(0.0, f64::max);
        let first = depths.first().map(|stretch| stretch.depth);
        let varies = |stretch: &Depth| !stretch.depth.is_constant() || Some(stretch.depth) != first;
        let depths = if largest > 0.0 && depths.iter().any(varies) { depths } else { &[] };
        Frame { depths, largest, ..self }
    }

    /// Whether the drawn depth of the beam varies.
    pub fn has_depths(&self) -> bool {
        !self.depths.is_empty()
    }

    /// Drawn depth of the beam on one side of a position, relative to the drawn depth of a uniform beam.
    pub fn depth(&self, x: f64, side: Side) -> f64 {
        let beside = |stretch: &&Depth| match side {
            Side::Left => stretch.from < x && x <= stretch.to,
            Side::Right => stretch.from <= x && x < stretch.to,
        };
        let ends_at = |stretch: &&Depth| stretch.from == x || stretch.to == x;
        let found = self.depths.iter().find(beside).or_else(|| self.depths.iter().find(ends_at));
        found.map_or(1.0, |&Depth { from, to, depth }| {
            (DEEPEST * depth.at((x - from) / (to - from)) / self.largest).max(SLIMMEST)
        })
    }

    /// Returns positions on the upper side of the beam, which include `nodes`, and drawn depths relative to that of a
    /// uniform beam.
    pub fn upper_side(&self, nodes: &[f64]) -> Vec<(f64, f64)> {
        let mut places = nodes.to_vec();
        for &Depth { from, to, depth } in self.depths {
            let steps = if depth.is_constant() { 1 } else { STEPS_OF_DEPTH };
            let at = |i| from + (to - from) * f64::from(i) / f64::from(steps);
            places.extend((0..=steps).map(at));
        }
        places.sort_by(f64::total_cmp);
        places.dedup();
        let sides = |x: f64| [Side::Left, Side::Right].map(|side| (x, self.depth(x, side)));
        let mut line: Vec<(f64, f64)> = places.into_iter().flat_map(sides).collect();
        line.dedup();
        line
    }

    /// Right end of the panels.
    pub fn right(&self) -> f64 {
        self.width - BESIDE
    }

    /// Page coordinate of the right end of the axis name. On a narrow page the name extends into the margin,
    /// beside the last number.
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

#[cfg(test)]
mod tests {
    use super::*;
    use groundbeam::{Beam, Foundation, model::Profile};

    fn frame(depths: &[Depth]) -> Frame<'_> {
        let model = Model::new(Beam::uniform(4.0, 1.0), Foundation::winkler(1.0));
        Frame::of(&model).with_depths(depths)
    }

    /// The depth of the beam is 1.2 m on the left half. On the right half it decreases from 0.9 m to 0.6 m.
    #[test]
    fn a_beam_of_varying_depth_is_drawn_with_its_depth() {
        let stretch = |from, to, depth| Depth { from, to, depth };
        let depths = [
            stretch(0.0, 2.0, Profile::constant(1.2)),
            stretch(2.0, 4.0, Profile::linear(0.9, 0.6)),
        ];
        let haunched = frame(&depths);
        let found = [(0.0, Side::Right), (2.0, Side::Left), (2.0, Side::Right), (4.0, Side::Left)]
            .map(|(x, side)| haunched.depth(x, side));
        for (found, expected) in found.into_iter().zip([1.5, 1.5, 1.125, 0.75]) {
            assert!((found - expected).abs() < 1e-12, "{found}");
        }
        assert!((haunched.depth(4.0, Side::Right) - 0.75).abs() < 1e-12);
        let upper = haunched.upper_side(&[0.0, 4.0]);
        assert!(upper.is_sorted_by(|a, b| a.0 <= b.0) && upper.len() == 19, "{upper:?}");
    }

    #[test]
    fn a_uniform_beam_is_drawn_with_one_depth() {
        let uniform = [Depth { from: 0.0, to: 4.0, depth: Profile::constant(1.2) }];
        let frame = frame(&uniform);
        assert!(!frame.has_depths() && frame.depth(1.0, Side::Right) == 1.0);
        assert_eq!(frame.upper_side(&[0.0, 4.0]), [(0.0, 1.0), (4.0, 1.0)]);
    }
}
