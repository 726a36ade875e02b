//! Lengths in feet and inches, or with fractions, as a decimal number of inches: `12'-6"`, `12 ft 6 1/2 in`, `6 1/2 in`.

/// Lengths are counted in millionths of an inch. So 1/64 inch and numbers of inches with six decimals are integers.
const MILLION: u128 = 1_000_000;

/// Converts a length in feet and inches, or with a fraction, to a decimal number of inches; `None` for every other
/// text.
pub(crate) fn inches(text: &str) -> Option<String> {
    let one_sign = |text: String, names: [&str; 5], sign: &str| {
        names.iter().fold(text, |text, name| text.replace(name, sign))
    };
    let text = one_sign(text.trim().to_owned(), ["feet", "foot", "ft", "′", "’"], "'");
    let text = one_sign(text, ["inches", "inch", "in", "″", "”"], "\"");
    let (minus, size) = match text.strip_prefix(['-', '\u{2212}']) {
        Some(size) => ("-", size),
        None => ("", text.as_str()),
    };
    let millionths = match (size.split_once('\''), size.strip_suffix('"')) {
        (Some((feet, rest)), Some(_)) => {
            let rest = rest.trim_start();
            let rest = rest.strip_prefix('-').unwrap_or(rest).trim_start();
            12 * number(feet.trim_end())? + number(rest.strip_suffix('"')?.trim_end())?
        }
        (None, Some(size)) if size.contains('/') => number(size.trim_end())?,
        (Some((size, "")), None) if size.contains('/') => 12 * number(size.trim_end())?,
        _ => return None,
    };
    Some(format!("{minus}{millionths}e-6"))
}

/// Reads a number with decimals, a fraction, or a whole number with a fraction. Returns it in millionths.
fn number(text: &str) -> Option<u128> {
    let Some((above, below)) = text.split_once('/') else {
        let (whole, part) = text.split_once('.').unwrap_or((text, "0"));
        let part = if part.is_empty() { "0" } else { part };
        let places = u32::try_from(part.len()).ok().filter(|places| *places <= 6)?;
        return Some(digits(whole)? * MILLION + digits(part)? * 10_u128.pow(6 - places));
    };
    let above = above.trim_end();
    let (whole, above) = match above.rfind([' ', '-']) {
        Some(at) => (digits(above.get(..at)?.trim_end())?, above.get(at + 1..)?),
        None => (0, above),
    };
    let (above, below) = (digits(above)?, digits(below.trim_start())?);
    let is_fraction = [1, 2, 4, 8, 16, 32, 64].contains(&below) && above < below;
    is_fraction.then(|| whole * MILLION + above * (MILLION / 64) * (64 / below))
}

fn digits(text: &str) -> Option<u128> {
    let short = (1..=9).contains(&text.len()) && text.bytes().all(|byte| byte.is_ascii_digit());
    text.parse().ok().filter(|_| short)
}

#[cfg(test)]
mod tests {
    #[test]
    fn feet_and_inches() {
        let cases = [
            ("12'-6\"", "150000000e-6"),
            ("12′ 6 1/2″", "150500000e-6"),
            ("12 feet 6.25 inches", "150250000e-6"),
            ("6 1/2 in", "6500000e-6"),
            ("2 1/2 ft", "30000000e-6"),
            ("\u{2212}1'-0\"", "-12000000e-6"),
        ];
        for (text, inches) in cases {
            assert_eq!(super::inches(text).as_deref(), Some(inches), "{text}");
        }
        for text in [
            "6.5 in",
            "12 ft",
            "3 1/3 in",
            "1/128 in",
            "' 6\"",
            "6 1/2 m",
            "12 m 6 in",
            "",
            "4/4 in",
            "6 2/2 in",
            "3/2 in",
            "+6 1/2 in",
            "12'-+6\"",
            "1234567890 1/2 in",
            "1/+2 in",
        ] {
            assert_eq!(super::inches(text), None, "{text}");
        }
    }
}
