//! What holds the beam besides the ground.

/// A support at one point of the beam. It acts in both directions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Support {
    /// Position \[m\].
    pub at: f64,
    /// What it holds.
    pub kind: SupportKind,
}

/// What a support holds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SupportKind {
    /// w = 0; the beam may turn.
    Pinned,
    /// w = 0 and w' = 0.
    Fixed,
    /// Elastic: pushes back with `spring`·w and `rotational_spring`·w'.
    Spring {
        /// Spring constant \[N/m\], not negative.
        spring: f64,
        /// Rotational spring constant \[N·m/rad\], not negative.
        rotational_spring: f64,
    },
}

impl Support {
    /// w = 0 at `at` \[m\].
    pub fn pinned(at: f64) -> Self {
        Support { at, kind: SupportKind::Pinned }
    }

    /// w = w' = 0 at `at` \[m\].
    pub fn fixed(at: f64) -> Self {
        Support { at, kind: SupportKind::Fixed }
    }

    /// Springs at `at` \[m\] against deflection \[N/m\] and rotation \[N·m/rad\].
    pub fn spring(at: f64, spring: f64, rotational_spring: f64) -> Self {
        Support { at, kind: SupportKind::Spring { spring, rotational_spring } }
    }
}
