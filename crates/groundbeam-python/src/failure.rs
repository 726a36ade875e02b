//! Converts failures to exceptions of `groundbeam._errors`.

use groundbeam::{Error, Existence, Model, Stopped, Verdict, existence::static_reactions};
use groundbeam_file::{Diagnostic, Diagnostics, Document};
use groundbeam_report::{Units, sentence};
use pyo3::prelude::*;
use pyo3::types::PyTuple;

/// Reason why there is no result.
pub enum Failure {
    /// The model is invalid. The fields are the complete message and the list of all faults.
    Wrong(String, Vec<Diagnostic>),
    /// There is no equilibrium.
    NoEquilibrium(Tipping),
    /// The method did not reach its tolerance.
    NotConverged(Stopped),
    /// An argument of the call is invalid.
    Asked(String),
}

/// The motion that proves that there is no equilibrium.
#[derive(Debug, Clone, PartialEq)]
pub struct Tipping {
    /// Motion r that proves that there is no equilibrium: its displacements r(0) and r(l) of the left and the right end
    /// of the beam, and the work F(r) of the loads.
    pub motion: [f64; 3],
    /// Deflections of the hinges in the rigid-body motion r of the beam that proves that there is no equilibrium.
    pub hinges: Vec<f64>,
    /// Static reactions under the ends and under each free hinge between them.
    pub static_reactions: Vec<f64>,
    /// Sentence that states why there is no equilibrium.
    pub sentence: String,
}

impl Tipping {
    /// Returns the motion that proves that a model has no equilibrium.
    pub fn of(model: &Model, existence: &Existence, units: Units) -> Self {
        let hinges = match existence.verdict {
            Verdict::None(motion) | Verdict::NotUnique(motion) => {
                model.hinges.iter().map(|hinge| motion.at(model, hinge.at)).collect()
            }
            Verdict::Buckles(_) | Verdict::Unique | Verdict::Local(_) => Vec::new(),
        };
        let static_reactions = static_reactions(model).into_iter().map(|(_, reaction)| reaction);
        Tipping {
            motion: existence.verdict.motion().unwrap_or([f64::NAN; 3]),
            hinges,
            static_reactions: static_reactions.collect(),
            sentence: sentence(model, existence, units),
        }
    }
}

/// Replaces the remedy of an error by one that is available in Python, where the memory limit is not an argument.
pub fn remediable(error: Error) -> Error {
    match error {
        Error::TooLarge(mut refused) => {
            refused.problem.hint = "shorten the beam, or use fewer elements".to_owned();
            Error::TooLarge(refused)
        }
        other => other,
    }
}

impl Failure {
    /// Faults in a text.
    pub fn wrong(found: Diagnostics, name: &str, text: &str) -> Self {
        let shown = found.render(name, text, false).trim_end().to_owned();
        Failure::Wrong(shown, found.into_iter().collect())
    }

    /// Converts an error of the library to a failure, with the location of each fault in the text.
    pub fn refused(error: Error, document: &Document, name: &str) -> Self {
        let problems = match remediable(error) {
            Error::NotConverged(reached) => return Failure::NotConverged(reached),
            Error::Invalid(problems) => problems,
            Error::Unsupported(problem) => vec![problem],
            Error::TooLarge(refused) => vec![refused.problem],
            other => return Failure::Asked(other.to_string()),
        };
        let located = problems.iter().map(|problem| document.diagnostic_for(problem));
        let found: Vec<Diagnostic> = located.collect();
        let shown = found.iter().map(|diagnostic| {
            let alone = Diagnostics::from(diagnostic.clone());
            alone.render(name, document.text(), false).trim_end().to_owned()
        });
        Failure::Wrong(shown.collect::<Vec<_>>().join("\n\n"), found)
    }

    fn raised(&self, py: Python<'_>) -> PyResult<PyErr> {
        let raise = |class: &str, arguments: Bound<'_, PyTuple>| {
            let class = py.import("groundbeam._errors")?.getattr(class)?;
            Ok(PyErr::from_value(class.call1(arguments)?))
        };
        match self {
            Failure::Wrong(shown, found) => {
                let each = found.iter().map(|d| (d.code, &d.message, &d.hint, d.line, d.column));
                let each: Vec<_> = each.collect();
                raise("ModelError", (shown, each).into_pyobject(py)?)
            }
            Failure::NoEquilibrium(Tipping { motion, hinges, static_reactions, sentence }) => {
                let [left, right, work] = *motion;
                let arguments = (sentence, left, right, work, static_reactions, hinges);
                raise("NoEquilibrium", arguments.into_pyobject(py)?)
            }
            Failure::NotConverged(reached) => {
                let Stopped { method, iterations, why } = reached;
                let (tolerance, came_to) = (why.tolerance(), why.reached());
                let nan = |value: Option<f64>| value.unwrap_or(f64::NAN);
                let shown = reached.to_string();
                let arguments =
                    (shown, method.name(), *iterations, nan(tolerance), nan(came_to), why.what());
                raise("NotConverged", arguments.into_pyobject(py)?)
            }
            Failure::Asked(message) => Ok(pyo3::exceptions::PyValueError::new_err(message.clone())),
        }
    }
}

impl From<Failure> for PyErr {
    fn from(failure: Failure) -> Self {
        Python::attach(|py| failure.raised(py).unwrap_or_else(|broken| broken))
    }
}
