//! Spring constant k of the ground, from a modulus of the soil or from a plate load test.
//!
//! All formulas are correlations for deep soil. They give k per unit length of beam, which is the subgrade modulus of
//! the source times the width of the beam.

use crate::numeric::elementary::{pow, power};

/// Spring constant of Vesić (1961), *Bending of beams resting on isotropic elastic solid*, for beams of length l with
/// l (k/(4 EI))^(1/4) > 2.25. The moments of shorter beams are approximate. `stiffness` is EI.
pub(crate) fn vesic(soil: &Elastic, width: f64, stiffness: f64) -> f64 {
    0.65 * pow(soil.modulus * power(width, 4) / stiffness, 1.0 / 12.0) * plane(soil)
}

/// Spring constant of Biot (1937), *Bending of an infinite beam on an elastic foundation*. It reproduces the largest
/// moment of an infinite beam under one force. `stiffness` is EI of the beam.
pub(crate) fn biot(soil: &Elastic, width: f64, stiffness: f64) -> f64 {
    let plane = plane(soil);
    0.95 * pow(plane * power(width, 4) / stiffness, 0.108) * plane
}

/// Spring constant of Meyerhof and Baike (1965): k = E/(1 − ν²), with Young's modulus E and Poisson's ratio ν of the
/// soil. It does not depend on the beam.
pub(crate) fn meyerhof_baike(soil: &Elastic) -> f64 {
    plane(soil)
}

/// Spring constant of Selvadurai (1984): k = 0.65 E/(1 − ν²), with Young's modulus E and Poisson's ratio ν of the
/// soil. It does not depend on the beam.
pub(crate) fn selvadurai(soil: &Elastic) -> f64 {
    0.65 * plane(soil)
}

/// Spring constant of Terzaghi (1955), *Evaluation of coefficients of subgrade reaction*, for a beam on stiff clay.
/// Under equal pressure, the settlement is proportional to the width.
pub(crate) fn terzaghi_clay(plate: &PlateTest, width: f64, length: f64) -> f64 {
    let m = (length / width).max(1.0);
    plate.modulus * plate.width * (m + 0.5) / (1.5 * m)
}

/// Spring constant of Terzaghi (1955) for a beam on sand, whose stiffness increases with depth.
pub(crate) fn terzaghi_sand(plate: &PlateTest, width: f64) -> f64 {
    plate.modulus * power((width + plate.width) / (2.0 * width), 2) * width
}

/// E/(1 − ν²).
fn plane(soil: &Elastic) -> f64 {
    soil.modulus / (1.0 - soil.poisson * soil.poisson)
}

/// Deep elastic soil.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Elastic {
    /// Young's modulus \[Pa\].
    pub modulus: f64,
    /// Poisson's ratio.
    pub poisson: f64,
}

/// The result of a load test with a square plate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlateTest {
    /// Subgrade modulus from the load test: the pressure on the plate divided by the settlement of the plate
    /// \[N/m³\].
    pub modulus: f64,
    /// The plate's width \[m\].
    pub width: f64,
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The expected subgrade moduli are from a worksheet (scribd.com/document/680935098). The beam has E = 30620 MPa
    /// and is 3 m wide and 0.5 m high.
    #[test]
    fn a_published_worksheet() {
        let (b, soil) = (3.0, Elastic { modulus: 10e6, poisson: 0.3 });
        let stiffness = 30_620e6 * b * power(0.5, 3) / 12.0;
        for (k, printed) in [
            (vesic(&soil, b, stiffness), 2348.118e3),
            (meyerhof_baike(&soil), 3663.004e3),
            (selvadurai(&soil), 2380.952e3),
        ] {
            assert!((k / b - printed).abs() < 1.0, "{k} {printed}");
        }
    }

    /// A square footing of the size of Terzaghi's plate, one foot, has the subgrade modulus of the plate test.
    #[test]
    fn a_footing_like_the_plate() {
        let plate = PlateTest { modulus: 40e6, width: 0.3 };
        assert!((terzaghi_clay(&plate, 0.3, 0.3) - 40e6 * 0.3).abs() < 1.0);
        assert!((terzaghi_sand(&plate, 0.3) - 40e6 * 0.3).abs() < 1.0);
        // A very wide beam on sand has a quarter of the plate's subgrade modulus. A very long beam on clay has two
        // thirds of the subgrade modulus of a square footing.
        assert!((terzaghi_sand(&plate, 3e6) / 3e6 / 40e6 - 0.25).abs() < 1e-6);
        assert!((terzaghi_clay(&plate, 1.0, 1e6) / 40e6 - 0.2).abs() < 1e-6);
    }
}
