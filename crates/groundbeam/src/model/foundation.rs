//! The ground: k(x) and μ(x) by segments on the whole line, (2.2) and Remark 2.

use super::beam::Beam;
use super::profile::{CellPolynomial, Profile};
use super::soil::{GroundConstants, SoilModel};

/// A Pasternak foundation; with `shear_layer` = 0 a Winkler foundation.
///
/// Outside the beam the ground has the constants of the beam's end, until a segment begins or the ground
/// [ends](GroundEnd).
#[derive(Debug, Clone, PartialEq)]
pub struct Foundation {
    /// Spring constant k \[N/m²\], force per length of beam and deflection, positive.
    pub subgrade: f64,
    /// Shear constant μ \[N\], not negative.
    pub shear_layer: f64,
    /// Stretches with other constants, under the beam and outside it. They may adjoin, but not overlap.
    /// Outside the beam each segment continues outward until the next one begins.
    pub segments: Vec<FoundationSegment>,
    /// How the ground ends on the left and on the right.
    pub ends: [GroundEnd; 2],
    /// The soil from which k and μ follow; `None` if they are given. A solve on soil sets `subgrade` and
    /// `shear_layer`. For the modified Vlasov model they follow from the solution, otherwise from the soil
    /// data alone. Such ground is uniform and infinite.
    pub soil: Option<SoilModel>,
}

/// A stretch of ground with its own constants.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FoundationSegment {
    /// Left end \[m\].
    pub from: f64,
    /// Right end \[m\].
    pub to: f64,
    /// Spring constant k \[N/m²\] from the left end to the right end, positive.
    pub subgrade: Profile,
    /// Shear constant μ \[N\] from the left end to the right end: zero everywhere or positive everywhere.
    pub shear_layer: Profile,
}

impl Foundation {
    /// Maximum number of control values of k and of μ on a segment: a modulus and a width may both be linear.
    pub const MOST_CONTROL_VALUES: usize = 3;

    /// Uniform ground with a shear layer.
    pub fn pasternak(spring: f64, shear: f64) -> Self {
        let ends = [GroundEnd::Endless; 2];
        Foundation { subgrade: spring, shear_layer: shear, segments: Vec::new(), ends, soil: None }
    }

    /// Uniform Winkler ground, μ = 0.
    pub fn winkler(spring: f64) -> Self {
        Self::pasternak(spring, 0.0)
    }

    /// Uniform ground defined by soil data, with the constants for this beam before the solve.
    pub fn on_soil(soil: SoilModel, beam: &Beam) -> Self {
        let GroundConstants { subgrade: spring, shear_layer: shear } = soil.subgrade(beam);
        Foundation { soil: Some(soil), ..Self::pasternak(spring, shear) }
    }

    /// The same ground with k and μ multiplied everywhere.
    pub fn scaled(mut self, spring: f64, shear: f64) -> Self {
        self.subgrade *= spring;
        self.shear_layer *= shear;
        if let Some(soil) = &mut self.soil {
            soil.factors = [soil.factors[0] * spring, soil.factors[1] * shear];
        }
        for segment in &mut self.segments {
            segment.subgrade = segment.subgrade.scaled(spring);
            segment.shear_layer = segment.shear_layer.scaled(shear);
        }
        self
    }

    /// The same ground with other constants between two positions.
    pub fn with_segment(self, from: f64, to: f64, spring: f64, shear: f64) -> Self {
        self.with_varying_segment(from, to, Profile::constant(spring), Profile::constant(shear))
    }

    /// The same ground with constants that vary between two positions.
    pub fn with_varying_segment(
        mut self,
        from: f64,
        to: f64,
        spring: Profile,
        shear: Profile,
    ) -> Self {
        self.segments.push(FoundationSegment { from, to, subgrade: spring, shear_layer: shear });
        self
    }

    /// The same ground with other ends on the left and on the right.
    pub fn with_ends(self, left: GroundEnd, right: GroundEnd) -> Self {
        Foundation { ends: [left, right], ..self }
    }

    /// (k \[N/m²\], μ \[N\]) at `x` on the beam; at a joint of two segments, those of the right one.
    pub fn constants_at(&self, x: f64) -> (f64, f64) {
        let segment = self.segments.iter().find(|s| s.from <= x && x < s.to);
        segment.map_or((self.subgrade, self.shear_layer), |s| s.constants_at(x))
    }

    /// Upper bounds of k \[N/m²\] and of μ \[N\]: the largest given values.
    pub fn largest(&self) -> (f64, f64) {
        self.segments.iter().fold((self.subgrade, self.shear_layer), |(k, mu), s| {
            (k.max(s.subgrade.largest()), mu.max(s.shear_layer.largest()))
        })
    }

    pub(super) fn mirrored(&self, l: f64) -> Self {
        let segments = self.segments.iter().rev();
        Foundation {
            segments: segments
                .map(|s| FoundationSegment {
                    from: l - s.to,
                    to: l - s.from,
                    subgrade: s.subgrade.mirrored(),
                    shear_layer: s.shear_layer.mirrored(),
                })
                .collect(),
            ends: [self.ends[1].mirrored(l), self.ends[0].mirrored(l)],
            soil: self.soil.clone(),
            ..*self
        }
    }
}

impl FoundationSegment {
    /// (k \[N/m²\], μ \[N\]) at `x` on the segment.
    pub fn constants_at(&self, x: f64) -> (f64, f64) {
        let ends = [self.from, self.to];
        (self.subgrade.at_position(ends, x), self.shear_layer.at_position(ends, x))
    }

    /// k and μ on a stretch of the segment.
    pub(crate) fn courses(&self, x: [f64; 2]) -> [CellPolynomial; 2] {
        [self.subgrade, self.shear_layer].map(|constant| constant.on([self.from, self.to], x))
    }
}

/// The end of the ground outside one end of the beam.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum GroundEnd {
    /// The ground is infinite.
    #[default]
    Endless,
    /// The surface of the ground ends at `at` \[m\] and is free there, as beside a trench: μu' = 0.
    Free {
        /// Position \[m\], at the beam's end or outside it.
        at: f64,
    },
    /// The surface of the ground is held at `at` \[m\], as by a wall: u = 0.
    Held {
        /// Position \[m\], outside the beam.
        at: f64,
    },
}

impl GroundEnd {
    /// The position, if there is one \[m\].
    pub fn at(self) -> Option<f64> {
        match self {
            GroundEnd::Endless => None,
            GroundEnd::Free { at } | GroundEnd::Held { at } => Some(at),
        }
    }

    pub(super) fn mirrored(self, l: f64) -> Self {
        match self {
            GroundEnd::Endless => GroundEnd::Endless,
            GroundEnd::Free { at } => GroundEnd::Free { at: l - at },
            GroundEnd::Held { at } => GroundEnd::Held { at: l - at },
        }
    }
}
