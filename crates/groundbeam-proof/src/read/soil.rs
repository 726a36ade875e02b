//! Reads `[foundation.soil]`: k and μ per length of beam from soil data, by the methods that do not need the solution.
//!
//! For layers on rock (Vlasov and Leontiev), μ = b dS/dr and k = b(S − r dS/dr) with the width b of the beam. S(r) is
//! the least energy of [`least_energy`] for the parameter r.

use super::error::{Read, Reason, fault, out_of_range, wrong};
use super::fields::{
    Fields, LENGTH, MODULUS, NUMBER, POSITIVE_NUMBER, Quantity, SUBGRADE_MODULUS, Section,
};
use crate::Scalar;

const ELASTIC: &[&str] = &["method", "E", "nu"];
const PLATE: &[&str] = &["method", "plate_modulus", "plate_width"];
const LAYERS: &[&str] = &["method", "layer", "gamma"];

/// Properties of the beam on which k depends.
pub(crate) struct Bearing<S> {
    pub width: S,
    pub length: S,
    pub bending_stiffness: S,
}

/// k and μ.
pub(crate) fn read<S: Scalar>(
    fields: &mut Fields,
    table: Section,
    beam: &Bearing<S>,
) -> Read<[S; 2]> {
    let Some((method, at)) = table.words("method")? else { return table.missing("method") };
    let b = beam.width;
    let of = |n: f64, d: f64| S::of(n).div(S::of(d));
    // b⁴/EI
    let beside = (b * b * b * b).div(beam.bending_stiffness);
    let spring = match method {
        "modified-vlasov" => return fault(at, Reason::NotRead("modified-vlasov")),
        "vlasov" => return vlasov(fields, table, b),
        "vesic" => {
            let [modulus, plane] = elastic(fields, table)?;
            let twelfth = power(modulus * beside, of(1.0, 12.0));
            twelfth.map(|twelfth| of(65.0, 100.0) * twelfth * plane)
        }
        "biot" => {
            let [_, plane] = elastic(fields, table)?;
            let part = power(plane * beside, of(108.0, 1000.0));
            part.map(|part| of(95.0, 100.0) * part * plane)
        }
        "meyerhof-baike" => Some(elastic(fields, table)?[1]),
        "selvadurai" => Some(of(65.0, 100.0) * elastic(fields, table)?[1]),
        "terzaghi-clay" => {
            let [modulus, width]: [S; 2] = plate(fields, table)?;
            let slender = beam.length.div(b);
            let slender = if slender.low() >= 1.0 { slender } else { longer(slender) };
            Some(modulus * width * (slender + of(1.0, 2.0)).div(of(3.0, 2.0) * slender))
        }
        "terzaghi-sand" => {
            let [modulus, width]: [S; 2] = plate(fields, table)?;
            Some(modulus * (b + width).div(S::of(2.0) * b).square() * b)
        }
        _ => return wrong(at, format!("the method `{method}` is not known")),
    };
    match spring {
        Some(spring) => Ok([spring, S::zero()]),
        None => out_of_range(at, "k of this soil is out of range"),
    }
}

/// max(x, 1).
fn longer<S: Scalar>(x: S) -> S {
    S::one() + crate::scalar::positive_part(x - S::one())
}

/// E and E/(1 − ν²).
fn elastic<S: Scalar>(fields: &mut Fields, table: Section) -> Read<[S; 2]> {
    table.only(&[ELASTIC], &[])?;
    let [modulus, poisson] = modulus_and_poisson(fields, table)?;
    Ok([modulus, modulus.div(S::one() - poisson.square())])
}

fn modulus_and_poisson<S: Scalar>(fields: &mut Fields, table: Section) -> Read<[S; 2]> {
    let modulus: Quantity<S> = fields.required(table, "E", MODULUS)?;
    let poisson: Quantity<S> = fields.required(table, "nu", NUMBER)?;
    if !(poisson.value.low() >= 0.0 && poisson.value.high() < 0.5) {
        return wrong(poisson.at, "Poisson's ratio of a soil must lie between 0 and 0.5");
    }
    Ok([modulus.value, poisson.value])
}

/// The subgrade modulus of a plate test, and the width of the plate.
fn plate<S: Scalar>(fields: &mut Fields, table: Section) -> Read<[S; 2]> {
    table.only(&[PLATE], &[])?;
    let modulus: Quantity<S> = fields.required(table, "plate_modulus", SUBGRADE_MODULUS)?;
    let width: Quantity<S> = fields.required(table, "plate_width", LENGTH)?;
    Ok([modulus.value, width.value])
}

/// A soil layer with the constrained modulus E₀, the shear modulus G and the thickness h.
struct Layer<S> {
    constrained: S,
    shear: S,
    thickness: S,
}

/// Computes k and μ of soil layers on rock from Vlasov's parameter γ. The parameter of [`least_energy`] is
/// r = (γ/Σh√(G/E₀))², with the thickness h and the moduli G and E₀ of each layer.
fn vlasov<S: Scalar>(fields: &mut Fields, table: Section, width: S) -> Read<[S; 2]> {
    table.only(&[LAYERS], &[])?;
    if table.table.get("layer").is_none() {
        return table.missing("layer");
    }
    let mut layers = Vec::new();
    for layer in table.tables("layer")? {
        layer.only(&[&["E", "nu", "thickness"]], &[])?;
        let [modulus, nu]: [S; 2] = modulus_and_poisson(fields, layer)?;
        let thickness = fields.required::<S>(layer, "thickness", LENGTH)?.value;
        let one = S::one();
        let shear = modulus.div(S::of(2.0) * (one + nu));
        let constrained = modulus * (one - nu).div((one + nu) * (one - S::of(2.0) * nu));
        layers.push(Layer { constrained, shear, thickness });
    }
    let gamma: Quantity<S> = fields.required(table, "gamma", POSITIVE_NUMBER)?;
    let decays = layers.iter().map(|l| l.thickness * l.shear.div(l.constrained).sqrt());
    let Some(decay) = decays.reduce(|a, b| a + b) else { return table.missing("layer") };
    let rate = gamma.value.div(decay).square();
    let [whole, slope] = least_energy(&layers, rate);
    let [spring, shear] = [width * (whole - rate * slope), width * slope];
    if !(spring.low() > 0.0 && shear.low() > 0.0) {
        return out_of_range(gamma.at, "k of this soil is out of range");
    }
    Ok([spring, shear])
}

/// Computes the minimum S of ∫(E₀φ′² + rGφ²) and dS/dr for r = `rate`, with the constrained modulus E₀ and the shear
/// modulus G. The settlement profile φ is 1 at the surface and 0 on the rock.
fn least_energy<S: Scalar>(layers: &[Layer<S>], rate: S) -> [S; 2] {
    let mut below: Option<[S; 2]> = None;
    for layer in layers.iter().rev() {
        let stiffness = layer.constrained.div(layer.thickness);
        let q = layer.thickness.square() * layer.shear.div(layer.constrained);
        let [t, turn] = tanh_over(rate * q);
        let turn = turn * q;
        // With e = E₀/h, c² = rq and T = tanh(c)/c, the layer on the rock has S = e/T. Another layer has
        // S = e(S_b + ec²T)/(e + S_bT), with the value S_b of the layers below it.
        below = Some(match below {
            None => [stiffness.div(t), -(stiffness * turn).div(t.square())],
            Some([under, slope]) => {
                let (above, whole) = (under + stiffness * rate * q * t, stiffness + under * t);
                let above_slope = slope + stiffness * (q * t + rate * q * turn);
                let whole_slope = slope * t + under * turn;
                let ratio = above.div(whole);
                [stiffness * ratio, stiffness * (above_slope - ratio * whole_slope).div(whole)]
            }
        });
    }
    below.unwrap_or([S::zero(); 2])
}

/// Computes T = tanh(c)/c and dT/d(c²) = (1 − c²T² − T)/(2c²) from c².
fn tanh_over<S: Scalar>(square: S) -> [S; 2] {
    let c = square.sqrt();
    let e = (S::of(-2.0) * c).expm1();
    let t = -e.div(c * (S::of(2.0) + e));
    [t, (S::one() - square * t.square() - t).div(S::of(2.0) * square)]
}

/// ln 2 in 62 digits.
const LN_2: &str = "0.69314718055994530941723212145817656807550013436025525412068001";

/// Computes x^a of a positive `x`; `None` if the result is outside the range of doubles.
fn power<S: Scalar>(x: S, a: S) -> Option<S> {
    let ln_2 = S::decimal(LN_2)?;
    let power = a * logarithm(x)?;
    let n = (power.middle() / ln_2.middle()) as i32 + 2;
    let rest = power - S::of(f64::from(n)) * ln_2;
    let raised = (rest.expm1() + S::one()).scaled(n);
    (raised.low() > 0.0 && raised.high().is_finite()).then_some(raised)
}

/// Computes ln x = n ln 2 + v + ln(1 + ε). n is the binary exponent of x, v is a double near ln(2⁻ⁿx), and ε = 2⁻ⁿx
/// e⁻ᵛ − 1. The term ln(1 + ε) differs from ε by at most ε².
fn logarithm<S: Scalar>(x: S) -> Option<S> {
    if !(x.low() > 1e-280 && x.high() < 1e280) {
        return None;
    }
    let n = ((x.middle().to_bits() >> 52) & 0x7ff) as i32 - 1023;
    let fraction = x.scaled(-n);
    let off = |fraction: S, v: f64| fraction * (S::of(-v).expm1() + S::one()) - S::one();
    // From v = 0, Newton's method reaches double precision in six steps. The enclosure below is valid for every v.
    let mut v = 0.0;
    for _ in 0..6 {
        v += off(fraction, v).middle();
    }
    let e = off(fraction, v);
    let size = e.size();
    if !(size < 1e-8) {
        return None;
    }
    let series = e.widened(size * size);
    Some(S::of(f64::from(n)) * S::decimal(LN_2)? + S::of(v) + series)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Wide;

    #[test]
    fn powers_of_known_roots() {
        let close = |found: Wide, known: f64| {
            let off = (found - Wide::of(known)).size() / known;
            assert!(off < 1e-26, "{found:?} {known}: {off:e}");
        };
        for root in [3.0_f64, 0.75, 1.0, 97.0, 0.015625, 3e70, 7e-80] {
            let cube = Wide::of(root) * Wide::of(root) * Wide::of(root);
            close(power(cube, Wide::one().div(Wide::of(3.0))).unwrap(), root);
        }
        assert_eq!(logarithm(Wide::of(1e300)), None);
        assert_eq!(logarithm(Wide::of(-1.0)), None);
    }

    /// Compares with the closed form of Vallabhan and Das (1991) for one layer. A layer that is cut into thinner layers
    /// must have the same k and μ.
    #[test]
    fn layers_agree_with_the_closed_form_of_one_layer() {
        let layer = |thickness: f64| Layer { constrained: 3.0, shear: 1.2, thickness };
        for gamma in [0.3_f64, 0.7, 3.0, 12.0] {
            let rate = (gamma / 2.0).powi(2) * 3.0 / 1.2;
            let (s, c) = (gamma.sinh(), gamma.cosh());
            let k = 3.0 * gamma * (s * c + gamma) / (4.0 * s * s);
            let mu = 1.2 * 2.0 * (s * c - gamma) / (2.0 * gamma * s * s);
            for layers in [vec![layer(2.0)], vec![layer(0.1), layer(1.5), layer(0.4)]] {
                let [whole, slope] = least_energy(&layers, rate);
                assert!(((whole - rate * slope) / k - 1.0).abs() < 1e-10, "{gamma}");
                assert!((slope / mu - 1.0).abs() < 1e-10, "{gamma}");
            }
        }
    }

    #[test]
    fn a_ratio_below_one_counts_as_one() {
        for (x, larger) in [(0.25, 1.0), (1.0, 1.0), (1.5, 1.5), (8.0, 8.0)] {
            assert_eq!(super::longer(x), larger);
        }
    }

    #[test]
    fn the_ratio_of_poisson_of_a_soil_is_below_one_half() {
        for (ratio, right) in
            [("0", true), ("0.49", true), ("0.5", false), ("0.6", false), ("-0.1", false)]
        {
            let soils = [
                format!("method = 'biot'\nE = 1\nnu = {ratio}\n"),
                format!(
                    "method = 'vlasov'\ngamma = 1\nlayer = [{{ thickness = 1, E = 1, nu = {ratio} }}]\n"
                ),
            ];
            for soil in soils {
                let text = format!(
                    "[beam]\nlength = 2\nEI = 3\n[foundation]\nwidth = 1\n[foundation.soil]\n{soil}"
                );
                let found = crate::read::read_model::<Wide>(&text, None);
                assert_eq!(found.is_ok(), right, "{soil}: {found:?}");
            }
        }
    }
}
