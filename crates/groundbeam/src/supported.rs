//! Table that states which features of a model each solution method supports.
//!
//! ```
//! use groundbeam::supported::{Feature, Way, refusal};
//!
//! assert_eq!(refusal(Feature::BeamShear, Way::Exact), None);
//! assert_eq!(refusal(Feature::NoShearLayer, Way::Iteration), Some("GB603"));
//! ```

use crate::error::Error;
use crate::mesh::mesh::Mesh;
use crate::model::refused::{self, Refusal};
use crate::model::{Load, Model, Part, Problem};
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
    /// Ground without a shear layer (μ = 0) somewhere under the beam.
    NoShearLayer,
    /// A beam with shear deformation.
    BeamShear,
    /// Loads on the ground.
    GroundLoads,
    /// Supports.
    Supports,
    /// Hinges.
    Hinges,
    /// Beam stiffness or ground constants that vary along a segment.
    Varying,
}

impl Feature {
    /// All features, in the order of the rows in the table of features and methods. The features are checked in the
    /// same order.
    pub const ALL: [Feature; 7] = [
        Feature::LocalEquilibrium,
        Feature::NoShearLayer,
        Feature::BeamShear,
        Feature::GroundLoads,
        Feature::Supports,
        Feature::Hinges,
        Feature::Varying,
    ];

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
            Feature::NoShearLayer => {
                let forces = Some(&NODAL_FORCES_ON_SPRINGS);
                [yes, yes, forces, forces, yes]
            }
            Feature::BeamShear => {
                let shear = Some(&SHEAR_BY_ANOTHER_METHOD);
                [yes, yes, shear, shear, yes]
            }
            Feature::GroundLoads => {
                let only_exactly = Some(&ONLY_EXACTLY);
                [yes, yes, only_exactly, only_exactly, yes]
            }
            Feature::Supports => [yes, yes, yes, Some(&NODAL_WITH_SUPPORTS), yes],
            Feature::Hinges => {
                [yes, yes, Some(&ITERATION_WITH_HINGES), Some(&NODAL_WITH_HINGES), yes]
            }
            Feature::Varying => [yes, yes, yes, Some(&NODAL_WHERE_IT_VARIES), yes],
        }
    }

    /// Returns the part and the field of a model that have this feature. `is_local` states whether the equilibrium is
    /// only a local minimum.
    fn of(self, model: &Model, is_local: bool) -> Option<(Part, &'static str)> {
        match self {
            Feature::LocalEquilibrium => is_local.then_some((Part::Beam, "axial_force")),
            Feature::NoShearLayer => without_shear_layer(model).map(|part| (part, "shear_layer")),
            Feature::BeamShear => {
                let beam = &model.beam;
                let segment = beam.segments.iter().position(|s| s.shear_stiffness.is_some());
                let segment = segment.filter(|_| beam.shear_stiffness.is_none());
                let part = segment.map_or(Part::Beam, Part::BeamSegment);
                beam.shears().then_some((part, "shear_stiffness"))
            }
            Feature::GroundLoads => {
                let load = model.loads.iter().position(Load::is_on_ground);
                load.map(|load| (Part::Load(load), "at"))
            }
            Feature::Supports => (!model.supports.is_empty()).then_some((Part::Support(0), "at")),
            Feature::Hinges => (!model.hinges.is_empty()).then_some((Part::Hinge(0), "at")),
            Feature::Varying => model.varying_part().map(|part| match part {
                Part::BeamSegment(_) => (part, "bending_stiffness"),
                _ => (part, "subgrade"),
            }),
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

/// Finds a part of the ground under the beam that has no shear layer: the foundation or one of its segments. Returns
/// `None` if there is a shear layer under the whole beam.
fn without_shear_layer(model: &Model) -> Option<Part> {
    let ground = &model.foundation;
    let mesh = Mesh::build(model, &[], |_| 1);
    let cell = mesh.cells.iter().find(|cell| cell.shear_layer == 0.0)?;
    let middle = 0.5 * (cell.x[0] + cell.x[1]);
    let segment = ground.segments.iter().position(|s| s.from <= middle && middle < s.to);
    Some(segment.map_or(Part::Foundation, Part::FoundationSegment))
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
