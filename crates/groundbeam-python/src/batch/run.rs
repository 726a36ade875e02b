//! Solves the models of a batch: numbers of each row put into its model, its answer made a row.

use super::parameter::{Parameter, apply};
use crate::failure::Tipping;
use crate::read::Read;
use groundbeam::{Options, Solver};
use groundbeam_study::{Row, Trouble, Wanted};
use pyo3::prelude::*;
use std::sync::Arc;

/// Everything that the threads need to know.
pub struct Task {
    /// One for each answer, or one for all.
    pub models: Vec<Arc<Read>>,
    pub parameters: Vec<Parameter>,
    pub wanted: Wanted,
    pub options: Options,
}

/// Solves every model in its place.
pub fn run(
    task: &Task,
    count: usize,
    threads: usize,
    progress: Option<&Py<PyAny>>,
) -> PyResult<Vec<Answered>> {
    let solver = || Solver::with_options(task.options.clone());
    crate::threads::map(count, threads, progress, solver, |solver, number| task.row(number, solver))
}

/// An answer, and in words why there is none.
pub struct Answered {
    pub row: Row,
    pub message: Option<String>,
}

impl Task {
    /// The answer of a number, the same whatever thread it is on and whatever that has solved before.
    fn row(&self, number: usize, solver: &mut Solver) -> Answered {
        let Task { models, parameters, wanted, .. } = self;
        let read = &models[if models.len() == 1 { 0 } else { number }];
        let mut model = read.document.model.clone();
        apply(parameters, number, &mut model);
        let row = Row::solve(&model, wanted, solver);
        let message = row.trouble.as_deref().map(|trouble| match trouble {
            Trouble::NoEquilibrium(existence) => {
                Tipping::of(&model, existence, read.units()).sentence
            }
            Trouble::Failed(error) => error.to_string(),
        });
        Answered { row, message }
    }
}
