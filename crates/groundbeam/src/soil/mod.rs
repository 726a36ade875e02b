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
//!     .with_load(Load::point(600e3, 1.0));
//! let found = bed.solve(&model, &Options::default())?;
//! let Outcome::Equilibrium(solution) = found.outcome else { panic!("it tips") };
//! assert_eq!(solution.model().foundation.spring, found.subgrade.spring);
//! # Ok::<(), groundbeam::Error>(())
//! ```

mod layers;
mod modified;
mod winkler;

use crate::model::{Beam, Foundation, Model};
use crate::solve::{Error, Options, Outcome, solve_with};
pub use layers::{LayeredSoil, SoilLayer, Subgrade};

/// What is known of the soil, and by whose method it becomes a ground.
#[derive(Debug, Clone, PartialEq)]
pub enum Soil {
    /// Vlasov and Leontiev (1966): layers on rock, and γ.
    Vlasov(LayeredSoil, f64),
    /// Vallabhan and Das (1991): layers on rock, with γ from the solution.
    ModifiedVlasov(LayeredSoil),
    /// Vesić (1961).
    Vesic(Elastic),
    /// Biot (1937).
    Biot(Elastic),
    /// Meyerhof and Baike (1965).
    MeyerhofBaike(Elastic),
    /// Selvadurai (1984).
    Selvadurai(Elastic),
    /// Terzaghi (1955), stiff clay.
    TerzaghiClay(PlateTest),
    /// Terzaghi (1955), sand.
    TerzaghiSand(PlateTest),
}

/// Deep elastic soil.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Elastic {
    /// Young's modulus \[Pa\].
    pub modulus: f64,
    /// Poisson's ratio.
    pub poisson: f64,
}

/// What a square plate on the soil showed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlateTest {
    /// Pressure over settlement \[N/m³\].
    pub modulus: f64,
    /// The plate's width \[m\].
    pub width: f64,
}

/// Soil under a beam that bears on a width of it.
#[derive(Debug, Clone, PartialEq)]
pub struct Bed {
    /// The soil.
    pub soil: Soil,
    /// The width on which the beam bears \[m\].
    pub width: f64,
    /// What k and μ are multiplied by: `[1, 1]` as the method gives them, other numbers for soil that is not
    /// well known.
    pub factors: [f64; 2],
}

/// An answer on soil.
#[derive(Debug, Clone)]
pub struct OnSoil {
    /// What mechanics says, for the ground below.
    pub outcome: Outcome,
    /// k and μ of the ground that was solved.
    pub subgrade: Subgrade,
    /// γ, for layers.
    pub gamma: Option<f64>,
    /// Solutions it took: one, unless γ is taken from the solution.
    pub rounds: usize,
}

/// βl below which a beam is too short for the correlations that were made for long ones.
const LONG: f64 = 2.25;
/// From this Poisson's ratio on, E₀ tells more of ν than of the soil.
const NEARLY_INCOMPRESSIBLE: f64 = 0.45;

impl Bed {
    /// Soil under a beam that bears on a `width` \[m\] of it.
    pub fn new(soil: Soil, width: f64) -> Self {
        Bed { soil, width, factors: [1.0; 2] }
    }

    /// k and μ under a beam, before anything is solved: for [`Soil::ModifiedVlasov`] those of γ = 1.
    pub fn subgrade(&self, beam: &Beam) -> Subgrade {
        let (width, length, stiffness) = (self.width, beam.length, beam.bending_stiffness);
        let springs = |spring: f64| Subgrade { spring, shear: 0.0 };
        let ground = match &self.soil {
            Soil::Vlasov(layers, gamma) => layers.subgrade(layers.rate(*gamma), width),
            Soil::ModifiedVlasov(layers) => layers.subgrade(layers.rate(1.0), width),
            Soil::Vesic(soil) => springs(winkler::vesic(soil, width, stiffness)),
            Soil::Biot(soil) => springs(winkler::biot(soil, width, stiffness)),
            Soil::MeyerhofBaike(soil) => springs(winkler::meyerhof_baike(soil)),
            Soil::Selvadurai(soil) => springs(winkler::selvadurai(soil)),
            Soil::TerzaghiClay(plate) => springs(winkler::terzaghi_clay(plate, width, length)),
            Soil::TerzaghiSand(plate) => springs(winkler::terzaghi_sand(plate, width)),
        };
        ground.times(self.factors)
    }

    /// Solves a beam on this soil; the model's own foundation is replaced. Without an equilibrium, or where
    /// the ground does not move, γ that would come from the solution is 1.
    ///
    /// # Errors
    ///
    /// As [`solve_with`]; [`Error::NotConverged`] also if γ does not settle.
    pub fn solve(&self, model: &Model, options: &Options) -> Result<OnSoil, Error> {
        if let Soil::ModifiedVlasov(layers) = &self.soil {
            return modified::solve(model, layers, self, options);
        }
        let subgrade = self.subgrade(&model.beam);
        let gamma = match self.soil {
            Soil::Vlasov(_, gamma) => Some(gamma),
            _ => None,
        };
        let outcome = solve_with(&subgrade.under(model), options)?;
        Ok(OnSoil { outcome, subgrade, gamma, rounds: 1 })
    }

    /// Who published the method.
    pub fn source(&self) -> &'static str {
        match self.soil {
            Soil::Vlasov(..) => "Vlasov and Leontiev (1966)",
            Soil::ModifiedVlasov(_) => "Vallabhan and Das (1991), modified Vlasov",
            Soil::Vesic(_) => "Vesić (1961)",
            Soil::Biot(_) => "Biot (1937)",
            Soil::MeyerhofBaike(_) => "Meyerhof and Baike (1965)",
            Soil::Selvadurai(_) => "Selvadurai (1984)",
            Soil::TerzaghiClay(_) => "Terzaghi (1955), stiff clay",
            Soil::TerzaghiSand(_) => "Terzaghi (1955), sand",
        }
    }

    /// Where the method is used outside the range it was made for: a sentence each, without a full stop.
    pub fn doubts(&self, beam: &Beam) -> Vec<String> {
        let mut doubts = Vec::new();
        let spring = self.subgrade(beam).spring;
        let waves = beam.length * (0.25 * spring / beam.bending_stiffness).powf(0.25);
        match &self.soil {
            Soil::Vesic(_) | Soil::Biot(_) if waves < LONG => doubts.push(format!(
                "{} is made for long beams, βl > {LONG}, and this one has βl = {waves:.2}",
                self.source()
            )),
            Soil::TerzaghiClay(plate) | Soil::TerzaghiSand(plate) if self.width < plate.width => {
                doubts.push(format!(
                    "{} goes from a plate to a wider beam, and this one is narrower",
                    self.source()
                ));
            }
            _ => {}
        }
        let nearly = |layers: &LayeredSoil| {
            layers.layers.iter().any(|layer| layer.poisson >= NEARLY_INCOMPRESSIBLE)
        };
        if matches!(&self.soil, Soil::Vlasov(layers, _) | Soil::ModifiedVlasov(layers) if nearly(layers))
        {
            doubts.push(format!(
                "soil with a Poisson's ratio of {NEARLY_INCOMPRESSIBLE} or more hardly gives way downwards \
                 alone, as Vlasov's model has it: k grows without end as the ratio nears 0.5"
            ));
        }
        doubts
    }
}

impl Subgrade {
    /// The same with k and μ multiplied.
    pub fn times(self, [spring, shear]: [f64; 2]) -> Self {
        Subgrade { spring: self.spring * spring, shear: self.shear * shear }
    }

    /// The model on this ground.
    pub fn under(&self, model: &Model) -> Model {
        let mut model = model.clone();
        model.foundation = Foundation::pasternak(self.spring, self.shear);
        model
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Load;

    #[test]
    fn short_beams_and_wide_plates_are_doubted() {
        let beam = |stiffness| Beam::uniform(5.0, stiffness);
        let bed = |soil| Bed::new(soil, 1.0);
        let vesic = || bed(Soil::Vesic(Elastic { modulus: 20e6, poisson: 0.3 }));
        assert!(vesic().doubts(&beam(1e6)).is_empty());
        assert!(vesic().doubts(&beam(1e9))[0].contains("βl = 1.1"));
        let plate = |width| bed(Soil::TerzaghiSand(PlateTest { modulus: 1e7, width }));
        assert!(
            plate(0.3).doubts(&beam(1.0)).is_empty() && !plate(1.5).doubts(&beam(1.0)).is_empty()
        );
    }

    #[test]
    fn one_round_unless_the_solution_tells_the_rate() {
        let layers = || LayeredSoil {
            layers: vec![SoilLayer { modulus: 15e6, poisson: 0.3, thickness: 3.0 }],
        };
        let model = Model::new(Beam::uniform(12.0, 1.2e9), Foundation::winkler(1.0))
            .with_load(Load::point(600e3, 5.0));
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
