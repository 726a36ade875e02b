//! Units: symbols, how they combine, and what they measure.
//!
//! Written for this file format rather than taken from a general unit calculator: those bring
//! large tables and an expression language, accept far more than a quantity, and do not tell
//! which characters are at fault. A force, a length and an angle are all that is needed here.

mod dimension;
mod expression;
mod feet;
mod marks;
mod scale;
mod symbol;

pub(crate) use dimension::Dimension;
pub(crate) use expression::Unit;
pub(crate) use feet::feet_and_inches;
pub(crate) use marks::Marks;
pub(crate) use scale::Scale;
