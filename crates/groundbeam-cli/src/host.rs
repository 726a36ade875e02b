//! Provides threads, a clock and a progress display for a run.

use crate::failure::Failure;
use crate::input::Input;
use crate::waiting::while_working;
use groundbeam::Error;
use groundbeam_run::{Answers, Asked, Failed, Host, Run};
use rayon::prelude::*;
use std::convert::Infallible;
use std::time::Instant;

/// Host of a run that uses all processors.
pub struct Threads<'a> {
    started: Instant,
    done: &'a (dyn Fn() + Sync),
}

impl<'a> Threads<'a> {
    /// Creates a host that calls `done` after each piece of work.
    pub fn new(done: &'a (dyn Fn() + Sync)) -> Self {
        Threads { started: Instant::now(), done }
    }
}

impl Host for Threads<'_> {
    type Stop = Infallible;

    fn map<T: Send>(
        &self,
        count: usize,
        work: impl Fn(usize) -> T + Sync + Send,
    ) -> Result<Vec<T>, Infallible> {
        Ok(match count {
            1 => vec![work(0)],
            count => (0..count).into_par_iter().map(work).collect(),
        })
    }

    fn seconds(&self) -> f64 {
        self.started.elapsed().as_secs_f64()
    }

    fn done(&self) {
        (self.done)();
    }
}

/// Solves the models of a run and shows progress. Returns the results and the run time \[s\].
pub fn solved(run: &Run, input: &Input, method: &str) -> Result<(Answers, f64), Failure> {
    let started = Instant::now();
    let words = match run.asked() {
        Asked::One | Asked::Methods => format!("solving with the method {method}"),
        Asked::Combinations => format!("solving combinations with the method {method}"),
        Asked::Trains => format!("solving train positions with the method {method}"),
    };
    let answers = while_working(words, run.pieces(), |done| run.solve(&Threads::new(done)));
    let answers = answers.map_err(Failed::refusal).map_err(|error: Error| input.refused(&error))?;
    Ok((answers, started.elapsed().as_secs_f64()))
}
