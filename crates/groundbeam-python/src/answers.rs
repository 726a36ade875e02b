//! The results for several models: all combinations, trains, or methods.

use crate::failure::Failure;
use crate::names::field;
use crate::read::Read;
use crate::solution::Solution;
use groundbeam::{design::LimitState, envelope::Envelope};
use groundbeam_report::{Context, Results, json};
use groundbeam_run::{self as run, Answer, Errors, InPassage, Passage};
use numpy::{PyArray1, PyReadonlyArray1};
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use std::sync::Arc;

/// The results for several models of one file.
#[pyclass(frozen, module = "groundbeam._native")]
pub struct Answers {
    pub read: Arc<Read>,
    pub answers: run::Answers,
    pub seconds: f64,
}

impl Answers {
    /// Returns the solution if there is exactly one result.
    pub fn only(&self) -> PyResult<Solution> {
        let answer = self.answers.list.first();
        let answer = answer.ok_or_else(|| Failure::Asked("nothing was solved".to_owned()))?;
        Ok(Solution::of(&self.read, answer)?)
    }

    /// Converts the results to the form that reports use.
    fn results(&self) -> Results<'_> {
        let context = Context::of(&self.read.document).with_seconds(self.seconds);
        Results::new(&self.answers, context)
    }

    /// Returns the solution of one result, or the exception that a separate solve would raise.
    fn answer(&self, py: Python<'_>, answer: &Answer) -> PyResult<Py<PyAny>> {
        match Solution::of(&self.read, answer) {
            Ok(solution) => Ok(Py::new(py, solution)?.into_any()),
            Err(failure) => Ok(PyErr::from(failure).into_value(py).into_any()),
        }
    }

    fn passage(&self, number: usize) -> PyResult<Passage<'_>> {
        let found = self.answers.passages().all.get(number).copied();
        Ok(found.ok_or_else(|| Failure::Asked(format!("there is no passage {number}")))?)
    }
}

/// One bound of an envelope: its values at the positions, and the indices of the governing combinations.
type Line<'py> = (Bound<'py, PyArray1<f64>>, Vec<usize>);

/// One bound of an envelope of passages: its values, the positions of the first axle, and the indices of the passages.
type Moving<'py> = (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<f64>>, Vec<usize>);

/// Value for the best estimates of k and μ, and its smallest and largest value over all pairs of k and μ of
/// `[foundation.band]`.
type Banded = (f64, f64, f64);

/// Relative errors of deflection, moment, settlement and end forces.
type Apart = (f64, f64, f64, f64);

#[pymethods]
impl Answers {
    #[getter]
    fn length(&self) -> f64 {
        self.read.document.model.beam.length
    }

    /// Reads a position from text, in the units of the file.
    fn read_position(&self, text: &str) -> Result<f64, Failure> {
        self.read.position(text)
    }

    /// Returns the name of each combination, with its solution or the exception that a separate solve would raise.
    fn answers(&self, py: Python<'_>) -> PyResult<Vec<(String, Py<PyAny>)>> {
        let each = self.answers.list.iter();
        each.map(|answer| Ok((answer.name().to_owned(), self.answer(py, answer)?))).collect()
    }

    /// Returns the load cases, and whether each load case alone has an equilibrium.
    fn load_cases(&self) -> Vec<(String, bool)> {
        let each = self.answers.alone.iter();
        each.map(|alone| (alone.case.name.clone(), alone.stands())).collect()
    }

    /// Returns the envelope of a field at positions on the beam: its values, and the indices of the governing
    /// combinations. If a limit state is given, only its combinations count.
    fn envelope<'py>(
        &self,
        py: Python<'py>,
        name: &str,
        x: PyReadonlyArray1<'py, f64>,
        limit_state: Option<&str>,
    ) -> Result<[Line<'py>; 2], Failure> {
        let field = field(name)?;
        let state = limit_state.and_then(LimitState::named);
        let all = self.answers.solved().enumerate();
        let of_it = all.filter(|(_, (answer, _))| state.is_none_or(|state| answer.is_of(state)));
        let (numbers, solutions): (Vec<usize>, Vec<&groundbeam::Solution>) =
            of_it.map(|(i, (_, solution))| (i, solution)).unzip();
        let envelope = Envelope::of(solutions);
        let bounds: Vec<_> = x.as_array().iter().map(|&x| envelope.at(field, x)).collect();
        let values = |smallest: bool| {
            let lines = bounds.iter().map(|b| if smallest { b.min } else { b.max });
            let (values, by) = lines.map(|g| (g.extreme.value, numbers[g.by])).unzip();
            (PyArray1::from_vec(py, values), by)
        };
        Ok([values(true), values(false)])
    }

    /// Names of the limit states of the solved combinations.
    fn limit_states(&self) -> Vec<&'static str> {
        self.answers.limit_states().iter().map(LimitState::name).collect()
    }

    /// Returns the smallest and the largest value of a field for the best estimates of k and μ, each with its range
    /// over all pairs of k and μ of `[foundation.band]`.
    fn band(&self, name: &str) -> Result<Option<(Banded, Banded)>, Failure> {
        let field = field(name)?;
        let of = |band: run::Banded| (band.best, band.low, band.high);
        Ok(self.answers.bands().map(|bands| {
            let [min, max] = bands[field.index()];
            (of(min), of(max))
        }))
    }

    fn stations<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        let passages = self.answers.passages();
        PyArray1::from_vec(
            py,
            match passages.all.is_empty() {
                true => json::envelope_stations(&self.answers),
                false => passages.default_stations(),
            },
        )
    }

    /// Returns for each passage: combination, train, range of the first axle, ranges without equilibrium, and positions
    /// of the first axle without convergence.
    fn passages(&self) -> Vec<(Option<String>, String, [f64; 2], Vec<[f64; 2]>, Vec<f64>)> {
        let each = self.answers.passages().all.into_iter().map(|passage| {
            (
                passage.combination().map(str::to_owned),
                passage.moving().placed_name(),
                passage.moving().range,
                passage.without_equilibrium().to_vec(),
                passage.not_converged().collect(),
            )
        });
        each.collect()
    }

    /// Returns all positions of the first axle in a passage that have a solution.
    fn positions<'py>(
        &self,
        py: Python<'py>,
        passage: usize,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let passage = self.passage(passage)?;
        let solved = passage.solved().map(|(first_axle, _)| first_axle).collect();
        Ok(PyArray1::from_vec(py, solved))
    }

    /// Finds the position of the first axle that has a solution and is nearest to `first_axle`. Returns the found
    /// position and its solution.
    fn nearest(&self, passage: usize, first_axle: f64) -> PyResult<Option<(f64, Solution)>> {
        let passage = self.passage(passage)?;
        let Some((first_axle, _)) = passage.nearest(first_axle) else { return Ok(None) };
        let here = |answer: &&Answer| {
            let train = answer.label.train.as_ref();
            train.is_some_and(|placed| placed.first_axle == first_axle)
        };
        let answer = passage.answers().iter().find(here);
        let solution = answer.map(|answer| Solution::of(&self.read, answer)).transpose()?;
        Ok(solution.map(|solution| (first_axle, solution)))
    }

    /// Returns the smallest and the largest values of a field at positions over all passages, or over the
    /// passages of a limit state; `None` if no position of a train was solved.
    fn moving_envelope<'py>(
        &self,
        py: Python<'py>,
        name: &str,
        x: PyReadonlyArray1<'py, f64>,
        limit_state: Option<&str>,
    ) -> Result<Option<[Moving<'py>; 2]>, Failure> {
        let index = field(name)?.index();
        let all = self.answers.passages();
        let passages = match limit_state.and_then(LimitState::named) {
            Some(state) => all.of_limit_state(state),
            None => all,
        };
        let each = x.as_array().iter().map(|&x| Some(passages.at(x)?[index])).collect();
        let Some::<Vec<[InPassage; 2]>>(bounds) = each else { return Ok(None) };
        let line = |bound: usize| {
            let all = || bounds.iter().map(move |both| both[bound]);
            let values = all().map(|found| found.located.value).collect();
            let axles = all().map(|found| found.located.first_axle).collect();
            let numbers = all().map(|found| found.passage).collect();
            (PyArray1::from_vec(py, values), PyArray1::from_vec(py, axles), numbers)
        };
        Ok(Some([line(0), line(1)]))
    }

    /// Returns for each method its name, its solution or an exception, its errors relative to the first method,
    /// and its duration.
    fn methods(
        &self,
        py: Python<'_>,
    ) -> PyResult<Vec<(&'static str, Py<PyAny>, Option<Apart>, f64)>> {
        let exact = self.answers.list.first().and_then(Answer::solution);
        let each = self.answers.list.iter().map(|answer| {
            let errors = answer.solution().zip(exact).map(|(solution, exact)| {
                let errors = Errors::of(solution, exact);
                (errors.deflection, errors.moment, errors.settlement, errors.end_forces)
            });
            Ok((answer.label.method, self.answer(py, answer)?, errors, answer.seconds))
        });
        each.collect()
    }

    fn to_json(&self, at: Option<Vec<f64>>) -> String {
        self.results().json(at.as_deref())
    }

    fn to_csv(&self, at: Option<Vec<f64>>) -> String {
        self.results().csv(at.as_deref())
    }

    fn to_svg(&self, py: Python<'_>) -> String {
        py.detach(|| self.results().picture().map_or_else(String::new, |drawn| drawn.to_string()))
    }

    fn to_png<'py>(&self, py: Python<'py>) -> Result<Bound<'py, PyBytes>, Failure> {
        let drawn = py.detach(|| self.results().picture().map(|drawn| drawn.png()).transpose());
        let drawn = drawn.map_err(|error| Failure::Asked(error.to_string()))?;
        Ok(PyBytes::new(py, &drawn.unwrap_or_default()))
    }

    fn report(&self) -> String {
        self.results().text(false)
    }
}
