//! Solves beams in unilateral contact with the ground.
//!
//! The ground is a Pasternak foundation. The solutions are exact up to rounding error and have a proven error bound.
//!
#![doc = include_str!("../problem.md")]
//!
//! [`solve()`] takes a [`Model`] and returns an [`Outcome`]: a [`Solution`] with its [`Certificate`], or the
//! [`RigidMotion`](existence::RigidMotion) or buckling mode that proves that no equilibrium exists. An invalid model
//! returns an [`Error`].
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
pub mod design;
mod element;
pub mod envelope;
mod equilibrium;
mod error;
pub mod existence;
mod ground;
pub mod load_factors;
mod mesh;
mod nodal;
mod nodal_solver;
mod numeric;
mod options;
mod outcome;
pub mod solution;
mod solve;
mod solver;
pub mod supported;

pub mod model;
pub mod soil;

pub use cancel::Cancel;
pub use equilibrium::buckling::own_buckling_load;
pub use equilibrium::size::{check_memory, memory_estimate};
pub use error::{Error, NotConverged, Stopped, TooLarge};
pub use existence::{Existence, Verdict};
pub use load_factors::load_factors;
pub use model::{Beam, Foundation, Hinge, Load, Model, Support, SupportKind};
pub use nodal::newton::Work;
pub use nodal::solution::{NodalCheck, NodalSolution};
pub use nodal_solver::NodalSolver;
pub use numeric::step::Step;
pub use options::{Method, Options, Start};
pub use outcome::Outcome;
pub use solution::{Certificate, Field, Solution};
pub use solve::{exists, solve, solve_near, solve_with};
pub use solver::{Answer, Solver};

/// The crate that proves error bounds of solutions.
pub use groundbeam_proof as proof;
