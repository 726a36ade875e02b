//! Draws, solves and saves the samples of studies in Rust. No Python code runs for the individual samples.

use crate::failure::Failure;
use crate::model::held;
use crate::threads;
use groundbeam_file::Course;
use groundbeam_file::study::{StudyError, read_held_study, read_study};
use groundbeam_report::{Context, json, svg};
use groundbeam_study::{Draws, Finished, Shard, Stage, StoreError, Watch};
use numpy::{PyArray1, PyArray2};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

/// A study file with a number of samples and a seed.
#[pyclass(frozen, module = "groundbeam._native")]
pub struct Study {
    draws: Draws,
}

fn lost(error: &StoreError) -> PyErr {
    Failure::Asked(error.to_string()).into()
}

#[pymethods]
impl Study {
    #[new]
    fn new(
        path: PathBuf,
        samples: Option<u64>,
        seed: Option<u64>,
        files: Option<Vec<(String, String)>>,
    ) -> PyResult<Self> {
        let study = match files {
            None => read_study(&path),
            Some(files) => read_held_study(&path, &held(files)),
        };
        let study = study.map_err(|error| match error {
            StudyError::Unreadable(path, error) => {
                let place = format!("{}: {error}", path.display());
                std::io::Error::new(error.kind(), place).into()
            }
            StudyError::Wrong(found, path, text) => {
                PyErr::from(Failure::wrong(found, &path.display().to_string(), &text))
            }
        })?;
        let plan = study.plan.with(samples, seed);
        let draws = Draws::new(study, plan);
        let draws =
            draws.map_err(|error| Failure::Asked(format!("{}: {error}", path.display())))?;
        Ok(Study { draws })
    }

    #[getter]
    fn title(&self) -> Option<&str> {
        self.draws.study().title.as_deref()
    }

    #[getter]
    fn samples(&self) -> u64 {
        self.draws.plan().samples
    }

    #[getter]
    fn seed(&self) -> u64 {
        self.draws.plan().seed
    }

    /// Names and texts of all files of the study.
    #[getter]
    fn files(&self) -> Vec<(String, String)> {
        self.draws.study().files().into_iter().map(|file| (file.name, file.text)).collect()
    }

    #[getter]
    fn digest(&self) -> String {
        groundbeam_study::digest(&self.draws)
    }

    /// Whether a file contains all results of a shard.
    fn is_done(&self, out: PathBuf, shard: (u64, u64)) -> PyResult<bool> {
        let shard = Shard { number: shard.0, of: shard.1 };
        groundbeam_study::is_done(&self.draws, &out, shard).map_err(|error| lost(&error))
    }

    #[getter]
    fn model_path(&self) -> &Path {
        &self.draws.study().model_path
    }

    /// Returns the random numbers of consecutive samples by name, and the random fields as arrays of samples by points.
    fn draw<'py>(&self, py: Python<'py>, first: u64, count: u64) -> PyResult<Bound<'py, PyDict>> {
        let drawn: Vec<_> =
            py.detach(|| (first..first + count).map(|sample| self.draws.draw(sample)).collect());
        let table = PyDict::new(py);
        for (i, random) in self.draws.study().random.iter().enumerate() {
            let column = drawn.iter().map(|draw| draw.numbers[i]).collect();
            table.set_item(&random.name, PyArray1::from_vec(py, column))?;
        }
        let fields = self.draws.study().field.iter().flat_map(|field| &field.of).enumerate();
        for (i, of) in fields {
            let rows: Vec<Vec<f64>> = drawn.iter().map(|draw| draw.fields[i].clone()).collect();
            let array = PyArray2::from_vec2(py, &rows)
                .map_err(|error| Failure::Asked(error.to_string()))?;
            table.set_item(of.name(), array)?;
        }
        Ok(table)
    }

    /// Name of the class that `solve_many` needs for the random fields of the samples.
    #[getter]
    fn shape(&self) -> &'static str {
        match self.draws.study().field.as_ref().map(|field| field.course) {
            Some(Course::Steps) => "Steps",
            Some(Course::Lines) | None => "Points",
        }
    }

    /// Solves the remaining samples. Returns the number of samples that this call solved.
    fn run(
        &self,
        py: Python<'_>,
        out: PathBuf,
        shard: (u64, u64),
        restart: bool,
        threads: usize,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<u64> {
        let shard = Shard { number: shard.0, of: shard.1 };
        let threads = threads::number(threads);
        let finished = watched(py, progress, |watch| {
            groundbeam_study::run(&self.draws, &out, shard, restart, threads, watch)
        })?;
        match finished {
            Finished::Whole(solved) => Ok(solved),
            Finished::Stopped(_) => Ok(0),
        }
    }

    /// Checks a file of results against its checksums. Returns the number of samples.
    fn verify(&self, py: Python<'_>, out: PathBuf) -> PyResult<u64> {
        watched(py, None, |watch| groundbeam_study::verify(&out, watch))
    }

    /// Computes the statistics of all samples. Returns a document and a picture.
    fn summary(&self, py: Python<'_>, out: PathBuf) -> PyResult<(String, String)> {
        let context = Context::new(self.draws.study().document.printed);
        let summary =
            watched(py, None, |watch| groundbeam_study::summary(&self.draws, &out, watch))?;
        Ok((json::study(&summary, &context), svg::study(&summary, &context).to_string()))
    }
}

/// Merges the shards of a study. Returns the number of samples.
#[pyfunction]
pub fn merge(py: Python<'_>, files: Vec<PathBuf>, out: PathBuf) -> PyResult<u64> {
    Ok(watched(py, None, |watch| groundbeam_study::merge(&files, &out, watch))?.samples)
}

/// Runs `work` without the interpreter's lock. Ctrl-C stops the work, and `progress` receives the number of
/// solved samples.
fn watched<T: Send>(
    py: Python<'_>,
    progress: Option<Py<PyAny>>,
    work: impl Send + FnOnce(&mut Watch) -> Result<T, StoreError>,
) -> PyResult<T> {
    let mut raised = None;
    let result = py.detach(|| {
        work(&mut |now| {
            let told = Python::attach(|py| {
                py.check_signals()?;
                if let (Some(progress), Stage::Solving) = (&progress, now.stage) {
                    progress.call1(py, (now.done, now.of))?;
                }
                Ok(())
            });
            match told {
                Ok(()) => ControlFlow::Continue(()),
                Err(error) => {
                    raised = raised.take().or(Some(error));
                    ControlFlow::Break(())
                }
            }
        })
    });
    match raised {
        Some(error) => Err(error),
        None => result.map_err(|error| lost(&error)),
    }
}
