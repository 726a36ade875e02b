//! Computes the point of sample i in the unit cube from the seed and i only.

mod latin;
mod sobol;

use groundbeam_file::study::{Plan, Sampling};
use rand_chacha::ChaCha8Rng;
use rand_core::{Rng, SeedableRng};
use sobol::Sobol;

/// The points of a plan.
#[derive(Debug, Clone)]
pub struct Points {
    plan: Plan,
    sobol: Option<Sobol>,
}

impl Points {
    /// The points of a plan in this number of dimensions.
    pub fn new(plan: Plan, dimensions: usize) -> Self {
        let sobol = (plan.sampling == Sampling::Sobol).then(|| Sobol::new(dimensions));
        Points { plan, sobol }
    }

    /// Writes the point of a sample. Every coordinate lies strictly between 0 and 1.
    pub fn fill(&self, sample: u64, point: &mut [f64]) {
        let Plan { samples, seed, replicates, .. } = self.plan;
        let mut random = generator(seed, sample);
        let each = (samples / replicates).max(1);
        let (replicate, index) = (sample / each, sample % each);
        for (dimension, coordinate) in point.iter_mut().enumerate() {
            let uniform = inside(random.next_u64());
            let key = mixed(mixed(seed ^ mixed(replicate)) ^ dimension as u64);
            *coordinate = match (&self.sobol, self.plan.sampling) {
                (_, Sampling::LatinHypercube) => latin::coordinate(index, each, key, uniform),
                (Some(sobol), _) => sobol.coordinate(dimension, index, key, uniform),
                _ => uniform,
            };
        }
    }
}

/// Creates the generator of the random numbers of one sample. Each pair of seed and sample has its own stream.
fn generator(seed: u64, sample: u64) -> ChaCha8Rng {
    let mut key = [0; 32];
    key[..8].copy_from_slice(&seed.to_le_bytes());
    let mut random = ChaCha8Rng::from_seed(key);
    random.set_stream(sample);
    random
}

/// Returns the middle of one of 2⁵³ equal parts of (0, 1). The middle of the last part must not round to 1.
fn inside(bits: u64) -> f64 {
    const PART: f64 = 1.0 / (1_u64 << 53) as f64;
    (((bits >> 11) as f64 + 0.5) * PART).min(1.0 - PART)
}

/// A hash in which each bit depends on all bits of `number` (Steele, Lea and Flood 2014, with Stafford's
/// constants).
fn mixed(number: u64) -> u64 {
    let mut z = number.wrapping_add(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plan(sampling: Sampling, samples: u64, replicates: u64) -> Plan {
        Plan { samples, seed: 11, sampling, replicates }
    }

    fn all(plan: Plan, dimensions: usize) -> Vec<Vec<f64>> {
        let points = Points::new(plan, dimensions);
        let point = |sample| {
            let mut point = vec![0.0; dimensions];
            points.fill(sample, &mut point);
            point
        };
        (0..plan.samples).map(point).collect()
    }

    /// Whether each of the n equal parts of every dimension contains exactly one of the n points.
    fn is_a_hypercube(points: &[Vec<f64>]) -> bool {
        let n = points.len();
        (0..points[0].len()).all(|dimension| {
            let mut parts: Vec<usize> =
                points.iter().map(|point| (point[dimension] * n as f64) as usize).collect();
            parts.sort_unstable();
            parts.into_iter().eq(0..n)
        })
    }

    #[test]
    fn latin_hypercubes_and_sobol_nets_have_one_point_in_every_stratum() {
        for replicate in all(plan(Sampling::LatinHypercube, 3000, 3), 7).chunks(1000) {
            assert!(is_a_hypercube(replicate));
        }
        for replicate in all(plan(Sampling::Sobol, 4096, 4), 7).chunks(1024) {
            assert!(is_a_hypercube(replicate));
        }
    }

    /// Tests that scrambling preserves the net property: for every j from 0 to 10, each box of 2ʲ equal columns and
    /// 2¹⁰⁻ʲ equal rows of the unit square contains one point.
    #[test]
    fn scrambled_sobol_points_are_still_a_net() {
        let points = all(plan(Sampling::Sobol, 1024, 1), 2);
        for wide in 0..=10 {
            let (columns, rows) = (1 << wide, 1 << (10 - wide));
            let mut boxes: Vec<usize> = points
                .iter()
                .map(|p| {
                    (p[0] * f64::from(columns)) as usize * rows as usize
                        + (p[1] * f64::from(rows)) as usize
                })
                .collect();
            boxes.sort_unstable();
            assert!(boxes.into_iter().eq(0..1024), "{columns} by {rows}");
        }
    }

    #[test]
    fn different_replicates_and_seeds_have_different_points() {
        for sampling in [Sampling::MonteCarlo, Sampling::LatinHypercube, Sampling::Sobol] {
            let points =
                all(plan(sampling, 64, if sampling == Sampling::MonteCarlo { 1 } else { 2 }), 3);
            assert!(points[..32].iter().zip(&points[32..]).all(|(a, b)| a[0] != b[0]));
            let other = all(Plan { seed: 12, ..plan(sampling, 64, 1) }, 3);
            assert!(points.iter().zip(&other).all(|(a, b)| a[1] != b[1]));
        }
    }

    /// Tests the mean of exp(Σ (uᵢ − ½)) over the unit cube of 6 dimensions. The scatter of the replicates estimates
    /// the error of this mean. Evenly spread points reduce the error.
    #[test]
    fn the_scatter_of_replicates_estimates_the_error_of_an_integral() {
        let exact = (2.0 * 0.5_f64.sinh()).powi(6);
        let error = |sampling| {
            let n = 1024;
            let points = all(
                plan(sampling, 16 * n, if sampling == Sampling::MonteCarlo { 1 } else { 16 }),
                6,
            );
            let means: Vec<f64> = points
                .chunks(n as usize)
                .map(|part| {
                    let value = |p: &Vec<f64>| p.iter().map(|u| u - 0.5).sum::<f64>().exp();
                    part.iter().map(value).sum::<f64>() / n as f64
                })
                .collect();
            let mean = means.iter().sum::<f64>() / 16.0;
            let variance = means.iter().map(|m| (m - mean).powi(2)).sum::<f64>() / (15.0 * 16.0);
            // A normal variable exceeds five standard errors about once in two million cases.
            assert!((mean - exact).abs() < 5.0 * variance.sqrt(), "{sampling:?}: {mean} {exact}");
            variance.sqrt()
        };
        let [plain, latin, sobol] =
            [Sampling::MonteCarlo, Sampling::LatinHypercube, Sampling::Sobol].map(error);
        assert!(latin < 0.5 * plain && sobol < 0.2 * latin, "{plain} {latin} {sobol}");
    }
}
