//! The answers to all combinations of a model, and their envelope.

use crate::failure::{Failure, Tipping};
use crate::model::Read;
use crate::solution::{Solution, field};
use groundbeam::{Envelope, Existence, Stopped};
use groundbeam_file::{Combination, LoadCase};
use groundbeam_report::{Alone, Answer, Combined, csv, json, svg, text};
use numpy::{PyArray1, PyReadonlyArray1};
use pyo3::prelude::*;
use std::sync::Arc;

/// The answers to all combinations of a model.
#[pyclass(frozen, module = "groundbeam._native")]
pub struct Combinations {
    read: Arc<Read>,
    all: Vec<(Combination, Found)>,
    alone: Vec<(LoadCase, Existence)>,
    seconds: f64,
}

enum Found {
    Equilibrium(Py<Solution>),
    NoEquilibrium(Tipping, Existence),
    NotConverged(Stopped),
}

impl Combinations {
    /// Of the answers in the order of the combinations; a model that is refused under one of them is refused.
    pub fn new(
        read: Arc<Read>,
        answers: Vec<(Combination, Result<Solution, Failure>)>,
        seconds: f64,
    ) -> Result<Self, Failure> {
        let mut all = Vec::new();
        for (combination, answer) in answers {
            let found = match answer {
                Ok(solution) => {
                    let kept = Python::attach(|py| Py::new(py, solution));
                    Found::Equilibrium(kept.map_err(|error| Failure::Asked(error.to_string()))?)
                }
                Err(Failure::NoEquilibrium(tipping)) => {
                    let checked = groundbeam::exists(&combination.model);
                    let existence = checked.map_err(|error| read.refused(error))?;
                    Found::NoEquilibrium(tipping, existence)
                }
                Err(Failure::NotConverged(reached)) => Found::NotConverged(reached),
                Err(refused) => return Err(refused),
            };
            all.push((combination, found));
        }
        let mut alone = Vec::new();
        for case in read.document.load_cases() {
            let existence = groundbeam::exists(&case.model).map_err(|error| read.refused(error))?;
            alone.push((case, existence));
        }
        Ok(Combinations { read, all, alone, seconds })
    }

    /// As reports want them.
    fn together(&self) -> groundbeam_report::Combinations<'_> {
        let combined = self.all.iter().map(|(combination, found)| {
            let Combination { name, factors, model, ground: band, .. } = combination;
            let (answer, ground) = match found {
                Found::Equilibrium(solution) => {
                    let solution = solution.get();
                    (Answer::Equilibrium(&solution.found), solution.context().ground)
                }
                Found::NoEquilibrium(_, existence) => (Answer::NoEquilibrium(existence), None),
                Found::NotConverged(reached) => (Answer::NotConverged(reached), None),
            };
            Combined { name, factors, model, band: *band, ground, answer }
        });
        let alone = self.alone.iter().map(|(LoadCase { name, model }, existence)| Alone {
            name,
            model,
            existence,
        });
        groundbeam_report::Combinations { combined: combined.collect(), alone: alone.collect() }
    }
}

/// A bound of an envelope: its values, and the numbers of the combinations that govern.
type Line<'py> = (Bound<'py, PyArray1<f64>>, Vec<usize>);

#[pymethods]
impl Combinations {
    /// Each combination's name with its solution, or with the exception that solving it alone would raise.
    fn answers(&self, py: Python<'_>) -> PyResult<Vec<(String, Py<PyAny>)>> {
        let each = self.all.iter().map(|(combination, found)| {
            let answer = match found {
                Found::Equilibrium(solution) => solution.clone_ref(py).into_any(),
                Found::NoEquilibrium(tipping, _) => {
                    let failure = Failure::NoEquilibrium(tipping.clone());
                    PyErr::from(failure).into_value(py).into_any()
                }
                Found::NotConverged(reached) => {
                    let failure = Failure::NotConverged(reached.clone());
                    PyErr::from(failure).into_value(py).into_any()
                }
            };
            Ok((combination.name.clone(), answer))
        });
        each.collect()
    }

    /// The load cases, and whether each could stand by itself.
    fn load_cases(&self) -> Vec<(String, bool)> {
        let each = self.together().alone.into_iter();
        each.map(|alone| (alone.name.to_owned(), alone.stands())).collect()
    }

    /// The smallest and the largest values of a field at positions on the beam, and the number of the solved
    /// combination that has them.
    fn envelope<'py>(
        &self,
        py: Python<'py>,
        name: &str,
        x: PyReadonlyArray1<'py, f64>,
    ) -> Result<[Line<'py>; 2], Failure> {
        let field = field(name)?;
        let together = self.together();
        let envelope: Envelope = together.envelope();
        let bounds: Vec<_> = x.as_array().iter().map(|&x| envelope.at(field, x)).collect();
        let values = |smallest: bool| {
            let lines = bounds.iter().map(|b| if smallest { b.min } else { b.max });
            let (values, by) = lines.map(|g| (g.extreme.value, g.by)).unzip();
            (PyArray1::from_vec(py, values), by)
        };
        Ok([values(true), values(false)])
    }

    fn stations<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_vec(py, json::envelope_stations(&self.together()))
    }

    fn to_json(&self, at: Option<Vec<f64>>) -> String {
        let context = self.read.context().with_seconds(self.seconds);
        json::combinations(&self.together(), at.as_deref(), &context)
    }

    fn to_csv(&self, at: Option<Vec<f64>>) -> String {
        let together = self.together();
        let at = at.unwrap_or_else(|| json::envelope_stations(&together));
        csv::envelope(&together, &at, self.read.units())
    }

    fn to_svg(&self) -> String {
        svg::combinations(&self.together(), &self.read.context())
    }

    fn report(&self) -> String {
        let context = self.read.context().with_seconds(self.seconds);
        text::combinations(&self.together(), &context, false)
    }
}
