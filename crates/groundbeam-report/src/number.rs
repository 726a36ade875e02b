//! Numbers in print.

/// A number with so many significant digits, without trailing zeros; very large and very small ones with
/// an exponent.
pub(crate) fn significant(value: f64, digits: usize) -> String {
    if !value.is_finite() {
        return if value.is_nan() {
            "nan"
        } else if value > 0.0 {
            "inf"
        } else {
            "-inf"
        }
        .to_owned();
    }
    if value == 0.0 {
        return "0".to_owned();
    }
    let digits = digits.max(1);
    // Rounding first: 9.9999 with three digits has the exponent of 10.
    let scientific = format!("{value:.*e}", digits - 1);
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    if (-4..7).contains(&exponent) {
        let decimals = (digits as i32 - 1 - exponent).max(0) as usize;
        without_trailing_zeros(&format!("{value:.decimals$}")).to_owned()
    } else {
        format!("{}e{exponent}", without_trailing_zeros(mantissa))
    }
}

/// A number of which only the size matters: `3e-13`.
pub(crate) fn order(value: f64) -> String {
    if value == 0.0 { "0".to_owned() } else { format!("{value:.0e}") }
}

/// A bound with two digits, rounded up: `1.64e-14` as `1.7e-14`.
pub(crate) fn above(bound: f64) -> String {
    if bound == 0.0 || !bound.is_finite() {
        return significant(bound, 2);
    }
    let nearest = format!("{bound:.1e}");
    if nearest.parse().is_ok_and(|shown: f64| shown > bound) {
        return nearest;
    }
    // Five hundredths of the leading digit's unit more: the next number with two digits.
    let exponent = nearest.split_once('e').map_or("0", |(_, exponent)| exponent);
    let step: f64 = format!("0.1e{exponent}").parse().unwrap_or(f64::INFINITY);
    format!("{:.1e}", bound + step)
}

pub(crate) fn without_trailing_zeros(text: &str) -> &str {
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
            (-1234.5678, "-1234.57"),
            (999999.96, "1000000"),
            (1234567.8, "1234568"),
            (12345678.9, "1.23457e7"),
            (9.9999999e-5, "0.0001"),
            (1.25e-9, "1.25e-9"),
            (-1.5e300, "-1.5e300"),
            (f64::INFINITY, "inf"),
        ];
        for (value, text) in cases {
            assert_eq!(significant(value, 6), text);
        }
        assert_eq!(order(3.2e-13), "3e-13");
    }

    #[test]
    fn bounds_are_rounded_up() {
        let cases = [
            (1.64e-14, "1.7e-14"),
            (1.61e-14, "1.7e-14"),
            (9.99e-3, "1.0e-2"),
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
            let shown: f64 = above(bound).parse().unwrap();
            assert!(shown > bound && shown <= 1.11 * bound, "{bound} {shown}");
        }
    }
}
