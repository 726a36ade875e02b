//! What holds the beam besides the ground.

/// A support at one point of the beam. It acts in both directions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Support {
    /// Position \[m\].
    pub at: f64,
    /// What it holds.
    pub kind: SupportKind,
    /// How far it has settled \[m\], down positive: it holds the beam there, w = δ, or pushes back with
    /// `spring`·(w − δ).
    pub settlement: f64,
}

/// What a support holds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SupportKind {
    /// w = δ, the support's settlement; the beam may turn.
    Pinned,
    /// w = δ and w' = 0.
    Fixed,
    /// Elastic: pushes back with `spring`·(w − δ) and `rotational_spring`·w'.
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
        Support { at, kind: SupportKind::Pinned, settlement: 0.0 }
    }

    /// w = w' = 0 at `at` \[m\].
    pub fn fixed(at: f64) -> Self {
        Support { at, kind: SupportKind::Fixed, settlement: 0.0 }
    }

    /// Springs at `at` \[m\] against deflection \[N/m\] and rotation \[N·m/rad\].
    pub fn spring(at: f64, spring: f64, rotational_spring: f64) -> Self {
        let kind = SupportKind::Spring { spring, rotational_spring };
        Support { at, kind, settlement: 0.0 }
    }

    /// The same support, settled by \[m\], down positive.
    pub fn settled(self, settlement: f64) -> Self {
        Support { settlement, ..self }
    }
}
