//! Table that states which features of a model each solution method supports.
//!
//! ```
//! use groundbeam::supported::{Feature, Way, refusal};
//!
//! assert_eq!(refusal(Feature::OneWaySupports, Way::Exact), None);
//! assert_eq!(refusal(Feature::OneWaySupports, Way::Nodes), Some("GB604"));
//! ```

use crate::error::Error;
use crate::model::refused::{self, Refusal};
use crate::model::soil::SoilModel;
use crate::model::{Model, Part, Problem, Support};
use crate::options::{Method, Options};

/// A solution method.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Way {
    /// The exact method, [`Method::Exact`].
    Exact,
    /// Newton's method on a mesh, [`Method::ActiveSet`].
    ActiveSet,
    /// The iterations on a mesh, [`Method::Psor`] and [`Method::Uzawa`].
    Iteration,
    /// The solver for long beams, [`NodalSolver`](crate::NodalSolver).
    Nodes,
    /// The computation of load factors, [`load_factors`](crate::load_factors()).
    LoadFactors,
}

impl Way {
    /// All solution methods, in the order of the columns in the table of features and methods.
    pub const ALL: [Way; 5] =
        [Way::Exact, Way::ActiveSet, Way::Iteration, Way::Nodes, Way::LoadFactors];

    /// The solution method that the options select.
    pub(crate) fn of(options: &Options) -> Self {
        match options.method {
            Method::Exact => Way::Exact,
            Method::ActiveSet => Way::ActiveSet,
            Method::Psor | Method::Uzawa => Way::Iteration,
        }
    }
}

/// A feature of a model that some solution methods do not support.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Feature {
    /// Compression above the buckling load of the beam without the ground, with a local equilibrium.
    LocalEquilibrium,
    /// Supports that act in one direction only.
    OneWaySupports,
    /// Ground constants that depend on the solution (modified Vlasov model).
    IteratedGround,
}

impl Feature {
    /// All features, in the order of the rows in the table of features and methods. The features are checked in the
    /// same order.
    pub const ALL: [Feature; 3] =
        [Feature::LocalEquilibrium, Feature::OneWaySupports, Feature::IteratedGround];

    /// Row of the table for this feature. For each method in [`Way::ALL`] it contains the error for this feature, or
    /// `None` if the method supports the feature.
    const fn row(self) -> [Option<&'static Refusal>; 5] {
        use refused::*;
        let yes = None;
        match self {
            Feature::LocalEquilibrium => {
                let local = Some(&LOCAL_BY_ANOTHER_METHOD);
                [yes, local, local, local, Some(&FACTORS_OF_A_LOCAL_EQUILIBRIUM)]
            }
            Feature::OneWaySupports => [yes, yes, yes, Some(&NODAL_ON_ONE_WAY_SUPPORTS), yes],
            Feature::IteratedGround => [yes, yes, yes, Some(&NODAL_ON_ITERATED_GROUND), yes],
        }
    }

    /// Returns the part and the field of a model that have this feature. `is_local` states whether the equilibrium is
    /// only a local minimum.
    fn of(self, model: &Model, is_local: bool) -> Option<(Part, &'static str)> {
        match self {
            Feature::LocalEquilibrium => is_local.then_some((Part::Beam, "axial_force")),
            Feature::OneWaySupports => {
                let support = model.supports.iter().position(Support::is_one_way);
                support.map(|support| (Part::Support(support), "acts"))
            }
            Feature::IteratedGround => {
                let soil = model.foundation.soil.as_ref();
                let is_iterated = soil.is_some_and(SoilModel::follows_solution);
                is_iterated.then_some((Part::Foundation, "soil"))
            }
        }
    }
}

/// Returns the code of the error for a feature that this solution method does not support; `None` if the method
/// supports the feature.
pub fn refusal(feature: Feature, way: Way) -> Option<&'static str> {
    feature.row()[way as usize].map(|refusal| refusal.code)
}

/// Returns an error if the model has a feature that the solution method `way` does not support.
pub(crate) fn check(model: &Model, way: Way, is_local: bool) -> Result<(), Error> {
    for feature in Feature::ALL {
        if let Some(refusal) = feature.row()[way as usize]
            && let Some((part, field)) = feature.of(model, is_local)
        {
            return Err(Error::Unsupported(Problem::refused(refusal, part, field)));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The table of features has one column for each solution method. The exact method supports every feature.
    #[test]
    fn the_table_has_a_column_for_each_way_of_solving() {
        for (column, way) in Way::ALL.into_iter().enumerate() {
            assert_eq!(way as usize, column);
        }
        assert!(Feature::ALL.iter().all(|feature| refusal(*feature, Way::Exact).is_none()));
    }
}
