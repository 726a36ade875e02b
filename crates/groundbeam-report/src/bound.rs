//! Formats numbers with error bounds, and computes the bounds of the largest and smallest of several numbers.

use crate::number::{upper, whole, without_trailing_zeros};
use crate::quantity::Unit;

/// Marks a printed number without a proven bound.
pub(crate) fn not_proven(words: &str) -> String {
    format!("{words} (not proven)").trim_start().to_owned()
}

/// Prints an error bound rounded up, as in `2.1e-13`.
pub(crate) fn bound_alone(error: f64) -> String {
    if error.is_finite() { upper(error) } else { not_proven("") }
}

/// An interval that contains an exact number. Its ends are stored as differences from the printed number.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Around {
    low: f64,
    high: f64,
}

impl Around {
    /// Returns an interval that contains the exact number. `value` is the computed number, and `error` its error bound.
    pub fn of(printed: f64, value: f64, error: f64) -> Self {
        let off = value - printed;
        match off {
            0.0 => Around { low: -error, high: error },
            _ => Around {
                low: (off.next_down() - error).next_down(),
                high: (off.next_up() + error).next_up(),
            },
        }
    }

    /// Returns an interval that contains the largest or smallest of several numbers, each given by an interval. Returns
    /// `None` if there are no numbers.
    pub fn extreme(all: impl IntoIterator<Item = Self>, is_max: bool) -> Option<Self> {
        let outer = if is_max { f64::max } else { f64::min };
        let fold =
            |a: Self, b: Self| Around { low: outer(a.low, b.low), high: outer(a.high, b.high) };
        all.into_iter().reduce(fold)
    }

    /// Bound of the distance between the exact and the printed number.
    pub fn error(self) -> f64 {
        self.high.max(-self.low)
    }

    /// Whether all numbers of this interval are more extreme than all numbers of another interval.
    pub fn leads(self, other: Self, is_max: bool) -> bool {
        if is_max { self.low > other.high } else { self.high < other.low }
    }
}

/// Maximum number of significant digits of a double.
const MOST_DIGITS: i32 = 17;

/// Prints a number with its error bound in a unit, as in `14.226133301 ± 1.3e-9 mm`, or marks it as not proven.
///
/// The printed bound includes the rounding of the printed number. The rounding adds at most a twentieth of the error
/// bound if 17 digits are sufficient.
pub(crate) fn with_bound(value: f64, error: f64, unit: Unit) -> String {
    rounded_with_bound(value, error, unit, MOST_DIGITS)
}

/// Prints a number with its error bound, with at most `most` digits of the number.
pub(crate) fn rounded_with_bound(value: f64, error: f64, unit: Unit, most: i32) -> String {
    if !(value.is_finite() && error.is_finite()) {
        return not_proven(&unit.write(value));
    }
    let Some(power) = unit.power_of_ten() else {
        // The unit size and the division are rounded. `rounding` covers up to sixteen relative rounding errors of
        // 2⁻⁵³ each.
        let quotient = value / unit.size;
        let rounding = 8.0 * f64::EPSILON * quotient.abs();
        let converted = if error == 0.0 { 0.0 } else { unit.upper(error) };
        let error = match converted + rounding {
            0.0 => 0.0,
            sum => sum.next_up(),
        };
        return rounded_with_bound(quotient, error, Unit { size: 1.0, ..unit }, most);
    };
    let exact = format!("{value:e}");
    let digits = exact.split('e').next().unwrap_or("").bytes().filter(u8::is_ascii_digit).count();
    let (number, rounding) = match error {
        0.0 if digits as i32 <= most => (shifted(&exact, power), 0.0),
        0.0 => rounded_within(value, i32::MIN / 2, power, most),
        _ => rounded_within(value, exponent(error) - 1, power, most),
    };
    let bound = match error + rounding {
        0.0 => "0".to_owned(),
        sum => shifted(&upper(sum.next_up()), power),
    };
    let unit = if unit.name.is_empty() { String::new() } else { format!(" {}", unit.name) };
    format!("{number} ± {bound}{unit}")
}

/// Rounds `value` to a multiple of 10^`last`, with at most `most` digits. Returns the result divided by 10^`power` as
/// text, and a bound of the rounding error of `value`.
fn rounded_within(value: f64, last: i32, power: i32, most: i32) -> (String, f64) {
    let leading = exponent(value);
    let digits = (leading - last + 1).min(most);
    if value == 0.0 || digits < 1 {
        return ("0".to_owned(), value.abs());
    }
    let number = shifted(&format!("{value:.*e}", digits as usize - 1), power);
    let half: f64 = format!("5.1e{}", leading - digits).parse().unwrap_or(f64::INFINITY);
    (number, half)
}

/// Returns the exponent n of a number a·10ⁿ with 1 ≤ a < 10.
fn exponent(value: f64) -> i32 {
    let written = format!("{value:e}");
    written.split_once('e').and_then(|(_, exponent)| exponent.parse().ok()).unwrap_or(0)
}

/// Divides a decimal such as `1.25e-9` by 10ᵖ without rounding. The digits stay the same.
fn shifted(scientific: &str, power: i32) -> String {
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((scientific, "0"));
    let exponent = exponent.parse::<i32>().unwrap_or(0) - power;
    let mantissa = without_trailing_zeros(mantissa);
    let (sign, mantissa) =
        mantissa.strip_prefix('-').map_or(("", mantissa), |size| ("\u{2212}", size));
    let digits = mantissa.replace('.', "");
    if digits == "0" {
        return digits;
    }
    let count = digits.len() as i32;
    match exponent {
        0..7 if exponent + 1 >= count => {
            format!("{sign}{digits}{}", "0".repeat((exponent + 1 - count) as usize))
        }
        0..7 => {
            let (whole, part) = digits.split_at(exponent as usize + 1);
            format!("{sign}{whole}.{part}")
        }
        -4..0 => format!("{sign}0.{}{digits}", "0".repeat((-exponent - 1) as usize)),
        _ => format!("{sign}{mantissa}e{}", whole(exponent)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_printed_with_their_bounds() {
        let plain = Unit { name: "", size: 1.0, digits: 6 };
        let (mm, kn) =
            (Unit { name: "mm", size: 1e-3, digits: 6 }, Unit { name: "kN", size: 1e3, digits: 6 });
        let cases = [
            (0.811_326_256_449_155, 2.0e-13, plain, "0.81132625644916 ± 2.1e−13"),
            (0.014_226_133_301, 1.21e-12, mm, "14.226133301 ± 1.3e−9 mm"),
            (-412_884.319_872_345, 1e-9, kn, "−412.884319872345 ± 1.1e−12 kN"),
            (3.4e-13, 1e-15, plain, "3.4e−13 ± 1.1e−15"),
            (3.4e-17, 1e-15, plain, "0 ± 1.1e−15"),
            (0.0, 0.0, plain, "0 ± 0"),
            (0.5, 0.0, plain, "0.5 ± 0"),
            (2.0 / 3.0, 1e-30, plain, "0.66666666666666663 ± 5.2e−18"),
            (0.123_4, 0.5, plain, "0.12 ± 0.51"),
            (12.5, f64::INFINITY, kn, "0.0125 kN (not proven)"),
        ];
        let ft = Unit { name: "ft", size: 0.3048, digits: 6 };
        let cases = cases.into_iter().chain([
            (3.048, 0.0, ft, "10 ± 1.9e−14 ft"),
            (0.0, 0.0, ft, "0 ± 0 ft"),
            (3.048, 0.003048, ft, "10 ± 0.011 ft"),
        ]);
        for (value, error, unit, text) in cases {
            assert_eq!(with_bound(value, error, unit), text);
        }
        let short = [
            (0.006_240_320_633, 2e-16, mm, "6.24 ± 0.00052 mm"),
            (1.5, 0.0, mm, "1500 ± 0 mm"),
            (2.0 / 3.0, 0.0, plain, "0.6667 ± 5.2e−5"),
            (2.0 / 3.0, 0.01, plain, "0.667 ± 0.011"),
        ];
        for (value, error, unit, text) in short {
            assert_eq!(rounded_with_bound(value, error, unit, 4), text);
        }
        assert_eq!((bound_alone(1e-9), bound_alone(0.0)), ("1.1e-9".to_owned(), "0".to_owned()));
        assert_eq!(bound_alone(f64::INFINITY), "(not proven)");
    }

    /// The largest of several exact numbers lies between their largest lower bound and their largest upper bound.
    #[test]
    fn the_extreme_of_intervals_lies_between_the_extremes_of_their_ends() {
        let around = |all: &[(f64, f64)], printed: f64, is_max: bool| {
            let all = all.iter().map(|&(value, error)| Around::of(printed, value, error));
            Around::extreme(all, is_max).map(Around::error)
        };
        assert_eq!(around(&[], 0.0, true), None);
        assert_eq!(around(&[(3.0, 0.25), (2.0, 0.5)], 3.0, true), Some(0.25));
        // The upper bound of the second number is 3.5, so the second number may be the largest one.
        let error = around(&[(3.0, 0.25), (2.5, 1.0)], 3.0, true).unwrap();
        assert!(error > 0.5 && error < 0.5 + 1e-15, "{error}");
        let error = around(&[(3.0, 0.25), (3.5, 1.0)], 3.0, false).unwrap();
        assert!(error > 0.5 && error < 0.5 + 1e-15, "{error}");
        assert_eq!(around(&[(3.0, 0.25), (2.0, f64::INFINITY)], 3.0, true), Some(f64::INFINITY));
        // The printed number 3 is smaller than the second number 3.5, so the bound must be at least 0.5.
        assert!(around(&[(3.0, 0.0), (3.5, 0.0)], 3.0, true).unwrap() >= 0.5);
        let [a, b] = [(3.0, 0.25), (2.0, 0.5)].map(|(value, error)| Around::of(3.0, value, error));
        assert!(a.leads(b, true) && !b.leads(a, true) && b.leads(a, false));
        assert!(!a.leads(Around::of(3.0, 2.5, 0.25), true));
    }
}
