//! Draws the model as given: beam, ground, supports and loads before deformation.

use super::canvas::{Anchor, Canvas, printed};
use super::frame::Frame;
use super::ground::{self, GroundLoads};
use super::labels::{Labels, Rect};
use super::loads::Loads;
use super::paint::{Colour, Fill, Stroke};
use super::style::{LABEL, NOTE};
use super::supports;
use crate::font::Metrics;
use crate::quantity::{Kind, Units};
use groundbeam::{Model, existence::RigidMotion, solution::Side};

/// Drawn thickness of the beam.
const THICKNESS: f64 = 9.0;
/// Drawn depth of the largest initial gap.
const DEEPEST: f64 = 22.0;
/// Height of the ground drawn below the lowest point of its surface.
const BELOW: f64 = 30.0;
/// Drawn rise of a tipping end.
const RISE: f64 = 52.0;

/// Draws the model with the beam's underside at y = 0. If a `motion` proves that no equilibrium exists, the
/// beam after this motion is also drawn.
pub(super) fn draw(
    model: &Model,
    motion: Option<RigidMotion>,
    units: Units,
    frame: &Frame,
    metrics: &Metrics,
) -> Canvas {
    let mut canvas = Canvas::new();
    let thickness = |x: f64| THICKNESS * frame.depth(x, Side::Right);
    let page =
        Rect { left: 8.0, top: f64::NEG_INFINITY, right: frame.width - 4.0, bottom: f64::INFINITY };
    let mut labels = Labels::new(metrics, page);
    let [left, right] = [frame.x(0.0), frame.x(frame.length)];
    let (surface, floor) = ground(&mut canvas, model, units, frame, &mut labels);
    let over = frame.upper_side(&[0.0, frame.length]);
    let over: Vec<_> = over.iter().map(|(x, depth)| [frame.x(*x), -THICKNESS * depth]).collect();
    if frame.has_depths() {
        let outline = [&[[right, 0.0], [left, 0.0]], &over[..]].concat();
        canvas.polyline(&outline, true, Fill::new(Colour::Beam));
    } else {
        canvas.rect([left, -THICKNESS], [right - left, THICKNESS], Fill::new(Colour::Beam));
    }
    let highest = over.iter().fold(0.0_f64, |highest, point| highest.min(point[1]));
    labels.avoid(Rect::around([left, highest], [right, 0.0], 0.0));
    for support in &model.supports {
        let outward = match support.at {
            0.0 => -1.0,
            x if x == model.beam.length => 1.0,
            _ => 0.0,
        };
        let x = frame.x(support.at);
        supports::draw(&mut canvas, [x, 0.0], support, outward);
        labels.avoid(Rect::around([x - 12.0, 0.0], [x + 12.0, supports::HEIGHT], 0.0));
    }
    for hinge in &model.hinges {
        let at = [frame.x(hinge.at), -0.5 * thickness(hinge.at)];
        supports::hinge(&mut canvas, at, hinge.is_free());
    }
    if let Some(motion) = motion {
        tipping(&mut canvas, model, motion, frame);
    }
    let loads = Loads { units, frame, top: &|x| -thickness(x) };
    loads.draw(&mut canvas, &model.loads, &mut labels);
    GroundLoads { units, frame, line: &surface }.draw(&mut canvas, &model.loads, &mut labels);
    dimension(&mut canvas, [left, right], floor + BELOW + 22.0, &units.position(frame.length));
    canvas
}

/// Draws the ground with the initial gap. Returns the surface line of the ground and the y coordinate of its
/// lowest point.
fn ground(
    canvas: &mut Canvas,
    model: &Model,
    units: Units,
    frame: &Frame,
    labels: &mut Labels,
) -> (Vec<[f64; 2]>, f64) {
    let deepest = model.gap.iter().fold(0.0_f64, |most, corner| most.max(corner.value.abs()));
    let scale = if deepest > 0.0 { DEEPEST / deepest } else { 0.0 };
    let [left, right] = ground::margins(model, frame);
    let [left, right] = [-left, frame.length + right].map(|x| frame.x(x));
    let corner = |at: f64, value: f64| [frame.x(at), scale * value];
    let mut line: Vec<[f64; 2]> = model.gap.iter().map(|c| corner(c.at, c.value)).collect();
    let [first, last] = [line.first(), line.last()].map(|point| point.map_or(0.0, |p| p[1]));
    line.insert(0, [left, first]);
    line.push([right, last]);
    let floor = line.iter().fold(0.0_f64, |floor, point| floor.max(point[1]));
    let bottom = floor + BELOW;
    ground::draw(canvas, model, frame, &line, bottom);
    labels.avoid_line(&line);
    if deepest > 0.0 {
        let words = printed(&units.write(Kind::Deflection, deepest));
        let words = format!("initial gap, up to {words}, not to scale");
        canvas.text([left + 6.0, bottom - 8.0], Anchor::Start, NOTE, &words);
    } else {
        ground::constants(canvas, model, units, frame, labels, bottom);
    }
    (line, floor)
}

/// Draws the beam after a rigid motion as a dashed line.
fn tipping(canvas: &mut Canvas, model: &Model, motion: RigidMotion, frame: &Frame) {
    let mut corners: Vec<f64> = model.hinges.iter().map(|hinge| hinge.at).collect();
    corners.extend([0.0, model.beam.length]);
    corners.sort_by(f64::total_cmp);
    let point = |x: &f64| [frame.x(*x), RISE * motion.at(model, *x) - 0.5 * THICKNESS];
    let line: Vec<[f64; 2]> = corners.iter().map(point).collect();
    let dashes = Stroke::new(Colour::Shear, 0.3 * THICKNESS).dashed(9.0, 5.0);
    canvas.polyline(&line, false, Fill::NONE.and(dashes));
}

/// Draws a dimension line with the length of the beam. The dimension line is below the ground.
fn dimension(canvas: &mut Canvas, [left, right]: [f64; 2], y: f64, length: &str) {
    let [thin, thick] = [0.8, 1.6].map(|width| Stroke::new(Colour::FaintInk, width));
    canvas.line([left - 6.0, y], [right + 6.0, y], thin);
    for x in [left, right] {
        canvas.line([x, y - 9.0], [x, y + 5.0], thin);
        canvas.line([x - 3.5, y + 3.5], [x + 3.5, y - 3.5], thick);
    }
    let words = printed(&format!("l = {length}"));
    canvas.text([0.5 * (left + right), y - 5.0], Anchor::Middle, LABEL, &words);
}
