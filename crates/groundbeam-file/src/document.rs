//! A model file that was read: the model, and where in the file each part of it stands.

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
use groundbeam::model::{Part, Problem};
use groundbeam::{Error, Limits, Model};
use std::collections::HashMap;
use std::ops::Range;
use std::sync::Arc;

/// A model file that was read and found right.
#[derive(Debug, Clone)]
pub struct Document {
    /// What the file calls itself.
    pub title: Option<String>,
    /// The model under all of its loads as they are written, in SI units or in the file's own consistent system.
    pub model: Model,
    /// How many chords of the model's gap replace the curve of settlement troughs, if the file has troughs.
    pub chords: Option<usize>,
    /// The width on which the beam bears \[m\], if the file gives one for the whole beam.
    pub width: Option<f64>,
    /// Between which multiples of their values the ground's constants lie, if the file says so.
    pub band: Option<Band>,
    /// What the file asks a design to keep to.
    pub limits: Limits,
    /// Whether all is in SI units or in the file's own consistent system.
    pub units: UnitSystem,
    /// The units of the file's own quantities, in which results are printed.
    pub printed: Units,
    /// What the file probably says otherwise than meant: implausible sizes, no loads.
    pub warnings: Vec<Diagnostic>,
    /// The load case to which each of the model's loads belongs, in the order of the loads; none for a
    /// load to which the file gives none.
    pub cases: Vec<Option<String>>,
    /// The trains that pass over the beam, each alone.
    pub trains: Vec<MovingTrain>,
    /// Every quantity of the file, in the order of the text: what a program changes to change the model.
    pub quantities: Vec<Quantity>,
    /// The files that the model names, as they were read.
    pub files: Vec<Arc<OtherFile>>,
    pub(crate) recipes: Vec<Recipe>,
    pub(crate) source: Source,
    pub(crate) places: Places,
}

/// A number of the file, perhaps with its unit, where it stands.
#[derive(Debug, Clone, PartialEq)]
pub struct Quantity {
    /// What it stands under: `k`, `at`, `E`, …
    pub key: String,
    /// Its bytes, with the quotes around a number that has a unit.
    pub span: Range<usize>,
    /// The bytes of the number alone.
    pub number: Range<usize>,
    /// What the number counts, in SI units; 1 where it has no unit.
    pub unit: f64,
    /// The signs that the number may have.
    pub sign: Sign,
    /// The body on which the number is a position; none for other quantities.
    pub place: Option<Place>,
    /// A usual value of such a quantity, in SI units.
    pub usual: f64,
}

impl Document {
    /// The text that was read.
    pub fn text(&self) -> &str {
        &self.source.text
    }

    /// The faults that a solve found in the model, each at its place; none for an error that is not about the model.
    pub fn diagnostics_for(&self, error: &Error) -> Vec<Diagnostic> {
        let problems = match error {
            Error::Invalid(problems) => &problems[..],
            Error::Unsupported(problem) => std::slice::from_ref(problem),
            Error::TooLarge(refused) => std::slice::from_ref(&refused.problem),
            _ => &[],
        };
        problems.iter().map(|problem| self.diagnostic_for(problem)).collect()
    }

    /// Where the table of a part begins: the bytes of its heading.
    pub fn part_span(&self, part: Part) -> Option<Range<usize>> {
        self.places.parts.get(&part).cloned()
    }

    /// Where the value of a field stands, by the names of [`Problem::field`]; for a value that
    /// was left out or has several sources, the heading of its part.
    pub fn field_span(&self, part: Part, field: &str) -> Option<Range<usize>> {
        let known = self.places.fields.get(&part)?.iter().find(|(name, _)| *name == field);
        known.and_then(|(_, place)| place.clone()).or_else(|| self.part_span(part))
    }

    /// A problem of the model, at its place in the file.
    ///
    /// [`parse`](crate::parse) has found the problems there were; this is for those of a model
    /// that was changed afterwards, and for rules found broken later.
    pub fn diagnostic_for(&self, problem: &Problem) -> Diagnostic {
        let span = self.field_span(problem.part, problem.field);
        let span = span.or_else(|| self.part_span(problem.part)).unwrap_or(0..0);
        diagnostic(&self.source, span, problem, self.printed)
    }
}

/// A problem of the model as a diagnostic, with its positions written out.
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

/// Where each part and field of the model stands.
#[derive(Debug, Clone, Default)]
pub(crate) struct Places {
    parts: HashMap<Part, Range<usize>>,
    /// No range: the value could not be read, or stands in another part.
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

    /// Where the part with a problem stands.
    pub fn part_of(&self, problem: &Problem) -> Option<Range<usize>> {
        self.parts.get(&problem.part).cloned()
    }

    /// The place of a problem, unless it only follows from what has been reported already.
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
