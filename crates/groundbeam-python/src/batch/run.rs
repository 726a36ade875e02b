//! Solves the models of a batch: sets the given parameter values in each model, and converts its result to a row of numbers.

use super::parameter::{Parameter, apply};
use crate::failure::{Tipping, remediable};
use crate::read::Read;
use groundbeam::{Options, Solver};
use groundbeam_study::{Row, Trouble, Wanted};
use pyo3::prelude::*;
use std::sync::Arc;

/// Data for the threads.
pub struct Task {
    /// One model for each result, or one model for all results.
    pub models: Vec<Arc<Read>>,
    pub parameters: Vec<Parameter>,
    pub wanted: Wanted,
    pub options: Options,
}

/// Solves all models. The results are in the order of the models.
pub fn run(
    task: &Task,
    count: usize,
    threads: usize,
    progress: Option<&Py<PyAny>>,
) -> PyResult<Vec<Answered>> {
    let solver = || Solver::with_options(task.options.clone());
    crate::threads::map(count, threads, progress, solver, |solver, number| task.row(number, solver))
}

/// The result of one model as a row of the batch, with a message if the model has no result.
pub struct Answered {
    pub row: Row,
    pub message: Option<String>,
}

impl Task {
    /// Solves model `number`. The result does not depend on the thread or on earlier solves of this thread.
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
            Trouble::Failed(error) => remediable(error.clone()).to_string(),
        });
        Answered { row, message }
    }
}
