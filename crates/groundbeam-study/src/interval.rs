//! Computes confidence intervals of a probability from the numbers of events in samples.

use groundbeam_report::{Interval, Way};
use statrs::distribution::{ContinuousCDF, StudentsT};

/// The confidence level of an interval.
const CONFIDENCE: f64 = 0.95;

/// Computes Clopper and Pearson's interval (*Biometrika* 26 (1934)). The lower end belongs to `low` events in `total`
/// samples, and the upper end to `high` events.
pub fn of_counts(low: u64, high: u64, total: u64) -> Interval {
    // At the lower end of the interval, the probability of `low` or more events is (1 − `CONFIDENCE`)/2. At the
    // upper end, the probability of `high` or fewer events has this value.
    let lower = least_odds(low, total).map_or(0.0, |odds| odds / (1.0 + odds));
    let upper = least_odds(total - high, total).map_or(1.0, |odds| 1.0 / (1.0 + odds));
    Interval { bounds: [lower, upper], by: Way::Counts }
}

/// Computes the odds of the lower confidence limit of a probability; `None` for `count` = 0. At this limit, `count` or
/// more events have the probability (1 − `CONFIDENCE`)/2.
///
/// The sums of positive terms are accurate for any numbers. Continued fractions of the beta distribution fail from
/// about 10⁹ samples on.
fn least_odds(count: u64, total: u64) -> Option<f64> {
    if count == 0 {
        return None;
    }
    let wanted = 0.5 * (1.0 - CONFIDENCE);
    // Search interval for ln(x/(1 − x)), where x is the probability of an event. It contains the result for all
    // event counts below 2⁶⁴.
    let [mut below, mut above] = [-60.0_f64, 60.0];
    loop {
        let middle = 0.5 * (below + above);
        if middle <= below || middle >= above {
            return Some(middle.exp());
        }
        if exceeds(count as f64, total as f64, middle.exp(), wanted) {
            above = middle;
        } else {
            below = middle;
        }
    }
}

/// Whether the probability of `count` or more events in `total` samples exceeds `wanted`, which is less than one half.
fn exceeds(count: f64, total: f64, odds: f64, wanted: f64) -> bool {
    if count <= total * (odds / (1.0 + odds)) {
        // A count up to the mean is at most the median (Kaas and Buhrman, *Stat. Neerl.* 34 (1980)). So the probability
        // is at least one half.
        return true;
    }
    let mut term = exactly(count, total, odds);
    let (mut sum, mut j) = (term, count);
    while j < total && term > sum * f64::EPSILON {
        if sum > wanted {
            return true;
        }
        term *= (total - j) / (j + 1.0) * odds;
        sum += term;
        j += 1.0;
    }
    sum > wanted
}

/// Computes the probability of exactly `count` events in `total` samples by Stirling's formula with its remainder
/// (Loader, *Fast and accurate computation of binomial probabilities* (2000)).
fn exactly(count: f64, total: f64, odds: f64) -> f64 {
    let other = total - count;
    let expected = [odds, 1.0].map(|share| total * (share / (1.0 + odds)));
    // `more` is the excess of the count over its mean. It is computed from the rarer outcome, whose rounding
    // error is smaller.
    let more = if odds < 1.0 { count - expected[0] } else { expected[1] - other };
    // Sum of n ln(n/E) over the samples with and without the event, with their number n and the expected number E.
    let distance = count * (more / expected[0]).ln_1p()
        + if other > 0.0 { other * (-more / expected[1]).ln_1p() } else { 0.0 };
    if other == 0.0 {
        return (-distance).exp();
    }
    let beyond = beyond_stirling(total) - beyond_stirling(count) - beyond_stirling(other);
    let scale = total / (std::f64::consts::TAU * count * other);
    scale.sqrt() * (beyond - distance).exp()
}

/// Returns the remainder ln n! − (n + ½) ln n + n − ½ ln 2π of Stirling's formula.
fn beyond_stirling(n: f64) -> f64 {
    if n < 16.0 {
        let factorial: f64 = (2..=n as u64).map(|factor| factor as f64).product();
        return factorial.ln() - (n + 0.5) * n.ln() + n - 0.5 * std::f64::consts::TAU.ln();
    }
    let square = n * n;
    // The coefficients of Stirling's series follow from the Bernoulli numbers. The first omitted term is below
    // 2e-14.
    (1.0 / 12.0 - (1.0 / 360.0 - (1.0 / 1260.0 - 1.0 / 1680.0 / square) / square) / square) / n
}

/// Computes Student's confidence interval of the mean of `values`.
pub fn of_replicates(values: &[f64]) -> [f64; 2] {
    let count = values.len() as f64;
    let mean = values.iter().sum::<f64>() / count;
    let variance = values.iter().map(|value| (value - mean).powi(2)).sum::<f64>() / (count - 1.0);
    let t = StudentsT::new(0.0, 1.0, count - 1.0);
    let t = t.map_or(f64::NAN, |t| t.inverse_cdf(0.5 + 0.5 * CONFIDENCE));
    let half = t * (variance / count).sqrt();
    [mean - half, mean + half]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The first three intervals are from `scipy.stats.binomtest(k, n).proportion_ci()`, the others from mpmath with 30
    /// digits. SciPy 1.17 is wrong in the eighth digit for 1 event in 10⁹ samples.
    #[test]
    fn intervals_of_counts_agree_with_reference_values() {
        for (count, total, low, high) in [
            (0, 20, 0.0, 0.168_433_470_983_085_4),
            (20, 20, 0.831_566_529_016_914_7, 1.0),
            (3, 50, 0.012_548_587_835_334_06, 0.165_481_946_603_772_88),
            (99_999, 1_000_000, 0.099_411_672_482_226_06, 0.100_588_645_577_044_08),
            (123, 10_000_000, 1.022_251_265_659_823e-5, 1.467_562_454_924_002e-5),
            (4_637_211, 10_000_000, 0.463_411_979_848_685_1, 0.464_030_241_156_267_2),
            (9_999_995, 10_000_000, 0.999_998_833_167_181_1, 0.999_999_837_651_341_7),
            (1, 1_000_000_000, 2.531_780_798_396_938e-11, 5.571_643_378_203_115e-9),
            (123_456, 1_000_000_000, 1.227_683_308_530_13e-4, 1.241_465_655_256_875_7e-4),
            (500_000_000, 1_000_000_000, 0.499_969_009_748_422_3, 0.500_030_990_251_577_7),
        ] {
            let Interval { bounds, .. } = of_counts(count, count, total);
            for (bound, expected) in bounds.into_iter().zip([low, high]) {
                assert!(
                    (bound - expected).abs() <= 1e-12 * expected.max(1e-300),
                    "{count} of {total}: {bound:e}, not {expected:e}"
                );
            }
        }
    }

    /// Tests the confidence interval for 0 events in n samples. Its upper end x satisfies
    /// (1 − x)ⁿ = ½ (1 − confidence level). The interval for n events in n samples is its mirror image.
    #[test]
    fn intervals_of_zero_and_of_all_counts_have_their_closed_form() {
        for total in (0..48).map(|power| 1_u64 << power) {
            let none = of_counts(0, 0, total).bounds;
            let all = of_counts(total, total, total).bounds;
            let expected = -(0.025_f64.ln() / total as f64).exp_m1();
            assert!(
                none[0] == 0.0 && (none[1] / expected - 1.0).abs() < 1e-12,
                "{total}: {none:?}"
            );
            assert!(all[1] == 1.0 && (all[0] - (1.0 - expected)).abs() < 1e-15, "{total}: {all:?}");
        }
    }

    /// The 97.5 % quantile of the t distribution with four degrees of freedom is 2.776445.
    #[test]
    fn intervals_of_replicates_use_the_t_distribution() {
        let bounds = of_replicates(&[0.1, 0.2, 0.3, 0.4, 0.5]);
        let half = 2.776_445_105_197_8 * (0.025_f64 / 5.0).sqrt();
        assert!(
            (bounds[0] - (0.3 - half)).abs() < 1e-10 && (bounds[1] - (0.3 + half)).abs() < 1e-10
        );
    }
}
