//! Gauss–Legendre quadrature on \[−1, 1\].

/// Positive points and weights of the rule with 12 points, exact up to degree 23. Its error is at rounding level in
/// this crate.
const GAUSS_12: [(f64, f64); 6] = [
    (0.125_233_408_511_468_9, 0.249_147_045_813_402_78),
    (0.367_831_498_998_180_2, 0.233_492_536_538_354_82),
    (0.587_317_954_286_617_4, 0.203_167_426_723_065_92),
    (0.769_902_674_194_304_7, 0.160_078_328_543_346_22),
    (0.904_117_256_370_474_9, 0.106_939_325_995_318_43),
    (0.981_560_634_246_719_2, 0.047_175_336_386_511_83),
];

/// Points and weights.
pub(crate) fn gauss() -> impl Iterator<Item = (f64, f64)> {
    GAUSS_12.iter().flat_map(|&(s, w)| [(-s, w), (s, w)])
}

#[cfg(test)]
mod tests {
    use super::gauss;
    use crate::numeric::elementary::power;

    #[test]
    fn powers_up_to_degree_23_are_integrated_exactly() {
        for degree in 0..=23 {
            let sum: f64 = gauss().map(|(s, weight)| weight * power(s, degree)).sum();
            let exact = if degree % 2 == 0 { 2.0 / (degree + 1) as f64 } else { 0.0 };
            assert!((sum - exact).abs() < 1e-15, "{degree}: {sum}");
        }
    }
}
