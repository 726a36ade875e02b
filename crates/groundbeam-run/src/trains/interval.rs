//! Interpolates results between two solved positions of a train, and estimates the error at a third position.

use super::position::{Beside, Position, Section};
use groundbeam::model::Train;
use groundbeam::{Field, solution::ByField};
use std::borrow::Borrow;

/// Fields on both sides of an axle, interpolated at the fraction t between two train positions that were
/// solved. `None` if the axle is off the beam.
fn beside_axle(ends: [&Section; 2], axle: usize, t: f64) -> Option<Beside> {
    let [start, end] = ends.map(|end| end.under.get(axle).copied().flatten());
    let (start, end) = (start?.leaving(), end?.arriving());
    Some([0, 1].map(|side| {
        std::array::from_fn(|field| (1.0 - t) * start[side][field] + t * end[side][field])
    }))
}

/// Envelope over all train positions solved so far: extremes of each field on both sides of every examined position.
pub(super) struct Table {
    bounds: Vec<[ByField<f64>; 2]>,
    /// Smallest and largest value of each field over the whole beam.
    all: [ByField<f64>; 2],
}

impl Table {
    pub fn of(found: &[Position], train: &Train, stations: &[f64]) -> Self {
        let nothing = [[f64::INFINITY; Field::ALL.len()], [f64::NEG_INFINITY; Field::ALL.len()]];
        let mut table = Table { bounds: vec![nothing; 2 * stations.len()], all: nothing };
        for position in found {
            for (bounds, values) in table.bounds.iter_mut().zip(&position.samples) {
                widen(bounds, values);
            }
            for (field, range) in position.section.ranges.iter().flatten().enumerate() {
                let [min, max] = &mut table.all;
                min[field] = min[field].min(range.min.value);
                max[field] = max[field].max(range.max.value);
            }
        }
        for (i, &x) in stations.iter().enumerate() {
            for (axle, _) in train.axles.iter().enumerate() {
                for values in passing(found, train, axle, x).iter().flat_map(|(_, both)| both) {
                    widen(&mut table.bounds[2 * i], values);
                    widen(&mut table.bounds[2 * i + 1], values);
                }
            }
        }
        table
    }
}

fn widen([min, max]: &mut [ByField<f64>; 2], values: &ByField<f64>) {
    for (field, value) in values.iter().enumerate() {
        min[field] = min[field].min(*value);
        max[field] = max[field].max(*value);
    }
}

/// Fields on both sides of an axle that passes the section x, and the position of the first axle at that
/// moment.
pub(super) fn passing<S: Borrow<Section>>(
    found: &[S],
    train: &Train,
    axle: usize,
    x: f64,
) -> Option<(f64, Beside)> {
    let at = x + train.axles[axle].behind;
    let next = found.partition_point(|position| position.borrow().first_axle <= at);
    let [left, right] = [found.get(next.checked_sub(1)?)?, found.get(next)?].map(Borrow::borrow);
    let t = (at - left.first_axle) / (right.first_axle - left.first_axle);
    Some((at, beside_axle([left, right], axle, t)?))
}

/// Error of the envelope of each field between two train positions, relative to the largest absolute value of the
/// field. *Which positions are solved* in docs/moving-loads.md defines it.
pub(super) fn sticks_out(
    middle: &Position,
    ends: [&Position; 2],
    train: &Train,
    stations: &[f64],
    table: &Table,
    scale: &ByField<f64>,
) -> ByField<f64> {
    let mut most = [0.0_f64; Field::ALL.len()];
    let near = stations.last().map_or(0.0, |l| train.same_place(*l));
    let mut note = |field: usize, by: f64| most[field] = most[field].max(by);
    for (i, (values, bounds)) in middle.samples.iter().zip(&table.bounds).enumerate() {
        let [start, end] = ends.map(|end| &end.samples[i]);
        let is_smooth = !is_passed(stations[i / 2], ends, train, near);
        for field in 0..Field::ALL.len() {
            let [min, max] = [bounds[0][field], bounds[1][field]];
            let [a, value, b] = [start[field], values[field], end[field]];
            // Where contact begins or ends, pressure and gap change between zero and positive values, and no
            // parabola fits.
            let is_one_curve = (a == 0.0) == (value == 0.0) && (b == 0.0) == (value == 0.0);
            let crest = if is_smooth && is_one_curve { crest(a, value, b) } else { value };
            note(field, crest.max(value) - max);
            note(field, min - crest.min(value));
        }
    }
    for (axle, _) in train.axles.iter().enumerate() {
        let here = middle.section.under.get(axle).copied().flatten();
        if let (Some(here), Some(between)) =
            (here, beside_axle(ends.map(|end| &end.section), axle, 0.5))
        {
            for (here, between) in here.beside.iter().zip(&between) {
                (0..Field::ALL.len())
                    .for_each(|field| note(field, (here[field] - between[field]).abs()));
            }
        }
    }
    for (field, range) in middle.section.ranges.iter().flatten().enumerate() {
        note(field, range.max.value - table.all[1][field]);
        note(field, table.all[0][field] - range.min.value);
    }
    let relative = |field: usize| if most[field] > 0.0 { most[field] / scale[field] } else { 0.0 };
    std::array::from_fn(relative)
}

/// Whether an axle passes the section x between two positions, or is at the section x at one of them.
fn is_passed(x: f64, [start, end]: [&Position; 2], train: &Train, near: f64) -> bool {
    let [from, to] = [start, end].map(|position| position.section.first_axle);
    let passing = from - near..=to + near;
    train.axles.iter().any(|axle| passing.contains(&(x + axle.behind)))
}

/// The extreme of the parabola through three equidistant values if it lies between the outer positions; otherwise
/// the middle value.
fn crest(a: f64, middle: f64, b: f64) -> f64 {
    let (slope, bend) = (0.5 * (b - a), a - 2.0 * middle + b);
    if slope.abs() < bend.abs() { middle - 0.5 * slope * slope / bend } else { middle }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_crest_of_a_parabola_is_exact() {
        let parabola = |s: f64| 3.0 - (s - 0.5) * (s - 0.5);
        assert_eq!(crest(parabola(-1.0), parabola(0.0), parabola(1.0)), 3.0);
        assert_eq!(crest(1.0, 2.0, 3.0), 2.0);
    }
}
