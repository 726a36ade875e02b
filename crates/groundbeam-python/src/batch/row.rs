//! What is kept of one answer of many.

use crate::failure::Tipping;
use groundbeam::{Error, Existence, Field, Model, Side, Solution};
use groundbeam_report::Units;

/// What is to be kept of every answer.
pub struct Wanted {
    /// Positions \[m\].
    pub at: Vec<f64>,
    /// Fields at these positions.
    pub fields: Vec<Field>,
    /// Fields of which the smallest and the largest value are kept.
    pub extremes: Vec<Field>,
}

/// How it went, by the numbers that Python knows it by.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
pub enum Status {
    Solved = 0,
    NoEquilibrium = 1,
    NotConverged = 2,
    Wrong = 3,
}

/// What is kept of one answer. Where there is none, numbers are not numbers.
pub struct Row {
    pub status: Status,
    pub message: Option<String>,
    pub end_forces: [f64; 2],
    pub lifted_share: f64,
    pub relative_gap: f64,
    /// r(0), r(l) and F(r) of the motion that proves that there is no equilibrium.
    pub motion: [f64; 3],
    pub contact: Vec<[f64; 2]>,
    /// Where a field is smallest and how small, where it is largest and how large.
    pub extremes: Vec<[f64; 4]>,
    /// Field by field.
    pub values: Vec<f64>,
}

impl Row {
    fn without_numbers(status: Status, message: String, wanted: &Wanted) -> Self {
        Row {
            status,
            message: Some(message),
            end_forces: [f64::NAN; 2],
            lifted_share: f64::NAN,
            relative_gap: f64::NAN,
            motion: [f64::NAN; 3],
            contact: Vec::new(),
            extremes: vec![[f64::NAN; 4]; wanted.extremes.len()],
            values: vec![f64::NAN; wanted.at.len() * wanted.fields.len()],
        }
    }

    /// Of an equilibrium. Beyond its ends a beam has no fields, but the ground beside it settles.
    pub fn of(solution: &Solution, wanted: &Wanted) -> Self {
        let ends = solution.end_forces();
        let on_beam = 0.0..=solution.model().beam.length;
        let fields: Vec<_> = wanted.at.iter().map(|&x| solution.at(x, Side::Right)).collect();
        let value = |field: Field| {
            let on_beam = &on_beam;
            let each = wanted.at.iter().zip(&fields);
            each.map(move |(x, fields)| match (on_beam.contains(x), field) {
                (true, field) => fields.get(field),
                (false, Field::Settlement) => solution.settlement(*x),
                (false, _) => f64::NAN,
            })
        };
        let extremes = wanted.extremes.iter().map(|&field| {
            let range = solution.range(field);
            [range.min.x, range.min.value, range.max.x, range.max.value]
        });
        Row {
            status: Status::Solved,
            message: None,
            end_forces: [ends.left, ends.right],
            lifted_share: solution.lifted_share(),
            relative_gap: solution.certificate().relative_gap,
            motion: [f64::NAN; 3],
            contact: solution.contact().iter().map(|c| [c.from, c.to]).collect(),
            extremes: extremes.collect(),
            values: wanted.fields.iter().flat_map(|&field| value(field)).collect(),
        }
    }

    /// Of a model that has no equilibrium.
    pub fn tips(model: &Model, existence: &Existence, units: Units, wanted: &Wanted) -> Self {
        let Tipping { motion, sentence, .. } = Tipping::of(model, existence, units);
        Row { motion, ..Self::without_numbers(Status::NoEquilibrium, sentence, wanted) }
    }

    /// Of a model that was refused, or of which no answer was certified.
    pub fn failed(error: &Error, wanted: &Wanted) -> Self {
        let status = match error {
            Error::NotConverged(_) => Status::NotConverged,
            _ => Status::Wrong,
        };
        Self::without_numbers(status, error.to_string(), wanted)
    }
}
