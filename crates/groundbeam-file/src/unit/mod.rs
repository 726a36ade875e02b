//! Parses units: symbols, their combination, and their dimension.
//!
//! A model needs only forces, lengths, angles and temperature differences. General unit libraries accept far
//! more than a quantity and do not report which characters are wrong.

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
