//! One step of a contact iteration, as stored in a solution.

/// One step of an iteration.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Step {
    /// Number of contact zones after the step.
    pub zones: usize,
    /// Accepted fraction of the full Newton step. For Uzawa's iteration, it is the parameter ρ.
    pub step: f64,
    /// Size of the change in the step. In the exact method it is the length of the longest interval on which
    /// the contact changes, relative to the beam's length. In Newton's method on a mesh it is the fraction of
    /// the nodes whose contact changes. In Uzawa's iteration it is the relative change of the pressure.
    pub decrement: f64,
}
