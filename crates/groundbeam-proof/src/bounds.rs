//! Bounds of the errors of an answer, each with the scale with which it is compared.

/// An error counts as small if it is at most this fraction of the scale of its quantity.
const SMALL: f64 = 1e-6;

/// A bound of the error of one quantity: |claimed − exact| ≤ `error`. It is infinite if no bound is proven.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bound {
    /// Bound of the error, in the unit of the quantity.
    pub error: f64,
    /// Scale with which the error is compared, in the unit of the quantity. Section 8 of docs/proof.md lists the
    /// scales.
    pub scale: f64,
}

impl Bound {
    /// Whether the bound `error` is at most 10⁻⁶ times `scale`, the reference value of the quantity.
    pub fn is_small(self) -> bool {
        self.error <= SMALL * self.scale
    }
}

/// Error bounds of the fields of an answer. Each bound is valid on the whole beam.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds {
    /// Error bound of the deflection w \[m\].
    pub deflection: Bound,
    /// Error bound of the slope w′ \[rad\]. At a hinge, the bound holds for the slope on each side of the hinge.
    pub slope: Bound,
    /// Error bound of the rotation of the cross-sections \[rad\].
    pub rotation: Bound,
    /// Error bound of the bending moment M \[N·m\].
    pub moment: Bound,
    /// Error bound of the shear force V \[N\].
    pub shear_force: Bound,
    /// Error bound of the displacement u of the ground \[m\].
    pub settlement: Bound,
    /// Error bound of the contact pressure p \[N/m\], outside the intervals that contain the edges of contact.
    pub pressure: Bound,
}

impl Bounds {
    /// Returns all bounds with the names that documents use.
    pub fn named(&self) -> [(&'static str, Bound); 7] {
        [
            ("deflection", self.deflection),
            ("slope", self.slope),
            ("rotation", self.rotation),
            ("moment", self.moment),
            ("shear_force", self.shear_force),
            ("settlement", self.settlement),
            ("pressure", self.pressure),
        ]
    }
}

/// Error bounds of the reactions of one support.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ReactionBound {
    /// Error bound of the reaction force \[N\].
    pub force: Bound,
    /// Error bound of the reaction moment \[N·m\].
    pub moment: Bound,
}

/// Scales of the quantities that are enclosed by intervals.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scales {
    /// Scale of the positions of contact edges: the length of the beam \[m\].
    pub length: f64,
    /// Scale of concentrated forces \[N\]: the larger of the sum of all loads and the largest reaction.
    pub force: f64,
}

#[cfg(test)]
mod tests {
    use super::Bound;

    #[test]
    fn an_error_is_compared_with_its_scale() {
        for scale in [1e-3, 1.0, 1e3] {
            for (share, small) in [
                (0.0, true),
                (9e-7, true),
                (1.1e-6, false),
                (f64::INFINITY, false),
                (f64::NAN, false),
            ] {
                assert_eq!(
                    Bound { error: share * scale, scale }.is_small(),
                    small,
                    "{share} {scale}"
                );
            }
        }
    }
}
