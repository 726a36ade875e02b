//! One picture of a train's passage: the train where it bends the beam most, and the envelopes of all its positions.

use super::canvas::Canvas;
use super::diagram::{Diagram, OF_ENVELOPES, worth_naming};
use super::frame::{Frame, WIDTH};
use super::samples::Samples;
use super::{PANEL_SPACE, axis_of_x, header, numbers, stacked, system};
use crate::context::Context;
use crate::font::Metrics;
use crate::quantity::Units;
use crate::size::Sizes;
use crate::trains::Moving;
use groundbeam::Extreme;
use groundbeam::train::{Located, Passage};

/// Even steps along the beam.
const EVEN_STEPS: usize = 400;

/// The train where the moment is largest, and the envelopes of its passage, as an SVG file.
pub fn train(moving: &Moving, context: &Context) -> String {
    let (passage, units) = (moving.passage, context.units);
    let title = context.clean_title();
    let mut page = Canvas::new();
    let governing = moving.largest_moment().and_then(|most| passage.nearest(most.first_axle));
    let Some((first_axle, solution)) = governing else {
        let y = header(&mut page, title.as_deref(), &["no position was solved"]);
        return page.finish(WIDTH, y, title.as_deref().unwrap_or("No position was solved"));
    };
    let metrics = Metrics::new();
    let frame = Frame::of(passage.model());
    let count = passage.solved().count();
    let at = units.position(first_axle);
    let note = format!("{count} positions; drawn where the moment is largest, first axle at {at}");
    let mut y = header(&mut page, title.as_deref(), &[&numbers(solution, units), &note]);
    let samples = Samples::of(solution);
    let drawn = system::draw(solution, units, &frame, &samples, &metrics);
    y = stacked(&mut page, &drawn, y);
    for diagram in diagrams(passage, units, samples.sizes) {
        y = stacked(&mut page, &diagram.draw(&frame, &metrics), y);
    }
    axis_of_x(&mut page, &frame, units, y - PANEL_SPACE + 2.0);
    let height = page.reach()[1].max(y) + 14.0;
    page.finish(WIDTH, height, title.as_deref().unwrap_or("A train passes"))
}

fn diagrams(passage: &Passage, units: Units, sizes: Sizes) -> [Diagram<'static>; 4] {
    let stations = passage.stations(EVEN_STEPS);
    let bounds: Vec<(f64, [[Located; 2]; 7])> =
        stations.into_iter().filter_map(|x| Some((x, passage.at(x)?))).collect();
    OF_ENVELOPES.map(|field| {
        let line = |bound: usize| -> Vec<(f64, f64)> {
            let value = |x: &f64, all: &[[Located; 2]; 7]| (*x, all[field.index()][bound].value);
            bounds.iter().map(|(x, all)| value(x, all)).collect()
        };
        let extremes = passage.range(field).into_iter().flatten().rev().map(|located| {
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
