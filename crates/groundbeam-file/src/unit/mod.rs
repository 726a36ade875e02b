//! Parses the units of quantities: symbols, combinations of symbols, and their dimensions.
//!
//! A general unit library would accept many other units and would not report which characters are wrong.

mod dimension;
mod expression;
mod feet;
mod marks;
mod scale;
mod symbol;

pub(crate) use dimension::Dimension;
pub(crate) use expression::Unit;
pub(crate) use feet::{decimal_length, feet_and_inches};
pub(crate) use marks::Marks;
pub(crate) use scale::Scale;
