//! Beams on ground that can only push back.
//!
//! The unilateral contact of a bending beam with a Pasternak foundation, solved exactly and with proof.
//!
#![doc = include_str!("../problem.md")]
//!
//! [`solve()`] takes a [`Model`] and says what mechanics says: an [`Outcome`] that is either a [`Solution`]
//! with its [`Certificate`], or no equilibrium, with the [`RigidMotion`] that proves it. What is wrong with
//! a model is an [`Error`].
//!
//! ```
//! use groundbeam::{Beam, Field, Foundation, Load, Model, Outcome, solve};
//!
//! // Kikuchi's case IV: a unit force and a moment at the middle, the left end lifts off.
//! let model = Model::new(Beam::uniform(1.0, 1.0), Foundation::pasternak(1.0, 1.0))
//!     .with_load(Load::point(1.0, 0.5))
//!     .with_load(Load::moment(0.49, 0.5));
//! let Outcome::Equilibrium(solution) = solve(&model)? else { panic!("it tips") };
//! assert_eq!(format!("{:.12}", solution.contact()[0].from), "0.811326256449");
//! assert_eq!(format!("{:.12}", solution.end_forces().right), "0.897199981230");
//! assert_eq!(format!("{:.12}", solution.value(Field::Deflection, 0.0)), "0.013217803941");
//! assert!(solution.certificate().relative_gap < 1e-12);
//! # Ok::<(), groundbeam::Error>(())
//! ```

#![forbid(unsafe_code)]
#![deny(missing_docs)]

mod assemble;
mod cell;
mod certificate;
mod chain;
mod checks;
mod contact;
mod elements;
mod envelope;
mod existence;
mod extremes;
mod factors;
mod free;
mod free_spans;
mod ground;
mod local;
mod mechanism;
mod mesh;
mod nodal;
mod one_way;
mod polynomial;
pub mod sensitivity;
mod size;
mod solution;
mod solve;
mod solver;
mod stability;
mod turns;

pub mod model;
pub mod soil;
pub mod train;

pub use certificate::Certificate;
pub use checks::{Check, Checked, Limits, overturning};
pub use contact::active_set::{Pressure, Step};
pub use envelope::{Bound, Bounds, Change, Envelope, Governing};
pub use existence::{
    Buckling, Existence, Local, RigidMotion, Verdict, static_reactions_of as static_reactions,
};
pub use factors::{FirstLiftOff, LoadFactors, LossOfEquilibrium, load_factors};
pub use free_spans::LiftOff;
pub use model::{
    Acts, Beam, BeamSegment, Foundation, FoundationSegment, GapPoint, GroundEnd, Hinge, Load,
    Model, Profile, Support, SupportKind,
};
pub use nodal::{NodalCheck, NodalSolution, NodalSolver, Work};
pub use size::{TooLarge, memory_estimate};
pub use solution::{
    ConcentratedForce, ContactRegion, EndForces, Extreme, Field, Fields, Range, Reaction, Side,
    Solution,
};
pub use solve::{
    Error, Method, NotConverged, Options, Outcome, Start, exists, solve, solve_near, solve_with,
};
pub use solver::{Answer, Solver};
pub use stability::own_buckling_load;
pub use turns::HingeTurn;
