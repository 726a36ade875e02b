//! Load factors in the result document.

use super::existence::Motion;
use groundbeam::{FirstLiftOff, LossOfEquilibrium, Model, RigidMotion};
use groundbeam_run::Factors;
use serde::Serialize;

const AT_ONCE: &str = "at-once";
const AT_FACTOR: &str = "at-factor";
const NEVER: &str = "never";

#[derive(Serialize)]
pub(super) struct Grown {
    /// Left out: all loads grow.
    #[serde(skip_serializing_if = "Option::is_none")]
    cases: Option<Vec<String>>,
    first_lift_off: LiftOff,
    loss_of_equilibrium: Loss,
}

#[derive(Serialize)]
struct LiftOff {
    when: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    factor: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    x: Option<f64>,
}

#[derive(Serialize)]
struct Loss {
    when: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    factor: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    motion: Option<Motion>,
}

impl Grown {
    /// Without a model, as for one that was not solved, motions say nothing of hinges.
    pub fn of(factors: &Factors, model: Option<&Model>) -> Self {
        let moving = |motion: RigidMotion| Motion::of(model, motion);
        let first_lift_off = match factors.found.first_lift_off {
            FirstLiftOff::AtOnce => LiftOff { when: AT_ONCE, factor: None, x: None },
            FirstLiftOff::At { factor, x } => {
                LiftOff { when: AT_FACTOR, factor: Some(factor), x: Some(x) }
            }
            FirstLiftOff::Never => LiftOff { when: NEVER, factor: None, x: None },
        };
        let loss_of_equilibrium = match factors.found.loss_of_equilibrium {
            LossOfEquilibrium::AtOnce(motion) => {
                Loss { when: AT_ONCE, factor: None, motion: Some(moving(motion)) }
            }
            LossOfEquilibrium::At { factor, motion } => {
                Loss { when: AT_FACTOR, factor: Some(factor), motion: Some(moving(motion)) }
            }
            LossOfEquilibrium::Never => Loss { when: NEVER, factor: None, motion: None },
        };
        let cases = (!factors.cases.is_empty()).then(|| factors.cases.to_vec());
        Grown { cases, first_lift_off, loss_of_equilibrium }
    }
}
