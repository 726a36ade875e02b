//! Elastic layers on rock as a two-parameter ground, after Vlasov and Leontiev.
//!
//! The soil below a beam of width b moves only vertically, by u(x) φ(z) at the depth z. u is the settlement of the
//! surface. φ is 1 at the surface and 0 on the rock at the depth H. The strain energy per length of beam is
//! ½(k u² + μ u'²) with
//!
//! k = b ∫₀ᴴ E₀ φ'² dz,  μ = b ∫₀ᴴ G φ² dz,
//!
//! the constrained modulus E₀ and the shear modulus G. The energy is stationary if (E₀ φ')' = r G φ with the rate
//! r = ∫u'² dx/∫u² dx.

use crate::numeric::elementary::{cosh, exp, power, sinh, tanh};

/// A layer of elastic soil.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SoilLayer {
    /// Young's modulus E \[Pa\].
    pub modulus: f64,
    /// Poisson's ratio ν, less than one half.
    pub poisson: f64,
    /// Thickness \[m\].
    pub thickness: f64,
}

impl SoilLayer {
    /// Constrained modulus E₀ \[Pa\], the modulus of soil without lateral strain.
    pub fn constrained_modulus(&self) -> f64 {
        let nu = self.poisson;
        self.modulus * (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu))
    }

    /// G \[Pa\].
    pub fn shear_modulus(&self) -> f64 {
        self.modulus / (2.0 * (1.0 + self.poisson))
    }

    /// Thickness of the layer divided by the decay length of the vertical displacement in the layer.
    fn decay(&self, rate: f64) -> f64 {
        (rate * self.shear_modulus() / self.constrained_modulus()).sqrt() * self.thickness
    }
}

/// Layers of elastic soil, the uppermost first, on rigid rock.
#[derive(Debug, Clone, PartialEq)]
pub struct LayeredSoil {
    /// Layers from the surface down. The list has at least one layer.
    pub layers: Vec<SoilLayer>,
}

/// Constants k and μ of a two-parameter ground, per unit length of beam.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GroundConstants {
    /// k \[N/m²\].
    pub subgrade: f64,
    /// μ \[N\].
    pub shear_layer: f64,
}

impl LayeredSoil {
    /// Computes k and μ under a beam of the given width \[m\]. `rate` is ∫u'² dx/∫u² dx \[1/m²\], where u is the
    /// settlement of the ground's surface. For uniform settlement, the rate is 0.
    ///
    /// ```
    /// use groundbeam::soil::{LayeredSoil, SoilLayer};
    ///
    /// let clay = SoilLayer { modulus: 20e6, poisson: 0.25, thickness: 4.0 };
    /// let ground = LayeredSoil { layers: vec![clay] }.subgrade(0.0, 1.5);
    /// assert_eq!(ground.subgrade, 1.5 * 24e6 / 4.0);
    /// assert!((ground.shear_layer - 1.5 * 8e6 * 4.0 / 3.0).abs() < 1e-6);
    /// ```
    pub fn subgrade(&self, rate: f64, width: f64) -> GroundConstants {
        let heights = self.heights(rate);
        let mut ground = GroundConstants { subgrade: 0.0, shear_layer: 0.0 };
        for (layer, ends) in self.layers.iter().zip(heights.windows(2)) {
            let [square, slope] = squares(ends[0], ends[1], layer.decay(rate));
            ground.subgrade += width * layer.constrained_modulus() * slope / layer.thickness;
            ground.shear_layer += width * layer.shear_modulus() * square * layer.thickness;
        }
        ground
    }

    /// Parameter γ of Vallabhan and Das: the sum of the thickness of each layer divided by its decay length of the
    /// vertical displacement. `rate` is ∫u'² dx/∫u² dx \[1/m²\] of the surface settlement u.
    pub fn gamma(&self, rate: f64) -> f64 {
        self.layers.iter().map(|layer| layer.decay(rate)).sum()
    }

    /// The rate r for a given γ.
    pub fn rate(&self, gamma: f64) -> f64 {
        power(gamma / self.gamma(1.0), 2)
    }

    /// Vertical displacement φ at the top of every layer and on the rock, relative to its value at the surface.
    fn heights(&self, rate: f64) -> Vec<f64> {
        // The loop runs from the rock up. For each layer, it computes the stiffness of the soil below the top, and the
        // ratio of φ at the bottom to φ at the top.
        let mut below = f64::INFINITY;
        let mut left: Vec<f64> = Vec::with_capacity(self.layers.len());
        for layer in self.layers.iter().rev() {
            let (part, above) = passed(layer, layer.decay(rate), below);
            left.push(part);
            below = above;
        }
        let mut phi = vec![1.0];
        for part in left.iter().rev() {
            phi.push(phi[phi.len() - 1] * part);
        }
        phi
    }
}

/// Returns the ratio of the displacement φ at the bottom of a layer to φ at the top, and the stiffness −E₀ φ'/φ of the
/// soil below the top. `below` is this stiffness below the bottom of the layer.
fn passed(layer: &SoilLayer, decay: f64, below: f64) -> (f64, f64) {
    let stiffness = layer.constrained_modulus() / layer.thickness;
    if below == f64::INFINITY {
        return (0.0, stiffness / tanh_over(decay));
    }
    // sinh(c)/(c cosh(c)).
    let sinh = tanh_over(decay);
    let whole = stiffness + below * sinh;
    let above = stiffness * (below + stiffness * decay * decay * sinh) / whole;
    (stiffness / (whole * cosh(decay)), above)
}

/// tanh(c)/c.
fn tanh_over(c: f64) -> f64 {
    if c < 1e-4 { 1.0 - c * c / 3.0 } else { tanh(c) / c }
}

/// Computes ∫₀¹ φ² dt and ∫₀¹ (dφ/dt)² dt for the solution of φ'' = c² φ with φ(0) = `top` and φ(1) = `bottom`.
pub(crate) fn squares(top: f64, bottom: f64, c: f64) -> [f64; 2] {
    let (both, product) = (top * top + bottom * bottom, top * bottom);
    if c < 0.5 {
        // For small c, power series avoid the cancellation in sinh c cosh c − c and in c cosh c − sinh c.
        let ratio = if c == 0.0 { 1.0 } else { c / sinh(c) };
        let (own, cross) = (series(2.0 * c, |_| 4.0), series(c, |n| 2.0 * n));
        let square = 0.5 * ratio * ratio * (both * own + 2.0 * product * cross);
        let fall = top - bottom;
        // `even` equals (sinh c cosh c + c − c cosh c − sinh c)/c.
        let even = (own - cross - 2.0 * series(c, |_| 1.0)) * c * c;
        let slope = ratio * ratio * (0.5 * fall * fall * (2.0 + own * c * c) + product * even);
        return [square, slope];
    }
    let d = exp(-c);
    let [coth, per_sinh] = [(1.0 + d * d), 2.0 * d].map(|x| x / (1.0 - d * d));
    let own = [coth - c * per_sinh * per_sinh, coth + c * per_sinh * per_sinh];
    let cross = [(c * coth - 1.0) * per_sinh, (c * coth + 1.0) * per_sinh];
    [
        (both * own[0] + 2.0 * product * cross[0]) / (2.0 * c),
        (both * own[1] - 2.0 * product * cross[1]) * (0.5 * c),
    ]
}

/// Computes the power series Σ weight(n) x^(2n−2)/(2n+1)! over n ≥ 1.
fn series(x: f64, weight: impl Fn(f64) -> f64) -> f64 {
    let mut term = 1.0;
    let mut sum = 0.0;
    for n in 1..12 {
        let n = f64::from(n);
        term /= 2.0 * n * (2.0 * n + 1.0);
        sum += weight(n) * term;
        term *= x * x;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    /// k and μ of one layer of unit width agree with the closed forms of Vallabhan and Das (1991), in which μ is called
    /// 2t. `gamma` is the thickness of the layer divided by the decay length of the displacement.
    #[test]
    fn one_layer_in_closed_form() {
        let layer = SoilLayer { modulus: 3.0, poisson: 0.2, thickness: 2.0 };
        let (e0, g) = (layer.constrained_modulus(), layer.shear_modulus());
        for gamma in [0.3_f64, 0.7, 3.0, 12.0] {
            let rate = gamma * gamma / 4.0 * e0 / g;
            let soil = LayeredSoil { layers: vec![layer] };
            let GroundConstants { subgrade: spring, shear_layer: shear } = soil.subgrade(rate, 1.0);
            let (s, c) = (sinh(gamma), cosh(gamma));
            let k = e0 * gamma * (s * c + gamma) / (4.0 * s * s);
            let two_t = g * 2.0 * (s * c - gamma) / (2.0 * gamma * s * s);
            assert!((spring / k - 1.0).abs() < 1e-13, "{gamma}: {spring} {k}");
            assert!((shear / two_t - 1.0).abs() < 1e-12, "{gamma}: {shear} {two_t}");
            assert!((soil.gamma(rate) / gamma - 1.0).abs() < 1e-14);
        }
    }

    /// One layer that is divided into three layers keeps its k and μ.
    #[test]
    fn divided_layers_are_the_same_soil() {
        let part = |thickness: f64| SoilLayer { modulus: 5.0, poisson: 0.3, thickness };
        let whole = LayeredSoil { layers: vec![part(3.0)] };
        let cut = LayeredSoil { layers: vec![part(0.01), part(2.0), part(0.99)] };
        for rate in [0.0, 1e-9, 0.04, 1.0, 300.0] {
            let (a, b) = (whole.subgrade(rate, 1.0), cut.subgrade(rate, 1.0));
            assert!((a.subgrade / b.subgrade - 1.0).abs() < 1e-13, "{rate}: {a:?} {b:?}");
            assert!((a.shear_layer / b.shear_layer - 1.0).abs() < 1e-12, "{rate}: {a:?} {b:?}");
        }
    }

    /// Under uniform pressure, the layers act like springs in series. `squares` is continuous at c = 0.5, where closed
    /// forms replace the power series.
    #[test]
    fn layers_are_springs_in_series() {
        let layers = [(2.0, 1.0), (7.0, 0.5), (1.0, 3.0)].map(|(modulus, thickness)| SoilLayer {
            modulus,
            poisson: 0.0,
            thickness,
        });
        let soil = LayeredSoil { layers: layers.to_vec() };
        let compliance: f64 = layers.iter().map(|l| l.thickness / l.modulus).sum();
        assert!((soil.subgrade(0.0, 2.0).subgrade * compliance - 2.0).abs() < 1e-14);
        for (top, bottom) in [(1.0, 0.0), (1.0, 0.9), (0.2, 1.0)] {
            let [below, above] = [0.5 - 1e-9, 0.5 + 1e-9].map(|c| squares(top, bottom, c));
            for (a, b) in below.iter().zip(above) {
                assert!((a / b - 1.0).abs() < 1e-8, "{below:?} {above:?}");
            }
        }
    }

    /// Under a beam of unit width, a unit settlement needs the pressure k + rμ with r = `rate`, because the strain
    /// energy equals the work of the load.
    #[test]
    fn the_strain_energy_equals_the_work_of_the_load() {
        let layers = [(2.0, 0.1, 1.0), (70.0, 0.4, 0.5), (1.0, 0.2, 3.0)]
            .map(|(modulus, poisson, thickness)| SoilLayer { modulus, poisson, thickness });
        let soil = LayeredSoil { layers: layers.to_vec() };
        for rate in [1e-6, 0.1, 2.0, 50.0] {
            let GroundConstants { subgrade: spring, shear_layer: shear } = soil.subgrade(rate, 1.0);
            let below = layers
                .iter()
                .rev()
                .fold(f64::INFINITY, |below, layer| passed(layer, layer.decay(rate), below).1);
            assert!(((spring + rate * shear) / below - 1.0).abs() < 1e-13);
        }
    }
}
