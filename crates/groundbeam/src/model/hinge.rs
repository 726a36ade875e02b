//! Hinges inside the beam, which transmit shear force and the moment of a rotational spring.

/// Hinge at one point inside the beam, where w is continuous and w' may jump.
///
/// The hinge transmits the moment M = −k_φ \[w'\], where \[w'\] is the jump of the slope, right minus left.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hinge {
    /// Position of the hinge \[m\], inside the beam.
    pub at: f64,
    /// Rotational spring constant k_φ \[N·m/rad\] of a semi-rigid joint, not negative; 0 for a free hinge.
    pub rotational_spring: f64,
}

impl Hinge {
    /// Creates a hinge at `at` \[m\] that rotates freely.
    pub fn free(at: f64) -> Self {
        Hinge { at, rotational_spring: 0.0 }
    }

    /// Creates a semi-rigid joint at `at` \[m\] with the rotational spring constant k_φ \[N·m/rad\].
    pub fn elastic(at: f64, rotational_spring: f64) -> Self {
        Hinge { at, rotational_spring }
    }

    /// Whether the hinge transmits no moment.
    pub fn is_free(&self) -> bool {
        self.rotational_spring == 0.0
    }
}
