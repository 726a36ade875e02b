//! Reads the values of a table: numbers with units, lists of numbers along a stretch, and texts.

use super::error::{Fault, Read, Reason, fault, out_of_range, wrong};
use super::feet;
use super::number::Decimal;
use super::toml::{Node, Table, Value};
use super::unit::{Dimension, Exact, Factor, Unit};
use crate::{Course, Scalar};

/// Maximum number of tables in a list.
const MOST_TABLES: usize = 100_000;

/// A table and its position in the file.
#[derive(Clone, Copy)]
pub(crate) struct Section<'t> {
    pub table: &'t Table,
    pub at: usize,
}

/// The dimension and the range that a key requires.
#[derive(Clone, Copy)]
pub(crate) struct Kind {
    dimension: Dimension,
    range: Range,
}

#[derive(Clone, Copy, PartialEq)]
enum Range {
    Any,
    NotNegative,
    Positive,
}

const fn any(dimension: Dimension) -> Kind {
    Kind { dimension, range: Range::Any }
}

const fn positive(dimension: Dimension) -> Kind {
    Kind { dimension, range: Range::Positive }
}

const fn not_negative(dimension: Dimension) -> Kind {
    Kind { dimension, range: Range::NotNegative }
}

pub(crate) const POSITION: Kind = any(Dimension::of(0, 1));
pub(crate) const DEFLECTION: Kind = any(Dimension::of(0, 1));
pub(crate) const LENGTH: Kind = positive(Dimension::of(0, 1));
/// The radius of a fillet. A section without fillets has the radius zero.
pub(crate) const FILLET: Kind = not_negative(Dimension::of(0, 1));
pub(crate) const AREA: Kind = positive(Dimension::of(0, 2));
pub(crate) const SECOND_MOMENT: Kind = positive(Dimension::of(0, 4));
pub(crate) const FORCE: Kind = any(Dimension::of(1, 0));
pub(crate) const MOMENT: Kind = any(Dimension::of(1, 1));
pub(crate) const FORCE_PER_LENGTH: Kind = any(Dimension::of(1, -1));
pub(crate) const MODULUS: Kind = positive(Dimension::of(1, -2));
pub(crate) const BENDING_STIFFNESS: Kind = positive(Dimension::of(1, 2));
pub(crate) const SHEAR_STIFFNESS: Kind = positive(Dimension::of(1, 0));
pub(crate) const SUBGRADE_MODULUS: Kind = positive(Dimension::of(1, -3));
pub(crate) const UNIT_WEIGHT: Kind = positive(Dimension::of(1, -3));
pub(crate) const GROUND_SHEAR: Kind = not_negative(Dimension::of(1, 0));
pub(crate) const AREA_SHEAR: Kind = not_negative(Dimension::of(1, -1));
pub(crate) const SPRING: Kind = not_negative(Dimension::of(1, -1));
pub(crate) const ROTATIONAL_SPRING: Kind = not_negative(Dimension::of(1, 1).with_angle(-1));
pub(crate) const CURVATURE: Kind = any(Dimension::of(0, -1).with_angle(1));
pub(crate) const TEMPERATURE: Kind = any(Dimension::NONE.with_temperature(1));
pub(crate) const EXPANSION: Kind = positive(Dimension::NONE.with_temperature(-1));
pub(crate) const NUMBER: Kind = any(Dimension::NONE);
pub(crate) const POSITIVE_NUMBER: Kind = positive(Dimension::NONE);

/// A quantity: its value in m, N, rad and K, its exact value in the unit of the file, and its position in the file.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Quantity<S> {
    pub value: S,
    pub exact: Exact,
    pub at: usize,
}

/// Number of values that a list may have.
#[derive(Clone, Copy)]
pub(crate) enum Values {
    /// One value for a constant, or two values for a linear function.
    Linear,
    /// The Bernstein coefficients of a polynomial, at most this many values.
    Curve(usize),
}

/// A quantity along a stretch, as a polynomial. If the file gives a constant, `exact` is this constant without rounding
/// error. `at` is the position in the file.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Along<S> {
    pub course: Course<S>,
    pub exact: Option<Exact>,
    pub at: usize,
}

/// Reads quantities. Either every nonzero quantity of a file has a unit, or no quantity has a unit. The first
/// quantity of the file decides which rule applies.
#[derive(Default)]
pub(crate) struct Fields {
    has_units: Option<bool>,
}

impl<'t> Section<'t> {
    /// Refuses every key that is not in `known`. A key in `foreign` is refused as one that this reader does not support.
    pub fn only(&self, known: &[&[&str]], foreign: &[&'static str]) -> Read<()> {
        for (key, at, _) in self.table.entries() {
            if let Some(key) = foreign.iter().find(|foreign| **foreign == key) {
                return fault(at, Reason::NotRead(key));
            }
            if !known.iter().any(|keys| keys.contains(&key)) {
                return fault(at, Reason::Unknown(key.to_owned()));
            }
        }
        Ok(())
    }

    /// The table under a key.
    pub fn table(&self, key: &str) -> Read<Option<Section<'t>>> {
        let Some(node) = self.table.get(key) else { return Ok(None) };
        match &node.value {
            Value::Table(table) => Ok(Some(Section { table, at: node.at })),
            _ => wrong(node.at, format!("`{key}` must be a table")),
        }
    }

    /// The tables of a list; an empty list if the key is missing.
    pub fn tables(&self, key: &str) -> Read<Vec<Section<'t>>> {
        let Some(node) = self.table.get(key) else { return Ok(Vec::new()) };
        let (Value::Tables(list) | Value::List(list)) = &node.value else {
            return wrong(node.at, format!("`{key}` must be a list of tables"));
        };
        if list.len() > MOST_TABLES {
            return fault(node.at, Reason::TooLarge);
        }
        let section = |node: &'t Node| match &node.value {
            Value::Table(table) => Ok(Section { table, at: node.at }),
            _ => wrong(node.at, format!("`{key}` must be a list of tables")),
        };
        list.iter().map(section).collect()
    }

    /// The text under a key, with its position.
    pub fn words(&self, key: &str) -> Read<Option<(&'t str, usize)>> {
        let Some(node) = self.table.get(key) else { return Ok(None) };
        match &node.value {
            Value::Text(text) => Ok(Some((text, node.at))),
            _ => wrong(node.at, format!("`{key}` is a text")),
        }
    }

    /// Refuses a table that contains both the key `a` and the key `b`.
    pub fn exclusive(&self, a: &'static str, b: &'static str) -> Read<()> {
        match (self.table.place(a), self.table.place(b)) {
            (Some(_), Some(at)) => fault(at, Reason::Together(a, b)),
            _ => Ok(()),
        }
    }

    /// Refuses `key`, which is not allowed together with the key `with`.
    pub fn without(&self, key: &'static str, with: &'static str) -> Read<()> {
        match self.table.place(key) {
            Some(at) => fault(at, Reason::Together(with, key)),
            None => Ok(()),
        }
    }

    /// Returns the error for a missing key.
    pub fn missing<T>(&self, key: &'static str) -> Read<T> {
        fault(self.at, Reason::Missing(key))
    }
}

impl Fields {
    /// The quantity under a key.
    pub fn quantity<S: Scalar>(
        &mut self,
        section: Section,
        key: &str,
        kind: Kind,
    ) -> Read<Option<Quantity<S>>> {
        section.table.get(key).map(|node| self.one(node, key, kind)).transpose()
    }

    /// The quantity under a required key.
    pub fn required<S: Scalar>(
        &mut self,
        section: Section,
        key: &'static str,
        kind: Kind,
    ) -> Read<Quantity<S>> {
        self.quantity(section, key, kind)?.map_or_else(|| section.missing(key), Ok)
    }

    /// A quantity along a stretch: one value or a list.
    pub fn along<S: Scalar>(
        &mut self,
        section: Section,
        key: &str,
        kind: Kind,
        values: Values,
    ) -> Read<Option<Along<S>>> {
        let Some(node) = section.table.get(key) else { return Ok(None) };
        let Value::List(list) = &node.value else {
            let Quantity { value, exact, at } = self.one(node, key, kind)?;
            return Ok(Some(Along { course: Course::Constant(value), exact: Some(exact), at }));
        };
        let most = match values {
            Values::Linear => 2,
            Values::Curve(most) => most,
        };
        if list.len() < 2 || list.len() > most {
            return wrong(node.at, format!("`{key}` must have 1 to {most} values"));
        }
        let mut all: Vec<Quantity<S>> = Vec::new();
        for node in list {
            all.push(self.one(node, key, kind)?);
        }
        let at = node.at;
        Ok(Some(match &all[..] {
            [first, rest @ ..] if rest.iter().all(|other| other.exact == first.exact) => {
                let course = Course::Constant(first.value);
                Along { course, exact: Some(first.exact.clone()), at }
            }
            _ => {
                let values = all.iter().map(|quantity| quantity.value).collect();
                Along { course: Course::Varying(values), exact: None, at }
            }
        }))
    }

    /// Reads a quantity that varies linearly along a stretch, and returns its values at both ends. The file has one
    /// value for both ends, or a list of two values.
    pub fn pair<S: Scalar>(&mut self, node: &Node, key: &str, kind: Kind) -> Read<[S; 2]> {
        let Value::List(list) = &node.value else {
            let value = self.one(node, key, kind)?.value;
            return Ok([value; 2]);
        };
        let [start, end] = &list[..] else {
            return wrong(node.at, format!("`{key}` must have one or two values"));
        };
        Ok([self.one(start, key, kind)?.value, self.one(end, key, kind)?.value])
    }

    /// One quantity.
    pub fn one<S: Scalar>(&mut self, node: &Node, key: &str, kind: Kind) -> Read<Quantity<S>> {
        let at = node.at;
        let (exact, has_unit) = match &node.value {
            Value::Text(text) => written(text, kind, key, at)?,
            Value::Number(text) => match Decimal::whole(text) {
                Some(number) => (Exact::new(number, Factor::ONE), false),
                None => return wrong(at, format!("`{key}` is not a number")),
            },
            _ => return wrong(at, format!("`{key}` must be a number with its unit")),
        };
        if kind.dimension != Dimension::NONE && (has_unit || !exact.is_zero()) {
            self.note(at, has_unit)?;
        }
        let value = value(&exact, kind, key, at)?;
        Ok(Quantity { value, exact, at })
    }

    /// Records whether a quantity has a unit. Refuses a file in which some quantities have units and other nonzero
    /// quantities have none.
    pub fn note(&mut self, at: usize, has_unit: bool) -> Read<()> {
        if *self.has_units.get_or_insert(has_unit) != has_unit {
            return wrong(at, "either every nonzero quantity of a file must have a unit, or none");
        }
        Ok(())
    }
}

/// Reads a text that consists of a number and, if the file has units, a unit.
fn written(text: &str, kind: Kind, key: &str, at: usize) -> Read<(Exact, bool)> {
    let is_length = kind.dimension == Dimension::of(0, 1);
    let inches = feet::inches(text).filter(|_| is_length);
    if let Some(inches) = inches.and_then(|inches| Decimal::whole(&inches)) {
        return Ok((Exact::new(inches, Factor::INCH), true));
    }
    let Some((number, rest)) = Decimal::head(text.trim()) else {
        return wrong(at, format!("`{key}` must begin with a number"));
    };
    let unit = rest.trim();
    if unit.is_empty() {
        return Ok((Exact::new(number, Factor::ONE), false));
    }
    let Some(unit) = Unit::read(unit) else {
        return wrong(at, format!("the unit of `{key}` is not known"));
    };
    if !kind.dimension.accepts(unit.dimension) {
        return wrong(at, format!("the unit of `{key}` belongs to another quantity"));
    }
    Ok((Exact::new(number, unit.factor), true))
}

/// Converts a value to a scalar. Checks that the value has the sign that `kind` requires, and that a nonzero value has
/// a magnitude between 1e-60 and 1e60.
fn value<S: Scalar>(exact: &Exact, kind: Kind, key: &str, at: usize) -> Read<S> {
    let value = exact.value::<S>().filter(|value| exact.is_zero() || is_within_reach(*value));
    let Some(value) = value else {
        return out_of_range(
            at,
            format!("`{key}` must be 0 or have a magnitude between 1e-60 and 1e60"),
        );
    };
    let right = match kind.range {
        Range::Any => true,
        Range::NotNegative => value.low() >= 0.0,
        Range::Positive => value.low() > 0.0,
    };
    if !right {
        return wrong(at, format!("`{key}` must be positive"));
    }
    Ok(value)
}

/// Whether the midpoint of a number's error interval has a magnitude between 1e-60 and 1e60.
pub(crate) fn is_within_reach<S: Scalar>(value: S) -> bool {
    (1e-60..=1e60).contains(&value.middle().abs())
}

/// Reads a quantity, such as `210 GPa`, from the tables of materials and sections in this crate.
pub(crate) fn listed<S: Scalar>(text: &str, kind: Kind) -> Read<Quantity<S>> {
    let (exact, _) = written(text, kind, text, 0)?;
    Ok(Quantity { value: value(&exact, kind, text, 0)?, exact, at: 0 })
}

impl<S: Scalar> Along<S> {
    /// A quantity that is constant on its interval.
    pub fn constant(value: S, at: usize) -> Self {
        Along { course: Course::Constant(value), exact: None, at }
    }

    /// Restricts the quantity to a part of the interval on which it is given. `way` contains the two ends of this part,
    /// as fractions of the length of the interval.
    pub fn between(&self, way: [S; 2]) -> Self {
        Along { course: super::course::between(&self.course, way), ..self.clone() }
    }

    /// The product.
    pub fn times(&self, other: &Along<S>) -> Self {
        let course = super::course::times(&self.course, &other.course);
        Along { course, exact: None, at: self.at }
    }

    /// Whether it is constant.
    pub fn is_constant(&self) -> bool {
        super::course::is_constant(&self.course)
    }

    /// The values at both ends.
    pub fn ends(&self) -> [S; 2] {
        super::course::ends(&self.course)
    }
}

impl Fault {
    /// Moves the fault to another position in the file.
    pub fn moved(self, at: usize) -> Fault {
        Fault { at, ..self }
    }
}
