//! Bounds of the errors of an answer, each with the scale with which it is compared.

/// An error is small if it is at most this fraction of its scale.
const SMALL: f64 = 1e-6;

/// A bound of the error of one quantity: |claimed − exact| ≤ `error`. It is infinite if no bound is proven.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bound {
    /// The bound, in the unit of the quantity.
    pub error: f64,
    /// The scale of the quantity, in the same unit: a proven lower bound of its largest absolute value.
    pub scale: f64,
}

impl Bound {
    /// Whether the error is at most 10⁻⁶ of its scale.
    pub fn is_small(self) -> bool {
        self.error <= SMALL * self.scale
    }
}

/// Bounds of the errors of the fields, each the largest over the beam.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds {
    /// Bound of w \[m\].
    pub deflection: Bound,
    /// Bound of w′ \[rad\], also on both sides of hinges.
    pub slope: Bound,
    /// Bound of the rotation of the sections \[rad\].
    pub rotation: Bound,
    /// Bound of M \[N·m\].
    pub moment: Bound,
    /// Bound of V \[N\].
    pub shear_force: Bound,
    /// Bound of u \[m\].
    pub settlement: Bound,
    /// Bound of p \[N/m\], outside the intervals that contain the edges of contact.
    pub pressure: Bound,
}

impl Bounds {
    /// All bounds with the names that documents use.
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

/// Bounds of the errors of the reactions of one support.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ReactionBound {
    /// Bound of the force \[N\].
    pub force: Bound,
    /// Bound of the moment \[N·m\].
    pub moment: Bound,
}

/// Scales of the quantities that are enclosed by intervals.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scales {
    /// Scale of the edges of contact: the length of the beam \[m\].
    pub length: f64,
    /// Scale of concentrated forces: the sum of the loads \[N\].
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
