//! The ground: k(x) and μ(x) by segments on the whole line, (2.2) and Remark 2.

/// A Pasternak foundation; with `shear` = 0 a Winkler foundation.
///
/// The ground goes on to infinity on both sides with the constants it has at the beam's ends.
#[derive(Debug, Clone, PartialEq)]
pub struct Foundation {
    /// Spring constant k \[N/m²\], force per length of beam and deflection, positive.
    pub spring: f64,
    /// Shear constant μ \[N\], not negative.
    pub shear: f64,
    /// Stretches with other constants. They may touch, not overlap. One that begins at or before
    /// the beam's left end holds for all the ground to the left of it, and the same on the right.
    pub segments: Vec<FoundationSegment>,
}

/// A stretch of ground with constants of its own.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FoundationSegment {
    /// Left end \[m\].
    pub from: f64,
    /// Right end \[m\].
    pub to: f64,
    /// Spring constant k \[N/m²\], positive.
    pub spring: f64,
    /// Shear constant μ \[N\], not negative.
    pub shear: f64,
}

impl Foundation {
    /// Uniform ground with a shear layer.
    pub fn pasternak(spring: f64, shear: f64) -> Self {
        Foundation { spring, shear, segments: Vec::new() }
    }

    /// Uniform ground of independent springs, μ = 0.
    pub fn winkler(spring: f64) -> Self {
        Self::pasternak(spring, 0.0)
    }

    /// The same ground with other constants between two positions.
    pub fn with_segment(mut self, from: f64, to: f64, spring: f64, shear: f64) -> Self {
        self.segments.push(FoundationSegment { from, to, spring, shear });
        self
    }

    /// (k \[N/m²\], μ \[N\]) at `x` on the beam; at a joint of two segments those of the right one.
    pub fn constants_at(&self, x: f64) -> (f64, f64) {
        self.segments
            .iter()
            .find(|s| s.from <= x && x < s.to)
            .map_or((self.spring, self.shear), |s| (s.spring, s.shear))
    }

    pub(super) fn mirrored(&self, l: f64) -> Self {
        let segments = self.segments.iter().rev();
        Foundation {
            segments: segments
                .map(|s| FoundationSegment { from: l - s.to, to: l - s.from, ..*s })
                .collect(),
            ..*self
        }
    }
}
