//! Interface to the program that runs a model file: threads, clock and display of progress.

use groundbeam::Error;
use std::convert::Infallible;

/// Threads, clock and display of progress of the program that runs a model file. The answers do not depend on
/// the host.
pub trait Host: Sync {
    /// Reason for an early stop.
    type Stop;

    /// Calls `work` for the numbers from 0 to `count - 1` on any threads. Returns the results in this order.
    ///
    /// # Errors
    ///
    /// Returns the reason if the host stops the work.
    fn map<T: Send>(
        &self,
        count: usize,
        work: impl Fn(usize) -> T + Sync + Send,
    ) -> Result<Vec<T>, Self::Stop>;

    /// Seconds since a fixed moment; NaN if the host has no clock.
    fn seconds(&self) -> f64;

    /// Is called after each part of the work. The number of parts is [`Run::pieces`](crate::Run::pieces).
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
    /// Returns the error of the refused model. No other failure is possible, because a host whose `Stop` is
    /// [`Infallible`] never stops the work.
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
