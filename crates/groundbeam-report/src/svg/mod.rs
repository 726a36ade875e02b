//! Draws the picture of a solution: the deflected beam on the ground, pressure, moment and shear force.
//!
//! Equal solutions give identical files. The files need no style sheet and no script. The widths of labels are those of
//! the font Inter. A [PNG](Picture::png) contains the labels as outlines.

mod axis;
mod canvas;
mod diagram;
mod envelope;
pub(crate) mod figures;
mod frame;
mod ground;
mod labels;
mod loads;
mod paint;
mod samples;
mod sketch;
mod study;
mod style;
mod supports;
mod system;
mod tipping;
mod train;
mod view;

use crate::characteristics::Characteristics;
use crate::context::Context;
use crate::font::Metrics;
use crate::quantity::{Kind, Units};
pub(crate) use canvas::Anchor;
pub use canvas::Picture;
#[cfg(feature = "png")]
pub(crate) use canvas::Text;
use canvas::{Canvas, printed};
use diagram::{Diagram, worth_naming};
pub use envelope::combinations;
use frame::{Frame, LEFT, WIDTH};
use groundbeam::{Field, Solution};
pub use paint::dark_style;
#[cfg(feature = "png")]
pub(crate) use paint::rounded;
use paint::{Colour, Stroke};
use samples::Samples;
pub use study::study;
use style::{NOTE, TICK, TITLE};
pub use tipping::tipping;
pub use train::trains;
pub use view::{Grip, Handle, View, view};

/// Maximum number of contact edges that diagrams mark.
const MOST_EDGES: usize = 40;

/// Draws the picture of one solution.
pub fn picture(solution: &Solution, context: &Context) -> Picture {
    let metrics = Metrics::new();
    let frame = Frame::of(solution.model()).with_depths(context.depths);
    let samples = Samples::of(solution);
    let edges = edges(solution);
    let title = context.clean_title();

    let mut page = Canvas::new();
    let numbers = numbers(solution, context.units);
    let mut y = header(&mut page, title.as_deref(), &[&numbers]);
    let system = system::draw(solution, context.units, &frame, &samples, &metrics);
    y = stacked(&mut page, system, y);
    let diagrams = diagrams(solution, context.units, &samples, &edges);
    let height = with_diagrams(&mut page, diagrams, (&frame, &metrics, context.units), y);
    page.finish(WIDTH, height, title.as_deref().unwrap_or("A beam on its ground"))
}

/// Stacks the diagrams below the coordinate `y`, and draws the horizontal axis under the last diagram. Returns
/// the height of the page.
fn with_diagrams<'a>(
    page: &mut Canvas,
    diagrams: impl IntoIterator<Item = Diagram<'a>>,
    (frame, metrics, units): (&Frame, &Metrics, Units),
    mut y: f64,
) -> f64 {
    for diagram in diagrams {
        y = stacked(page, diagram.draw(frame, metrics), y);
    }
    axis_of_x(page, frame, units, y - PANEL_SPACE + 2.0);
    page.reach()[1].max(y) + 14.0
}

/// Vertical distance between two panels.
const PANEL_SPACE: f64 = 22.0;

/// Places a panel below the coordinate `y`. Returns the coordinate of the next panel.
fn stacked(page: &mut Canvas, panel: Canvas, y: f64) -> f64 {
    let [top, bottom] = panel.reach();
    page.place(panel, y - top);
    y - top + bottom + PANEL_SPACE
}

/// Writes the title and the notes at the top of the page. Returns the vertical coordinate at which the first
/// panel begins.
fn header(page: &mut Canvas, title: Option<&str>, notes: &[&str]) -> f64 {
    let mut y = 16.0;
    if let Some(title) = title {
        y += 18.0;
        page.text([LEFT, y], Anchor::Start, TITLE, title);
    }
    y += 3.0;
    for note in notes {
        y += 17.0;
        page.text([LEFT, y], Anchor::Start, NOTE, note);
    }
    y + 16.0
}

/// Line with the main parameters of the problem, such as `l = 12 m · EI = … · k = … · μ = … · βl = …`.
fn numbers(solution: &Solution, units: Units) -> String {
    let model = solution.model();
    let found = Characteristics::of(model, solution.existence());
    let mut parts = vec![format!("l = {}", units.position(model.beam.length))];
    if model.beam.segments.is_empty() {
        let stiffness = units.write(Kind::BendingStiffness, model.beam.bending_stiffness);
        parts.push(format!("EI = {stiffness}"));
    } else {
        parts.push("EI varies".to_owned());
    }
    if let Some(stiffness) = model.beam.shear_stiffness {
        parts.push(format!("GA = {}", units.write(Kind::Constant, stiffness)));
    }
    if model.beam.axial_force != 0.0 {
        parts.push(format!("P = {}", units.write(Kind::Constant, model.beam.axial_force)));
    }
    if model.foundation.segments.is_empty() {
        parts.push(format!("k = {}", units.write(Kind::Spring, model.foundation.subgrade)));
        parts.push(format!("μ = {}", units.write(Kind::Constant, model.foundation.shear_layer)));
    } else {
        parts.push("k and μ vary".to_owned());
    }
    parts.push(format!("βl = {}", units.ratio(found.beta_length)));
    printed(&parts.join("\u{a0}\u{a0} · \u{a0}\u{a0}"))
}

/// Positions of contact edges inside the beam.
fn edges(solution: &Solution) -> Vec<f64> {
    let l = solution.model().beam.length;
    let mut edges: Vec<f64> = solution.contact().iter().flat_map(|c| [c.from, c.to]).collect();
    edges.retain(|&x| x > 0.0 && x < l);
    edges.dedup();
    edges.truncate(MOST_EDGES);
    edges
}

fn diagrams<'a>(
    solution: &Solution,
    units: Units,
    samples: &Samples,
    edges: &'a [f64],
) -> [Diagram<'a>; 3] {
    let diagram = |field: Field| {
        let range = solution.range(field);
        let extremes = [range.max, range.min].map(|extreme| samples.sizes.extreme(field, extreme));
        Diagram {
            values: samples.field(field),
            extremes: worth_naming(field, extremes.to_vec()),
            edges,
            ..Diagram::of(field, units)
        }
    };
    let mut pressure = diagram(Field::Pressure);
    pressure.forces = concentrated(solution, units, samples);
    if !pressure.forces.is_empty() {
        pressure.note = "pushes the beam up; arrows are concentrated forces";
    }
    [pressure, diagram(Field::Moment), diagram(Field::ShearForce)]
}

/// Positions, values and labels of the point contact forces.
fn concentrated(solution: &Solution, units: Units, samples: &Samples) -> Vec<(f64, f64, String)> {
    let ends = solution.end_forces();
    let l = solution.model().beam.length;
    let inner = solution.concentrated_forces().iter().map(|force| (force.at, force.force));
    let all = [(0.0, ends.left)].into_iter().chain(inner).chain([(l, ends.right)]);
    all.map(|(at, force)| (at, samples.sizes.force(force)))
        .filter(|&(_, force)| force != 0.0)
        .map(|(at, force)| (at, force, units.write(Kind::Force, force)))
        .collect()
}

fn axis_of_x(page: &mut Canvas, frame: &Frame, units: Units, y: f64) {
    let stroke = Stroke::new(Colour::FaintInk, 1.0);
    page.line([frame.x(0.0), y], [frame.x(frame.length), y], stroke);
    let unit = units.of_input().unit(Kind::Position, frame.length);
    for x in axis::ticks_in(unit, [0.0, frame.length], 6) {
        let at = frame.x(x);
        page.line([at, y], [at, y + 5.0], stroke);
        page.text([at, y + 18.0], Anchor::Middle, TICK, &printed(&unit.number(x)));
    }
    let words = format!("x{}", unit.bracketed());
    page.text([frame.end_of_axis(), y + 18.0], Anchor::End, TICK, &words);
}

/// Draws lines of text with all anchors, weights and kinds of characters on a tinted background.
#[cfg(test)]
pub(crate) fn test_card() -> Picture {
    use canvas::Style;
    let mut card = Canvas::new();
    card.rect([0.0, 0.0], [600.0, 240.0], paint::Fill::new(Colour::Rule));
    let style = |size, bold, colour| Style::new(size, bold, colour);
    let rimmed = Style { rim: true, ..style(30.0, false, Colour::Moment) };
    for (at, anchor, style, words) in [
        ([10.5, 40.0], Anchor::Start, style(24.0, false, Colour::Ink), "AVATAR To, LTV 1 < 2 & é"),
        (
            [300.0, 90.0],
            Anchor::Middle,
            style(22.0, true, Colour::Pressure),
            "Wave \"Ty\" βl = −3.7 kN/m²",
        ),
        ([590.0, 150.0], Anchor::End, rimmed, "Pressure → 12 mm"),
        ([10.0, 210.0], Anchor::Start, style(18.0, false, Colour::Ink), "lacks: 木 and no more"),
    ] {
        card.text(at, anchor, style, words);
    }
    card.finish(600.0, 240.0, "Lines of text")
}
