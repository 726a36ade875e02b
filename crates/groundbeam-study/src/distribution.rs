//! Transforms a standard normal variate to a variate of another distribution with the same cumulative probability.

use groundbeam_file::study::Distribution;
use statrs::distribution::{ContinuousCDF, Normal};
use std::f64::consts::PI;

/// Euler's constant γ, the mean of the standard Gumbel distribution.
const EULER: f64 = 0.577_215_664_901_532_9;

/// Quantile Φ⁻¹(u) of the standard normal distribution for 0 < u < 1.
pub fn normal_of(u: f64) -> f64 {
    Normal::standard().inverse_cdf(u)
}

/// Cumulative probability Φ(z) of the standard normal distribution.
fn probability(z: f64) -> f64 {
    Normal::standard().cdf(z)
}

/// Variance ln(1 + (σ/m)²) of the logarithm of a lognormal variate with mean m and standard deviation σ.
pub fn log_variance(mean: f64, deviation: f64) -> f64 {
    (deviation / mean).powi(2).ln_1p()
}

/// The lognormal variate with the same cumulative probability as the standard normal variate `z`.
pub fn lognormal(mean: f64, deviation: f64, z: f64) -> f64 {
    let variance = log_variance(mean, deviation);
    mean * (variance.sqrt() * z - 0.5 * variance).exp()
}

/// The variate whose cumulative probability in `distribution` equals the cumulative probability of the variate
/// `z` in the standard normal distribution.
pub fn of_normal(distribution: &Distribution, z: f64) -> f64 {
    match *distribution {
        Distribution::Normal { mean, deviation } => mean + deviation * z,
        Distribution::Lognormal { mean, deviation } => lognormal(mean, deviation, z),
        Distribution::Gumbel { mean, deviation } => {
            // Solves exp(−exp(−(x − mode)/scale)) = Φ(z) for x, with the standard normal distribution Φ. For z ≥ 0, ln
            // Φ(z) is computed as ln(1 − Φ(−z)), which avoids cancellation.
            let scale = deviation * 6.0_f64.sqrt() / PI;
            let exponent = if z < 0.0 { -probability(z).ln() } else { -(-probability(-z)).ln_1p() };
            mean - scale * (EULER + exponent.ln())
        }
        Distribution::Uniform { from, to } => {
            // The variate is computed from its distance to the nearer end of the interval, which avoids cancellation.
            let width = to - from;
            if z < 0.0 { from + width * probability(z) } else { to - width * probability(-z) }
        }
        Distribution::Triangular { from, mode, to } => {
            let width = to - from;
            let below = (mode - from) / width;
            if probability(z) < below {
                from + (probability(z) * width * (mode - from)).sqrt()
            } else {
                to - (probability(-z) * width * (to - mode)).sqrt()
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The reference values are from `scipy.special.ndtri`, SciPy 1.17.
    #[test]
    fn quantiles_of_the_normal_distribution_agree_with_reference_values() {
        for (u, z) in [
            (1e-300, -37.047_096_299_361_2),
            (1e-12, -7.034_483_825_301_132),
            (0.025, -1.959_963_984_540_054_5),
            (0.5, 0.0),
            (0.84, 0.994_457_883_209_753_1),
        ] {
            assert!((normal_of(u) - z).abs() <= 4e-14 * z.abs().max(1.0), "{u}: {}", normal_of(u));
        }
    }

    /// Tests mean and standard deviation of every distribution. The error of the trapezoidal rule is below rounding
    /// error for smooth functions times exp(−z²/2).
    #[test]
    fn every_distribution_has_the_given_mean_and_deviation() {
        let step = 0.01;
        let moments = |distribution: &Distribution| {
            let mut sums = [0.0; 3];
            for i in -900..=900 {
                let z = step * f64::from(i);
                let weight = step * (-0.5 * z * z).exp() / (2.0 * PI).sqrt();
                let x = of_normal(distribution, z);
                for (power, sum) in sums.iter_mut().enumerate() {
                    *sum += weight * x.powi(power as i32);
                }
            }
            [sums[1], (sums[2] - sums[1] * sums[1]).sqrt()]
        };
        let (mean, deviation) = (3.0, 0.6);
        for (distribution, [m, s], close) in [
            (Distribution::Normal { mean, deviation }, [mean, deviation], 1e-12),
            (Distribution::Lognormal { mean, deviation }, [mean, deviation], 1e-12),
            (Distribution::Gumbel { mean, deviation }, [mean, deviation], 1e-9),
            (Distribution::Uniform { from: 1.0, to: 4.0 }, [2.5, 3.0 / 12.0_f64.sqrt()], 1e-9),
            // The density of the triangular distribution has a kink at the mode, so the trapezoidal rule has only
            // second order.
            (
                Distribution::Triangular { from: 1.0, mode: 2.0, to: 4.0 },
                [7.0 / 3.0, (7.0_f64 / 18.0).sqrt()],
                1e-5,
            ),
        ] {
            let [mean, deviation] = moments(&distribution);
            assert!((mean - m).abs() < close && (deviation - s).abs() < close, "{distribution:?}");
        }
    }

    #[test]
    fn transformed_normal_numbers_keep_their_order() {
        let all = [
            Distribution::Gumbel { mean: -1.0, deviation: 0.2 },
            Distribution::Uniform { from: -1.0, to: 1.0 },
            Distribution::Triangular { from: 0.0, mode: 0.0, to: 1.0 },
            Distribution::Triangular { from: 0.0, mode: 1.0, to: 1.0 },
        ];
        for distribution in all {
            let values: Vec<f64> =
                (-80..=80).map(|i| of_normal(&distribution, 0.1 * f64::from(i))).collect();
            assert!(values.is_sorted() && values.iter().all(|x| x.is_finite()), "{distribution:?}");
        }
    }
}
