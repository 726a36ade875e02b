//! Supports: pins, clamps, springs; two-way or one-way; with settlement.

/// A support at one point of the beam.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Support {
    /// Position \[m\].
    pub at: f64,
    /// What it holds.
    pub kind: SupportKind,
    /// How far it has settled \[m\], down positive: it holds the beam there, w = δ, or pushes back with
    /// `spring`·(w − δ).
    pub settlement: f64,
    /// In which directions it does.
    pub acts: Acts,
}

/// In which directions a support acts on the beam.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Acts {
    /// Both.
    #[default]
    Both,
    /// It only pushes the beam up: a bearing from which the beam may lift. w ≤ 0 where it is rigid.
    Up,
    /// It only pulls the beam down: a hold-down. w ≥ 0 where it is rigid.
    Down,
}

impl Acts {
    /// 1 where it pushes up alone, −1 where it pulls down alone, 0 for both.
    pub(crate) fn sign(self) -> f64 {
        match self {
            Acts::Both => 0.0,
            Acts::Up => 1.0,
            Acts::Down => -1.0,
        }
    }
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
        Support { at, kind: SupportKind::Pinned, settlement: 0.0, acts: Acts::Both }
    }

    /// w = w' = 0 at `at` \[m\].
    pub fn fixed(at: f64) -> Self {
        Support { at, kind: SupportKind::Fixed, settlement: 0.0, acts: Acts::Both }
    }

    /// Springs at `at` \[m\] against deflection \[N/m\] and rotation \[N·m/rad\].
    pub fn spring(at: f64, spring: f64, rotational_spring: f64) -> Self {
        let kind = SupportKind::Spring { spring, rotational_spring };
        Support { at, kind, settlement: 0.0, acts: Acts::Both }
    }

    /// The same support, settled by \[m\], down positive.
    pub fn settled(self, settlement: f64) -> Self {
        Support { settlement, ..self }
    }

    /// The same support in one direction alone.
    pub fn acting(self, acts: Acts) -> Self {
        Support { acts, ..self }
    }

    /// Whether it acts in one direction alone.
    pub fn is_one_way(&self) -> bool {
        self.acts != Acts::Both
    }
}
