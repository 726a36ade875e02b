//! One picture of all combinations: the envelopes of deflection, pressure, moment and shear.

use super::canvas::Canvas;
use super::diagram::Diagram;
use super::frame::{Frame, WIDTH};
use super::samples::Samples;
use super::style::{BEAM, MOMENT, PRESSURE, SHEAR};
use super::{PANEL_SPACE, axis_of_x, header, numbers, stacked};
use crate::combinations::Combinations;
use crate::context::Context;
use crate::font::Metrics;
use crate::quantity::{Kind, Units};
use groundbeam::{Envelope, Field, Side, Solution};

/// Even steps along the beam: finer than a screen.
const EVEN_STEPS: usize = 1200;

/// The envelopes of all combinations that were solved, each combination a thin line, as an SVG file.
pub fn combinations(combinations: &Combinations, context: &Context) -> String {
    let solutions: Vec<&Solution> = combinations.solved().map(|(_, solution)| solution).collect();
    let title = context.clean_title();
    let mut page = Canvas::new();
    let count = combinations.combined.len();
    let note = match count - solutions.len() {
        0 => format!("envelope of {count} combinations"),
        lost => format!("envelope of {} of {count} combinations; {lost} not solved", count - lost),
    };
    let Some(first) = solutions.first() else {
        let y = header(&mut page, title.as_deref(), &[&note]);
        return page.finish(WIDTH, y, title.as_deref().unwrap_or("No combination was solved"));
    };
    let metrics = Metrics::new();
    let frame = Frame::of(first.model());
    let numbers = numbers(first, context.units);
    let mut y = header(&mut page, title.as_deref(), &[&numbers, &note]);
    for diagram in diagrams(&combinations.envelope(), context.units) {
        y = stacked(&mut page, &diagram.draw(&frame, &metrics), y);
    }
    axis_of_x(&mut page, &frame, context.units, y - PANEL_SPACE + 2.0);
    let height = page.reach()[1].max(y) + 14.0;
    page.finish(WIDTH, height, title.as_deref().unwrap_or("Combinations of loads"))
}

fn diagrams(envelope: &Envelope, units: Units) -> [Diagram<'static>; 4] {
    let samples: Vec<Samples> = envelope.solutions().iter().map(|s| Samples::of(s)).collect();
    let mut lines = lines(envelope, &envelope.stations(EVEN_STEPS));
    let mut diagram = |field: Field, title, note, colour, downward| {
        let range = envelope.range(field);
        let extremes = [range.max, range.min].map(|governing| {
            let sizes = samples.get(governing.by).map(|samples| samples.sizes);
            sizes.map_or(governing.extreme, |sizes| sizes.extreme(field, governing.extreme))
        });
        let number = Field::ALL.iter().position(|other| *other == field).unwrap_or(0);
        let [lower, values] = std::mem::take(&mut lines[number]);
        Diagram {
            title,
            note,
            kind: Kind::of(field),
            units,
            colour,
            downward,
            values,
            lower,
            thin: samples.iter().map(|samples| samples.field(field)).collect(),
            extremes: extremes.to_vec(),
            forces: Vec::new(),
            edges: &[],
        }
    };
    let tension = "drawn on the tension side";
    let mut pressure =
        diagram(Field::Pressure, "Contact pressure", "pushes the beam up", PRESSURE, true);
    // The smallest pressure is zero, or of no interest.
    pressure.extremes.truncate(1);
    [
        diagram(Field::Deflection, "Deflection", "down", BEAM, true),
        pressure,
        diagram(Field::Moment, "Bending moment", tension, MOMENT, true),
        diagram(Field::ShearForce, "Shear force", "", SHEAR, false),
    ]
}

/// The lines of smallest and largest values of all fields, with both sides of every jump.
fn lines(envelope: &Envelope, stations: &[f64]) -> [[Vec<(f64, f64)>; 2]; Field::ALL.len()] {
    let mut lines = Field::ALL.map(|_| [Vec::new(), Vec::new()]);
    for &x in stations {
        for side in [Side::Left, Side::Right] {
            for (lines, bounds) in lines.iter_mut().zip(envelope.all_beside(x, side)) {
                lines[0].push((x, bounds.min.extreme.value));
                lines[1].push((x, bounds.max.extreme.value));
            }
        }
    }
    lines
}
