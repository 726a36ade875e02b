//! Decides before the solve whether an equilibrium exists, by the conditions (4.16)–(4.25) of Kikuchi's paper.

pub(crate) mod existence;
pub(crate) mod free_motions;
pub(crate) mod rigid_motions;
pub(crate) mod statics;
mod unloaded_piece;
pub(crate) mod verdict;
pub(crate) mod work;

pub use verdict::{Buckling, Existence, Local, RigidMotion, Verdict};
pub use work::static_reactions_of as static_reactions;
