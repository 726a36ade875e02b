//! Writes load factors in the result document.

use super::existence::Motion;
use groundbeam::{
    Model,
    load_factors::{FirstLiftOff, LossOfEquilibrium},
};
use groundbeam_run::Factors;
use serde::Serialize;

#[derive(Serialize)]
pub(super) struct Grown<'a> {
    /// Load cases that the load factor multiplies; empty if the load factor multiplies all loads.
    #[serde(skip_serializing_if = "<[String]>::is_empty")]
    cases: &'a [String],
    first_lift_off: FirstLiftOff,
    loss_of_equilibrium: Loss,
}

#[derive(Serialize)]
struct Loss {
    when: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    factor: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    motion: Option<Motion>,
}

impl<'a> Grown<'a> {
    /// Returns the load factors for the document. Without `model`, the data of a rigid motion omit the
    /// hinges.
    pub fn of(factors: &'a Factors, model: Option<&Model>) -> Self {
        let (when, factor, motion) = match factors.found.loss_of_equilibrium {
            LossOfEquilibrium::AtOnce(motion) => ("at-once", None, Some(motion)),
            LossOfEquilibrium::At { factor, motion } => ("at-factor", Some(factor), Some(motion)),
            LossOfEquilibrium::Never => ("never", None, None),
        };
        let motion = motion.map(|motion| Motion::of(model, motion));
        Grown {
            cases: &factors.cases,
            first_lift_off: factors.found.first_lift_off,
            loss_of_equilibrium: Loss { when, factor, motion },
        }
    }
}
