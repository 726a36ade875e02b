//! Reads a quantity from a text: a number and a unit, or a number alone.

use super::kind::Kind;
use super::kinds::MODULUS;
use crate::code;
use crate::fault::Fault;
use crate::misread::{DENSITY, is_density, without_comma};
use crate::number::Decimal;
use crate::unit::{Dimension, Marks, Unit, feet_and_inches};

impl Kind {
    /// Reads a quantity of a built-in list, in N, m and K. An unreadable text gives NaN, which the tests of
    /// the list detect.
    pub fn listed(&self, text: &str) -> f64 {
        self.read("", text, false).map_or(f64::NAN, |written| written.value)
    }

    /// Reads a number with or without a unit. A number with a unit is converted to SI units. `plain`
    /// selects the hints for a file without units.
    pub fn read(&self, key: &str, text: &str, plain: bool) -> Result<Written, Fault> {
        let start = text.len() - text.trim_start().len();
        let trimmed = text.trim();
        if let Some(value) = self.feet_and_inches(trimmed) {
            let marks =
                if trimmed.contains(['f', '\'', '′', '’']) { Marks::FOOT } else { Marks::INCH };
            return Ok(Written { value, has_unit: true, marks });
        }
        let Some((number, length)) = Decimal::read(trimmed) else {
            return Err(self.unreadable(key, text, trimmed, plain).moved(start));
        };
        let rest = &trimmed[length..];
        let unit_start = length + rest.len() - rest.trim_start().len();
        let unit_text = rest.trim_start();
        if let Some(fault) = self.interrupted(&trimmed[..length], unit_text, trimmed.len()) {
            return Err(fault.moved(start));
        }
        let (value, has_unit, marks) = if unit_text.is_empty() {
            (number.to_f64(), false, Marks::NONE)
        } else {
            let unit = Unit::read(unit_text).map_err(|fault| {
                let hint = match self.dimension == MODULUS && fault.code == code::UNKNOWN_UNIT {
                    true if is_density(unit_text) => DENSITY.to_owned(),
                    _ => fault.hint.clone(),
                };
                Fault { hint, ..fault }.moved(start + unit_start)
            })?;
            if !self.accepts(unit.dimension) {
                let at = start + unit_start..start + trimmed.len();
                return Err(self.wrong_kind(key, unit.dimension, unit_text, at));
            }
            (number.times(&unit.scale), true, unit.marks)
        };
        if !is_within_reach(value) || (value == 0.0 && !number.is_zero()) {
            return Err(out_of_reach(value, start..start + trimmed.len()));
        }
        Ok(Written { value, has_unit, marks })
    }

    /// Reads a length in feet and inches, or a fraction of an inch, and returns it in metres. Returns
    /// `None` for other texts and for quantities that are not lengths.
    fn feet_and_inches(&self, text: &str) -> Option<f64> {
        let inches = feet_and_inches(text).filter(|_| self.dimension == Dimension::LENGTH)?;
        Some(Decimal::read(&inches)?.0.times(&Unit::read("in").ok()?.scale))
    }

    fn wrong_kind(
        &self,
        key: &str,
        found: Dimension,
        unit: &str,
        at: std::ops::Range<usize>,
    ) -> Fault {
        let hint = match self.mistaken.iter().find(|(dimension, _)| *dimension == found) {
            Some((_, advice)) => (*advice).to_owned(),
            None if found == Dimension::TEMPERATURE && unit.starts_with('K') => {
                "`K` is kelvin; kips are written kip".to_owned()
            }
            None if self.unit.is_empty() => {
                format!("give a number without a unit, as in {key} = {}", self.example)
            }
            None => format!("give a unit as in {}", self.line(key, false)),
        };
        let found = found.describe();
        let message = format!("`{unit}` is {found}, but {} is needed here", self.what);
        Fault::new(code::WRONG_UNIT, at, message, found, hint)
    }

    /// Returns the fault for a text that does not begin with a number. `trimmed` is this text without
    /// surrounding spaces.
    fn unreadable(&self, key: &str, text: &str, trimmed: &str, plain: bool) -> Fault {
        let word = trimmed.trim_start_matches(['+', '-', '\u{2212}']);
        let word = word.split_whitespace().next().unwrap_or("").to_lowercase();
        if ["nan", "inf", "infinity"].contains(&&*word) {
            return not_finite(&word, 0..trimmed.len());
        }
        let message = if trimmed.is_empty() {
            format!("a number is missing: `{key}` is {}", self.what)
        } else {
            format!("`{text}` does not begin with a number")
        };
        Fault::new(code::NUMBER, 0..trimmed.len(), message, "", self.advice(key, plain))
    }

    /// Returns the fault for a number that continues after a comma or a space; `None` if the number does
    /// not continue.
    fn interrupted(&self, number: &str, rest: &str, length: usize) -> Option<Fault> {
        // The text after the number may be a unit that begins with `1/`, such as 1/m.
        let over = rest.strip_prefix('1').and_then(|rest| rest.trim_start().strip_prefix('/'));
        if over.is_some_and(|unit| !unit.trim_start().starts_with(|c: char| c.is_ascii_digit())) {
            return None;
        }
        let digits_after =
            |text: &str| -> String { text.chars().take_while(char::is_ascii_digit).collect() };
        let (more, hint) = match rest.strip_prefix(',') {
            Some(after) => (digits_after(after), without_comma(number, after)),
            None => {
                let more = digits_after(rest);
                let hint = format!("write the digits together: {number}{more}");
                (more, hint)
            }
        };
        if more.is_empty() {
            return None;
        }
        let message = "this number cannot be read";
        let at = number.len()..length - rest.len() + rest.find(more.as_str())? + more.len();
        Some(Fault::new(code::NUMBER, at, message, "a second number", hint))
    }
}

/// Value of a quantity as read from the file, and whether the file gives its unit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Written {
    /// Value in SI units if the file gives a unit; otherwise the number in the file.
    pub value: f64,
    pub has_unit: bool,
    pub marks: Marks,
}

/// Returns the fault for `nan` or `inf`, which TOML allows and many programs write.
pub(crate) fn not_finite(written: &str, at: std::ops::Range<usize>) -> Fault {
    let what = if written.contains("nan") { "not a number" } else { "infinite" };
    let message = format!("`{written}` is {what}; a finite number is needed");
    Fault::new(code::NOT_FINITE, at, message, "", "give a finite number, or leave the key out")
}

/// Whether a number is within the allowed range. Products and powers of a few numbers in this range are
/// finite.
pub(crate) fn is_within_reach(value: f64) -> bool {
    value == 0.0 || (1e-60..=1e60).contains(&value.abs())
}

/// Text that states the allowed range of numbers.
pub(crate) const REACH: &str = "allowed values are 0 and magnitudes between 1e-60 and 1e60";

/// Returns the fault for a number outside the allowed range. `value` may be 0 or infinity, because 64-bit
/// floating point may have rounded the number.
pub(crate) fn out_of_reach(value: f64, at: std::ops::Range<usize>) -> Fault {
    let size = if value.abs() < 1.0 { "small" } else { "large" };
    let message = format!("this number is too {size}");
    Fault::new(code::NOT_FINITE, at, message, "", REACH)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quantity::{
        BENDING_STIFFNESS, CURVATURE, ELASTIC_MODULUS, EXPANSION, FORCE, LENGTH, MOMENT_PER_LENGTH,
        ROTATIONAL_SPRING, SECOND_MOMENT_OF_AREA, SPRING_PER_LENGTH, TEMPERATURE, UNIT_WEIGHT,
    };

    #[track_caller]
    fn si(kind: &Kind, text: &str) -> f64 {
        kind.read("key", text, false).unwrap().value
    }

    #[test]
    fn decimal_prefixes_are_exact() {
        assert_eq!(si(&FORCE, "12 kN"), 12_000.0);
        assert_eq!(si(&FORCE, "0.1 kN"), 100.0);
        assert_eq!(si(&LENGTH, "3.6 mm"), 0.0036);
        assert_eq!(si(&ELASTIC_MODULUS, "9.3 MPa"), 9.3e6);
        assert_eq!(si(&SPRING_PER_LENGTH, "1.1 N/mm^2"), 1.1e6);
        assert_eq!(si(&SECOND_MOMENT_OF_AREA, "8356.1 cm4"), 8.3561e-5);
        assert_eq!(si(&BENDING_STIFFNESS, "1.2e6 kN m^2"), 1.2e9);
        assert_eq!(si(&MOMENT_PER_LENGTH, "5 kN m/m"), 5000.0);
        assert_eq!(si(&ROTATIONAL_SPRING, "5 MN m/rad"), 5e6);
        assert_eq!(si(&ROTATIONAL_SPRING, "5 MN m"), 5e6);
        assert_eq!(si(&CURVATURE, "1e-4 1/m"), 1e-4);
        assert_eq!(si(&CURVATURE, "0.1 mrad/m"), 1e-4);
        assert_eq!(si(&CURVATURE, "0.1 1 / km"), 1e-4);
        assert_eq!(si(&EXPANSION, "10e-6 1/°C"), 1e-5);
        assert_eq!(si(&TEMPERATURE, "27 degF"), 15.0);
    }

    #[test]
    fn other_units_are_rounded_once() {
        assert_eq!(si(&LENGTH, "3.6 in"), 0.09144);
        assert_eq!(si(&LENGTH, "10 ft"), 3.048);
        assert_eq!(si(&FORCE, "1.5 kip"), 6_672.332_422_890_75);
        assert_eq!(si(&ELASTIC_MODULUS, "29000 ksi"), 199_947_961_501.882_48);
        let per_degree = si(&ROTATIONAL_SPRING, "1 N m/deg");
        assert_eq!(per_degree, 57.295_779_513_082_32);
    }

    #[test]
    fn surrounding_spaces_are_ignored_and_divided_numbers_are_refused() {
        assert_eq!(si(&LENGTH, "  12m\t"), 12.0);
        assert_eq!(si(&LENGTH, "1_000 mm"), 1.0);
        let code_of = |text| LENGTH.read("length", text, false).unwrap_err().code;
        for text in ["3 1/2 m", "3,5 m", "1 000 m", "12,5", "twelve m", "", "  ", "m", "-", "$3"] {
            assert_eq!(code_of(text), code::NUMBER, "{text:?}");
        }
        for text in ["nan", "-inf m", "1e400", "1e-400 m", "1e-330", "1e308 km"] {
            assert_eq!(code_of(text), code::NOT_FINITE, "{text:?}");
        }
        for text in ["5 kN", "5 m^2", "5 m/m", "5 rad"] {
            assert_eq!(code_of(text), code::WRONG_UNIT, "{text:?}");
        }
    }

    #[test]
    fn lengths_in_feet_and_inches_are_rounded_once() {
        let cases =
            [("12'-6\"", 3.81), ("12ft 6in", 3.81), ("6 1/2 in", 0.1651), ("12' 6 1/2\"", 3.8227)];
        for (text, metres) in cases {
            assert_eq!(si(&LENGTH, text), metres, "{text}");
        }
        assert_eq!(FORCE.read("point", "6 1/2 kip", false).unwrap_err().code, code::NUMBER);
    }

    #[test]
    fn numbers_with_commas_are_refused() {
        let cases = [
            (
                "1,200 kN",
                "a number must not contain a comma: write 1200, or 1.200 if the comma is a decimal comma",
            ),
            ("1,200.5 kN", "a number must not contain a comma: write 1200.5"),
            ("1,234,567 kN", "a number must not contain a comma: write 1234567"),
            ("3,5 kN", "write a decimal point: 3.5"),
            ("3,1416 kN", "write a decimal point: 3.1416"),
        ];
        for (text, hint) in cases {
            assert_eq!(FORCE.read("point", text, false).unwrap_err().hint, hint, "{text}");
        }
    }

    #[test]
    fn masses_and_kelvins_are_explained() {
        let hint = |kind: &Kind, text| kind.read("key", text, false).unwrap_err().hint;
        assert_eq!(hint(&UNIT_WEIGHT, "2400 kg/m3"), DENSITY);
        assert_eq!(hint(&UNIT_WEIGHT, "2.4 t/m³"), DENSITY);
        assert_eq!(hint(&FORCE, "12 K"), "`K` is kelvin; kips are written kip");
        assert_eq!(si(&FORCE, "500#"), si(&FORCE, "500 lbf"));
        assert_eq!(si(&FORCE, "12 k"), si(&FORCE, "12 kip"));
    }
}
