//! The ground's two constants from what is known of the soil.
//!
//! | [`Soil`] | takes | gives |
//! |---|---|---|
//! | `Vlasov` | layers of elastic soil on rock, and γ | k and μ |
//! | `ModifiedVlasov` | the same layers; γ from the solution | k and μ |
//! | `Vesic`, `Biot`, `MeyerhofBaike`, `Selvadurai` | a modulus and Poisson's ratio | k |
//! | `TerzaghiClay`, `TerzaghiSand` | a plate load test | k |
//!
//! Both constants are per length of *beam*: an area's values times the width on which the beam bears.
//!
//! ```
//! use groundbeam::soil::{Bed, LayeredSoil, Soil, SoilLayer};
//! use groundbeam::{Beam, Foundation, Load, Model, Options, Outcome};
//!
//! let loam = SoilLayer { modulus: 15e6, poisson: 0.3, thickness: 2.0 };
//! let gravel = SoilLayer { modulus: 60e6, poisson: 0.25, thickness: 4.0 };
//! let soil = Soil::ModifiedVlasov(LayeredSoil { layers: vec![loam, gravel] });
//! let bed = Bed::new(soil, 1.2);
//!
//! let model = Model::new(Beam::uniform(12.0, 1.2e9), Foundation::winkler(1.0))
//!     .with_load(Load::point_force(1.0, 600e3));
//! let found = bed.solve(&model, &Options::default())?;
//! let Outcome::Equilibrium(solution) = found.outcome else { panic!("it tips") };
//! assert_eq!(solution.model().foundation.spring, found.subgrade.spring);
//! # Ok::<(), groundbeam::Error>(())
//! ```

use crate::equilibrium::soil;
pub use crate::equilibrium::soil::OnSoil;
use crate::error::Error;
use crate::model::Model;
pub use crate::model::soil::correlations::{Elastic, PlateTest};
pub use crate::model::soil::{Bed, LayeredSoil, Soil, SoilLayer, Subgrade};
use crate::options::Options;
use crate::solve::solve_with;

impl Bed {
    /// Solves a beam on this soil; the model's own foundation is replaced. Without an equilibrium, or where
    /// the ground does not move, γ that would come from the solution is 1.
    ///
    /// # Errors
    ///
    /// As [`solve_with`]; [`Error::NotConverged`] also if γ does not settle.
    pub fn solve(&self, model: &Model, options: &Options) -> Result<OnSoil, Error> {
        soil::solve(self, model, options.method, |model| solve_with(model, options))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Beam, Foundation, Load};

    #[test]
    fn one_round_unless_the_solution_tells_the_rate() {
        let layers = || LayeredSoil {
            layers: vec![SoilLayer { modulus: 15e6, poisson: 0.3, thickness: 3.0 }],
        };
        let model = Model::new(Beam::uniform(12.0, 1.2e9), Foundation::winkler(1.0))
            .with_load(Load::point_force(5.0, 600e3));
        let solved = |soil| Bed::new(soil, 1.2).solve(&model, &Options::default()).unwrap();
        let modified = solved(Soil::ModifiedVlasov(layers()));
        let gamma = modified.gamma.unwrap();
        let given = solved(Soil::Vlasov(layers(), gamma));
        assert!(modified.rounds > 2 && given.rounds == 1);
        let same = |a: f64, b: f64| (a / b - 1.0).abs() < 1e-12;
        assert!(same(given.subgrade.spring, modified.subgrade.spring));
        assert!(same(given.subgrade.shear, modified.subgrade.shear));
    }
}
