//! Errors of a solve: an invalid model, an unsupported one, an iteration without convergence.

use crate::model::Problem;
use crate::options::Method;
use std::fmt;

/// Why there is no answer.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Error {
    /// The model is wrong; every [`Problem`] says what would be right.
    Invalid(Vec<Problem>),
    /// The model is right but lies outside what is solved; the problem says why.
    Unsupported(Problem),
    /// The method did not reach its own tolerance.
    NotConverged(NotConverged),
}

/// A method that did not reach its tolerance, and what it reached.
#[derive(Debug, Clone, PartialEq)]
pub struct NotConverged {
    /// The method.
    pub method: Method,
    /// Steps taken.
    pub iterations: usize,
    /// What was asked for and what was reached, both relative.
    pub tolerance: f64,
    /// See `tolerance`.
    pub reached: f64,
    /// What was not reached, in words.
    pub what: &'static str,
}

impl fmt::Display for NotConverged {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "the method `{}` stopped after {} iterations: {} is {:.1e}, above its tolerance {:.1e}",
            self.method.name(),
            self.iterations,
            self.what,
            self.reached,
            self.tolerance
        )
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Error::Invalid(problems) => {
                for (i, problem) in problems.iter().enumerate() {
                    if i > 0 {
                        writeln!(f)?;
                    }
                    write!(f, "{problem}")?;
                }
                Ok(())
            }
            Error::Unsupported(problem) => problem.fmt(f),
            Error::NotConverged(what) => what.fmt(f),
        }
    }
}

impl std::error::Error for Error {}
