//! One step of a contact iteration, as an answer reports it.

/// One step of an iteration.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Step {
    /// Zones of contact after the step.
    pub zones: usize,
    /// The part of Newton's step that was taken; for Uzawa's iteration the parameter ρ.
    pub step: f64,
    /// The move of the contact relative to the beam's length; on a mesh the part of all nodes that touch before or after the
    /// step alone; for Uzawa's iteration the relative change of the pressure.
    pub decrement: f64,
}
