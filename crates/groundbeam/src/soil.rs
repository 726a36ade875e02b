//! Computes the constants k and μ of the ground from soil data.
//!
//! | [`Soil`] | data | results |
//! |---|---|---|
//! | `Vlasov` | layers of elastic soil on rock, and the decay parameter γ of the settlement over the depth | k and μ |
//! | `ModifiedVlasov` | the same layers; γ follows from the solution | k and μ |
//! | `Vesic`, `Biot`, `MeyerhofBaike`, `Selvadurai` | a modulus and Poisson's ratio | k |
//! | `TerzaghiClay`, `TerzaghiSand` | a plate load test | k |
//!
//! The constants k and μ apply to the full width of the beam.
//!
//! ```
//! use groundbeam::soil::{LayeredSoil, Soil, SoilLayer, SoilModel};
//! use groundbeam::{Beam, Foundation, Load, Model, Outcome, solve};
//!
//! let loam = SoilLayer { modulus: 15e6, poisson: 0.3, thickness: 2.0 };
//! let gravel = SoilLayer { modulus: 60e6, poisson: 0.25, thickness: 4.0 };
//! let soil = Soil::ModifiedVlasov(LayeredSoil { layers: vec![loam, gravel] });
//!
//! let beam = Beam::uniform(12.0, 1.2e9);
//! let ground = Foundation::on_soil(SoilModel::new(soil, 1.2), &beam);
//! let model = Model::new(beam, ground).with_load(Load::point_force(1.0, 600e3));
//! let Outcome::Equilibrium(solution) = solve(&model)? else { panic!("it tips") };
//! // The solution's model has the constants that belong to its γ.
//! assert!(solution.soil().unwrap().rounds > 1);
//! assert!(solution.model().foundation.subgrade > model.foundation.subgrade);
//! # Ok::<(), groundbeam::Error>(())
//! ```

pub use crate::model::soil::correlations::{Elastic, PlateTest};
pub use crate::model::soil::{GroundConstants, LayeredSoil, Soil, SoilLayer, SoilModel};
pub use crate::solution::solution::SoilRounds;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Beam, Foundation, GroundEnd, Load, Model};
    use crate::numeric::elementary::pow;
    use crate::outcome::Outcome;
    use crate::solution::solution::Solution;
    use crate::solve::{exists, solve, solve_near};
    use crate::solver::{Answer, Solver};

    fn layers() -> LayeredSoil {
        LayeredSoil { layers: vec![SoilLayer { modulus: 15e6, poisson: 0.3, thickness: 3.0 }] }
    }

    fn on(soil: Soil) -> Model {
        let beam = Beam::uniform(12.0, 1.2e9);
        let ground = Foundation::on_soil(SoilModel::new(soil, 1.2), &beam);
        Model::new(beam, ground).with_load(Load::point_force(5.0, 600e3))
    }

    fn solved(model: &Model) -> Solution {
        let Ok(Outcome::Equilibrium(solution)) = solve(model) else { panic!("it stands") };
        *solution
    }

    #[test]
    fn only_the_modified_model_iterates() {
        let modified = solved(&on(Soil::ModifiedVlasov(layers())));
        let SoilRounds { gamma, rounds } = modified.soil().unwrap();
        let given = solved(&on(Soil::Vlasov(layers(), gamma.unwrap())));
        assert!(rounds > 2 && given.soil().unwrap().rounds == 1);
        let same = |a: f64, b: f64| (a / b - 1.0).abs() < 1e-12;
        let [given, modified] = [given, modified].map(|s| s.model().foundation.clone());
        assert!(
            same(given.subgrade, modified.subgrade)
                && same(given.shear_layer, modified.shear_layer)
        );
        assert!(given.soil.is_none());
    }

    #[test]
    fn k_follows_a_beam_that_changes_later() {
        let soil = || Soil::Vesic(Elastic { modulus: 20e6, poisson: 0.3 });
        let mut model = on(soil());
        model.beam.bending_stiffness *= 16.0;
        let stiffer = solved(&model).model().foundation.subgrade;
        assert!((stiffer / model.foundation.subgrade - pow(16.0, -1.0 / 12.0)).abs() < 1e-12);
    }

    #[test]
    fn every_way_of_solving_uses_the_soil() {
        let model = on(Soil::ModifiedVlasov(layers()));
        let alone = solved(&model);
        let near = solve_near(&model, &crate::Options::default(), Some(&alone));
        let Ok(Outcome::Equilibrium(near)) = near else { panic!("it stands") };
        let mut solver = Solver::new();
        let Ok(Answer::Equilibrium(kept)) = solver.solve(&model) else { panic!("it stands") };
        assert_eq!(kept.model(), alone.model());
        let (near, alone) = (near.model().foundation.subgrade, alone.model().foundation.subgrade);
        assert!((near / alone - 1.0).abs() < 1e-12);
        assert!(exists(&model).unwrap().verdict.stands());
    }

    #[test]
    fn ground_on_soil_must_be_uniform_and_infinite() {
        let mut model = on(Soil::ModifiedVlasov(layers()));
        model.foundation =
            model.foundation.with_ends(GroundEnd::Endless, GroundEnd::Free { at: 13.0 });
        let Err(crate::Error::Invalid(problems)) = solve(&model) else { panic!("it is refused") };
        assert_eq!(problems[0].code, "GB212");
    }
}
