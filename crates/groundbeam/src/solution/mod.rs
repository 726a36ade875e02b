//! A certified solution: fields at every position, reactions, extremes and lift-off.

pub(crate) mod assemble;
pub(crate) mod candidate;
pub(crate) mod certificate;
mod claim;
pub(crate) mod extremes;
pub(crate) mod field;
mod field_bounds;
pub(crate) mod fields;
pub(crate) mod hinges;
pub(crate) mod lift_off;
pub(crate) mod solution;
mod turning_points;

pub use crate::model::support::Reaction;
pub use certificate::Certificate;
pub use field::{ByField, Dimension, Field};
pub use fields::{ConcentratedForce, ContactZone, EndForces, Extreme, Fields, Range, Side};
pub use hinges::HingeTurn;
pub use lift_off::LiftOff;
pub use solution::Solution;
