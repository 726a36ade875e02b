//! A model file after reading: the model, and the location of each of its parts in the file.

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
    /// The title that the file gives.
    pub title: Option<String>,
    /// The model under all of its loads as written, in SI units or in the file's own consistent system.
    pub model: Model,
    /// Number of chords that replace the curve of settlement troughs in the model's gap, if the file has
    /// troughs.
    pub chords: Option<usize>,
    /// Bearing width of the beam \[m\], if the file gives one for the whole beam.
    pub width: Option<f64>,
    /// Lower and upper factors on the ground's constants, if the file gives them.
    pub band: Option<Band>,
    /// Limits of the design checks.
    pub limits: Limits,
    /// SI units, or the file's own consistent system.
    pub units: UnitSystem,
    /// The units of the file's own quantities, in which results are printed.
    pub printed: Units,
    /// Warnings: implausible sizes, no loads.
    pub warnings: Vec<Diagnostic>,
    /// Load case of each load of the model, in the order of the loads; `None` for a load without a case.
    pub cases: Vec<Option<String>>,
    /// Trains that pass over the beam, one at a time.
    pub trains: Vec<MovingTrain>,
    /// Depth of the section along the beam; empty if it is not known everywhere.
    pub depths: Vec<Depth>,
    /// All quantities of the file, in the order of the text. Programs edit them to change the model.
    pub quantities: Vec<Quantity>,
    /// Files that the model file names.
    pub files: Vec<Arc<OtherFile>>,
    pub(crate) recipes: Vec<Recipe>,
    pub(crate) source: Source,
    pub(crate) places: Places,
}

/// The depth of the beam's section on a stretch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Depth {
    /// Left end \[m\].
    pub from: f64,
    /// Right end \[m\].
    pub to: f64,
    /// Depth from the left end to the right end \[m\].
    pub depth: Profile,
}

/// A number in the file, with its unit if it has one.
#[derive(Debug, Clone, PartialEq)]
pub struct Quantity {
    /// Its key: `k`, `at`, `E`, …
    pub key: String,
    /// Its byte range; for a number with a unit, including the quotes.
    pub span: Range<usize>,
    /// Byte range of the number without the unit; of the whole text for a length as `1'-6"`.
    pub number: Range<usize>,
    /// Byte range of the number and the unit, without quotes.
    pub text: Range<usize>,
    /// For a length in feet and inches or with a fraction, the equal decimal number and its unit; `None` for
    /// a decimal number.
    pub decimal: Option<(f64, &'static str)>,
    /// Factor of the unit in SI units; 1 without a unit.
    pub unit: f64,
    /// Signs that the number may have.
    pub sign: Sign,
    /// For a position, the body on which it lies; otherwise `None`.
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

    /// Faults of the model that a solve found, with their locations; empty if the error does not concern the
    /// model.
    pub fn diagnostics_for(&self, error: &Error) -> Vec<Diagnostic> {
        let problems = match error {
            Error::Invalid(problems) => &problems[..],
            Error::Unsupported(problem) => std::slice::from_ref(problem),
            Error::TooLarge(refused) => std::slice::from_ref(&refused.problem),
            _ => &[],
        };
        problems.iter().map(|problem| self.diagnostic_for(problem)).collect()
    }

    /// Byte range of the heading of a part's table.
    pub fn part_span(&self, part: Part) -> Option<Range<usize>> {
        self.places.parts.get(&part).cloned()
    }

    /// Location of the value of a field; the fields have the names of [`Problem::field`]. If the value was
    /// left out or has several sources, the heading of its part.
    pub fn field_span(&self, part: Part, field: &str) -> Option<Range<usize>> {
        let known = self.places.fields.get(&part)?.iter().find(|(name, _)| *name == field);
        known.and_then(|(_, place)| place.clone()).or_else(|| self.part_span(part))
    }

    /// A problem of the model as a diagnostic at its location in the file.
    ///
    /// [`parse`](crate::parse) reports the problems of the file. This function serves models that were
    /// changed afterwards, and problems that a solve finds.
    pub fn diagnostic_for(&self, problem: &Problem) -> Diagnostic {
        let span = self.field_span(problem.part, problem.field);
        let span = span.or_else(|| self.part_span(problem.part)).unwrap_or(0..0);
        diagnostic(&self.source, span, problem, self.printed)
    }
}

/// A problem of the model as a diagnostic, with its positions as text.
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

/// Location of each part and field of the model in the text.
#[derive(Debug, Clone, Default)]
pub(crate) struct Places {
    parts: HashMap<Part, Range<usize>>,
    /// `None`: the value could not be read, or lies in another part.
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

    /// Location of the part with a problem.
    pub fn part_of(&self, problem: &Problem) -> Option<Range<usize>> {
        self.parts.get(&problem.part).cloned()
    }

    /// Location of a problem, unless it only follows from a reported one.
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
