//! The outcome of a solve: an equilibrium or the reason why none exists.

use crate::existence::verdict::Existence;
use crate::solution::solution::Solution;

/// The outcome of a solve.
#[derive(Debug, Clone)]
pub enum Outcome {
    /// An equilibrium with its certificate.
    Equilibrium(Box<Solution>),
    /// No equilibrium exists. For a beam under compression it means that no stable equilibrium exists on the path
    /// from the unloaded state. The [`Existence`] contains the rigid-body motion or the buckling mode that proves
    /// this verdict.
    NoEquilibrium(Existence),
}
