//! Decimal numbers as text: numbers of TOML, and numbers at the beginning of a quantity.

/// Converts a number of TOML to digits with an optional sign, point and exponent.
pub(crate) fn of_toml(word: &str) -> Result<String, &'static str> {
    const NO_NUMBER: &str = "a value is expected here; put text and numbers with units in quotes";
    let (sign, size) = match word.as_bytes().first() {
        Some(b'-') => ("-", word.get(1..).unwrap_or("")),
        Some(b'+') => ("", word.get(1..).unwrap_or("")),
        _ => ("", word),
    };
    if matches!(size, "nan" | "inf") {
        return Err("a number must be finite");
    }
    for (prefix, radix) in [("0x", 16), ("0o", 8), ("0b", 2)] {
        if let Some(digits) = word.strip_prefix(prefix) {
            let digits = grouped(digits, |b| char::from(b).is_digit(radix)).ok_or(NO_NUMBER)?;
            let whole =
                u128::from_str_radix(&digits, radix).map_err(|_| "this number is too large")?;
            return Ok(whole.to_string());
        }
    }
    let (mantissa, power) = match size.find(['e', 'E']) {
        Some(e) => (size.get(..e).unwrap_or(""), size.get(e + 1..)),
        None => (size, None),
    };
    let digits = |text| grouped(text, |b: u8| b.is_ascii_digit()).ok_or(NO_NUMBER);
    let (before, after) = match mantissa.split_once('.') {
        Some((before, after)) => (before, Some(after)),
        None => (mantissa, None),
    };
    let before = digits(before)?;
    if before.len() > 1 && before.starts_with('0') {
        return Err("a number may begin with a zero only if a point follows");
    }
    let mut number = format!("{sign}{before}");
    if let Some(after) = after {
        number = format!("{number}.{}", digits(after)?);
    }
    if let Some(power) = power {
        let unsigned = power.strip_prefix(['-', '+']).unwrap_or(power);
        let minus = if power.starts_with('-') { "-" } else { "" };
        number = format!("{number}e{minus}{}", digits(unsigned)?);
    }
    Ok(number)
}

/// Removes the underscores from the digits of a number, such as `1_000`. Returns `None` unless each underscore stands
/// between two digits and all other characters are digits.
fn grouped(text: &str, is_digit: impl Fn(u8) -> bool) -> Option<String> {
    let bytes = text.as_bytes();
    let digit_at = |i: usize| bytes.get(i).is_some_and(|b| is_digit(*b));
    let right = |i: usize| match bytes[i] {
        // An underscore must not be the first character, and a digit must follow it. This also refuses two underscores
        // in a row.
        b'_' => i > 0 && digit_at(i + 1),
        byte => is_digit(byte),
    };
    let is_right = !bytes.is_empty() && (0..bytes.len()).all(right);
    is_right.then(|| text.replace('_', ""))
}

/// A decimal number: ± digits × 10^power without leading or trailing zeros. Numbers of equal value compare as
/// equal.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Decimal {
    negative: bool,
    /// Digits without leading or trailing zeros; empty for 0.
    digits: String,
    power: i32,
}

impl Decimal {
    /// Reads the number at the beginning of a text. Returns the number and the text after the number. Digits may be
    /// grouped by `_`, and U+2212 is a minus sign.
    pub fn head(text: &str) -> Option<(Decimal, &str)> {
        let (negative, mut rest) = signed(text);
        let mut digits = take_digits(&mut rest);
        let mut power = 0;
        if let Some(mut after) = rest.strip_prefix('.') {
            let fraction = take_digits(&mut after);
            power = -i32::try_from(fraction.len()).ok()?;
            digits += &fraction;
            rest = after;
        }
        if digits.is_empty() {
            return None;
        }
        if let Some(exponent) = rest.strip_prefix(['e', 'E']) {
            let (below, mut after) = signed(exponent);
            let written = take_digits(&mut after);
            if !written.is_empty() {
                // The exponent is limited to 10⁵, which lies outside every accepted range.
                let size = written.parse::<i32>().unwrap_or(100_000).min(100_000);
                power = power.saturating_add(if below { -size } else { size });
                rest = after;
            }
        }
        Some((Decimal::of(negative, &digits, power), rest))
    }

    /// Reads a text that consists of a number only; `None` for any other text.
    pub fn whole(text: &str) -> Option<Decimal> {
        Decimal::head(text).filter(|(_, rest)| rest.is_empty()).map(|(number, _)| number)
    }

    fn of(negative: bool, digits: &str, power: i32) -> Self {
        let digits = digits.trim_start_matches('0');
        let short = digits.trim_end_matches('0');
        if short.is_empty() {
            return Decimal { negative: false, digits: String::new(), power: 0 };
        }
        let zeros = i32::try_from(digits.len() - short.len()).unwrap_or(i32::MAX);
        Decimal { negative, digits: short.to_owned(), power: power.saturating_add(zeros) }
    }

    /// Whether it is 0.
    pub fn is_zero(&self) -> bool {
        self.digits.is_empty()
    }

    /// The number times 10^ten.
    pub fn shifted(mut self, ten: i32) -> Self {
        if !self.is_zero() {
            self.power = self.power.saturating_add(ten);
        }
        self
    }

    /// The number as text: digits and a power of ten.
    pub fn text(&self) -> String {
        let sign = if self.negative { "-" } else { "" };
        match self.is_zero() {
            true => "0".to_owned(),
            false => format!("{sign}{}e{}", self.digits, self.power),
        }
    }
}

fn signed(text: &str) -> (bool, &str) {
    match text.strip_prefix(['-', '\u{2212}']) {
        Some(rest) => (true, rest),
        None => (false, text.strip_prefix('+').unwrap_or(text)),
    }
}

fn take_digits(rest: &mut &str) -> String {
    let mut digits = String::new();
    loop {
        let after = match digits.is_empty() {
            true => *rest,
            false => rest.strip_prefix('_').unwrap_or(rest),
        };
        let Some(digit) = after.chars().next().filter(char::is_ascii_digit) else {
            return digits;
        };
        digits.push(digit);
        *rest = after.get(1..).unwrap_or("");
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_of_toml() {
        let cases = [
            ("12", "12"),
            ("+1_000", "1000"),
            ("-0.5e-1_0", "-0.5e-10"),
            ("1E+3", "1e3"),
            ("0x1F", "31"),
            ("0b101", "5"),
            ("0", "0"),
        ];
        for (word, expected) in cases {
            assert_eq!(of_toml(word).as_deref(), Ok(expected), "{word}");
        }
        for word in [
            "", "-", "01", ".5", "5.", "1__0", "_1", "1_", "1e", "0x", "--1", "1.e3", "0xffg",
            "1e5.5", "inf", "-nan", "1.2.3", "-0x1", "0x1_",
        ] {
            assert!(of_toml(word).is_err(), "{word}");
        }
    }

    #[test]
    fn numbers_at_the_start_of_a_quantity() {
        let head = |text| Decimal::head(text).map(|(number, rest)| (number.text(), rest));
        let is = |number: &str, rest| Some((number.to_owned(), rest));
        assert_eq!(head("12 m"), is("12e0", " m"));
        assert_eq!(head("-.50"), is("-5e-1", ""));
        assert_eq!(head("5.m"), is("5e0", "m"));
        assert_eq!(head("1_000 kN"), is("1e3", " kN"));
        assert_eq!(head("\u{2212}3e\u{2212}3"), is("-3e-3", ""));
        assert_eq!(head("3em"), is("3e0", "em"));
        assert_eq!(head("1e99999999999"), is("1e100000", ""));
        assert_eq!(head("-0.00"), is("0", ""));
        for nothing in ["", ".", "-", "e5", "m", "_1", "+-1"] {
            assert_eq!(head(nothing), None, "{nothing:?}");
        }
        assert_eq!(Decimal::whole("25e1"), Decimal::whole("250"));
        assert_eq!(Decimal::whole("2.5").map(|n| n.shifted(2)), Decimal::whole("250.0"));
    }
}
