//! Computes load factors at lift-off and at the loss of equilibrium.

use groundbeam::{
    Error, Load, Model, Options,
    load_factors::{LoadFactors, load_factors_with},
    model::Action,
};
use groundbeam_file::{Combination, Document};

/// The loads that a load factor multiplies.
#[derive(Debug, Clone, PartialEq)]
pub struct Growing {
    /// Names of the load cases that a load factor multiplies; empty if it multiplies all loads.
    pub cases: Vec<String>,
    /// For each load of the combination, in order: whether the load factor multiplies this load.
    grows: Vec<bool>,
}

/// Load factors, with the names of the load cases that they multiply.
#[derive(Debug, Clone, PartialEq)]
pub struct Factors {
    /// The load factors.
    pub found: LoadFactors,
    /// Names of the load cases that the load factors multiply; empty if they multiply all loads.
    pub cases: Vec<String>,
}

impl Growing {
    /// Selects all loads of a combination for multiplication by a load factor.
    pub fn all(combination: &Combination) -> Self {
        Growing { cases: Vec::new(), grows: vec![true; combination.loads.len()] }
    }

    /// Selects the loads of the given load cases of a document for multiplication by a load factor.
    pub fn of_cases(cases: Vec<String>, document: &Document, combination: &Combination) -> Self {
        let grows = combination.loads.iter().map(|&load| document.is_of_case(load, &cases));
        Growing { grows: grows.collect(), cases }
    }

    /// Computes the load factors of a model. The load factors do not change the constants k and μ of the ground.
    pub(crate) fn factors(&self, model: &Model, options: &Options) -> Result<Factors, Error> {
        // If no case is named, all loads on the beam grow, except temperature loads and a camber. Loads on the
        // ground outside the beam keep their values.
        let stays = |load: usize| {
            let stays = |load: &Load| load.is_on_ground() || load.action() == Action::Curvature;
            self.cases.is_empty() && model.loads.get(load).is_some_and(stays)
        };
        let grows = |load: usize| self.grows.get(load).is_some_and(|&grows| grows && !stays(load));
        Ok(Factors { found: load_factors_with(model, options, grows)?, cases: self.cases.clone() })
    }
}
