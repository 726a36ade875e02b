//! Ground along the whole x-axis, with k(x) and μ(x) defined segment by segment, as in (2.2) and Remark 2 of Kikuchi's paper.

use super::beam::Beam;
use super::profile::{CellPolynomial, Profile};
use super::soil::{GroundConstants, SoilModel};

/// Pasternak foundation, or Winkler foundation if `shear_layer` is 0. Outside the beam, k and μ are constant until a
/// segment begins or the ground [ends](GroundEnd).
#[derive(Debug, Clone, PartialEq)]
pub struct Foundation {
    /// Spring constant k \[N/m²\], the force per unit length of beam and unit deflection; positive.
    pub subgrade: f64,
    /// Shear constant μ \[N\], not negative.
    pub shear_layer: f64,
    /// Segments with their own k and μ, under the beam and outside it. Segments may adjoin but not overlap. Outside
    /// the beam, each segment continues outward until the next segment begins.
    pub segments: Vec<FoundationSegment>,
    /// How the ground ends on the left and on the right.
    pub ends: [GroundEnd; 2],
    /// Soil data from which a solve computes `subgrade` and `shear_layer`; `None` if these constants are given. Ground
    /// defined by soil data is uniform and infinite.
    pub soil: Option<SoilModel>,
}

/// Segment of the ground with its own k and μ.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FoundationSegment {
    /// Left end \[m\].
    pub from: f64,
    /// Right end \[m\].
    pub to: f64,
    /// Spring constant k \[N/m²\] along the segment, from its left end to its right end; positive.
    pub subgrade: Profile,
    /// Shear constant μ \[N\] along the segment, from its left end to its right end. It is zero everywhere or
    /// positive everywhere.
    pub shear_layer: Profile,
}

impl Foundation {
    /// Maximum number of control values (Bernstein coefficients) of k and of μ on a segment. Three values describe
    /// the product of a modulus and a width that both vary linearly.
    pub const MOST_CONTROL_VALUES: usize = 3;

    /// Creates uniform ground with a shear layer.
    pub fn pasternak(spring: f64, shear: f64) -> Self {
        let ends = [GroundEnd::Endless; 2];
        Foundation { subgrade: spring, shear_layer: shear, segments: Vec::new(), ends, soil: None }
    }

    /// Creates uniform Winkler ground, with μ = 0.
    pub fn winkler(spring: f64) -> Self {
        Self::pasternak(spring, 0.0)
    }

    /// Creates uniform ground whose k and μ are computed from soil data and the data of a beam.
    pub fn on_soil(soil: SoilModel, beam: &Beam) -> Self {
        let GroundConstants { subgrade: spring, shear_layer: shear } = soil.subgrade(beam);
        Foundation { soil: Some(soil), ..Self::pasternak(spring, shear) }
    }

    /// Returns the ground with k multiplied by `spring` and μ multiplied by `shear` everywhere.
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

    /// Returns the ground with other values of k and μ between two positions.
    pub fn with_segment(self, from: f64, to: f64, spring: f64, shear: f64) -> Self {
        self.with_varying_segment(from, to, Profile::constant(spring), Profile::constant(shear))
    }

    /// Returns the ground with values of k and μ that vary between two positions.
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

    /// Returns the ground with its end conditions on the two sides of the beam replaced by `left` and `right`.
    pub fn with_ends(self, left: GroundEnd, right: GroundEnd) -> Self {
        Foundation { ends: [left, right], ..self }
    }

    /// k \[N/m²\] and μ \[N\] at `x` on the beam. At a joint of two segments, the values of the right segment apply.
    pub fn constants_at(&self, x: f64) -> (f64, f64) {
        let segment = self.segments.iter().find(|s| s.from <= x && x < s.to);
        segment.map_or((self.subgrade, self.shear_layer), |s| s.constants_at(x))
    }

    /// Upper bounds of k \[N/m²\] and of μ \[N\] along the ground, which are the largest given values.
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
    /// k \[N/m²\] and μ \[N\] at `x` on the segment.
    pub fn constants_at(&self, x: f64) -> (f64, f64) {
        let ends = [self.from, self.to];
        (self.subgrade.at_position(ends, x), self.shear_layer.at_position(ends, x))
    }

    /// Returns k and μ on the stretch `x` of the segment, each as a polynomial in the local coordinate of the stretch.
    pub(crate) fn courses(&self, x: [f64; 2]) -> [CellPolynomial; 2] {
        [self.subgrade, self.shear_layer].map(|constant| constant.on([self.from, self.to], x))
    }
}

/// How the ground ends on one side of the beam.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum GroundEnd {
    /// The ground is infinite.
    #[default]
    Endless,
    /// The ground ends at `at` \[m\] with a free surface, as beside a trench. The boundary condition is μu' = 0.
    Free {
        /// Position of the end of the ground \[m\], at the beam's end or outside the beam.
        at: f64,
    },
    /// The surface of the ground is held at `at` \[m\], as by a wall. The boundary condition is u = 0.
    Held {
        /// Position of the end of the ground \[m\], outside the beam.
        at: f64,
    },
}

impl GroundEnd {
    /// Position of the end of the ground \[m\]; `None` if the ground is infinite.
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
