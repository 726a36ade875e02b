//! Reads decimal numbers exactly as written, and multiplies them by the factor of a unit with a single rounding.

use crate::unit::Scale;

/// A decimal number exactly as written: ±digits × 10^exponent.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Decimal {
    negative: bool,
    /// ASCII digits of the number, at least one digit.
    digits: String,
    exponent: i32,
}

impl Decimal {
    /// Reads a number from the start of `text`. Returns the number and its length in bytes.
    ///
    /// Also accepts U+2212 as minus sign, and `_` between digits.
    pub fn read(text: &str) -> Option<(Decimal, usize)> {
        let mut rest = text;
        let negative = ['-', '\u{2212}'].iter().any(|&minus| take(&mut rest, minus));
        if !negative {
            take(&mut rest, '+');
        }
        let mut digits = take_digits(&mut rest);
        let mut exponent = 0_i32;
        if let Some(mut after_point) = rest.strip_prefix('.') {
            let fraction = take_digits(&mut after_point);
            exponent = -i32::try_from(fraction.len()).ok()?;
            digits += &fraction;
            rest = after_point;
        }
        if digits.is_empty() {
            return None;
        }
        if let Some(mut power) = rest.strip_prefix(['e', 'E']) {
            let below = ['-', '\u{2212}'].iter().any(|&minus| take(&mut power, minus));
            if !below {
                take(&mut power, '+');
            }
            let written = take_digits(&mut power);
            if !written.is_empty() {
                // An exponent of more than four digits makes the number infinite or zero.
                let size = written.parse::<i32>().unwrap_or(99_999).min(99_999);
                exponent = exponent.saturating_add(if below { -size } else { size });
                rest = power;
            }
        }
        Some((Decimal { negative, digits, exponent }, text.len() - rest.len()))
    }

    /// Whether every digit is 0.
    pub fn is_zero(&self) -> bool {
        self.digits.bytes().all(|digit| digit == b'0')
    }

    /// Returns the nearest 64-bit number.
    pub fn to_f64(&self) -> f64 {
        self.nearest(&self.digits, self.exponent)
    }

    /// Returns the product of this number and `scale`, rounded once: "9.3 MPa" is exactly 9.3e6.
    ///
    /// Only a product with integers of more than 128 bits is rounded several times.
    pub fn times(&self, scale: &Scale) -> f64 {
        let Some((numerator, denominator)) = scale.fraction() else {
            return self.to_f64() * scale.to_f64();
        };
        let exponent = self.exponent.saturating_add(scale.ten());
        if (numerator, denominator) == (1, 1) {
            return self.nearest(&self.digits, exponent);
        }
        let whole = self.digits.parse::<u128>().ok().and_then(|d| d.checked_mul(numerator));
        match whole {
            Some(whole) if denominator <= u128::MAX / 10 => {
                let (digits, shift) = divide(whole, denominator);
                self.nearest(&digits, exponent.saturating_add(shift))
            }
            _ => self.to_f64() * scale.to_f64(),
        }
    }

    fn nearest(&self, digits: &str, exponent: i32) -> f64 {
        let sign = if self.negative { "-" } else { "" };
        // Rust's parser rounds correctly for any number of digits.
        format!("{sign}{digits}e{exponent}").parse().unwrap_or(f64::NAN)
    }
}

/// Returns the digits and the decimal exponent of the quotient. After 45 digits, a digit 1 replaces the remainder, so
/// that later rounding is correct.
fn divide(whole: u128, denominator: u128) -> (String, i32) {
    let mut digits = (whole / denominator).to_string();
    let mut remainder = whole % denominator;
    let mut exponent = 0;
    while remainder != 0 && digits.trim_start_matches('0').len() < 45 {
        remainder *= 10;
        digits.push(char::from(b'0' + (remainder / denominator) as u8));
        remainder %= denominator;
        exponent -= 1;
    }
    if remainder != 0 {
        digits.push('1');
        exponent -= 1;
    }
    (digits, exponent)
}

fn take(rest: &mut &str, wanted: char) -> bool {
    match rest.strip_prefix(wanted) {
        Some(after) => {
            *rest = after;
            true
        }
        None => false,
    }
}

/// Reads digits that may be separated by single characters `_`.
fn take_digits(rest: &mut &str) -> String {
    let mut digits = String::new();
    loop {
        let after = if digits.is_empty() { *rest } else { rest.strip_prefix('_').unwrap_or(rest) };
        let Some(digit) = after.chars().next().filter(char::is_ascii_digit) else {
            return digits;
        };
        digits.push(digit);
        *rest = &after[1..];
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(text: &str) -> Option<(f64, usize)> {
        Decimal::read(text).map(|(decimal, length)| (decimal.to_f64(), length))
    }

    #[test]
    fn common_notations_of_numbers_are_read() {
        assert_eq!(value("12"), Some((12.0, 2)));
        assert_eq!(value("+1.25e-3 m"), Some((0.00125, 8)));
        assert_eq!(value("-.5"), Some((-0.5, 3)));
        assert_eq!(value("5. m"), Some((5.0, 2)));
        assert_eq!(value("1_000_000"), Some((1e6, 9)));
        assert_eq!(value("\u{2212}3"), Some((-3.0, 4)));
        assert_eq!(value("1e\u{2212}3"), Some((1e-3, 6)));
        assert_eq!(value("3 EI"), Some((3.0, 1)));
        assert_eq!(value("3em"), Some((3.0, 1)), "no exponent without digits");
        assert_eq!(value("1e999999999999"), Some((f64::INFINITY, 14)));
        assert_eq!(value("1__0"), Some((1.0, 1)));
        for nothing in ["", ".", "-", "e5", "m", "_1", "+-1"] {
            assert_eq!(value(nothing), None, "{nothing:?}");
        }
    }

    #[test]
    fn the_sign_of_zero_is_kept() {
        let (zero, _) = Decimal::read("-0.0").unwrap();
        assert!(zero.is_zero());
        assert!(zero.to_f64().is_sign_negative());
    }

    #[test]
    fn long_division_rounds_correctly() {
        assert_eq!(divide(1, 8), ("0125".to_owned(), -3));
        for (whole, denominator) in
            [(1_u128, 3_u128), (2, 7), (12_345, 64_516), (1, u128::MAX / 10)]
        {
            let (digits, exponent) = divide(whole, denominator);
            let nearest: f64 = format!("{digits}e{exponent}").parse().unwrap();
            // Converting `u128::MAX / 10` to f64 adds a relative error of 2^-53. All other operands are exact in f64.
            let quotient = whole as f64 / denominator as f64;
            assert!((nearest - quotient).abs() <= f64::EPSILON * quotient);
        }
    }
}
