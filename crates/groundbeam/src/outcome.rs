//! The outcome of a solve: an equilibrium or the reason why none exists.

use crate::existence::verdict::Existence;
use crate::solution::solution::Solution;

/// The outcome of a solve.
#[derive(Debug, Clone)]
pub enum Outcome {
    /// An equilibrium with its certificate.
    Equilibrium(Box<Solution>),
    /// No equilibrium exists; under compression, no stable one exists on the path from the unloaded state. The
    /// [`Existence`] contains the motion or buckling mode that proves it.
    NoEquilibrium(Existence),
}
