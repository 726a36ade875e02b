//! Collects the smallest and the largest value of every field from envelopes of combinations and of trains.

use crate::combinations::Numbered;
use crate::quantity::{Kind, Unit, Units};
use crate::size::Sizes;
use groundbeam::{
    Field,
    envelope::{Envelope, Governing},
};
use groundbeam_run::{InPassage, Located, Passage, Passages};
use std::collections::BTreeMap;

/// A field with its smallest and its largest value, in one unit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Extremes {
    pub field: Field,
    pub unit: Unit,
    pub ends: [End; 2],
}

/// An extreme value of a field. It is stored as 0 if its magnitude does not exceed the rounding error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct End {
    pub value: f64,
    pub x: f64,
    /// The position of the first axle; `None` without a train.
    pub first_axle: Option<f64>,
    /// Number of the combination or passage with this value, counted from 1; `None` for a single passage.
    pub number: Option<usize>,
}

impl Extremes {
    fn new(field: Field, ends: [End; 2], units: Units) -> Self {
        let most = ends.iter().fold(0.0_f64, |most, end| most.max(end.value.abs()));
        Extremes { field, unit: units.unit(Kind::of(field), most), ends }
    }

    /// The constant value of the field; `None` if the field varies.
    pub fn everywhere(&self) -> Option<f64> {
        let [min, max] = self.ends.map(|end| end.value);
        (min == max).then_some(min)
    }

    /// The extreme with the larger absolute value.
    pub fn largest(&self) -> End {
        let [min, max] = self.ends;
        if -min.value > max.value { min } else { max }
    }
}

/// The extremes of an envelope of combinations.
pub(crate) fn of_combinations(
    envelope: &Envelope,
    solved: &[Numbered],
    units: Units,
) -> Vec<Extremes> {
    let of = |field: Field| {
        let range = envelope.range(field);
        let ends = [range.min, range.max].map(|Governing { extreme, by }| {
            let row = solved.get(by);
            let extreme = row.map_or(extreme, |row| row.sizes.extreme(field, extreme));
            let number = Some(row.map_or(0, |row| row.number));
            End { value: extreme.value, x: extreme.x, first_axle: None, number }
        });
        Extremes::new(field, ends, units)
    };
    envelope.fields().map(of).collect()
}

/// Returns the smallest and the largest value of each field in one passage of a train.
pub(crate) fn of_passage(passage: &Passage, units: Units) -> Vec<Extremes> {
    let of = |field: Field| {
        let ends = passage.range(field)?.map(|located| end(passage, field, located, None));
        Some(Extremes::new(field, ends, units))
    };
    passage.fields().filter_map(of).collect()
}

/// Returns the smallest and the largest value of each field over all passages of trains.
pub(crate) fn of_passages(passages: &Passages, units: Units) -> Vec<Extremes> {
    let of = |field: Field| {
        let ends = passages.range(field)?.map(|InPassage { located, passage: i }| {
            let number = (passages.all.len() > 1).then_some(i + 1);
            end(&passages.all[i], field, located, number)
        });
        Some(Extremes::new(field, ends, units))
    };
    passages.fields().filter_map(of).collect()
}

fn end(passage: &Passage, field: Field, located: Located, number: Option<usize>) -> End {
    let Located { x, value, first_axle } = cleaned(passage, field, located);
    End { value, x, first_axle: Some(first_axle), number }
}

/// Replaces values that are only rounding error by zero, in the results of train passages. The typical
/// magnitudes of the fields are computed once for each train position.
pub(crate) struct Rounding<'a> {
    passages: Passages<'a>,
    /// Magnitudes of the fields at a train position; `None` without a solution. The key is the index of the passage and
    /// the bits of the position of the first axle.
    sizes: BTreeMap<(usize, u64), Option<Sizes>>,
}

impl<'a> Rounding<'a> {
    pub fn new(passages: &Passages<'a>) -> Self {
        Rounding { passages: passages.clone(), sizes: BTreeMap::new() }
    }

    pub fn value(&mut self, field: Field, &InPassage { located, passage }: &InPassage) -> f64 {
        let of_it = || {
            let (_, solution) = self.passages.all[passage].nearest(located.first_axle)?;
            Some(Sizes::of(solution))
        };
        let sizes = self.sizes.entry((passage, located.first_axle.to_bits())).or_insert_with(of_it);
        sizes.as_ref().map_or(located.value, |sizes| sizes.value(field, located.value))
    }
}

/// Sets a value that is only rounding error to zero.
pub(crate) fn cleaned(passage: &Passage, field: Field, located: Located) -> Located {
    let Some((_, solution)) = passage.nearest(located.first_axle) else { return located };
    let sizes = Sizes::of(solution);
    let (x, value) = (sizes.position(located.x), sizes.value(field, located.value));
    Located { x, value, ..located }
}
