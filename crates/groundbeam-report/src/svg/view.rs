//! Draws the picture for a page: without a heading, with any width, and with handles.

use super::canvas::Canvas;
use super::frame::{Frame, ROOM};
use super::ground;
use super::samples::Samples;
use super::{diagrams, edges, stacked, supports, system, with_diagrams};
use crate::context::Context;
use crate::font::Metrics;
use groundbeam::{Model, Solution, model::Extent, solution::Side};

/// A picture with handles. Positions are in units of the picture, from its upper left corner.
#[derive(Debug, Clone, PartialEq)]
pub struct View {
    /// The picture as an SVG file.
    pub svg: String,
    /// Its width and height.
    pub size: [f64; 2],
    /// Coordinate of x = 0.
    pub left: f64,
    /// Drawn length of a unit of length \[1/m\].
    pub scale: f64,
    /// Its handles.
    pub handles: Vec<Handle>,
}

/// A handle of the picture for a position in the model.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Handle {
    /// The object that the handle moves.
    pub grip: Grip,
    /// The position along the beam \[m\].
    pub at: f64,
    /// Position in the picture.
    pub place: [f64; 2],
    /// Allowed range of positions in the model \[m\].
    pub range: [f64; 2],
}

/// The object of a handle, by its index in the model.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Grip {
    /// The point at which a load acts.
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

/// Smallest page width at which labels find positions.
const NARROWEST: f64 = 440.0;
/// Above this width the picture is only magnified.
const WIDEST: f64 = 1400.0;
/// Margin above the first panel.
const TOP: f64 = 8.0;
/// Height of a load's handle above the beam.
const GRIP: f64 = 24.0;

/// The requested width, within limits.
pub(super) fn sensible(width: f64) -> f64 {
    if width.is_finite() { width.clamp(NARROWEST, WIDEST) } else { WIDEST }
}

/// The picture of [`picture`](super::picture) without its heading, as wide as the page.
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

/// Handles of loads above the beam or on the ground, of hinges in the beam, and of supports below it.
/// `underside` is the drawn height of the beam, `surface` that of the ground.
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
    // The range ends where the drawn ground ends, so that the picture does not move away from a dragged
    // object.
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
