//! Beams on ground that can only push back.
//!
//! The unilateral contact of a bending beam with a Pasternak foundation, after N. Kikuchi, *Beam bending
//! problems on a Pasternak foundation using reciprocal variational inequalities* (1980), whose equation
//! numbers are used throughout.

#![forbid(unsafe_code)]
#![deny(missing_docs)]

mod assemble;
mod certificate;
mod chain;
mod contact;
mod elements;
mod existence;
mod ground;
mod mesh;
mod polynomial;
mod solution;
mod solve;
mod stability;

pub mod model;

pub use certificate::Certificate;
pub use contact::active_set::{Pressure, Step};
pub use existence::{Existence, RigidMotion, Verdict};
pub use model::{
    Beam, BeamSegment, Foundation, FoundationSegment, GapPoint, Load, Model, Support, SupportKind,
};
pub use solution::{
    ConcentratedForce, ContactRegion, EndForces, Extreme, Field, Fields, LiftOff, Range, Reaction,
    Side, Solution,
};
pub use solve::{Error, Method, NotConverged, Options, Outcome, Start, exists, solve, solve_with};
pub use stability::own_buckling_load;
