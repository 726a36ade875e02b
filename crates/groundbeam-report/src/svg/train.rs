//! Draws the train at the position that causes the largest bending moment, and the envelopes over all train positions.

use super::canvas::{Canvas, Picture};
use super::diagram::{Diagram, OF_ENVELOPES, worth_naming};
use super::frame::{Frame, WIDTH};
use super::samples::Samples;
use super::{header, numbers, stacked, system, with_diagrams};
use crate::context::{Context, clean};
use crate::font::Metrics;
use crate::quantity::Units;
use crate::size::Sizes;
use groundbeam::solution::{ByField, Extreme};
use groundbeam_run::{InPassage, Passages};

/// Number of equal steps along the beam at which the envelopes are computed.
const EVEN_STEPS: usize = 400;

/// Draws the train at the position that causes the largest bending moment, and the envelopes over all passages.
pub fn trains(passages: &Passages, context: &Context) -> Picture {
    let units = context.units;
    let title = context.clean_title();
    let mut page = Canvas::new();
    let governing = passages.largest_moment().and_then(|most| {
        let passage = passages.all.get(most.passage)?;
        Some((passage, passage.nearest(most.located.first_axle)?))
    });
    let Some((passage, (first_axle, solution))) = governing else {
        let y = header(&mut page, title.as_deref(), &["no position was solved"]);
        return page.finish(WIDTH, y, title.as_deref().unwrap_or("No position was solved"));
    };
    let metrics = Metrics::new();
    let frame = Frame::of(passage.model()).with_depths(context.depths);
    let count: usize = passages.all.iter().map(|passage| passage.solved().count()).sum();
    let at = units.position(first_axle);
    let whose = match passages.all.len() {
        1 => String::new(),
        passages => format!(" in {passages} passages"),
    };
    let of = if passages.all.len() == 1 { String::new() } else { clean(&passage.label()) + ", " };
    let note = format!(
        "{count} positions{whose}; drawn where the moment is largest, {of}first axle at {at}"
    );
    let mut y = header(&mut page, title.as_deref(), &[&numbers(solution, units), &note]);
    let samples = Samples::of(solution);
    let drawn = system::draw(solution, units, &frame, &samples, &metrics);
    y = stacked(&mut page, drawn, y);
    let diagrams = diagrams(passages, units, samples.sizes);
    let height = with_diagrams(&mut page, diagrams, (&frame, &metrics, units), y);
    page.finish(WIDTH, height, title.as_deref().unwrap_or("A train passes"))
}

pub(super) fn diagrams(passages: &Passages, units: Units, sizes: Sizes) -> [Diagram<'static>; 4] {
    let stations = passages.stations(EVEN_STEPS);
    let bounds: Vec<(f64, ByField<[InPassage; 2]>)> =
        stations.into_iter().filter_map(|x| Some((x, passages.at(x)?))).collect();
    OF_ENVELOPES.map(|field| {
        let line = |bound: usize| -> Vec<(f64, f64)> {
            let value = |x: &f64, all: &ByField<[InPassage; 2]>| {
                (*x, all[field.index()][bound].located.value)
            };
            bounds.iter().map(|(x, all)| value(x, all)).collect()
        };
        let extremes = passages.range(field).into_iter().flatten().rev().map(|governing| {
            let located = governing.located;
            let extreme = Extreme { x: located.x, value: located.value };
            sizes.extreme(field, extreme)
        });
        Diagram {
            values: line(1),
            lower: line(0),
            extremes: worth_naming(field, extremes.collect()),
            ..Diagram::of(field, units)
        }
    })
}
