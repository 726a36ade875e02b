//! Runs work on threads that end with the call, and that Python can stop.
//!
//! The global pool of `rayon` must not be used here. After a fork, its threads do not exist, so its work never ends.

use crate::failure::Failure;
use groundbeam_run::Host;
use pyo3::prelude::*;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::thread;
use std::time::{Duration, Instant};

/// Interval of time at which signals are checked and the progress is reported.
const BETWEEN_LOOKS: Duration = Duration::from_millis(100);

/// Returns the number of threads: `asked` if positive, else the variable `RAYON_NUM_THREADS`, else one per processor.
pub fn number(asked: usize) -> usize {
    let of_variable = || {
        let variable = std::env::var("RAYON_NUM_THREADS").ok()?;
        variable.parse().ok().filter(|&number: &usize| number > 0)
    };
    match asked {
        0 => {
            of_variable().unwrap_or_else(|| thread::available_parallelism().map_or(1, usize::from))
        }
        asked => asked,
    }
}

/// Calls `work` for all numbers below `count` and returns the results in order. Each thread has its own `state` as
/// workspace. The results must not depend on this state.
pub fn map<S, T: Send>(
    count: usize,
    threads: usize,
    progress: Option<&Py<PyAny>>,
    state: impl Fn() -> S + Sync,
    work: impl Fn(&mut S, usize) -> T + Sync,
) -> PyResult<Vec<T>> {
    let (next, done, stop) = (AtomicUsize::new(0), AtomicUsize::new(0), AtomicBool::new(false));
    let one_thread = || {
        let (mut state, mut found) = (state(), Vec::new());
        while !stop.load(Ordering::Relaxed) {
            let number = next.fetch_add(1, Ordering::Relaxed);
            if number >= count {
                break;
            }
            found.push((number, work(&mut state, number)));
            done.fetch_add(1, Ordering::Relaxed);
        }
        found
    };
    let parts = thread::scope(|scope| {
        let (say, ended) = mpsc::channel();
        for _ in 0..number(threads).min(count) {
            let (say, one_thread) = (say.clone(), &one_thread);
            // If Python has stopped the work, the receiver no longer exists.
            let thread = move || drop(say.send(one_thread()));
            if let Err(error) = thread::Builder::new().spawn_scoped(scope, thread) {
                stop.store(true, Ordering::Relaxed);
                return Err(Failure::Asked(format!("a thread cannot be started: {error}")).into());
            }
        }
        drop(say);
        let mut parts = Vec::new();
        loop {
            match ended.recv_timeout(BETWEEN_LOOKS) {
                Ok(found) => parts.push(found),
                Err(RecvTimeoutError::Disconnected) => return Ok(parts),
                Err(RecvTimeoutError::Timeout) => {
                    if let Err(error) = tell(progress, done.load(Ordering::Relaxed), count) {
                        stop.store(true, Ordering::Relaxed);
                        return Err(error);
                    }
                }
            }
        }
    })?;
    tell(progress, count, count)?;
    let mut all: Vec<(usize, T)> = parts.into_iter().flatten().collect();
    all.sort_unstable_by_key(|(number, _)| *number);
    Ok(all.into_iter().map(|(_, result)| result).collect())
}

/// Lets Python handle signals such as Ctrl-C, and reports the progress.
fn tell(progress: Option<&Py<PyAny>>, done: usize, count: usize) -> PyResult<()> {
    Python::attach(|py| {
        py.check_signals()?;
        if let Some(progress) = progress {
            progress.call1(py, (done, count))?;
        }
        Ok(())
    })
}

/// The number of threads and the start time of one run. Without a number, the work runs on the caller's thread.
pub struct Threads {
    number: Option<usize>,
    started: Instant,
}

impl Threads {
    /// Sets the number of threads; `None` for the caller's thread. If the number is 0, the function [`number()`] determines
    /// the number of threads.
    pub fn new(number: Option<usize>) -> Self {
        Threads { number, started: Instant::now() }
    }
}

impl Host for Threads {
    type Stop = PyErr;

    fn map<T: Send>(
        &self,
        count: usize,
        work: impl Fn(usize) -> T + Sync + Send,
    ) -> PyResult<Vec<T>> {
        match self.number {
            None => Ok((0..count).map(work).collect()),
            Some(threads) => map(count, threads, None, || (), |(), number| work(number)),
        }
    }

    fn seconds(&self) -> f64 {
        self.started.elapsed().as_secs_f64()
    }
}
