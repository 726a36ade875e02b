//! One step of a contact iteration, as stored in a solution.

/// One step of an iteration.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Step {
    /// Number of contact zones after the step.
    pub zones: usize,
    /// The fraction of the full Newton step; for Uzawa's iteration, the parameter ρ.
    pub step: f64,
    /// Exact method: the move of the contact edges relative to the beam's length. Newton's method on a mesh:
    /// the fraction of the nodes whose contact changes in the step. Uzawa's iteration: the relative change of
    /// the pressure.
    pub decrement: f64,
}
