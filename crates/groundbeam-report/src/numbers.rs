//! The numbers of one solution in print: rounded to six digits, or with the bounds of their errors if they are proven.

use crate::number::{above, without_trailing_zeros};
use crate::quantity::{Kind, Unit, Units};
use crate::size::Sizes;
use crate::verified::Named;
use groundbeam::proof::{Bound, PlacedExtreme, ReactionBound, Verification};
use groundbeam::{Extreme, Field, Solution};

/// Digits of a number without a bound.
const DIGITS: usize = 6;

/// Wider intervals of the place of an extreme, as a part of the length, are printed as intervals.
const NARROW: f64 = 1e-3;

/// Writes the numbers of one solution.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Numbers<'a> {
    pub units: Units,
    sizes: Sizes,
    /// What is proven of the solution; none if nobody asked.
    proof: Option<&'a Named>,
}

impl<'a> Numbers<'a> {
    /// Numbers without bounds.
    pub fn plain(solution: &Solution, units: Units) -> Self {
        Numbers { units, sizes: Sizes::of(solution), proof: None }
    }

    /// Numbers with the bounds of a proof, if there is one.
    pub fn with_proof(self, proof: Option<&'a Named>) -> Self {
        Numbers { proof, ..self }
    }

    /// Whether the numbers have bounds.
    pub fn have_bounds(&self) -> bool {
        self.proof.is_some()
    }

    pub fn sizes(&self) -> &Sizes {
        &self.sizes
    }

    /// A number in a unit, with the bound of its error if one is asked for. `rounded` is what is printed without a bound.
    fn write(
        &self,
        unit: Unit,
        value: f64,
        rounded: f64,
        error: impl Fn(&Verification) -> f64,
    ) -> String {
        match self.proof {
            None => unit.write(rounded, DIGITS),
            Some(named) => {
                let error = named.found.as_ref().map_or(f64::INFINITY, error);
                with_bound(value, error, unit)
            }
        }
    }

    /// The value of a field, in its own unit or in one that is given.
    pub fn field(&self, field: Field, value: f64, unit: Option<Unit>) -> String {
        let unit = unit.unwrap_or_else(|| self.units.unit(Kind::of(field), value));
        let rounded = self.sizes.value(field, value);
        self.write(unit, value, rounded, |found| error_of(found, field))
    }

    /// The place of an extreme.
    pub fn place(&self, x: f64) -> String {
        self.units.position(self.sizes.position(x))
    }

    /// The place of an extreme, with the bound of its error, or the interval that holds it.
    pub fn place_of(&self, field: Field, is_max: bool, x: f64) -> String {
        let found = self.proof.and_then(|named| named.found.as_ref().ok());
        let placed = found.and_then(|found| {
            let same = |e: &&PlacedExtreme| e.field == field.name() && e.is_max == is_max;
            found.extremes.iter().find(same)
        });
        let Some((placed, [low, high])) = placed.and_then(|p| Some((p, p.nearest()?))) else {
            return self.place(x);
        };
        let unit = self.units.unit(Kind::Position, x);
        let place = match high - low <= NARROW * self.sizes.length() {
            true => with_bound(x, placed.error(), unit),
            false => {
                format!("{} ({} to {})", self.place(x), unit.number(low, 4), unit.write(high, 4))
            }
        };
        match placed.places.len() {
            1 => place,
            _ => format!("{place} or elsewhere"),
        }
    }

    /// One end of a region of contact.
    pub fn edge(&self, region: usize, end: usize, x: f64) -> String {
        let unit = self.units.unit(Kind::Position, x);
        let error = |found: &Verification| of(found.listed.edges.get(region).map(|ends| ends[end]));
        self.write(unit, x, self.sizes.position(x), error)
    }

    /// The force under an end of the beam, 0 the left one.
    pub fn end_force(&self, end: usize, force: f64) -> String {
        let error = |found: &Verification| of(found.listed.end_forces.map(|ends| ends[end]));
        self.force(force, error)
    }

    /// One of the concentrated forces inside the beam. In documents those under the ends stand beside them.
    pub fn inner_force(&self, i: usize, force: f64) -> String {
        self.force(force, |found| of(found.listed.forces.get(i + 1).copied()))
    }

    /// The force of a support.
    pub fn reaction(&self, support: usize, force: f64) -> String {
        self.force(force, |found| reaction(found, support, |bound| bound.force))
    }

    /// The moment of a support.
    pub fn reaction_moment(&self, support: usize, moment: f64) -> String {
        let unit = self.units.unit(Kind::Moment, moment);
        let error = |found: &Verification| reaction(found, support, |bound| bound.moment);
        self.write(unit, moment, self.sizes.moment(moment), error)
    }

    fn force(&self, force: f64, error: impl Fn(&Verification) -> f64) -> String {
        let unit = self.units.unit(Kind::Force, force);
        self.write(unit, force, self.sizes.force(force), error)
    }

    /// Rotation and moment of a hinge.
    pub fn hinge(&self, i: usize, rotation: f64, moment: f64) -> [String; 2] {
        let error = |which: usize| {
            move |found: &Verification| of(found.listed.hinges.get(i).map(|hinge| hinge[which]))
        };
        let [turn, bend] = [(Kind::Slope, rotation), (Kind::Moment, moment)]
            .map(|(kind, x)| self.units.unit(kind, x));
        [
            self.write(turn, rotation, self.sizes.value(Field::Slope, rotation), error(0)),
            self.write(bend, moment, self.sizes.moment(moment), error(1)),
        ]
    }

    /// An extreme without what is rounding; with bounds as it is.
    pub fn extreme(&self, field: Field, extreme: Extreme) -> Extreme {
        if self.have_bounds() { extreme } else { self.sizes.extreme(field, extreme) }
    }
}

/// A bound, infinite if there is none.
fn of(error: Option<f64>) -> f64 {
    error.unwrap_or(f64::INFINITY)
}

fn reaction(
    found: &Verification,
    support: usize,
    of_bound: impl Fn(&ReactionBound) -> Bound,
) -> f64 {
    of(found.proof.reactions.get(support).map(|bound| of_bound(bound).error))
}

/// The bound of the error of a field.
fn error_of(found: &Verification, field: Field) -> f64 {
    let named = found.named();
    of(named.iter().find(|(name, _)| *name == field.name()).map(|(_, bound)| bound.error))
}

/// Significant digits that a double can have.
const MOST_DIGITS: i32 = 17;

/// A number with a bound of its error, in a unit: `14.226133301 ± 1.3e-9 mm`. Without a finite bound it is rounded to six
/// digits and said to be not proven.
///
/// |printed − exact| is at most the printed bound: that of the number, and the half of its last printed digit, rounded up.
/// So many digits are printed that the second part is at most a twentieth of the first, as far as a double has digits.
fn with_bound(value: f64, error: f64, unit: Unit) -> String {
    if !(value.is_finite() && error.is_finite()) {
        return format!("{} (not proven)", unit.write(value, 6));
    }
    let power = unit.size.log10().round() as i32;
    let (number, rounding) = match error {
        0.0 => (shifted(&format!("{value:e}"), power), 0.0),
        _ => rounded_within(value, exponent(error) - 1, power),
    };
    let bound = match error + rounding {
        0.0 => "0".to_owned(),
        sum => shifted(&above(sum.next_up()), power),
    };
    let unit = if unit.name.is_empty() { String::new() } else { format!(" {}", unit.name) };
    format!("{number} ± {bound}{unit}")
}

/// A number rounded to the digit of 10ⁿ, in units of 10ᵖ, and a bound of what rounding changes.
fn rounded_within(value: f64, last: i32, power: i32) -> (String, f64) {
    let leading = exponent(value);
    let digits = (leading - last + 1).min(MOST_DIGITS);
    if value == 0.0 || digits < 1 {
        return ("0".to_owned(), value.abs());
    }
    let number = shifted(&format!("{value:.*e}", digits as usize - 1), power);
    let half: f64 = format!("5.1e{}", leading - digits).parse().unwrap_or(f64::INFINITY);
    (number, half)
}

/// The exponent n of a number a·10ⁿ, 1 ≤ a < 10.
fn exponent(value: f64) -> i32 {
    let written = format!("{value:e}");
    written.split_once('e').and_then(|(_, exponent)| exponent.parse().ok()).unwrap_or(0)
}

/// A decimal `1.25e-9` divided by 10ᵖ, without rounding: its digits stay as they are.
fn shifted(scientific: &str, power: i32) -> String {
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((scientific, "0"));
    let exponent = exponent.parse::<i32>().unwrap_or(0) - power;
    let mantissa = without_trailing_zeros(mantissa);
    let (sign, mantissa) = mantissa.strip_prefix('-').map_or(("", mantissa), |size| ("-", size));
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
        _ => format!("{sign}{mantissa}e{exponent}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_with_their_bounds() {
        let plain = Unit { name: "", size: 1.0 };
        let (mm, kn) = (Unit { name: "mm", size: 1e-3 }, Unit { name: "kN", size: 1e3 });
        let cases = [
            (0.811_326_256_449_155, 2.0e-13, plain, "0.81132625644916 ± 2.1e-13"),
            (0.014_226_133_301, 1.21e-12, mm, "14.226133301 ± 1.3e-9 mm"),
            (-412_884.319_872_345, 1e-9, kn, "-412.884319872345 ± 1.1e-12 kN"),
            (3.4e-13, 1e-15, plain, "3.4e-13 ± 1.1e-15"),
            (3.4e-17, 1e-15, plain, "0 ± 1.1e-15"),
            (0.0, 0.0, plain, "0 ± 0"),
            (0.5, 0.0, plain, "0.5 ± 0"),
            (2.0 / 3.0, 1e-30, plain, "0.66666666666666663 ± 5.2e-18"),
            (0.123_4, 0.5, plain, "0.12 ± 0.51"),
            (12.5, f64::INFINITY, kn, "0.0125 kN (not proven)"),
        ];
        for (value, error, unit, text) in cases {
            assert_eq!(with_bound(value, error, unit), text);
        }
    }
}
