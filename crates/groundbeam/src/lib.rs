//! Beams in unilateral contact with the ground.
//!
//! The unilateral contact of a bending beam with a Pasternak foundation, with exact and proven solutions.
//!
#![doc = include_str!("../problem.md")]
//!
//! [`solve()`] takes a [`Model`] and returns an [`Outcome`]: a [`Solution`] with its [`Certificate`], or no
//! equilibrium, with the [`RigidMotion`] that proves it. An invalid model gives an [`Error`].
//!
//! ```
//! use groundbeam::{Beam, Field, Foundation, Load, Model, Outcome, solve};
//!
//! // Kikuchi's case IV: a unit force and a moment at the middle, the left end lifts off.
//! let model = Model::new(Beam::uniform(1.0, 1.0), Foundation::pasternak(1.0, 1.0))
//!     .with_load(Load::point_force(0.5, 1.0))
//!     .with_load(Load::point_moment(0.5, 0.49));
//! let Outcome::Equilibrium(solution) = solve(&model)? else { panic!("it tips") };
//! assert_eq!(format!("{:.12}", solution.contact()[0].from), "0.811326256449");
//! assert_eq!(format!("{:.12}", solution.end_forces().right), "0.897199981230");
//! assert_eq!(format!("{:.12}", solution.value(Field::Deflection, 0.0)), "0.013217803941");
//! assert!(solution.certificate().relative_gap() < 1e-12);
//! # Ok::<(), groundbeam::Error>(())
//! ```

#![forbid(unsafe_code)]
#![deny(missing_docs)]

mod cancel;
mod chain;
mod contact;
pub mod derivatives;
mod design;
mod element;
mod envelope;
mod equilibrium;
mod error;
mod existence;
mod ground;
mod load_factors;
mod mesh;
mod nodal;
mod nodal_solver;
mod numeric;
mod options;
mod outcome;
mod solution;
mod solve;
mod solver;
pub mod supported;

pub mod model;
pub mod soil;

pub use crate::existence::verdict::{Buckling, Existence, Local, RigidMotion, Verdict};
pub use crate::solution::certificate::Certificate;
pub use crate::solution::field::{ByField, Dimension, Field};
pub use crate::solution::fields::{
    ConcentratedForce, ContactZone, EndForces, Extreme, Fields, Range, Reaction, Side,
};
pub use cancel::Cancel;
pub use design::checks::{Beside, Check, Checked, Limits, overturning};
pub use design::limit_states::{LimitState, LimitStates};
pub use envelope::{Bound, Bounds, Change, Envelope, Governing};
pub use equilibrium::buckling::own_buckling_load;
pub use equilibrium::size::{check_memory, memory_estimate};
pub use error::{Error, NotConverged, Stopped, TooLarge};
pub use existence::existence::static_reactions_of as static_reactions;
pub use load_factors::parts::{FirstLiftOff, LossOfEquilibrium};
pub use load_factors::{LoadFactors, load_factors, load_factors_with};
pub use model::{
    Action, Acts, Beam, BeamSegment, Extent, Foundation, FoundationSegment, GapPoint, GroundEnd,
    Hinge, Load, Model, Profile, Support, SupportKind,
};
pub use nodal::newton::Work;
pub use nodal::solution::{NodalCheck, NodalSolution};
pub use nodal_solver::NodalSolver;
pub use numeric::step::Step;
pub use options::{Method, Options, Start};
pub use outcome::Outcome;
pub use solution::hinges::HingeTurn;
pub use solution::lift_off::LiftOff;
pub use solution::solution::Solution;
pub use solve::{exists, solve, solve_near, solve_with};
pub use solver::{Answer, Solver};

/// The crate that proves solutions.
pub use groundbeam_proof as proof;
