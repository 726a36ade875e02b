//! Computes the load factors that a case expects, such as `first_lift_off(Q)` or `loss_of_equilibrium(Q, W)`.

use groundbeam::{
    load_factors,
    load_factors::{FirstLiftOff, LoadFactors, LossOfEquilibrium},
};
use groundbeam_file::{Document, parse_cases};

/// The requested result of a load-factor computation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Growth {
    /// The load factor at which the beam first lifts off.
    FirstLiftOff,
    /// The position at which the beam first lifts off.
    PositionOfLiftOff,
    /// The load factor beyond which no equilibrium exists.
    LossOfEquilibrium,
}

impl Growth {
    /// Returns the load factor, or the position of lift-off, that a name such as `first_lift_off` requests; `None`
    /// for other names.
    pub fn read(name: &str) -> Option<Growth> {
        match name {
            "first_lift_off" => Some(Growth::FirstLiftOff),
            "position_of_lift_off" => Some(Growth::PositionOfLiftOff),
            "loss_of_equilibrium" => Some(Growth::LossOfEquilibrium),
            _ => None,
        }
    }

    /// Returns the requested load factor or position of lift-off, for the load cases in the brackets of `quantity`. The
    /// list is empty if no such value exists.
    pub fn of(self, quantity: &str, document: &Document) -> Result<Vec<f64>, String> {
        let cases = quantity.split_once('(').map_or("", |(_, rest)| rest.trim_end_matches(')'));
        let cases = parse_cases(cases, document).map_err(|f| f.render("#:", cases, false))?;
        let found = load_factors(&document.model, |load| document.is_of_case(load, &cases));
        let LoadFactors { first_lift_off, loss_of_equilibrium } =
            found.map_err(|error| error.to_string())?;
        Ok(match (self, first_lift_off, loss_of_equilibrium) {
            (Growth::LossOfEquilibrium, _, LossOfEquilibrium::At { factor, .. }) => vec![factor],
            (Growth::LossOfEquilibrium, _, LossOfEquilibrium::AtOnce(_)) => vec![0.0],
            (Growth::FirstLiftOff, FirstLiftOff::At { factor, .. }, _) => vec![factor],
            (Growth::FirstLiftOff, FirstLiftOff::AtOnce, _) => vec![0.0],
            (Growth::PositionOfLiftOff, FirstLiftOff::At { x, .. }, _) => vec![x],
            _ => Vec::new(),
        })
    }
}
