//! Range limits of balls (intervals stored as midpoint and radius), and exact scaling of doubles by powers of two.

/// Factor for computed radii of balls, so that rounding errors cannot make them too small. It is 1 + 16u with the
/// largest relative rounding error u = 2⁻⁵³, and covers ten operations.
pub(crate) const ABOVE: f64 = 1.0 + 8.0 * f64::EPSILON;
/// Smallest magnitude of a nonzero midpoint of a ball. Smaller midpoints are replaced by 0, because the error bounds do
/// not cover the rounding errors of subnormal numbers.
pub(crate) const TINY: f64 = 1e-290;
/// Largest magnitude of the midpoint and of the radius of a ball. If the midpoint or the radius is larger, the radius
/// becomes infinite, so every overflow causes an infinite radius.
pub(crate) const HUGE: f64 = 1e290;

/// Returns |x|. The result is 0 for −0, and NaN for NaN.
pub(crate) fn magnitude(x: f64) -> f64 {
    x.abs()
}

/// Returns x·2ⁿ, or `None` if its absolute value exceeds [`HUGE`]. The product is exact if its absolute value is
/// at least [`TINY`], the smallest midpoint of a ball.
pub(crate) fn times_power_of_two(x: f64, exponent: i32) -> Option<f64> {
    let scaled = scale(x, exponent);
    if !(magnitude(scaled) <= HUGE) {
        return None;
    }
    // A nonzero result that rounds to zero must stay nonzero.
    Some(if scaled == 0.0 && x != 0.0 { f64::MIN_POSITIVE } else { scaled })
}

/// r·2ⁿ, rounded up.
pub(crate) fn magnitude_scaled(r: f64, exponent: i32) -> f64 {
    if r == 0.0 { 0.0 } else { scale(r, exponent) * ABOVE + f64::MIN_POSITIVE }
}

/// Multiplies x by 2ⁿ in several steps. Each factor is a power of two in the range of doubles.
pub(crate) fn scale(mut x: f64, mut exponent: i32) -> f64 {
    while exponent > 500 && x != 0.0 && magnitude(x) <= HUGE {
        (x, exponent) = (x * power_of_two(500), exponent - 500);
    }
    while exponent < -500 && x != 0.0 {
        (x, exponent) = (x * power_of_two(-500), exponent + 500);
    }
    if x == 0.0 { x } else { x * power_of_two(if exponent > 500 { 1023 } else { exponent }) }
}

/// 2ⁿ for −1022 ≤ n ≤ 1023.
pub(crate) fn power_of_two(exponent: i32) -> f64 {
    f64::from_bits(((1023 + i64::from(exponent)) as u64) << 52)
}
