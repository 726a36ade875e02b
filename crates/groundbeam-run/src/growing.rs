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
    /// Names of load cases; empty if all loads grow.
    pub cases: Vec<String>,
    /// Whether each load grows, in the order of the combination's loads.
    grows: Vec<bool>,
}

/// Load factors with the names of the load cases that grow.
#[derive(Debug, Clone, PartialEq)]
pub struct Factors {
    /// The load factors.
    pub found: LoadFactors,
    /// The load cases whose loads grow; empty if all loads grow.
    pub cases: Vec<String>,
}

impl Growing {
    /// All loads of a combination grow.
    pub fn all(combination: &Combination) -> Self {
        Growing { cases: Vec::new(), grows: vec![true; combination.loads.len()] }
    }

    /// The loads of some cases of a document grow.
    pub fn of_cases(cases: Vec<String>, document: &Document, combination: &Combination) -> Self {
        let grows = combination.loads.iter().map(|&load| document.is_of_case(load, &cases));
        Growing { grows: grows.collect(), cases }
    }

    /// The load factors for the foundation of the model.
    pub(crate) fn factors(&self, model: &Model, options: &Options) -> Result<Factors, Error> {
        // If no case is named, all loads on the beam grow. Temperature loads, a camber and loads on the
        // ground outside the beam keep their values.
        let stays = |load: usize| {
            let stays = |load: &Load| load.is_on_ground() || load.action() == Action::Curvature;
            self.cases.is_empty() && model.loads.get(load).is_some_and(stays)
        };
        let grows = |load: usize| self.grows.get(load).is_some_and(|&grows| grows && !stays(load));
        Ok(Factors { found: load_factors_with(model, options, grows)?, cases: self.cases.clone() })
    }
}
