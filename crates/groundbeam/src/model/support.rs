//! Supports: pins, clamps, springs; two-way or one-way; with settlement.

/// A support at one point of the beam.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Support {
    /// Position \[m\].
    pub at: f64,
    /// The motions that it restrains.
    pub kind: SupportKind,
    /// Settlement δ \[m\], positive down. A rigid support holds the beam at w = δ, a spring has the force
    /// `spring`·(w − δ).
    pub settlement: f64,
    /// The directions in which it acts.
    pub acts: Acts,
}

/// The directions in which a support acts on the beam.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Acts {
    /// The support acts in both directions.
    #[default]
    Both,
    /// The support only pushes the beam up: a bearing from which the beam may lift. A rigid one requires w ≤
    /// 0.
    Up,
    /// The support only pulls the beam down: a hold-down. A rigid one requires w ≥ 0.
    Down,
}

impl Acts {
    /// 1 if the support only pushes up, −1 if it only pulls down, 0 if it acts in both directions.
    pub(crate) fn sign(self) -> f64 {
        match self {
            Acts::Both => 0.0,
            Acts::Up => 1.0,
            Acts::Down => -1.0,
        }
    }
}

/// The motions that a support restrains.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SupportKind {
    /// A rigid support without rotational restraint: w = δ, the settlement of the support.
    Pinned,
    /// A rigid support that also prevents rotation: w = δ and w' = 0.
    Fixed,
    /// An elastic support: the force `spring`·(w − δ) and the moment `rotational_spring`·w' oppose the
    /// motion.
    Spring {
        /// Spring constant \[N/m\], not negative.
        spring: f64,
        /// Rotational spring constant \[N·m/rad\], not negative.
        rotational_spring: f64,
    },
}

impl Support {
    /// A pinned support at `at` \[m\]: w = 0.
    pub fn pinned(at: f64) -> Self {
        Support { at, kind: SupportKind::Pinned, settlement: 0.0, acts: Acts::Both }
    }

    /// A fixed support at `at` \[m\]: w = w' = 0.
    pub fn fixed(at: f64) -> Self {
        Support { at, kind: SupportKind::Fixed, settlement: 0.0, acts: Acts::Both }
    }

    /// An elastic support at `at` \[m\], with translational stiffness \[N/m\] and rotational stiffness
    /// \[N·m/rad\].
    pub fn spring(at: f64, spring: f64, rotational_spring: f64) -> Self {
        let kind = SupportKind::Spring { spring, rotational_spring };
        Support { at, kind, settlement: 0.0, acts: Acts::Both }
    }

    /// The same support with a settlement \[m\], positive down.
    pub fn settled(self, settlement: f64) -> Self {
        Support { settlement, ..self }
    }

    /// The same support as a one-way support.
    pub fn acting(self, acts: Acts) -> Self {
        Support { acts, ..self }
    }

    /// Whether the support acts in one direction only.
    pub fn is_one_way(&self) -> bool {
        self.acts != Acts::Both
    }
}
