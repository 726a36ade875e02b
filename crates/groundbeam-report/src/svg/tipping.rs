//! Draws the start of the motion of a beam without equilibrium.

use super::canvas::{Anchor, Canvas, Group};
use super::frame::{Frame, LEFT};
use super::ground::{self, GroundLoads};
use super::labels::{Labels, Rect};
use super::loads::Loads;
use super::paint::{Colour, Fill, Stroke, number};
use super::style::{NOTE, PANEL_TITLE};
use super::system::{BELOW, THICKNESS, thickness};
use super::view::{View, handles, sensible};
use super::{axis_of_x, supports};
use crate::context::Context;
use crate::font::Metrics;
use groundbeam::{Existence, Model, Verdict};

/// Drawn rise of the highest point of the beam above the ground.
const RISE: f64 = 46.0;
/// Margin above the panel.
const TOP: f64 = 8.0;

/// Draws the beam as it tips about an end or a hinge, or rises as a whole. If an equilibrium exists, the beam is drawn
/// before deformation.
///
/// The SVG group of class `moves` contains the beam with its loads. Without hinges, its `data-still` is the transform
/// that returns the beam to the ground.
pub fn tipping(model: &Model, existence: &Existence, context: &Context, width: f64) -> View {
    let metrics = Metrics::new();
    let frame = Frame::of(model).on_page(sensible(width)).with_depths(context.depths);
    let rises = |x: f64| match existence.verdict {
        Verdict::None(motion) => RISE * motion.at(model, x),
        _ => 0.0,
    };
    let mut ground = lying(model, &frame);
    let mut beam = Canvas::new();
    let nodes = nodes(model);
    let under: Vec<_> = nodes.iter().map(|&x| [frame.x(x), rises(x)]).collect();
    let over = frame.upper_side(&nodes).into_iter().rev();
    let over = over.map(|(x, depth)| [frame.x(x), rises(x) - THICKNESS * depth]).collect();
    let outline = [under.clone(), over].concat();
    beam.polyline(&outline, true, Fill::new(Colour::Beam));
    for hinge in &model.hinges {
        let at = [frame.x(hinge.at), rises(hinge.at) - 0.5 * thickness(&frame, hinge.at)];
        supports::hinge(&mut beam, at, hinge.is_free());
    }
    let (left, right) = (8.0, frame.width - 4.0);
    let room = Rect { left, top: f64::NEG_INFINITY, right, bottom: f64::INFINITY };
    let mut labels = Labels::new(&metrics, room);
    labels.avoid_line(&under);
    let top = |x: f64| rises(x) - thickness(&frame, x);
    let loads = Loads { units: context.units, frame: &frame, top: &top };
    loads.draw(&mut beam, &model.loads, &mut labels);
    let line = flat(model, &frame);
    let loads = GroundLoads { units: context.units, frame: &frame, line: &line };
    loads.draw(&mut ground, &model.loads, &mut labels);

    let mut panel = Canvas::new();
    panel.group(ground, Group::Ground);
    let still = model.hinges.is_empty().then(|| laid_back(&frame, rises));
    panel.group(beam, Group::Moves(still));
    let y = panel.reach()[0] - 16.0;
    panel.text([LEFT, y], Anchor::Start, PANEL_TITLE, "Beam and ground");
    let x = LEFT + 1.06 * metrics.width("Beam and ground", PANEL_TITLE.size) + 12.0;
    let note = match existence.verdict {
        Verdict::None(_) => "how the beam begins to move; sizes are not to scale",
        _ => "the beam before it moves",
    };
    panel.text([x, y], Anchor::Start, NOTE, note);
    let [top, bottom] = panel.reach();
    let down = TOP - top;
    let mut page = Canvas::new();
    page.place(panel, down);
    axis_of_x(&mut page, &frame, context.units, bottom + down + 10.0);
    let height = page.reach()[1] + 14.0;
    let handles = handles(model, &frame, |x| rises(x) + down, |_| down);
    let svg = page.finish(frame.width, height, "The beam moves").to_string();
    let size = [frame.width, height];
    View { svg, size, left: frame.x(0.0), scale: frame.scale(), handles }
}

/// Draws the ground with the supports, and the initial position of the beam.
fn lying(model: &Model, frame: &Frame) -> Canvas {
    let mut canvas = Canvas::new();
    let line = flat(model, frame);
    ground::draw(&mut canvas, model, frame, &line, BELOW);
    let [start, end] = [frame.x(0.0), frame.x(frame.length)];
    let over = frame.upper_side(&[0.0, frame.length]).into_iter().rev();
    let over: Vec<_> = over.map(|(x, depth)| [frame.x(x), -THICKNESS * depth]).collect();
    let outline = [vec![[start, 0.0], [end, 0.0]], over].concat();
    let dashes = Stroke::new(Colour::FaintInk, 1.0).dashed(5.0, 4.0);
    canvas.polyline(&outline, true, Fill::NONE.and(dashes));
    for support in &model.supports {
        let outward = match support.at {
            0.0 => -1.0,
            x if x == frame.length => 1.0,
            _ => 0.0,
        };
        supports::draw(&mut canvas, [frame.x(support.at), 0.0], support, outward);
    }
    canvas
}

/// Left and right end points of the ground's surface before loading.
fn flat(model: &Model, frame: &Frame) -> [[f64; 2]; 2] {
    let [left, right] = ground::margins(model, frame);
    [[frame.x(-left), 0.0], [frame.x(frame.length + right), 0.0]]
}

/// Positions of the ends and hinges of the beam. The beam remains straight between them.
fn nodes(model: &Model) -> Vec<f64> {
    let mut nodes: Vec<f64> = model.hinges.iter().map(|hinge| hinge.at).collect();
    nodes.extend([0.0, model.beam.length]);
    nodes.sort_by(f64::total_cmp);
    nodes
}

/// Returns the SVG skew transform that reverses the vertical displacement `rises`, which is linear in x.
fn laid_back(frame: &Frame, rises: impl Fn(f64) -> f64) -> String {
    let [start, end] = [frame.x(0.0), frame.x(frame.length)];
    let slope = (rises(frame.length) - rises(0.0)) / (end - start);
    let shift = rises(0.0) - slope * start;
    format!("matrix(1, {:.6}, 0, 1, 0, {})", -slope, number(-shift))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quantity::Units;
    use crate::svg::Grip;
    use groundbeam::{Beam, Foundation, Hinge, Load};

    fn drawn(model: &Model) -> View {
        let existence = groundbeam::exists(model).unwrap();
        tipping(model, &existence, &Context::new(Units::PLAIN), 800.0)
    }

    /// Returns the y coordinates of the drag handles of all loads.
    fn heights(view: &View) -> Vec<f64> {
        let loads = view.handles.iter().filter(|h| matches!(h.grip, Grip::Load(_)));
        loads.map(|handle| handle.place[1]).collect()
    }

    #[test]
    fn the_lifting_end_is_drawn_above_the_other_end() {
        let beam = || Model::new(Beam::uniform(4.0, 1.0), Foundation::pasternak(1.0, 1.0));
        let at = |model: Model, x: f64| model.with_load(Load::point_force(x, 1.0));
        let left = at(at(beam(), 0.0), 4.0).with_load(Load::point_moment(2.0, -9.0));
        let view = drawn(&left);
        assert!((heights(&view)[0] - heights(&view)[1] - RISE).abs() < 1e-9);
        // The moment acts halfway between the two forces. So the drag handle of the moment in the picture is
        // halfway between the drag handles of the forces.
        let middle = heights(&view)[2];
        assert!((2.0 * middle - heights(&view)[0] - heights(&view)[1]).abs() < 1e-9);
        let right = at(at(beam(), 0.0), 4.0).with_load(Load::point_moment(2.0, 9.0));
        assert!(heights(&drawn(&right))[1] > heights(&drawn(&right))[0]);
        // The transform in `data-still` returns the lifted end of the beam to the ground.
        assert!(view.svg.contains(r#"data-still="matrix(1, "#), "{}", view.svg);
    }

    #[test]
    fn only_the_part_beyond_the_hinge_is_drawn_lifted() {
        let model = Model::new(Beam::uniform(4.0, 1.0), Foundation::pasternak(1.0, 1.0))
            .with_hinge(Hinge::free(2.0))
            .with_load(Load::point_force(1.0, 3.0))
            .with_load(Load::point_force(2.0, 1.0))
            .with_load(Load::point_force(4.0, -0.5));
        let view = drawn(&model);
        let heights = heights(&view);
        assert!((heights[0] - heights[1]).abs() < 1e-9 && heights[2] < heights[0] - 40.0);
        assert!(!view.svg.contains("data-still"), "it does not move as one piece");
    }
}
