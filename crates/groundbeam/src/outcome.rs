//! The outcome of a solve: an equilibrium or the reason why none exists.

use crate::existence::verdict::Existence;
use crate::solution::solution::Solution;

/// What mechanics says.
#[derive(Debug, Clone)]
pub enum Outcome {
    /// An equilibrium, certified.
    Equilibrium(Box<Solution>),
    /// There is none, or in compression none next to the unloaded state. The verdict holds the motion that
    /// shows it.
    NoEquilibrium(Existence),
}
