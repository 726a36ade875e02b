//! The factor of a unit: a fraction of integers times a power of ten.

/// Factor `numerator / denominator × 10^ten` of a unit. It is exact as long as the integers fit into 128 bits.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Scale {
    /// Numerator and denominator of the factor without its power of ten; `None` if one of them exceeds 128 bits.
    fraction: Option<(u128, u128)>,
    ten: i32,
    approximate: f64,
}

impl Scale {
    pub const ONE: Scale = Scale { fraction: Some((1, 1)), ten: 0, approximate: 1.0 };

    /// Returns the factor `numerator / denominator × 10^ten`. Numerator and denominator must not be zero.
    pub fn new(numerator: u64, denominator: u64, ten: i32) -> Self {
        let approximate = numerator as f64 / denominator as f64 * 10_f64.powi(ten);
        Scale { fraction: Some((numerator.into(), denominator.into())), ten, approximate }
    }

    /// Multiplies this factor by a power of `other`.
    pub fn times(self, other: Scale, power: i32) -> Self {
        let mut fraction = self.fraction;
        for _ in 0..power.unsigned_abs() {
            fraction = fraction.zip(other.fraction).and_then(|(mine, its)| {
                if power > 0 { multiply(mine, its) } else { multiply(mine, (its.1, its.0)) }
            });
        }
        Scale {
            fraction,
            ten: self.ten.saturating_add(other.ten.saturating_mul(power)),
            approximate: self.approximate * other.approximate.powi(power),
        }
    }

    /// Returns the numerator and the denominator; `None` if the factor is not stored exactly.
    pub fn fraction(&self) -> Option<(u128, u128)> {
        self.fraction
    }

    /// Returns the exponent of the power of ten that multiplies the fraction.
    pub fn ten(&self) -> i32 {
        self.ten
    }

    /// Returns the factor as a double, accurate to a few units in the last place.
    pub fn to_f64(self) -> f64 {
        self.approximate
    }
}

/// Multiplies two fractions and reduces the product, so that lbf/lbf is exactly 1.
fn multiply(a: (u128, u128), b: (u128, u128)) -> Option<(u128, u128)> {
    let (left, right) = (common_divisor(a.0, b.1), common_divisor(b.0, a.1));
    let numerator = (a.0 / left).checked_mul(b.0 / right)?;
    let denominator = (a.1 / right).checked_mul(b.1 / left)?;
    Some((numerator, denominator))
}

fn common_divisor(mut a: u128, mut b: u128) -> u128 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_factors_cancel_exactly() {
        let inch = Scale::new(254, 1, -4);
        let squared = Scale::ONE.times(inch, 3).times(inch, -1);
        assert_eq!(squared.fraction(), Some((64_516, 1)));
        assert_eq!(squared.ten(), -8);
        assert_eq!(squared.times(inch, -2).fraction(), Some((1, 1)));
    }

    #[test]
    fn factors_that_overflow_integers_are_floating_point_numbers() {
        let pound = Scale::new(44_482_216_152_605, 1, -13);
        let power = Scale::ONE.times(pound, 12);
        assert_eq!(power.fraction(), None);
        assert!((power.to_f64() / 4.448_221_615_260_5_f64.powi(12) - 1.0).abs() < 1e-13);
    }
}
