//! Reads a decimal number from text: its digits as an integer, and a power of ten.

/// A decimal number as written in the file: a sign, and digits times a power of ten.
pub(crate) struct Decimal {
    pub negative: bool,
    /// At most 37 digits.
    pub digits: u128,
    /// Power of ten of the last stored digit.
    pub exponent: i32,
    /// Whether nonzero digits after the stored digits were omitted.
    pub cut: bool,
}

impl Decimal {
    pub fn read(text: &str) -> Option<Self> {
        let (negative, text) = match text.as_bytes().first()? {
            b'-' => (true, &text[1..]),
            b'+' => (false, &text[1..]),
            _ => (false, text),
        };
        let (digits, power) = match text.find(['e', 'E']) {
            Some(at) => (&text[..at], text[at + 1..].parse::<i32>().ok()?),
            None => (text, 0),
        };
        let (before, after) = digits.split_once('.').unwrap_or((digits, ""));
        if before.is_empty() && after.is_empty() {
            return None;
        }
        let mut read = Decimal { negative, digits: 0, exponent: power, cut: false };
        for (part, step) in [(before, 0), (after, -1)] {
            for digit in part.bytes() {
                read.add(digit, step)?;
            }
        }
        // Trailing zeros are removed, unless nonzero digits were omitted. Then the zeros must stay, because one unit
        // of the last stored digit bounds the omitted part.
        while !read.cut && read.digits != 0 && read.digits.is_multiple_of(10) {
            (read.digits, read.exponent) = (read.digits / 10, read.exponent.checked_add(1)?);
        }
        Some(read)
    }

    /// Appends a digit. `step` is the change of the exponent: 0 before the decimal point, −1 after it.
    fn add(&mut self, digit: u8, step: i32) -> Option<()> {
        if !digit.is_ascii_digit() {
            return None;
        }
        let full = self.digits >= 10_u128.pow(36);
        if full {
            self.cut |= digit != b'0';
        } else {
            self.digits = 10 * self.digits + u128::from(digit - b'0');
        }
        self.exponent = self.exponent.checked_add(step + i32::from(full))?;
        Some(())
    }
}
