//! Errors of a solve: an invalid model, an unsupported model, or an iteration without convergence.

use crate::model::Problem;
use crate::numeric::tolerance;
use crate::options::Method;
use std::fmt;

/// Reason why a solve has no result.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Error {
    /// The model is invalid; every [`Problem`] names a remedy.
    Invalid(Vec<Problem>),
    /// The model is valid but not supported; the problem names the reason.
    Unsupported(Problem),
    /// The model is valid but needs more memory than [`Options::memory_limit`](crate::Options::memory_limit).
    TooLarge(Box<TooLarge>),
    /// The method stopped without an accepted solution.
    NotConverged(Stopped),
    /// The solve was stopped by its [`Cancel`](crate::Cancel).
    Cancelled,
}

/// A model that would need more memory than the limit.
#[derive(Debug, Clone, PartialEq)]
pub struct TooLarge {
    /// The problem as text, with a remedy.
    pub problem: Problem,
    /// Number of elements of the mesh; for the exact method, an upper bound of its number of elements.
    pub elements: usize,
    /// The estimated memory \[bytes\].
    pub needed: u64,
    /// The memory limit \[bytes\].
    pub limit: u64,
}

/// A method that stopped without an accepted solution.
#[derive(Debug, Clone, PartialEq)]
pub struct Stopped {
    /// The method that stopped.
    pub method: Method,
    /// Number of iterations of the method.
    pub iterations: usize,
    /// The reason why the method stopped.
    pub why: NotConverged,
}

/// Reason why a method stopped without an accepted solution. The number in a variant is the last value of a
/// dimensionless quantity that did not fall below its tolerance.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum NotConverged {
    /// The relative residual of the contact condition (5.10) of Kikuchi's paper, after the last sweep of Uzawa's
    /// iteration or of PSOR.
    Sweeps(f64),
    /// The last displacement of a contact edge, as a fraction of the beam's length.
    Edges(f64),
    /// The stiffness matrix of the beam bonded to the ground in trial contact zones is singular. In these zones
    /// the beam is a mechanism.
    Singular,
    /// The set of contact nodes still changes, or the nodal solution of a long beam violates equilibrium or a
    /// sign condition.
    Nodes,
    /// The set of active one-way supports still changes.
    Supports,
    /// The stability margin at which the path of equilibria under compression ended.
    Branch(f64),
    /// The relative energy gap of the certificate for the solution at the load factor of first lift-off.
    LiftOff(f64),
    /// The last relative change of r = ∫u'²/∫u² from one solution to the next, where u is the ground displacement. On
    /// layered soil, k and μ depend on r.
    Soil(f64),
    /// The relative energy gap of the certificate. It is too large because the loads cancel each other up to rounding
    /// errors.
    CancellingLoads(f64),
    /// The relative energy gap of the certificate, which is larger than its tolerance.
    Gap(f64),
}

impl NotConverged {
    /// Description of the quantity that did not reach its tolerance.
    pub fn what(&self) -> &'static str {
        match self {
            NotConverged::Sweeps(_) => {
                "the relative residual of the contact condition (5.10) of Kikuchi (1980)"
            }
            NotConverged::Edges(_) => {
                "the last move of a contact edge relative to the beam's length"
            }
            NotConverged::Singular => {
                "the stiffness matrix of the beam bonded to the ground in the trial contact zones"
            }
            NotConverged::Nodes => "the set of contact nodes",
            NotConverged::Supports => "the set of active one-way supports",
            NotConverged::Branch(_) => "the stability margin at the end of the path of equilibria",
            NotConverged::LiftOff(_) => {
                "the relative energy gap of the certificate at first lift-off"
            }
            NotConverged::Soil(_) => {
                "the relative change of the ratio r = ∫u'²/∫u² of the ground displacement u"
            }
            NotConverged::CancellingLoads(_) => {
                "the relative energy gap of the certificate for loads that cancel to rounding error"
            }
            NotConverged::Gap(_) => "the relative energy gap of the certificate",
        }
    }

    /// Returns the value of the quantity that [`Self::what`] describes. Returns `None` if this quantity has no
    /// value or the value is not finite.
    pub fn reached(&self) -> Option<f64> {
        match *self {
            NotConverged::Singular | NotConverged::Nodes | NotConverged::Supports => None,
            NotConverged::Sweeps(reached)
            | NotConverged::Edges(reached)
            | NotConverged::Branch(reached)
            | NotConverged::LiftOff(reached)
            | NotConverged::Soil(reached)
            | NotConverged::CancellingLoads(reached)
            | NotConverged::Gap(reached) => Some(reached).filter(|reached| reached.is_finite()),
        }
    }

    /// Returns the tolerance of the quantity that [`Self::what`] describes; `None` if this quantity has no
    /// value.
    pub fn tolerance(&self) -> Option<f64> {
        match self {
            NotConverged::Singular | NotConverged::Nodes | NotConverged::Supports => None,
            NotConverged::Sweeps(_) => Some(tolerance::SWEEPS),
            NotConverged::Edges(_) => Some(tolerance::EDGES),
            NotConverged::Branch(_) => Some(tolerance::BRANCH),
            NotConverged::Soil(_) => Some(tolerance::SOIL),
            NotConverged::LiftOff(_) | NotConverged::CancellingLoads(_) | NotConverged::Gap(_) => {
                Some(tolerance::GAP)
            }
        }
    }
}

impl fmt::Display for NotConverged {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NotConverged::Singular => {
                return f.write_str(
                    "the beam bonded to the ground in the trial contact zones is a mechanism",
                );
            }
            NotConverged::Nodes | NotConverged::Supports => {
                return write!(f, "{} did not settle", self.what());
            }
            _ => {}
        }
        match (self.reached(), self.tolerance()) {
            (Some(reached), Some(tolerance)) => {
                write!(f, "{} is {reached:.1e}; the tolerance is {tolerance:.1e}", self.what())
            }
            _ => write!(f, "{} could not be computed", self.what()),
        }
    }
}

impl fmt::Display for Stopped {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Stopped { method, iterations, why } = self;
        let method = method.name();
        write!(f, "the method `{method}` stopped after {iterations} iterations: {why}")
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
            Error::TooLarge(refused) => refused.problem.fmt(f),
            Error::NotConverged(what) => what.fmt(f),
            Error::Cancelled => f.write_str("the solve was cancelled"),
        }
    }
}

impl std::error::Error for Error {}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::problem::Bytes;
    use crate::model::{Beam, Foundation, Model, Part};

    /// Returns every variant of `NotConverged`. Variants with a number contain `figure`.
    fn all(figure: f64) -> Vec<NotConverged> {
        let all = vec![
            NotConverged::Sweeps(figure),
            NotConverged::Edges(figure),
            NotConverged::Singular,
            NotConverged::Nodes,
            NotConverged::Supports,
            NotConverged::Branch(figure),
            NotConverged::LiftOff(figure),
            NotConverged::Soil(figure),
            NotConverged::CancellingLoads(figure),
            NotConverged::Gap(figure),
        ];
        // This match numbers all variants. A new variant needs a number in the match and an entry in the list
        // `all`.
        let number = |why: &NotConverged| match why {
            NotConverged::Sweeps(_) => 0,
            NotConverged::Edges(_) => 1,
            NotConverged::Singular => 2,
            NotConverged::Nodes => 3,
            NotConverged::Supports => 4,
            NotConverged::Branch(_) => 5,
            NotConverged::LiftOff(_) => 6,
            NotConverged::Soil(_) => 7,
            NotConverged::CancellingLoads(_) => 8,
            NotConverged::Gap(_) => 9,
        };
        assert!(all.iter().enumerate().all(|(i, why)| number(why) == i));
        all
    }

    fn written(figure: f64) -> String {
        let stopped =
            |why| Error::NotConverged(Stopped { method: Method::Uzawa, iterations: 7, why });
        all(figure).into_iter().map(|why| format!("{}\n", stopped(why))).collect()
    }

    #[test]
    fn every_end_of_an_iteration_has_its_message() {
        let expected = "\
the method `uzawa` stopped after 7 iterations: the relative residual of the contact condition (5.10) of Kikuchi (1980) is 1.2e-3; the tolerance is 1.0e-11
the method `uzawa` stopped after 7 iterations: the last move of a contact edge relative to the beam's length is 1.2e-3; the tolerance is 1.0e-12
the method `uzawa` stopped after 7 iterations: the beam bonded to the ground in the trial contact zones is a mechanism
the method `uzawa` stopped after 7 iterations: the set of contact nodes did not settle
the method `uzawa` stopped after 7 iterations: the set of active one-way supports did not settle
the method `uzawa` stopped after 7 iterations: the stability margin at the end of the path of equilibria is 1.2e-3; the tolerance is 1.0e-3
the method `uzawa` stopped after 7 iterations: the relative energy gap of the certificate at first lift-off is 1.2e-3; the tolerance is 1.0e-9
the method `uzawa` stopped after 7 iterations: the relative change of the ratio r = ∫u'²/∫u² of the ground displacement u is 1.2e-3; the tolerance is 1.0e-12
the method `uzawa` stopped after 7 iterations: the relative energy gap of the certificate for loads that cancel to rounding error is 1.2e-3; the tolerance is 1.0e-9
the method `uzawa` stopped after 7 iterations: the relative energy gap of the certificate is 1.2e-3; the tolerance is 1.0e-9
";
        assert_eq!(written(1.23e-3), expected);
    }

    #[test]
    fn messages_omit_figures_that_are_not_finite() {
        for figure in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let written = written(figure);
            assert!(!written.contains("NaN") && !written.contains("inf"), "{written}");
            assert_eq!(written.matches("could not be computed").count(), 7, "{written}");
        }
    }

    #[test]
    fn the_other_errors_have_their_messages() {
        let mut model = Model::new(Beam::uniform(f64::NAN, 1.0), Foundation::winkler(-1.0));
        model.beam.bending_stiffness = f64::INFINITY;
        let invalid = Error::Invalid(model.problems()).to_string();
        let expected = "\
[GB101] Beam, length: the beam's length is not a number (it must be positive)
[GB102] Beam, bending_stiffness: the bending stiffness EI is infinite (it must be positive)
[GB201] Foundation, subgrade: the spring constant k is negative (it must be positive)";
        assert_eq!(invalid, expected);
        let too_fine = Error::Unsupported(Problem::too_fine(Part::Beam, 123_456));
        let expected = "\
[GB616] Beam, bending_stiffness: where the beam or the ground varies, or the beam has shear deformation, the shortest \
waves would need 1e5 elements (the bending stiffness is very small compared with the shear layer, the springs or the \
tension: increase it, or give constant stiffnesses and no shear stiffness)";
        assert_eq!(too_fine.to_string(), expected);
        let problem = Problem::too_large("exact", 5, [Bytes(7_000_000_000), Bytes(4_000_000_000)]);
        let refused = TooLarge { problem, elements: 5, needed: 7, limit: 4 };
        let expected = "\
[GB617] Beam, length: the method `exact` would need about 7 GB of memory for 5 elements, more than the limit of 4 GB \
(the beam is very long compared with its waves, or has very many parts: shorten it, or raise the limit, as in \
--memory-limit \"8 GB\")";
        assert_eq!(Error::TooLarge(Box::new(refused)).to_string(), expected);
        assert_eq!(Error::Cancelled.to_string(), "the solve was cancelled");
    }
}
