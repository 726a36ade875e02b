//! Draws the figures of calculation reports. Each figure is one drawing or diagram, so that pages can break between figures.

use super::canvas::Canvas;
pub(crate) use super::diagram::OF_ENVELOPES;
use super::diagram::{Diagram, worth_naming};
use super::frame::Frame;
use super::samples::Samples;
use super::{PANEL_SPACE, axis_of_x, diagrams, edges, envelope, sketch, system, train};
use crate::context::Context;
use crate::font::Metrics;
use crate::quantity::Units;
use groundbeam::{Field, Model, Solution, existence::RigidMotion};
use groundbeam_run::{Answers, Passages};

/// Draws the model. `motion` is the rigid motion that proves that the model has no equilibrium; it is drawn
/// as well.
pub(crate) fn model(model: &Model, motion: Option<RigidMotion>, context: &Context) -> String {
    let frame = Frame::narrow(model).with_depths(context.depths);
    let drawing = sketch::draw(model, motion, context.units, &frame, &Metrics::new());
    alone(drawing, &frame, None, "The model")
}

/// Draws the deflected beam on the ground.
pub(crate) fn bent(solution: &Solution, context: &Context) -> String {
    let frame = Frame::narrow(solution.model()).with_depths(context.depths);
    let (units, metrics) = (context.units, Metrics::new());
    let drawing = system::draw(solution, units, &frame, &Samples::of(solution), &metrics);
    alone(drawing, &frame, Some(units), "Beam and ground")
}

/// Draws the deflection with the ground's surface, the gap, the contact pressure with the end forces, the
/// bending moment and the shear force of a solution.
pub(crate) fn fields(solution: &Solution, units: Units) -> Vec<String> {
    let (samples, edges) = (Samples::of(solution), edges(solution));
    let of = |field: Field| {
        let range = solution.range(field);
        let extremes = [range.max, range.min].map(|extreme| samples.sizes.extreme(field, extreme));
        Diagram {
            values: samples.field(field),
            extremes: worth_naming(field, extremes.to_vec()),
            edges: &edges,
            ..Diagram::of(field, units)
        }
    };
    let mut deflection = of(Field::Deflection);
    deflection.thin = vec![samples.field(Field::Settlement)];
    deflection.note = "down; the thin line is the ground's surface";
    let all = [deflection, of(Field::Gap)].into_iter();
    let all = all.chain(diagrams(solution, units, &samples, &edges));
    drawn(all, solution.model(), units)
}

/// Draws the envelopes of combinations; empty if no combination is solved.
pub(crate) fn combinations(all: &Answers, units: Units) -> Vec<String> {
    let Some((_, first)) = all.solved().next() else { return Vec::new() };
    drawn(envelope::diagrams(&all.envelope(), units).into_iter(), first.model(), units)
}

/// Draws the envelopes of passages; empty if no position of a train is solved.
pub(crate) fn trains(passages: &Passages, units: Units) -> Vec<String> {
    let first = passages.all.iter().find_map(|passage| Some((passage, passage.solved().next()?)));
    let Some((passage, (_, solution))) = first else { return Vec::new() };
    let sizes = Samples::of(solution).sizes;
    drawn(train::diagrams(passages, units, sizes).into_iter(), passage.model(), units)
}

fn drawn<'a>(all: impl Iterator<Item = Diagram<'a>>, model: &Model, units: Units) -> Vec<String> {
    let (frame, metrics) = (Frame::narrow(model), Metrics::new());
    let figure = |diagram: Diagram| {
        alone(diagram.draw(&frame, &metrics), &frame, Some(units), diagram.title)
    };
    all.map(figure).collect()
}

/// Returns one panel as a separate SVG file, with an axis of positions if `axis` is given.
fn alone(panel: Canvas, frame: &Frame, axis: Option<Units>, title: &str) -> String {
    const EDGE: f64 = 4.0;
    let [top, bottom] = panel.reach();
    let mut page = Canvas::new();
    page.place(panel, EDGE - top);
    let mut height = EDGE - top + bottom;
    if let Some(units) = axis {
        axis_of_x(&mut page, frame, units, height + 0.2 * PANEL_SPACE);
        height = page.reach()[1];
    }
    page.finish(frame.width, height + EDGE, title).to_string()
}
