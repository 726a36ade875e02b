//! A kind of quantity that a key expects: its dimension, units, sign and plausible range.

use crate::demand::{Place, Sign};
use crate::print;
use crate::unit::Dimension;

/// A kind of quantity that a key expects.
#[derive(Debug, PartialEq)]
pub(crate) struct Kind {
    /// Description of the quantity with an article, such as "a length".
    pub what: &'static str,
    pub dimension: Dimension,
    /// Example of a valid value in a file.
    pub example: &'static str,
    /// Unit that a hint suggests for a number without a unit.
    pub unit: &'static str,
    /// Signs that the quantity may have.
    pub sign: Sign,
    /// Body on which a position must lie, the beam or the ground; `None` for other quantities.
    pub place: Option<Place>,
    /// Kind of printed quantity that has the units of this quantity; `None` if this quantity is not
    /// printed.
    pub printed: Option<print::Kind>,
    /// Plausible range of the quantity in SI units, and a text that states this range.
    pub plausible: Option<([f64; 2], &'static str)>,
    /// Hints for quantities of another dimension that users may give by mistake.
    pub(super) mistaken: &'static [(Dimension, &'static str)],
}

/// Creates a kind of quantity that may have any sign, is not a position and is not printed.
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

    /// Whether a value of this dimension is accepted. A radian is dimensionless, so a quantity per angle
    /// may be given without the radian.
    pub(super) fn accepts(&self, dimension: Dimension) -> bool {
        dimension == self.dimension
            || (dimension.angle == 0 && Dimension { angle: 0, ..self.dimension } == dimension)
    }

    /// Returns an example of a valid line for `key`. `plain` is true for a file without units.
    pub fn line(&self, key: &str, plain: bool) -> String {
        format!("{key} = {}", self.value(plain))
    }

    /// Returns an example of a valid value as written in a file.
    pub fn value(&self, plain: bool) -> String {
        match self.example.split_once(' ') {
            Some((number, _)) if plain => number.to_owned(),
            _ => format!("\"{}\"", self.example),
        }
    }

    /// Returns an example of a list of two valid values, the first of which is 0.
    pub fn pair(&self, plain: bool) -> String {
        let zero = if plain { "0".to_owned() } else { format!("\"0 {}\"", self.unit) };
        format!("[{zero}, {}]", self.value(plain))
    }

    /// Returns the hint for a value that is not a quantity of this kind.
    pub fn advice(&self, key: &str, plain: bool) -> String {
        let what = if plain { "a number" } else { "a number and its unit" };
        format!("write {what}, as in {}", self.line(key, plain))
    }
}
