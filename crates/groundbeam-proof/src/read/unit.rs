//! Units by dimension and exact factor, and numbers with their unit.
//!
//! The factor of a unit is a product of integer powers of ten and of a few constants, so equal powers cancel exactly. A
//! number times a power of ten remains a decimal number.

use super::number::Decimal;
use crate::Scalar;

/// Dimension of a quantity: the exponents of force, length, angle and temperature difference.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Dimension {
    pub force: i32,
    pub length: i32,
    pub angle: i32,
    pub temperature: i32,
}

impl Dimension {
    pub const NONE: Dimension = Dimension::of(0, 0);

    /// The dimension force^`force` × length^`length`.
    pub const fn of(force: i32, length: i32) -> Self {
        Dimension { force, length, angle: 0, temperature: 0 }
    }

    /// This dimension times a power of an angle.
    pub const fn with_angle(self, angle: i32) -> Self {
        Dimension { angle, ..self }
    }

    /// This dimension times a power of a temperature difference.
    pub const fn with_temperature(self, temperature: i32) -> Self {
        Dimension { temperature, ..self }
    }

    fn times(self, other: Dimension, power: i32) -> Option<Self> {
        let add = |a: i32, b: i32| a.checked_add(b.checked_mul(power)?);
        Some(Dimension {
            force: add(self.force, other.force)?,
            length: add(self.length, other.length)?,
            angle: add(self.angle, other.angle)?,
            temperature: add(self.temperature, other.temperature)?,
        })
    }

    /// Whether a quantity of this dimension may have a unit of the dimension `unit`. A radian has the value 1, so
    /// the unit of a quantity per angle may omit the angle.
    pub fn accepts(self, unit: Dimension) -> bool {
        unit == self || unit == self.with_angle(0)
    }
}

/// Each conversion factor is a product of integer powers of these numbers, of ten and of π/180. The inch, the
/// pound-force and the kilogram-force are exact by definition.
const BASES: [&str; 7] = ["0.0254", "12", "3", "4.4482216152605", "9.80665", "1.8", "2"];
/// Exponents of the numbers in `BASES`, followed by the exponent of π/180.
pub(super) type Powers = [i32; 8];
pub(super) const INCH: Powers = [1, 0, 0, 0, 0, 0, 0, 0];
pub(super) const ONE: Powers = [0; 8];
/// Maximum magnitude of the exponent of a number in `BASES`, and of the exponent of π/180.
const HIGHEST: i32 = 50;

/// The factor of a unit: 10^`ten` times powers of the numbers in `BASES` and of π/180.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Factor {
    pub ten: i32,
    pub powers: Powers,
}

impl Factor {
    pub const ONE: Factor = Factor { ten: 0, powers: ONE };
    pub const INCH: Factor = Factor { ten: 0, powers: INCH };

    fn times(self, other: Factor, power: i32) -> Option<Self> {
        let mut product = self;
        product.ten = self.ten.checked_add(other.ten.checked_mul(power)?)?;
        for (mine, its) in product.powers.iter_mut().zip(other.powers) {
            *mine = mine.checked_add(its.checked_mul(power)?)?;
        }
        Some(product).filter(|p| p.powers.iter().all(|power| power.abs() <= HIGHEST))
    }
}

/// The exact value of a quantity. `number` includes the power of ten of the unit, so 25 cm and 0.25 m compare as equal.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Exact {
    number: Decimal,
    /// Exponents of the numbers in `BASES` and of π/180 in the factor of the unit.
    powers: Powers,
}

impl Exact {
    pub fn new(number: Decimal, factor: Factor) -> Self {
        let powers = if number.is_zero() { ONE } else { factor.powers };
        Exact { number: number.shifted(factor.ten), powers }
    }

    pub fn is_zero(&self) -> bool {
        self.number.is_zero()
    }

    /// The value in N, m, rad and K; `None` if the number is outside the range of the scalar.
    pub fn value<S: Scalar>(&self) -> Option<S> {
        let number = S::decimal(&self.number.text())?;
        let (mut above, mut below) = (None, None);
        for (i, power) in self.powers.iter().enumerate() {
            let base = match BASES.get(i) {
                Some(base) => S::decimal(base)?,
                None => pi::<S>()?.div(S::of(180.0)),
            };
            let product = if *power > 0 { &mut above } else { &mut below };
            for _ in 0..power.abs() {
                *product = Some(product.map_or(base, |product: S| product * base));
            }
        }
        let number = above.map_or(number, |above| number * above);
        Some(below.map_or(number, |below| number.div(below)))
    }
}

/// π.
pub(crate) fn pi<S: Scalar>() -> Option<S> {
    S::decimal("3.14159265358979323846264338327950288419716939937510582097494459")
}

/// A unit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Unit {
    pub factor: Factor,
    pub dimension: Dimension,
}

impl Unit {
    pub const ONE: Unit = Unit { factor: Factor::ONE, dimension: Dimension::NONE };

    /// This unit times a power of another unit; `None` if an exponent is too high.
    pub fn times(self, other: Unit, power: i32) -> Option<Unit> {
        let factor = self.factor.times(other.factor, power)?;
        Some(Unit { factor, dimension: self.dimension.times(other.dimension, power)? })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Wide;

    #[test]
    fn equal_numbers_are_equal() {
        let exact = |number: &str, unit: &str| {
            Exact::new(Decimal::whole(number).unwrap(), Unit::read(unit).unwrap().factor)
        };
        assert_eq!(exact("25", "cm"), exact("0.25", "m"));
        assert_eq!(exact("0", "ft"), exact("0.0", "m"));
        assert_ne!(exact("1", "ft"), exact("1", "in"));
        assert_eq!(exact("9.3", "MPa").value::<f64>(), Some(9.3e6));
        assert_eq!(exact("3.6", "in").value::<Wide>().unwrap().middle(), 0.09144);
    }
}
