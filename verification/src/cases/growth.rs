//! Load factors as quantities that a case expects: `first_lift_off(Q)`, `loss_of_equilibrium(Q, W)`.

use groundbeam::{FirstLiftOff, LoadFactors, LossOfEquilibrium, load_factors};
use groundbeam_file::{Document, parse_cases};

/// Which of them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Growth {
    /// The factor of first lift-off.
    FirstLiftOff,
    /// Where the beam then leaves the ground.
    PositionOfLiftOff,
    /// The factor beyond which there is no equilibrium.
    LossOfEquilibrium,
}

impl Growth {
    /// `first_lift_off` and its like.
    pub fn read(name: &str) -> Option<Growth> {
        match name {
            "first_lift_off" => Some(Growth::FirstLiftOff),
            "position_of_lift_off" => Some(Growth::PositionOfLiftOff),
            "loss_of_equilibrium" => Some(Growth::LossOfEquilibrium),
            _ => None,
        }
    }

    /// The number for the loads of the cases named in the brackets of `quantity`; none if the loads can grow
    /// for ever.
    pub fn of(self, quantity: &str, document: &Document) -> Result<Vec<f64>, String> {
        let cases = quantity.split_once('(').map_or("", |(_, rest)| rest.trim_end_matches(')'));
        let grows = parse_cases(cases, document).map_err(|f| f.render("#:", cases, false))?;
        let found = load_factors(&document.model, |load| grows.get(load) == Some(&true));
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
