//! Model file after reading, with its model and with the location of each part of the model in the file.

use crate::band::Band;
use crate::beside::OtherFile;
use crate::combination::Recipe;
use crate::demand::{Place, Sign};
use crate::diagnostic::Diagnostic;
use crate::fault::Fault;
use crate::moving::MovingTrain;
use crate::print::Units;
use crate::reader::Field;
use crate::source::Source;
use crate::units::UnitSystem;
use groundbeam::model::{Part, Problem, Profile};
use groundbeam::{Error, Model, design::Limits};
use std::collections::HashMap;
use std::ops::Range;
use std::sync::Arc;

/// A model file that has been read and validated.
#[derive(Debug, Clone)]
pub struct Document {
    /// Title of the model, if the file gives a title.
    pub title: Option<String>,
    /// Model under all loads as the file gives them, in SI units or in the file's own consistent system of units.
    pub model: Model,
    /// Number of chords (straight segments) that replace the curve of settlement troughs in the gap of the model;
    /// `None` without troughs.
    pub chords: Option<usize>,
    /// Bearing width of the beam \[m\], if the file gives one for the whole beam.
    pub width: Option<f64>,
    /// Lower and upper factors on k and μ, if the file gives such factors.
    pub band: Option<Band>,
    /// Limits of the design checks.
    pub limits: Limits,
    /// System of units of the file: SI units, or the file's own consistent system.
    pub units: UnitSystem,
    /// Units of printed results. They follow the units of the quantities in the file.
    pub printed: Units,
    /// Warnings about quantities of implausible size and about a model without loads.
    pub warnings: Vec<Diagnostic>,
    /// Load case of each load of the model, in the order of the loads; `None` for a load without a case.
    pub cases: Vec<Option<String>>,
    /// Trains that pass over the beam, one at a time.
    pub trains: Vec<MovingTrain>,
    /// Depth of the beam's section along the beam; empty if the depth of any part of the beam is unknown.
    pub depths: Vec<Depth>,
    /// All quantities of the file, in the order of the text. Programs edit these quantities to change the model.
    pub quantities: Vec<Quantity>,
    /// Other files to which the model file refers.
    pub files: Vec<Arc<OtherFile>>,
    pub(crate) recipes: Vec<Recipe>,
    pub(crate) source: Source,
    pub(crate) places: Places,
}

/// Depth of the beam's section on a stretch of the beam.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Depth {
    /// Position of the left end of the stretch of the beam \[m\].
    pub from: f64,
    /// Position of the right end of the stretch of the beam \[m\].
    pub to: f64,
    /// Depth of the section \[m\] as a profile from the left end to the right end of the stretch.
    pub depth: Profile,
}

/// A number in the file, with its unit if it has one.
#[derive(Debug, Clone, PartialEq)]
pub struct Quantity {
    /// Key of the number, such as `k`, `at` or `E`.
    pub key: String,
    /// Byte range of the number and its unit, including the quotes of a number with a unit.
    pub span: Range<usize>,
    /// Byte range of the number without its unit, or of the whole text of a length such as `1'-6"`.
    pub number: Range<usize>,
    /// Byte range of the number and the unit, without quotes.
    pub text: Range<usize>,
    /// The quantity as a decimal number and its unit, if the file gives a length in feet and inches or as a fraction.
    /// `None` if the file gives a decimal number.
    pub decimal: Option<(f64, &'static str)>,
    /// Factor that converts the unit to SI units; 1 without a unit.
    pub unit: f64,
    /// Signs that the number may have.
    pub sign: Sign,
    /// Whether a position must lie on the beam or on the ground; `None` for a quantity that is not a position.
    pub place: Option<Place>,
    /// A typical value of this quantity, in SI units.
    pub usual: f64,
}

impl Document {
    /// Text of the file.
    pub fn text(&self) -> &str {
        &self.source.text
    }

    /// Whether a load of the model belongs to one of the given load cases.
    pub fn is_of_case(&self, load: usize, cases: &[String]) -> bool {
        let case = self.cases.get(load).and_then(Option::as_ref);
        case.is_some_and(|case| cases.contains(case))
    }

    /// Returns the faults of the model that the error of a solve reports, with their locations in the file. The list is
    /// empty if the error does not concern the model.
    pub fn diagnostics_for(&self, error: &Error) -> Vec<Diagnostic> {
        let problems = match error {
            Error::Invalid(problems) => &problems[..],
            Error::Unsupported(problem) => std::slice::from_ref(problem),
            Error::TooLarge(refused) => std::slice::from_ref(&refused.problem),
            _ => &[],
        };
        problems.iter().map(|problem| self.diagnostic_for(problem)).collect()
    }

    /// Returns the byte range of the heading of the table that describes a part of the model.
    pub fn part_span(&self, part: Part) -> Option<Range<usize>> {
        self.places.parts.get(&part).cloned()
    }

    /// Returns the location of a value of the model, named as in [`Problem::field`]. If no single key gives the value,
    /// returns the heading of its table.
    pub fn field_span(&self, part: Part, field: &str) -> Option<Range<usize>> {
        let known = self.places.fields.get(&part)?.iter().find(|(name, _)| *name == field);
        known.and_then(|(_, place)| place.clone()).or_else(|| self.part_span(part))
    }

    /// Converts a problem of the model to a diagnostic at its location in the file.
    ///
    /// This function is for models that were changed after reading, and for problems that a solve finds.
    pub fn diagnostic_for(&self, problem: &Problem) -> Diagnostic {
        let span = self.field_span(problem.part, problem.field);
        let span = span.or_else(|| self.part_span(problem.part)).unwrap_or(0..0);
        diagnostic(&self.source, span, problem, self.printed)
    }
}

/// Converts a problem of the model to a diagnostic, and writes its positions in the given units.
pub(crate) fn diagnostic(
    source: &Source,
    span: Range<usize>,
    problem: &Problem,
    units: Units,
) -> Diagnostic {
    let fill = |text: &str| problem.fill(text, |x| units.of_input().position(x));
    let fault = Fault::new(problem.code, span, fill(&problem.message), "", fill(&problem.hint));
    Diagnostic::new(source, fault)
}

/// Locations of all parts and fields of the model in the text.
#[derive(Debug, Clone, Default)]
pub(crate) struct Places {
    parts: HashMap<Part, Range<usize>>,
    /// Location of each field of each part. `None` means that the value could not be read, or that another table
    /// gives it.
    fields: HashMap<Part, Vec<(&'static str, Option<Range<usize>>)>>,
}

impl Places {
    pub fn part(&mut self, part: Part, span: &Range<usize>) {
        self.parts.insert(part, span.clone());
    }

    pub fn field(&mut self, part: Part, name: &'static str, field: &Field) {
        let place = (!field.value.is_nan()).then(|| field.span.clone());
        self.fields.entry(part).or_default().push((name, place));
    }

    /// Returns the location of the table that contains the problem.
    pub fn part_of(&self, problem: &Problem) -> Option<Range<usize>> {
        self.parts.get(&problem.part).cloned()
    }

    /// Returns the location of a problem. Returns `None` if the problem only follows from a fault that is already
    /// reported.
    pub fn of(&self, problem: &Problem) -> Option<Range<usize>> {
        if problem.numbers.iter().any(|number| number.is_nan()) {
            return None;
        }
        let fields = self.fields.get(&problem.part)?;
        let known = fields.iter().find(|(name, _)| *name == problem.field);
        match known {
            Some((_, place)) => place.clone(),
            None => self.parts.get(&problem.part).cloned(),
        }
    }
}
