//! A model as text, read; and what can be asked of it.

use crate::combinations::Combinations;
use crate::derivatives::parameter;
use crate::failure::{Failure, Tipping};
use crate::solution::{Soil, Solution};
use crate::threads;
use groundbeam::{Error, Method, Options, Outcome, Verdict};
use groundbeam_file::{Beside, Combination, Document, OtherFile, UnitSystem};
use groundbeam_report::{Context, Units, sentence};
use pyo3::prelude::*;
use std::path::Path;
use std::sync::Arc;
use std::time::Instant;

/// How results of a text are written: as its quantities are.
pub fn units(of: UnitSystem) -> Units {
    match of {
        UnitSystem::Si => Units::Si,
        UnitSystem::Plain => Units::Plain,
    }
}

/// A model that was read and found right.
#[pyclass(frozen, module = "groundbeam._native")]
pub struct Model {
    pub read: Arc<Read>,
}

/// A text, what it is called, and what it says.
pub struct Read {
    pub document: Document,
    pub name: String,
}

impl Read {
    pub fn units(&self) -> Units {
        units(self.document.units)
    }

    /// The system of units by the name that results use.
    pub fn system(&self) -> &'static str {
        self.units().name()
    }

    /// Title, units and limits, as reports want them.
    pub fn context(&self) -> Context<'_> {
        let context = Context::new(self.units()).with_limits(&self.document.limits);
        let Document { title, chords, .. } = &self.document;
        Context { title: title.as_deref(), chords: *chords, ..context }
    }

    pub fn refused(&self, error: Error) -> Failure {
        Failure::refused(error, &self.document, &self.name)
    }

    /// What mechanics says of one of the text's combinations.
    pub fn answer(
        self: &Arc<Self>,
        combination: Combination,
        options: &Options,
    ) -> Result<Solution, Failure> {
        let started = Instant::now();
        let (outcome, soil) = match &combination.bed {
            None => (groundbeam::solve_with(&combination.model, options), None),
            Some(bed) => match bed.solve(&combination.model, options) {
                Ok(found) => {
                    let soil = Soil::of(&found);
                    (Ok(found.outcome), Some(soil))
                }
                Err(error) => (Err(error), None),
            },
        };
        let seconds = started.elapsed().as_secs_f64();
        match outcome.map_err(|error| self.refused(error))? {
            Outcome::Equilibrium(found) => {
                Ok(Solution { read: self.clone(), combination, found, soil, seconds })
            }
            Outcome::NoEquilibrium(existence) => {
                let tipping = Tipping::of(&combination.model, &existence, self.units());
                Err(Failure::NoEquilibrium(tipping))
            }
        }
    }

    /// The one that is called so; without a name the model as it is written.
    fn combination(&self, name: Option<&str>) -> Result<Combination, Failure> {
        let document = &self.document;
        let Some(name) = name else { return Ok(document.as_written()) };
        let wrong = |found| Failure::wrong(found, "combination", name);
        document.combination(name).map_err(wrong)
    }
}

/// What was chosen about the method.
pub fn options(method: &str, elements: usize) -> Result<Options, Failure> {
    let known = Method::ALL.into_iter().find(|known| known.name() == method);
    let Some(method) = known else {
        let names = Method::ALL.map(Method::name).join(", ");
        return Err(Failure::Asked(format!(
            "no method is called `{method}`; the methods are {names}"
        )));
    };
    if elements == 0 {
        return Err(Failure::Asked("a mesh has at least one element".to_owned()));
    }
    Ok(Options { method, elements, ..Options::default() })
}

/// What the statics say, by the name that results use.
pub fn verdict(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Unique => "unique",
        Verdict::NotUnique(_) => "not-unique",
        Verdict::Local(_) => "local",
        Verdict::None(_) | Verdict::Buckles(_) => "none",
    }
}

/// Files in memory, of names and texts.
pub fn held(files: Vec<(String, String)>) -> Vec<OtherFile> {
    files.into_iter().map(|(name, text)| OtherFile { name, text }).collect()
}

/// A model file's text, which must be UTF-8.
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

    /// The names and texts of the files that the model names, as they were read.
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

    /// The names of the trains that pass over the beam.
    #[getter]
    fn trains(&self) -> Vec<String> {
        self.read.document.trains.iter().map(|train| train.name.clone()).collect()
    }

    /// Every combination of load cases and grounds: its name, and the factors of the cases.
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
    ) -> Result<Solution, Failure> {
        let options = options(method, elements)?;
        let combination = self.read.combination(combination)?;
        py.detach(|| self.read.answer(combination, &options))
    }

    /// Solves it with other numbers for some parameters, as they are called.
    fn solve_with(
        &self,
        py: Python<'_>,
        numbers: Vec<(String, f64)>,
        combination: Option<&str>,
    ) -> Result<Solution, Failure> {
        let mut combination = self.read.combination(combination)?;
        for (name, number) in numbers {
            let own = parameter(&name)?;
            if own.is_of_ground() && combination.bed.is_some() {
                let why = "the model's ground is made of its soil";
                return Err(Failure::Asked(format!("parameter `{name}`: {why}")));
            }
            let changed = own.set(&combination.model, number);
            combination.model = changed.ok_or_else(|| {
                Failure::Asked(format!("parameter `{name}`: the model has no such number"))
            })?;
        }
        py.detach(|| self.read.answer(combination, &Options::default()))
    }

    /// The number that a parameter has.
    fn number(&self, name: &str, combination: Option<&str>) -> Result<f64, Failure> {
        let model = self.read.combination(combination)?.model;
        let number = parameter(name)?.value(&model);
        number.ok_or_else(|| {
            Failure::Asked(format!("parameter `{name}`: the model has no such number"))
        })
    }

    /// Solves every combination, each by itself and in its place.
    fn solve_combinations(
        &self,
        py: Python<'_>,
        method: &str,
        elements: usize,
        threads: usize,
    ) -> PyResult<Combinations> {
        let options = options(method, elements)?;
        py.detach(|| {
            let started = Instant::now();
            let all = self.read.document.combinations();
            let answer =
                |(): &mut (), number: usize| self.read.answer(all[number].clone(), &options);
            let answers = threads::map(all.len(), threads, None, || (), answer)?;
            let answers = all.into_iter().zip(answers).collect();
            let seconds = started.elapsed().as_secs_f64();
            Ok(Combinations::new(self.read.clone(), answers, seconds)?)
        })
    }

    /// The verdict, the static reactions, the motion that costs nothing or gains work, and a sentence.
    fn check(&self, combination: Option<&str>) -> Result<Statics, Failure> {
        let combination = self.read.combination(combination)?;
        let model = &combination.model;
        let existence = groundbeam::exists(model).map_err(|error| self.read.refused(error))?;
        let motion = existence.verdict.motion().map(|[left, right, work]| (left, right, work));
        let verdict = verdict(existence.verdict);
        let sentence = sentence(model, &existence, self.read.units());
        let reactions = groundbeam::static_reactions(model).iter().map(|(_, r)| *r).collect();
        Ok((verdict, reactions, motion, sentence))
    }

    /// Positions with units, separated by commas.
    fn positions(&self, list: &str) -> Result<Vec<f64>, Failure> {
        let found = groundbeam_file::parse_positions(list, self.read.document.units);
        found.map_err(|found| Failure::wrong(found, "x", list))
    }
}

/// Verdict, static reactions, motion, sentence.
type Statics = (&'static str, Vec<f64>, Option<(f64, f64, f64)>, String);
