//! The Python class of a model, read from text.

use crate::answers::Answers;
use crate::derivatives::parameter;
use crate::failure::Failure;
use crate::read::Read;
use crate::solution::Solution;
use crate::threads::Threads;
use groundbeam::{Method, Options};
use groundbeam_file::{Beside, Combination, OtherFile};
use groundbeam_report::{sentence, verdict_name};
use groundbeam_run::{Compare, Host, Run};
use pyo3::prelude::*;
use std::path::Path;
use std::sync::Arc;

/// A model file that was read and validated.
#[pyclass(frozen, module = "groundbeam._native")]
pub struct Model {
    pub read: Arc<Read>,
}

impl Model {
    /// The answers of a run.
    fn answers(&self, run: &Run, threads: Option<usize>) -> PyResult<Answers> {
        let (answers, seconds) = self.read.solve(run, threads)?;
        Ok(Answers { read: self.read.clone(), answers, seconds })
    }

    /// Solves a combination under its own loads, without trains.
    fn solution(&self, combination: Combination, options: Options) -> PyResult<Solution> {
        let run = Run::without_trains(&self.read.document, combination).with_options(options);
        self.answers(&run, None)?.only()
    }
}

/// Options of the method.
pub fn options(method: &str, elements: usize) -> Result<Options, Failure> {
    let known = Method::ALL.into_iter().find(|known| known.name() == method);
    let Some(method) = known else {
        let names = Method::ALL.map(Method::name).join(", ");
        return Err(Failure::Asked(format!(
            "no method has the name `{method}`; the methods are {names}"
        )));
    };
    if elements == 0 {
        return Err(Failure::Asked("a mesh needs at least one element".to_owned()));
    }
    Ok(Options { method, elements, ..Options::default() })
}

/// Converts pairs of names and texts to files in memory.
pub fn held(files: Vec<(String, String)>) -> Vec<OtherFile> {
    files.into_iter().map(|(name, text)| OtherFile { name, text }).collect()
}

/// Decodes the text of a model file, which must be UTF-8.
#[pyfunction]
pub fn text_of(bytes: &[u8], name: &str) -> Result<String, Failure> {
    let text = groundbeam_file::text_of(bytes).map(str::to_owned);
    text.map_err(|found| Failure::wrong(found, name, &String::from_utf8_lossy(bytes)))
}

#[pymethods]
impl Model {
    #[new]
    fn new(
        py: Python<'_>,
        text: &str,
        name: &str,
        bare_is_si: bool,
        folder: Option<&str>,
        files: Option<Vec<(String, String)>>,
    ) -> Result<Self, Failure> {
        let files = files.map(held);
        let beside = folder.map(Path::new).map(|folder| match &files {
            Some(files) => Beside::held(folder, files),
            None => Beside::from(folder),
        });
        let document = py.detach(|| match beside {
            beside if bare_is_si => groundbeam_file::parse_si(text, beside),
            Some(beside) => groundbeam_file::parse_beside(text, beside),
            None => groundbeam_file::parse(text),
        });
        let document = document.map_err(|found| Failure::wrong(found, name, text))?;
        Ok(Model { read: Arc::new(Read { document, name: name.to_owned() }) })
    }

    /// Names and texts of the other files to which the model refers.
    #[getter]
    fn files(&self) -> Vec<(String, String)> {
        let files = self.read.document.files.iter();
        files.map(|file| (file.name.clone(), file.text.clone())).collect()
    }

    #[getter]
    fn title(&self) -> Option<&str> {
        self.read.document.title.as_deref()
    }

    #[getter]
    fn units(&self) -> &'static str {
        self.read.system()
    }

    #[getter]
    fn length(&self) -> f64 {
        self.read.document.model.beam.length
    }

    #[getter]
    fn load_count(&self) -> usize {
        self.read.document.model.loads.len()
    }

    /// Names of the trains that pass over the beam.
    #[getter]
    fn trains(&self) -> Vec<String> {
        self.read.document.trains.iter().map(|train| train.name.clone()).collect()
    }

    /// Returns all combinations of load cases and grounds, each with its name and the factors of its load cases.
    fn combinations(&self) -> Vec<(String, Vec<(String, f64)>)> {
        let all = self.read.document.combinations();
        all.into_iter().map(|combination| (combination.name, combination.factors)).collect()
    }

    fn solve(
        &self,
        py: Python<'_>,
        method: &str,
        elements: usize,
        combination: Option<&str>,
    ) -> PyResult<Solution> {
        let options = options(method, elements)?;
        let combination = self.read.combination(combination)?;
        py.detach(|| self.solution(combination, options))
    }

    /// Solves the model with other values of some parameters.
    fn solve_with(
        &self,
        py: Python<'_>,
        numbers: Vec<(String, f64)>,
        combination: Option<&str>,
    ) -> PyResult<Solution> {
        let mut combination = self.read.combination(combination)?;
        for (name, number) in numbers {
            let own = parameter(&name)?;
            if own.is_of_ground() && combination.model.foundation.soil.is_some() {
                let why = "the model's ground is defined by soil data";
                return Err(Failure::Asked(format!("parameter `{name}`: {why}")).into());
            }
            let changed = own.set(&combination.model, number);
            combination.model = changed.ok_or_else(|| {
                Failure::Asked(format!("the model has no single value of the parameter `{name}`"))
            })?;
        }
        py.detach(|| self.solution(combination, Options::default()))
    }

    /// Value of a parameter.
    fn number(&self, name: &str, combination: Option<&str>) -> Result<f64, Failure> {
        let model = self.read.combination(combination)?.model;
        let number = parameter(name)?.value(&model);
        number.ok_or_else(|| {
            Failure::Asked(format!("the model has no single value of the parameter `{name}`"))
        })
    }

    /// Solves all combinations. The results are in the order of the combinations.
    fn solve_combinations(
        &self,
        py: Python<'_>,
        method: &str,
        elements: usize,
        threads: usize,
    ) -> PyResult<Answers> {
        let run = Run::of_combinations(&self.read.document);
        let run = run.with_options(options(method, elements)?);
        py.detach(|| self.answers(&run, Some(threads)))
    }

    /// Moves every train over the beam under every combination, or under one given combination.
    fn solve_trains(
        &self,
        py: Python<'_>,
        method: &str,
        elements: usize,
        combination: Option<&str>,
        threads: usize,
    ) -> PyResult<Answers> {
        let document = &self.read.document;
        let run = match combination {
            None => Run::of(document),
            Some(_) => Run::of_one(document, self.read.combination(combination)?),
        };
        let run = run.with_options(options(method, elements)?);
        py.detach(|| self.answers(&run, Some(threads)))
    }

    /// Solves one model by every method.
    fn compare(
        &self,
        py: Python<'_>,
        elements: usize,
        most_sweeps: usize,
        combination: Option<&str>,
    ) -> PyResult<Answers> {
        options("exact", elements)?;
        let combination = self.read.combination(combination)?;
        let run = Run::without_trains(&self.read.document, combination);
        let compare = Compare { elements, most_sweeps, ..Compare::default() };
        let host = Threads::new(None);
        let answers = py.detach(|| run.compare(compare, &host));
        let answers = answers.map_err(|error| self.read.refused(error))?;
        Ok(Answers { read: self.read.clone(), answers, seconds: host.seconds() })
    }

    /// Checks the existence of an equilibrium. Returns verdict, static reactions, deciding motion and a sentence.
    fn check(&self, combination: Option<&str>) -> Result<Statics, Failure> {
        let combination = self.read.combination(combination)?;
        let model = &combination.model;
        let existence = groundbeam::exists(model).map_err(|error| self.read.refused(error))?;
        let motion = existence.verdict.motion().map(|[left, right, work]| (left, right, work));
        let verdict = verdict_name(existence.verdict);
        let sentence = sentence(model, &existence, self.read.units());
        let reactions =
            groundbeam::existence::static_reactions(model).iter().map(|(_, r)| *r).collect();
        Ok((verdict, reactions, motion, sentence))
    }

    /// Reads a position from text, in the units of the file.
    fn read_position(&self, text: &str) -> Result<f64, Failure> {
        self.read.position(text)
    }
}

/// Verdict on the existence of an equilibrium, static reactions, deciding motion, and explanation. The motion is given
/// by the displacements of the left and the right end and by the work of the loads.
type Statics = (&'static str, Vec<f64>, Option<(f64, f64, f64)>, String);
