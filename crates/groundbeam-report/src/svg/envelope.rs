//! Draws the picture of all combinations: envelopes of deflection, pressure, moment and shear force.

use super::canvas::{Canvas, Picture};
use super::diagram::{Diagram, OF_ENVELOPES, worth_naming};
use super::frame::{Frame, WIDTH};
use super::samples::Samples;
use super::{header, numbers, with_diagrams};
use crate::context::Context;
use crate::font::Metrics;
use crate::quantity::Units;
use groundbeam::{
    Field, Solution,
    envelope::Envelope,
    solution::{ByField, Side},
};
use groundbeam_run::Answers;

/// Number of equal steps along the beam. A step is smaller than a pixel of a screen.
const EVEN_STEPS: usize = 1200;

/// Draws the envelopes of all solved combinations, with each combination as a thin line.
pub fn combinations(answers: &Answers, context: &Context) -> Picture {
    let solutions: Vec<&Solution> = answers.solved().map(|(_, solution)| solution).collect();
    let title = context.clean_title();
    let mut page = Canvas::new();
    let count = answers.list.len();
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
    let y = header(&mut page, title.as_deref(), &[&numbers, &note]);
    let diagrams = diagrams(&answers.envelope(), context.units);
    let height = with_diagrams(&mut page, diagrams, (&frame, &metrics, context.units), y);
    page.finish(WIDTH, height, title.as_deref().unwrap_or("Combinations of loads"))
}

pub(super) fn diagrams(envelope: &Envelope, units: Units) -> [Diagram<'static>; 4] {
    let samples: Vec<Samples> = envelope.solutions().iter().map(|s| Samples::of(s)).collect();
    let mut lines = lines(envelope, &envelope.stations(EVEN_STEPS));
    OF_ENVELOPES.map(|field| {
        let range = envelope.range(field);
        let extremes = [range.max, range.min].map(|governing| {
            let sizes = samples.get(governing.by).map(|samples| samples.sizes);
            sizes.map_or(governing.extreme, |sizes| sizes.extreme(field, governing.extreme))
        });
        let [lower, values] = std::mem::take(&mut lines[field.index()]);
        Diagram {
            values,
            lower,
            thin: samples.iter().map(|samples| samples.field(field)).collect(),
            extremes: worth_naming(field, extremes.to_vec()),
            ..Diagram::of(field, units)
        }
    })
}

/// Returns the lines of the smallest and of the largest values of all fields, with both sides of every jump.
fn lines(envelope: &Envelope, stations: &[f64]) -> ByField<[Vec<(f64, f64)>; 2]> {
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
