//! Formats numbers with a given number of significant digits and with the true minus sign.

/// Formats a number with `digits` significant digits and without trailing zeros. Very large and very small
/// numbers are written with an exponent.
pub fn significant(value: f64, digits: usize) -> String {
    if value.is_nan() || value == 0.0 {
        return if value == 0.0 { "0" } else { "nan" }.to_owned();
    }
    if value < 0.0 {
        return format!("{MINUS}{}", significant(-value, digits));
    }
    if value.is_infinite() {
        return "inf".to_owned();
    }
    let digits = digits.max(1);
    // The number is rounded before its exponent is determined: 9.9999 with three digits becomes 10.
    let scientific = format!("{value:.*e}", digits - 1);
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    // The value is replaced by the rounded value: 12346 with four digits becomes 12350.
    let value: f64 = scientific.parse().unwrap_or(value);
    if (-4..7).contains(&exponent) {
        let decimals = (digits as i32 - 1 - exponent).max(0) as usize;
        without_trailing_zeros(&format!("{value:.decimals$}")).to_owned()
    } else {
        format!("{}e{}", without_trailing_zeros(mantissa), whole(exponent))
    }
}

/// The true minus sign, U+2212.
pub const MINUS: char = '\u{2212}';

/// Formats an integer with the true minus sign.
pub fn whole(value: i32) -> String {
    value.to_string().replace('-', "\u{2212}")
}

/// Formats a number with one significant digit, an exponent and the true minus sign, such as `3e−13`.
pub fn order(value: f64) -> String {
    if value == 0.0 { "0".to_owned() } else { format!("{value:.0e}").replace('-', "\u{2212}") }
}

/// Formats an upper bound, rounded up to two significant digits, with the true minus sign: 1.64e-14 becomes
/// `1.7e−14`.
pub fn above(bound: f64) -> String {
    upper(bound).replace('-', "\u{2212}")
}

/// Formats an upper bound, rounded up to two significant digits, with the ASCII minus sign that programs
/// read.
pub fn upper(bound: f64) -> String {
    if bound == 0.0 || !bound.is_finite() {
        return significant(bound, 2);
    }
    let nearest = format!("{bound:.1e}");
    if nearest.parse().is_ok_and(|shown: f64| shown > bound) {
        return nearest;
    }
    // The next number with two significant digits is larger by 0.1 × 10^exponent.
    let exponent = nearest.split_once('e').map_or("0", |(_, exponent)| exponent);
    let step: f64 = format!("0.1e{exponent}").parse().unwrap_or(f64::INFINITY);
    format!("{:.1e}", bound + step)
}

/// Removes the trailing zeros after the decimal point.
pub fn without_trailing_zeros(text: &str) -> &str {
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { text }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn significant_digits() {
        let cases = [
            (0.0, "0"),
            (-0.0, "0"),
            (1.0, "1"),
            (0.811326256449155, "0.811326"),
            (-1234.5678, "−1234.57"),
            (999999.96, "1000000"),
            (1234567.8, "1234570"),
            (12345678.9, "1.23457e7"),
            (9.9999999e-5, "0.0001"),
            (1.25e-9, "1.25e−9"),
            (-1.5e300, "−1.5e300"),
            (f64::INFINITY, "inf"),
        ];
        for (value, text) in cases {
            assert_eq!(significant(value, 6), text);
        }
        assert_eq!(order(3.2e-13), "3e−13");
    }

    #[test]
    fn bounds_are_rounded_up() {
        let cases = [
            (1.64e-14, "1.7e−14"),
            (1.61e-14, "1.7e−14"),
            (9.99e-3, "1.0e−2"),
            (9.91e300, "1.0e301"),
            (2.0, "2.1e0"),
            (0.0, "0"),
            (f64::INFINITY, "inf"),
        ];
        for (bound, text) in cases {
            assert_eq!(above(bound), text);
        }
        for i in 1..1000 {
            let bound = f64::from(i) * 0.001_234_5;
            let shown: f64 = upper(bound).parse().unwrap();
            assert!(shown > bound && shown <= 1.11 * bound, "{bound} {shown}");
        }
    }
}
