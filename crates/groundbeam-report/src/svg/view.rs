//! Draws a solution for a web page, without a heading, with any width, and with handles for dragging.

use super::canvas::Canvas;
use super::frame::{Frame, ROOM};
use super::ground;
use super::samples::Samples;
use super::{diagrams, edges, stacked, supports, system, with_diagrams};
use crate::context::Context;
use crate::font::Metrics;
use groundbeam::{Model, Solution, model::Extent, solution::Side};

/// A picture with handles for dragging. Coordinates are in picture units and start at the upper left corner.
#[derive(Debug, Clone, PartialEq)]
pub struct View {
    /// The picture as an SVG file.
    pub svg: String,
    /// Width and height of the picture.
    pub size: [f64; 2],
    /// Horizontal coordinate of the left end of the beam in the picture.
    pub left: f64,
    /// Number of picture units per metre of the model \[1/m\].
    pub scale: f64,
    /// Handles of the picture.
    pub handles: Vec<Handle>,
}

/// A handle with which an object of the model is moved along the beam.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Handle {
    /// The object that the handle moves.
    pub grip: Grip,
    /// Position of the object along the beam \[m\].
    pub at: f64,
    /// Coordinates of the handle in the picture.
    pub place: [f64; 2],
    /// Allowed range of positions in the model \[m\].
    pub range: [f64; 2],
}

/// The object that a handle moves, with its index in the model.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Grip {
    /// A load that acts at a point.
    Load(usize),
    /// Start of a distributed load.
    From(usize),
    /// End of a distributed load.
    To(usize),
    /// A support.
    Support(usize),
    /// A hinge.
    Hinge(usize),
}

/// Smallest width of a page on which there is room for the labels.
const NARROWEST: f64 = 440.0;
/// Largest width of the picture. A wider page only magnifies the picture.
const WIDEST: f64 = 1400.0;
/// Margin above the first panel.
const TOP: f64 = 8.0;
/// Height of a load's handle above the beam.
const GRIP: f64 = 24.0;

/// The requested width, limited to the range from `NARROWEST` to `WIDEST`.
pub(super) fn sensible(width: f64) -> f64 {
    if width.is_finite() { width.clamp(NARROWEST, WIDEST) } else { WIDEST }
}

/// Draws the content of [`picture`](super::picture) without its heading, as wide as the page.
pub fn view(solution: &Solution, context: &Context, width: f64) -> View {
    let metrics = Metrics::new();
    let frame = Frame::of(solution.model()).on_page(sensible(width)).with_depths(context.depths);
    let samples = Samples::of(solution);
    let edges = edges(solution);

    let mut page = Canvas::new();
    let system = system::draw(solution, context.units, &frame, &samples, &metrics);
    let down = TOP - system.reach()[0];
    let y = stacked(&mut page, system, TOP);
    let diagrams = diagrams(solution, context.units, &samples, &edges);
    let height = with_diagrams(&mut page, diagrams, (&frame, &metrics, context.units), y);
    let scale = system::vertical_scale(solution, &frame, &samples);
    let underside = |x: f64| scale * solution.at(x, Side::Right).deflection + down;
    let surface = |x: f64| system::level(solution, scale, x) + down;
    let handles = handles(solution.model(), &frame, underside, surface);
    let svg =
        page.finish(frame.width, height, "The beam on its ground and its diagrams").to_string();
    let size = [frame.width, height];
    View { svg, size, left: frame.x(0.0), scale: frame.scale(), handles }
}

/// Handles of the loads, hinges and supports. `underside` and `surface` return y coordinates of the beam's underside
/// and of the ground's surface.
pub(super) fn handles(
    model: &Model,
    frame: &Frame,
    underside: impl Fn(f64) -> f64,
    surface: impl Fn(f64) -> f64,
) -> Vec<Handle> {
    let handle = |grip, at: f64, rise: f64| Handle {
        grip,
        at,
        place: [frame.x(at), underside(at) - rise],
        range: [0.0, frame.length],
    };
    // A load on the ground can be dragged only within the drawn ground. Beyond it, the margins of the picture
    // would change during the drag.
    let [left, right] = ground::margins(model, frame);
    let most = frame.margin / ROOM;
    let reach = [-left.min(most), frame.length + right.min(most)];
    let on_ground = |grip, at: f64, rise: f64| {
        let is_seen = reach[0] <= at && at <= reach[1];
        let rise = if at < 0.0 || at > frame.length { rise } else { -rise };
        let place = [frame.x(at), surface(at) - rise];
        is_seen.then_some(Handle { grip, at, place, range: reach })
    };
    let thickness = |x: f64| system::thickness(frame, x);
    let mut all = Vec::new();
    for (i, load) in model.loads.iter().enumerate() {
        let [from, to] = load.extent().ends();
        let above = thickness(from) + GRIP;
        let (grips, rises) = match load.extent() {
            Extent::Point { .. } => (vec![(Grip::Load(i), from)], [above, GRIP]),
            Extent::Distributed { .. } => {
                (vec![(Grip::From(i), from), (Grip::To(i), to)], [above - 9.0, GRIP - 12.0])
            }
        };
        let [over_beam, over_ground] = rises;
        all.extend(grips.into_iter().filter_map(|(grip, at)| match load.is_on_ground() {
            true => on_ground(grip, at, over_ground),
            false => Some(handle(grip, at, over_beam)),
        }));
    }
    for (i, hinge) in model.hinges.iter().enumerate() {
        all.push(handle(Grip::Hinge(i), hinge.at, 0.5 * thickness(hinge.at)));
    }
    for (i, support) in model.supports.iter().enumerate() {
        all.push(handle(Grip::Support(i), support.at, -0.5 * supports::HEIGHT));
    }
    all
}
