//! Existence of an equilibrium, decided before the solve: (4.16)–(4.25).

pub(crate) mod existence;
pub(crate) mod rigid_motions;
pub(crate) mod statics;
pub(crate) mod verdict;

pub use existence::static_reactions_of as static_reactions;
pub use verdict::{Buckling, Existence, Local, RigidMotion, Verdict};
