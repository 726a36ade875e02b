//! One step of a contact iteration, as stored in a solution.

/// One step of an iteration.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Step {
    /// Number of contact zones after the step.
    pub zones: usize,
    /// Accepted fraction of the full Newton step. For Uzawa's iteration, it is the parameter ρ.
    pub step: f64,
    /// Change in the step. In the exact method it is the longest interval whose contact changes, relative to the beam's
    /// length; on a mesh, the fraction of nodes whose contact changes; for Uzawa and PSOR, the relative change of the
    /// pressure.
    pub decrement: f64,
}
