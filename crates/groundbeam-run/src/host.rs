//! The services of the program that runs a file: threads, clock and progress.

use groundbeam::Error;
use std::convert::Infallible;

/// Threads, clock and progress of the program that runs a file. The answers do not depend on them.
pub trait Host: Sync {
    /// Reason for an early stop.
    type Stop;

    /// Results of `work` for 0 to `count`, in this order, on any number of threads.
    ///
    /// # Errors
    ///
    /// If the host stops the work.
    fn map<T: Send>(
        &self,
        count: usize,
        work: impl Fn(usize) -> T + Sync + Send,
    ) -> Result<Vec<T>, Self::Stop>;

    /// Seconds since a fixed moment; NaN without a clock.
    fn seconds(&self) -> f64;

    /// Called when one of [`Run::pieces`](crate::Run::pieces) is done.
    fn done(&self) {}
}

/// A host with one thread, without a clock and without a display of progress.
#[derive(Debug, Clone, Copy, Default)]
pub struct OneThread;

impl Host for OneThread {
    type Stop = Infallible;

    fn map<T: Send>(
        &self,
        count: usize,
        work: impl Fn(usize) -> T + Sync + Send,
    ) -> Result<Vec<T>, Infallible> {
        Ok((0..count).map(work).collect())
    }

    fn seconds(&self) -> f64 {
        f64::NAN
    }
}

/// Reason why a run has no answers.
#[derive(Debug, Clone, PartialEq)]
pub enum Failed<Stop> {
    /// A model was refused.
    Refused(Error),
    /// The host stopped the work.
    Stopped(Stop),
}

impl Failed<Infallible> {
    /// The error of the refused model, if the host never stops the work.
    pub fn refusal(self) -> Error {
        match self {
            Failed::Refused(error) => error,
            Failed::Stopped(never) => match never {},
        }
    }
}

impl<Stop> From<Error> for Failed<Stop> {
    fn from(error: Error) -> Self {
        Failed::Refused(error)
    }
}
