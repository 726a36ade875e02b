//! Formats quantities as text: unit, digits and sign.
//!
//! Results have the units of the file: a file in feet and kips gives results in feet and kips.

mod kind;
pub mod number;
mod us;

pub use kind::Kind;
pub use us::UsUnits;

use kind::{BARE, TECHNICAL};
use number::significant;
use std::ops::RangeInclusive;

/// Default number of significant digits of a printed result.
pub const RESULT_DIGITS: usize = 4;
/// Allowed numbers of significant digits.
pub const DIGITS: RangeInclusive<usize> = 2..=15;
/// Minimum number of significant digits of a printed input.
const INPUT_DIGITS: usize = 6;

/// The units in which quantities are printed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum System {
    /// A consistent system of units without names. Numbers are printed without units.
    Plain,
    /// SI units, such as kN, m, mm and MPa.
    Si,
    /// Metric units with the kilogram-force, such as tf, m and mm.
    Technical,
    /// US units, such as ft, in, kip and ksf.
    Us(UsUnits),
}

/// Units that the user requests.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Asked {
    /// Units of the file.
    #[default]
    File,
    /// SI units.
    Si,
    /// US units.
    Us,
}

impl Asked {
    /// Returns the units that the user requests by this name; `None` for an unknown name.
    pub fn named(name: &str) -> Option<Self> {
        match name {
            "file" => Some(Asked::File),
            "si" => Some(Asked::Si),
            "us" => Some(Asked::Us),
            _ => None,
        }
    }
}

/// Units and number of digits for printed quantities.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Units {
    system: System,
    digits: usize,
}

impl Units {
    /// SI units.
    pub const SI: Units = Units::new(System::Si);
    /// No units.
    pub const PLAIN: Units = Units::new(System::Plain);
    /// US units.
    pub const US: Units = Units::new(System::Us(UsUnits::USUAL));

    /// Returns the units of `system`, with the default number of digits of a printed result.
    pub const fn new(system: System) -> Self {
        Units { system, digits: RESULT_DIGITS }
    }

    /// Replaces the units of the file by the requested units. Returns `None` if SI or US units are
    /// requested for a file without units.
    pub fn in_system(self, asked: Asked) -> Option<Self> {
        let system = match (asked, self.system) {
            (Asked::File, own) => own,
            (_, System::Plain) => return None,
            (Asked::Si, _) => System::Si,
            (Asked::Us, own @ System::Us(_)) => own,
            (Asked::Us, _) => System::Us(UsUnits::USUAL),
        };
        Some(Units { system, ..self })
    }

    /// Returns these units with the given number of digits.
    pub fn with_digits(self, digits: usize) -> Self {
        Units { digits, ..self }
    }

    /// Returns these units with the number of digits for printed inputs, which is at least six.
    pub fn of_input(self) -> Self {
        self.with_digits(self.digits.max(INPUT_DIGITS))
    }

    /// Returns the number of significant digits of a printed result.
    pub fn digits(self) -> usize {
        self.digits
    }

    /// Whether numbers are printed without units.
    pub fn is_plain(self) -> bool {
        self.system == System::Plain
    }

    /// Name of the unit system in result documents: `SI` or `none`.
    pub fn name(self) -> &'static str {
        if self.is_plain() { "none" } else { "SI" }
    }

    /// Returns a suitable unit for quantities whose largest magnitude is `largest`.
    pub fn unit(self, kind: Kind, largest: f64) -> Unit {
        let size = largest.abs();
        let usual = |usual: f64| if size == 0.0 { usual } else { size };
        let (name, size) = match self.system {
            System::Plain => ("", 1.0),
            System::Si => kind::fitting(kind.ladder(), usual(kind.usual())),
            System::Technical => match kind.technical() {
                Some(ladder) => kind::fitting(ladder, usual(TECHNICAL)),
                None => kind::fitting(kind.ladder(), usual(kind.usual())),
            },
            System::Us(own) => own.unit(kind, size),
        };
        Unit { name, size, digits: self.digits }
    }

    /// Returns the unit of a column in a machine-readable table. The unit does not depend on the values in
    /// the column.
    pub fn column(self, kind: Kind) -> Unit {
        match self.system {
            _ if kind == Kind::Slope => Unit {
                name: if self.is_plain() { "" } else { "rad" },
                size: 1.0,
                digits: self.digits,
            },
            System::Si => {
                let base = kind.ladder().last().unwrap_or(&BARE);
                Unit { name: base.name, size: base.size, digits: self.digits }
            }
            _ => self.unit(kind, 0.0),
        }
    }

    /// Formats a quantity in a suitable unit, such as `600 kN`.
    pub fn write(self, kind: Kind, value: f64) -> String {
        self.unit(kind, value).write(value)
    }

    /// Formats a position along the beam in a suitable unit.
    pub fn position(self, x: f64) -> String {
        self.write(Kind::Position, x)
    }

    /// Returns a unit for dimensionless numbers that are followed by the word `name`.
    pub fn plain(self, name: &'static str) -> Unit {
        Unit { name, size: 1.0, digits: self.digits }
    }

    /// Returns the unit for percentages.
    pub fn percent(self) -> Unit {
        Unit { name: "%", size: 0.01, digits: self.digits }
    }

    /// Formats a dimensionless number.
    pub fn ratio(self, value: f64) -> String {
        significant(value, self.digits)
    }

    /// Returns the suffix `/rad` of the unit of a moment per angle; empty for numbers without units.
    pub fn per_radian(self) -> &'static str {
        if self.is_plain() { "" } else { "/rad" }
    }
}

/// A unit: its name, its size in m, N and rad, and the number of digits of printed values.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unit {
    /// Name of the unit; empty for numbers without a unit.
    pub name: &'static str,
    /// Size of the unit in m, N and rad.
    pub size: f64,
    /// Significant digits of numbers in this unit.
    pub digits: usize,
}

impl Unit {
    /// Formats a value in this unit, without the name of the unit.
    pub fn number(self, value: f64) -> String {
        significant(value / self.size, self.digits)
    }

    /// Formats a value in this unit, followed by the name of the unit.
    pub fn write(self, value: f64) -> String {
        let number = self.number(value);
        if self.name.is_empty() { number } else { format!("{number} {}", self.name) }
    }

    /// Converts an upper bound to this unit, and rounds it up so that it remains an upper bound.
    pub fn upper(self, bound: f64) -> f64 {
        if self.size == 1.0 {
            bound
        } else {
            (bound / self.size * (1.0 + 4.0 * f64::EPSILON)).next_up()
        }
    }

    /// Returns the exponent n if the size of this unit is 10ⁿ; otherwise `None`.
    pub fn power_of_ten(self) -> Option<i32> {
        let text = format!("{:e}", self.size);
        text.strip_prefix("1e").and_then(|power| power.parse().ok())
    }

    /// Returns this unit with the given number of digits.
    pub fn with_digits(self, digits: usize) -> Self {
        Unit { digits, ..self }
    }

    /// Returns this unit with the number of digits for printed inputs, which is at least six.
    pub fn of_input(self) -> Self {
        self.with_digits(self.digits.max(INPUT_DIGITS))
    }

    /// Returns a space and the name of the unit in brackets, such as ` [kN]`; empty for numbers without a
    /// unit.
    pub fn bracketed(self) -> String {
        if self.name.is_empty() { String::new() } else { format!(" [{}]", self.name) }
    }
}

/// Names of the units of a duration.
const TIMES: [&str; 3] = ["µs", "ms", "s"];

/// Formats a duration with a suitable unit.
pub fn duration(seconds: f64) -> String {
    let [micro, milli, whole] = TIMES;
    if seconds < 1e-3 {
        format!("{:.0} {micro}", seconds * 1e6)
    } else if seconds < 1.0 {
        format!("{} {milli}", significant(seconds * 1e3, 2))
    } else {
        format!("{} {whole}", significant(seconds, 3))
    }
}

/// All units that may follow a number.
pub fn units() -> impl Iterator<Item = &'static str> {
    let metric = |kind: &Kind| kind.ladder().iter().chain(kind.technical().unwrap_or_default());
    let of_quantities = Kind::ALL.iter().flat_map(metric).map(|rung| rung.name);
    of_quantities.chain(us::names()).chain(TIMES)
}

/// Whether this text is the name of a unit, or the first word of the name of a unit. A suffix `/rad` is
/// ignored.
pub fn is_unit(words: &str) -> bool {
    let words = words.strip_suffix("/rad").unwrap_or(words);
    units().any(|unit| unit == words || unit.split(' ').next() == Some(words))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_have_customary_units() {
        let cases = [
            (Kind::Force, 600e3, "600 kN"),
            (Kind::Force, -12.5, "−12.5 N"),
            (Kind::Force, 1.44e6, "1440 kN"),
            (Kind::Force, 2.5e8, "250 MN"),
            (Kind::Force, 12_345_678.0, "12350 kN"),
            (Kind::Deflection, 2e-3, "2 mm"),
            (Kind::Deflection, 0.2, "200 mm"),
            (Kind::Deflection, 3e-13, "3e−13 m"),
            (Kind::BendingStiffness, 1.2e9, "1.2 GN m²"),
            (Kind::Spring, 40e6, "40 MN/m²"),
            (Kind::Constant, 9e6, "9 MN"),
            (Kind::Moment, 0.0, "0 kN m"),
        ];
        for (kind, value, text) in cases {
            assert_eq!(Units::SI.write(kind, value), text);
        }
        assert_eq!(Units::PLAIN.write(Kind::Force, 600e3), "600000");
        assert_eq!(Units::SI.of_input().write(Kind::Force, 123_456.0), "123.456 kN");
        assert_eq!(Units::SI.with_digits(8).of_input().digits(), 8);
    }

    /// The units of `length`, a point load, a gap and `k` determine the printed units.
    #[test]
    fn printed_units_follow_the_units_of_the_file() {
        let file = |length: &str, load: &str, k: &str| {
            let text = format!(
                "[beam]\nlength = {length}\nE = '30 GPa'\nI = '0.01 m^4'\n[foundation]\nk = '{k}'\n\
                 [[load]]\npoint = '{load}'\nat = 0\n[[gap]]\nat = 0\nvalue = '0.001 in'\n"
            );
            crate::parse(&text).unwrap().printed
        };
        let us = file("'12 ft'", "5 kip", "100 ksf");
        let printed = [
            us.write(Kind::Position, 3.048),
            us.write(Kind::Deflection, 0.0254),
            us.write(Kind::Force, 44_482.216_152_605),
            us.write(Kind::Moment, 1_355.817_948_331_4),
            us.write(Kind::Spring, 4_788_025.898_034),
            us.write(Kind::Slope, 2e-3),
        ];
        assert_eq!(printed, ["10 ft", "1 in", "10 kip", "1 kip-ft", "100 ksf", "2 mrad"]);
        assert_eq!(
            file("'12 ft'", "5 kip", "500 psi").write(Kind::Spring, 6_894_757.293),
            "1000 psi"
        );
        assert_eq!(
            file("'12 in'", "5 lbf", "500 psi").write(Kind::Force, 4_448.221_615),
            "1000 lbf"
        );
        assert_eq!(file("'12 m'", "5 kN", "40 MN/m^2"), Units::SI);
        let technical = file("'12 m'", "5 tf", "40 tf/m^2");
        assert_eq!(technical.write(Kind::Moment, 98_066.5), "10 tf m");
    }
}
