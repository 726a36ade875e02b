//! Supports of the beam: pins, clamps and springs, two-way or one-way, with settlement.

use crate::numeric::sum::Rounded;

/// A support at one point of the beam.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Support {
    /// Position \[m\].
    pub at: f64,
    /// Type of the support: pinned, fixed or elastic.
    pub kind: SupportKind,
    /// Settlement δ \[m\], positive down. A rigid support prescribes w = δ. A spring exerts the force
    /// `spring`·(w − δ).
    pub settlement: f64,
    /// Directions in which the support acts.
    pub acts: Acts,
}

/// The force and the moment that a support exerts on the beam.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Reaction {
    /// Position of the support \[m\].
    pub at: f64,
    /// Force of the support on the beam, positive upwards \[N\].
    pub force: f64,
    /// Moment that the support exerts on the beam, positive clockwise \[N·m\].
    pub moment: f64,
}

/// The directions in which a support acts on the beam.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Acts {
    /// The support acts in both directions.
    #[default]
    Both,
    /// The support only pushes the beam up, like a bearing from which the beam may lift. A rigid support with the
    /// settlement δ then requires w ≤ δ.
    Up,
    /// The support only pulls the beam down, like a hold-down. A rigid support with the settlement δ then requires
    /// w ≥ δ.
    Down,
}

impl Acts {
    /// Sign of the direction: 1 if the support only pushes up, −1 if it only pulls down, 0 if it acts in both
    /// directions.
    pub(crate) fn sign(self) -> f64 {
        match self {
            Acts::Both => 0.0,
            Acts::Up => 1.0,
            Acts::Down => -1.0,
        }
    }
}

/// Type of a support, by its restraint of deflection and rotation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SupportKind {
    /// Rigid support without rotational restraint. It prescribes w = δ, where δ is the settlement of the support.
    Pinned,
    /// Rigid support that also prevents rotation. It prescribes w = δ and w' = 0, where δ is the settlement of the
    /// support.
    Fixed,
    /// Elastic support with the settlement δ. The force `spring`·(w − δ) opposes the deflection w, and the moment
    /// `rotational_spring`·w' opposes the rotation w'.
    Spring {
        /// Translational spring constant \[N/m\], not negative.
        spring: f64,
        /// Rotational spring constant \[N·m/rad\], not negative.
        rotational_spring: f64,
    },
}

impl Support {
    /// Creates a pinned support at `at` \[m\], which prescribes w = 0.
    pub fn pinned(at: f64) -> Self {
        Support { at, kind: SupportKind::Pinned, settlement: 0.0, acts: Acts::Both }
    }

    /// Creates a fixed support at `at` \[m\], which prescribes w = w' = 0.
    pub fn fixed(at: f64) -> Self {
        Support { at, kind: SupportKind::Fixed, settlement: 0.0, acts: Acts::Both }
    }

    /// Creates an elastic support at `at` \[m\], with translational stiffness \[N/m\] and rotational stiffness
    /// \[N·m/rad\].
    pub fn spring(at: f64, spring: f64, rotational_spring: f64) -> Self {
        let kind = SupportKind::Spring { spring, rotational_spring };
        Support { at, kind, settlement: 0.0, acts: Acts::Both }
    }

    /// Returns the support with a settlement \[m\], positive down.
    pub fn settled(self, settlement: f64) -> Self {
        Support { settlement, ..self }
    }

    /// Returns the support with other directions of action.
    pub fn acting(self, acts: Acts) -> Self {
        Support { acts, ..self }
    }

    /// Returns the reaction. `motion` computes the deflection and the rotation of the beam at the support. `force` and
    /// `moment` compute what a rigid support must exert for equilibrium. The reaction of a spring follows from the motion,
    /// or from the equilibrium of the beam if the spring is so stiff that the equilibrium has less rounding error.
    pub(crate) fn reaction(
        &self,
        motion: impl FnOnce() -> [Rounded; 2],
        force: impl FnOnce() -> Rounded,
        moment: impl FnOnce() -> Rounded,
    ) -> Reaction {
        let (force, moment) = match self.kind {
            SupportKind::Pinned => (force().value, 0.0),
            SupportKind::Fixed => (force().value, moment().value),
            SupportKind::Spring { spring, rotational_spring } => {
                let [deflection, rotation] = motion();
                let compression = deflection.value - self.settlement;
                let by_deflection =
                    Rounded { value: spring * compression, size: spring * deflection.size };
                let by_rotation = Rounded {
                    value: -rotational_spring * rotation.value,
                    size: rotational_spring * rotation.size,
                };
                (by_deflection.or_if_smaller(force), by_rotation.or_if_smaller(moment))
            }
        };
        Reaction { at: self.at, force, moment }
    }

    /// Whether the support acts in one direction only.
    pub fn is_one_way(&self) -> bool {
        self.acts != Acts::Both
    }
}
