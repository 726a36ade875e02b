//! The work itself, on threads of its own, while Python waits for it and may stop it.

use super::parameter::{Parameter, apply};
use crate::failure::{Failure, Tipping};
use crate::model::Read;
use groundbeam::{Options, Solver};
use groundbeam_study::{Row, Trouble, Wanted};
use pyo3::prelude::*;
use rayon::prelude::*;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::mpsc;
use std::time::Duration;

/// Everything that the threads need to know.
pub struct Task {
    /// One for each answer, or one for all.
    pub models: Vec<Arc<Read>>,
    pub parameters: Vec<Parameter>,
    pub wanted: Wanted,
    pub options: Options,
}

/// How often Python is asked whether to stop, and told how far it is.
const BETWEEN_LOOKS: Duration = Duration::from_millis(100);

/// Solves every model in its place; `threads` of 0 are as many as there are processors.
pub fn run(
    task: &Task,
    count: usize,
    threads: usize,
    progress: Option<Py<PyAny>>,
) -> PyResult<Vec<Answered>> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    let pool = pool.map_err(|error| Failure::Asked(error.to_string()))?;
    let (done, stop) = (AtomicUsize::new(0), AtomicBool::new(false));
    let (say_ready, ready) = mpsc::channel();
    std::thread::scope(|scope| {
        let (done, stop) = (&done, &stop);
        let work = move || {
            let each = (0..count).into_par_iter().map_init(Solver::new, |solver, number| {
                let row = (!stop.load(Ordering::Relaxed)).then(|| task.row(number, solver));
                done.fetch_add(1, Ordering::Relaxed);
                row
            });
            let rows: Option<Vec<Answered>> = pool.install(|| each.collect());
            // Nobody listens any more if Python has stopped.
            let _ = say_ready.send(rows);
        };
        scope.spawn(work);
        loop {
            match ready.recv_timeout(BETWEEN_LOOKS) {
                Ok(Some(rows)) => break tell(&progress, count, count).map(|()| rows),
                Ok(None) | Err(mpsc::RecvTimeoutError::Disconnected) => {
                    break Err(Failure::Asked("the work was stopped".to_owned()).into());
                }
                Err(mpsc::RecvTimeoutError::Timeout) => {
                    let so_far = done.load(Ordering::Relaxed);
                    if let Err(error) = tell(&progress, so_far, count) {
                        stop.store(true, Ordering::Relaxed);
                        break Err(error);
                    }
                }
            }
        }
    })
}

/// Lets Python handle what was pressed, and tells it how far the work is.
fn tell(progress: &Option<Py<PyAny>>, done: usize, count: usize) -> PyResult<()> {
    Python::attach(|py| {
        py.check_signals()?;
        if let Some(progress) = progress {
            progress.call1(py, (done, count))?;
        }
        Ok(())
    })
}

/// An answer, and in words why there is none.
pub struct Answered {
    pub row: Row,
    pub message: Option<String>,
}

impl Task {
    /// The answer of a number, the same whatever thread it is on and whatever that has solved before.
    fn row(&self, number: usize, solver: &mut Solver) -> Answered {
        let Task { models, parameters, wanted, options } = self;
        let read = &models[if models.len() == 1 { 0 } else { number }];
        let mut model = read.document.model.clone();
        apply(parameters, number, &mut model);
        let row = Row::solve(&model, &read.document, options, wanted, solver);
        let message = row.trouble.as_deref().map(|trouble| match trouble {
            Trouble::NoEquilibrium(existence) => {
                Tipping::of(&model, existence, read.units()).sentence
            }
            Trouble::Failed(error) => error.to_string(),
        });
        Answered { row, message }
    }
}
