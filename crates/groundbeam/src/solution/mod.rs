//! A certified solution: fields everywhere, reactions, extremes, lift-off.

pub(crate) mod assemble;
pub(crate) mod candidate;
pub(crate) mod certificate;
mod claim;
pub(crate) mod extremes;
pub(crate) mod field;
pub(crate) mod fields;
pub(crate) mod hinges;
pub(crate) mod lift_off;
pub(crate) mod solution;
