//! Hinges inside the beam: they transmit shear force, and the moment of their rotational spring.

/// A hinge at one point inside the beam: w is continuous there, w' jumps.
///
/// It transmits the moment M = −k_φ \[w'\], where \[w'\] is the jump of the slope, right minus left: zero for
/// a free hinge, k_φ = 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hinge {
    /// Position \[m\], inside the beam.
    pub at: f64,
    /// Rotational spring constant k_φ \[N·m/rad\] of a semi-rigid joint, not negative; 0 for a free hinge.
    pub rotational_spring: f64,
}

impl Hinge {
    /// A hinge at `at` \[m\] that rotates freely.
    pub fn free(at: f64) -> Self {
        Hinge { at, rotational_spring: 0.0 }
    }

    /// A semi-rigid joint at `at` \[m\] with a rotational spring k_φ \[N·m/rad\].
    pub fn elastic(at: f64, rotational_spring: f64) -> Self {
        Hinge { at, rotational_spring }
    }

    /// Whether the hinge transmits no moment.
    pub fn is_free(&self) -> bool {
        self.rotational_spring == 0.0
    }
}
