//! A kind of quantity that a key expects: its dimension, units, sign and plausible range.

use crate::demand::{Place, Sign};
use crate::print;
use crate::unit::Dimension;

/// A kind of quantity that a key expects.
#[derive(Debug, PartialEq)]
pub(crate) struct Kind {
    /// Its description with an article.
    pub what: &'static str,
    pub dimension: Dimension,
    /// A valid value in a file.
    pub example: &'static str,
    /// The unit suggested after a number without one.
    pub unit: &'static str,
    /// Signs that its number may have.
    pub sign: Sign,
    /// For a position, the body on which it lies; otherwise `None`.
    pub place: Option<Place>,
    /// The kind of printed quantity with the same units; `None` for quantities that are not printed.
    pub printed: Option<print::Kind>,
    /// Plausible range in SI units, and the rule in words.
    pub plausible: Option<([f64; 2], &'static str)>,
    /// Hints for quantities of another dimension that users may give by mistake.
    pub(super) mistaken: &'static [(Dimension, &'static str)],
}

/// A kind of quantity of any sign that is not a position and is not printed.
pub(super) const fn kind(
    what: &'static str,
    dimension: Dimension,
    example: &'static str,
    unit: &'static str,
    mistaken: &'static [(Dimension, &'static str)],
) -> Kind {
    let (sign, place, printed, plausible) = (Sign::Any, None, None, None);
    Kind { what, dimension, example, unit, sign, place, printed, plausible, mistaken }
}

impl Kind {
    pub(super) const fn sign(self, sign: Sign) -> Kind {
        Kind { sign, ..self }
    }

    pub(super) const fn on(self, place: Place) -> Kind {
        Kind { place: Some(place), ..self }
    }

    pub(super) const fn plausible(self, sizes: [f64; 2], rule: &'static str) -> Kind {
        Kind { plausible: Some((sizes, rule)), ..self }
    }

    pub(super) const fn printed_as(self, kind: print::Kind) -> Kind {
        Kind { printed: Some(kind), ..self }
    }

    /// A radian is dimensionless, so quantities per angle may be given without it.
    pub(super) fn accepts(&self, dimension: Dimension) -> bool {
        dimension == self.dimension
            || (dimension.angle == 0 && Dimension { angle: 0, ..self.dimension } == dimension)
    }

    /// A valid line of a file for `key`; `plain` means a file without units.
    pub fn line(&self, key: &str, plain: bool) -> String {
        format!("{key} = {}", self.value(plain))
    }

    /// A valid value as written in a file.
    pub fn value(&self, plain: bool) -> String {
        match self.example.split_once(' ') {
            Some((number, _)) if plain => number.to_owned(),
            _ => format!("\"{}\"", self.example),
        }
    }

    /// A list of two valid values, the first of which is 0.
    pub fn pair(&self, plain: bool) -> String {
        let zero = if plain { "0".to_owned() } else { format!("\"0 {}\"", self.unit) };
        format!("[{zero}, {}]", self.value(plain))
    }

    /// Hint where this quantity is expected and another value is given.
    pub fn advice(&self, key: &str, plain: bool) -> String {
        let what = if plain { "a number" } else { "a number and its unit" };
        format!("write {what}, as in {}", self.line(key, plain))
    }
}
