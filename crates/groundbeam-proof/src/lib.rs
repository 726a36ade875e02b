//! Proof of an answer: bounds of the distance of a claimed deflection, contact set and forces from the exact solution.
//!
//! The model is a beam in unilateral contact with a Winkler or Pasternak foundation. The proof does not depend on the
//! method that found the answer. `docs/proof.md` states the theorem.

#![forbid(unsafe_code)]
// The code writes `!(a <= b)` to refuse NaN; `a > b` would accept NaN.
#![allow(clippy::neg_cmp_op_on_partial_ord)]

mod anchors;
mod answer;
mod approach;
mod arc;
mod balance;
mod balance_energy;
mod ball;
mod beside;
mod bounds;
mod clearance;
mod coefficient;
mod compression;
mod contact;
mod contact_set;
mod cuts;
mod decimal;
mod deflection;
mod document;
mod edge_forces;
mod enclosing;
mod energies;
mod estimate;
mod extremes;
mod fields;
mod float;
mod frame;
mod given;
mod given_claim;
mod ground;
mod held;
mod idle;
mod json;
mod json_object;
mod kinds;
mod lemmas;
mod listed;
mod listed_objects;
mod log;
mod model;
mod outside;
mod patches;
mod pointwise;
mod polynomial;
mod positions;
mod pressure;
mod proof;
#[cfg(test)]
mod random;
mod reactions;
mod read;
mod refusal;
mod residual;
mod resting;
mod rough_contact;
mod scalar;
mod scales;
mod shear_force;
mod shearing;
mod size;
mod springs;
mod stability;
mod stored_ground;
mod test_functions;
mod unique;
mod units;
mod values;
mod varying_shear;
mod verification;
mod wide;

pub use answer::{Answer, Force, Piece, Reaction};
pub use ball::Ball;
pub use bounds::{Bound, Bounds, ReactionBound, Scales};
pub use contact_set::{ContactForce, ContactRegion, ContactSet};
pub use document::{Document, Extreme};
pub use enclosing::{Enclosing, prove, read_model, verify, verify_and_log};
pub use estimate::{Estimate, estimate};
pub use extremes::PlacedExtreme;
pub use json::JsonError;
pub use listed::{Checked, ListedErrors};
pub use log::Log;
pub use model::{
    Action, Acts, Beam, BeamSegment, Course, Extent, GapCorner, Ground, GroundEnd, GroundSegment,
    Hinge, Load, Model, Support, SupportKind,
};
pub use proof::Proof;
pub use read::{ReadError, Reason};
pub use refusal::NotProven;
pub use scalar::Scalar;
pub use verification::Verification;
pub use wide::Wide;
