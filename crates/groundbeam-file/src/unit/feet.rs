//! Parses lengths in feet, inches and fractions of an inch, such as `12'-6"`, `12 ft 6 in`, `6 1/2 in` and `12' 6 1/2"`.

use super::symbol::{FEET, INCHES};

/// Largest allowed denominator of a fraction of a foot or an inch.
const FINEST: u128 = 64;
/// Number of equal parts of an inch. All 64ths and all decimals with six decimal places are whole numbers of parts.
const PARTS: u128 = 1_000_000;

/// Converts a length in feet and inches, or with a fraction, to decimal inches. Returns `None` for other text, such as
/// `6.5 in`.
pub(crate) fn feet_and_inches(text: &str) -> Option<String> {
    let text = text.trim();
    let (sign, text) = match text.strip_prefix(['-', '\u{2212}']) {
        Some(size) => ("-", size),
        None => ("", text),
    };
    let parts = match number_and_unit(text, INCHES) {
        Some(number) => match number.find(starts_feet) {
            Some(_) => {
                let (feet, inches) = feet_before(number)?;
                12 * parts_of(feet)? + parts_of(inches)?
            }
            None if number.contains('/') => parts_of(number)?,
            None => return None,
        },
        None => {
            let number = number_and_unit(text, FEET).filter(|number| number.contains('/'))?;
            12 * parts_of(number)?
        }
    };
    Some(format!("{sign}{}.{:06}", parts / PARTS, parts % PARTS))
}

/// Converts a length in feet and inches, or a length with a fraction, to a decimal number with its unit. The
/// unit is feet if the text contains feet, and inches otherwise.
pub(crate) fn decimal_length(text: &str) -> Option<(f64, &'static str)> {
    let inches: f64 = feet_and_inches(text)?.parse().ok()?;
    Some(if text.contains(starts_feet) { (inches / 12.0, "ft") } else { (inches, "in") })
}

/// Returns the text before the unit if the text ends with one of the unit names `names`.
fn number_and_unit<'t>(text: &'t str, names: &[&str]) -> Option<&'t str> {
    let number = names.iter().filter_map(|name| text.strip_suffix(name));
    number.min_by_key(|number| number.len()).map(str::trim_end)
}

/// Whether a name of the foot begins with this letter.
fn starts_feet(letter: char) -> bool {
    FEET.iter().any(|name| name.starts_with(letter))
}

/// Splits a length into the text of the feet and the text of the inches. The unit of the inches has already
/// been removed.
fn feet_before(text: &str) -> Option<(&str, &str)> {
    let at = text.find(starts_feet)?;
    let (feet, rest) = text.split_at(at);
    let rest = FEET.iter().filter_map(|name| rest.strip_prefix(name)).min_by_key(|r| r.len())?;
    let rest = rest.trim_start();
    Some((feet.trim_end(), rest.strip_prefix('-').unwrap_or(rest).trim_start()))
}

/// Parses a decimal number, a fraction, or an integer and a fraction. Returns the number times `PARTS`.
fn parts_of(text: &str) -> Option<u128> {
    let Some((before, below)) = text.split_once('/') else { return decimal(text) };
    let (whole, above) = match before.trim_end().rsplit_once([' ', '-']) {
        Some((whole, above)) => (PARTS.checked_mul(count(whole.trim_end())?)?, above),
        None => (0, before.trim_end()),
    };
    let (above, below) = (count(above)?, count(below.trim_start())?);
    let is_fraction = below.is_power_of_two() && below <= FINEST && above < below;
    is_fraction.then(|| whole + above * (PARTS / FINEST) * (FINEST / below))
}

fn decimal(text: &str) -> Option<u128> {
    let (whole, part) = text.split_once('.').unwrap_or((text, ""));
    let is_short = part.len() <= 6 && part.bytes().all(|byte| byte.is_ascii_digit());
    let part = is_short.then(|| format!("{part:0<6}"))?;
    Some(PARTS.checked_mul(count(whole)?)? + count(&part)?)
}

/// Parses an integer of up to nine digits.
fn count(text: &str) -> Option<u128> {
    let is_count = (1..=9).contains(&text.len()) && text.bytes().all(|byte| byte.is_ascii_digit());
    is_count.then(|| text.parse().ok()).flatten()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_as_us_engineers_write_them() {
        let cases = [
            ("12'-6\"", "150.000000"),
            ("12' 6\"", "150.000000"),
            ("12'6\"", "150.000000"),
            ("12′-6″", "150.000000"),
            ("12’ 6 1/2”", "150.500000"),
            ("12' 6-1/2\"", "150.500000"),
            ("12ft 6in", "150.000000"),
            ("12 feet 6.25 inches", "150.250000"),
            ("6 1/2 in", "6.500000"),
            ("63/64\"", "0.984375"),
            ("2 1/2 ft", "30.000000"),
            ("-1'-0\"", "-12.000000"),
            ("\u{2212}0' 6\"", "-6.000000"),
        ];
        for (text, inches) in cases {
            assert_eq!(feet_and_inches(text).as_deref(), Some(inches), "{text}");
        }
        let others = [
            "6.5 in",
            "12'",
            "12 ft",
            "3 1/3 in",
            "3 4/2 in",
            "1/128 in",
            "' 6\"",
            "6 1/2 m",
            "12 m 6 in",
            "",
            "\"",
            "1e3' 6\"",
            "1.2.3' 6\"",
        ];
        for text in others {
            assert_eq!(feet_and_inches(text), None, "{text}");
        }
    }

    #[test]
    fn lengths_in_feet_have_a_decimal_number() {
        for (text, decimal) in [
            ("1'-6\"", (1.5, "ft")),
            ("-0' 6\"", (-0.5, "ft")),
            ("2 1/2 ft", (2.5, "ft")),
            ("6 1/2 in", (6.5, "in")),
        ] {
            assert_eq!(decimal_length(text), Some(decimal), "{text}");
        }
        assert_eq!(decimal_length("12 ft"), None);
    }
}
