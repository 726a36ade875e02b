//! Constants k and μ of the ground, from soil data.

pub(crate) mod correlations;
pub(crate) mod layers;

use crate::model::Beam;
use crate::model::soil::correlations as winkler;
use crate::model::soil::correlations::{Elastic, PlateTest};
use crate::numeric::elementary::pow;
pub use layers::{GroundConstants, LayeredSoil, SoilLayer};

/// Soil data, with the method that computes the ground's constants.
#[derive(Debug, Clone, PartialEq)]
pub enum Soil {
    /// Method of Vlasov and Leontiev (1966) for layers on rock, with a given decay parameter γ of the settlement over
    /// the depth.
    Vlasov(LayeredSoil, f64),
    /// Method of Vallabhan and Das (1991) for layers on rock. The decay parameter γ of the settlement over the depth
    /// follows from the solution.
    ModifiedVlasov(LayeredSoil),
    /// Correlation of Vesić (1961).
    Vesic(Elastic),
    /// Correlation of Biot (1937).
    Biot(Elastic),
    /// Correlation of Meyerhof and Baike (1965).
    MeyerhofBaike(Elastic),
    /// Correlation of Selvadurai (1984).
    Selvadurai(Elastic),
    /// Correlation of Terzaghi (1955) for stiff clay.
    TerzaghiClay(PlateTest),
    /// Correlation of Terzaghi (1955) for sand.
    TerzaghiSand(PlateTest),
}

/// Soil under a beam that bears on a given width. k and μ follow from these data.
#[derive(Debug, Clone, PartialEq)]
pub struct SoilModel {
    /// The soil.
    pub soil: Soil,
    /// Width of the contact area between beam and soil \[m\].
    pub width: f64,
    /// Factors on k and μ, for uncertain soil; `[1, 1]` leaves the values of the method unchanged.
    pub factors: [f64; 2],
}

/// Limit of βl for a beam of length l, with β = (k/(4 EI))^(1/4). Below this limit, a beam is too short for
/// correlations that were derived for long beams.
const LONG: f64 = 2.25;
/// Poisson's ratio above which the constrained modulus depends much more on Poisson's ratio than on Young's modulus.
const NEARLY_INCOMPRESSIBLE: f64 = 0.45;

impl SoilModel {
    /// Creates the data of the soil under a beam. `width` \[m\] is the width of the contact area between beam and
    /// soil.
    pub fn new(soil: Soil, width: f64) -> Self {
        SoilModel { soil, width, factors: [1.0; 2] }
    }

    /// Computes k and μ under a beam before the solve. For [`Soil::ModifiedVlasov`], the decay parameter γ = 1 is
    /// assumed.
    pub fn subgrade(&self, beam: &Beam) -> GroundConstants {
        let (width, length, stiffness) = (self.width, beam.length, beam.bending_stiffness);
        let springs = |spring: f64| GroundConstants { subgrade: spring, shear_layer: 0.0 };
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

    /// Decay parameter γ before the solve: the given value of [`Soil::Vlasov`], or 1 for [`Soil::ModifiedVlasov`].
    /// `None` for soil data without layers.
    pub fn gamma(&self) -> Option<f64> {
        match &self.soil {
            Soil::Vlasov(_, gamma) => Some(*gamma),
            Soil::ModifiedVlasov(layers) => Some(layers.gamma(layers.rate(1.0))),
            _ => None,
        }
    }

    /// Whether k and μ depend on the solution.
    pub fn follows_solution(&self) -> bool {
        matches!(self.soil, Soil::ModifiedVlasov(_))
    }

    /// The author and year of the method.
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

    /// Warnings about the range of validity of the method. Each is a sentence without a full stop.
    pub fn doubts(&self, beam: &Beam) -> Vec<String> {
        let mut doubts = Vec::new();
        let spring = self.subgrade(beam).subgrade;
        let waves = beam.length * pow(0.25 * spring / beam.bending_stiffness, 0.25);
        match &self.soil {
            Soil::Vesic(_) | Soil::Biot(_) if waves < LONG => doubts.push(format!(
                "{}: this method is valid for long beams with βl > {LONG}, but the beam has βl = {waves:.2}",
                self.source()
            )),
            Soil::TerzaghiClay(plate) | Soil::TerzaghiSand(plate) if self.width < plate.width => {
                doubts.push(format!(
                    "{}: this method is valid for beams wider than the plate of the load test, but the beam is narrower",
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
                "Vlasov's model overestimates k of soil with a Poisson's ratio of {NEARLY_INCOMPRESSIBLE} or more: \
                 it has no horizontal displacements, so k tends to infinity as the ratio tends to 0.5"
            ));
        }
        doubts
    }
}

impl GroundConstants {
    /// Returns the constants with k multiplied by the first factor and μ multiplied by the second factor.
    pub fn times(self, [spring, shear]: [f64; 2]) -> Self {
        GroundConstants { subgrade: self.subgrade * spring, shear_layer: self.shear_layer * shear }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn short_beams_and_wide_plates_give_warnings() {
        let beam = |stiffness| Beam::uniform(5.0, stiffness);
        let on = |soil| SoilModel::new(soil, 1.0);
        let vesic = || on(Soil::Vesic(Elastic { modulus: 20e6, poisson: 0.3 }));
        assert!(vesic().doubts(&beam(1e6)).is_empty());
        assert!(vesic().doubts(&beam(1e9))[0].contains("βl = 1.1"));
        let plate = |width| on(Soil::TerzaghiSand(PlateTest { modulus: 1e7, width }));
        assert!(
            plate(0.3).doubts(&beam(1.0)).is_empty() && !plate(1.5).doubts(&beam(1.0)).is_empty()
        );
    }
}
