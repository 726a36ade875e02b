//! Beam with bending and shear stiffness given by segments, under a constant axial force; (2.1) and (4.1) of the paper.

use super::profile::{CellPolynomial, Profile};

/// A straight beam with bending stiffness and, optionally, shear stiffness.
#[derive(Debug, Clone, PartialEq)]
pub struct Beam {
    /// Length l \[m\], positive.
    pub length: f64,
    /// Bending stiffness EI \[N·m²\] outside the segments, positive.
    pub bending_stiffness: f64,
    /// Shear stiffness S = κGA \[N\] outside the segments, positive (Timoshenko beam). If it is `None`, the beam has no
    /// shear deformation (Euler–Bernoulli beam).
    pub shear_stiffness: Option<f64>,
    /// Segments whose stiffnesses differ from those of the beam. Segments may adjoin but not overlap.
    pub segments: Vec<BeamSegment>,
    /// Axial force P \[N\], tension positive, constant along the beam.
    pub axial_force: f64,
}

/// Segment of a beam with its own stiffnesses.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BeamSegment {
    /// Left end \[m\].
    pub from: f64,
    /// Right end \[m\].
    pub to: f64,
    /// Bending stiffness EI \[N·m²\] along the segment, from its left end to its right end; positive.
    pub bending_stiffness: Profile,
    /// Shear stiffness S \[N\] along the segment, from its left end to its right end; positive. If it is `None`, the
    /// shear stiffness of the beam applies.
    pub shear_stiffness: Option<Profile>,
}

impl Beam {
    /// Creates a uniform beam without axial force and without shear deformation.
    pub fn uniform(length: f64, bending_stiffness: f64) -> Self {
        Beam {
            length,
            bending_stiffness,
            shear_stiffness: None,
            segments: Vec::new(),
            axial_force: 0.0,
        }
    }

    /// Returns the beam under the axial force P \[N\], tension positive.
    pub fn with_axial_force(mut self, axial_force: f64) -> Self {
        self.axial_force = axial_force;
        self
    }

    /// Returns the beam with the shear stiffness S = κGA \[N\].
    ///
    /// ```
    /// use groundbeam::{Beam, Field, Foundation, Load, Model, Outcome, Support, solve};
    ///
    /// // A cantilever on very soft ground: the deflection is F l³/3EI from bending and F l/S from shear.
    /// let beam = Beam::uniform(2.0, 3.0).with_shear_stiffness(4.0);
    /// let model = Model::new(beam, Foundation::winkler(1e-12))
    ///     .with_support(Support::fixed(0.0))
    ///     .with_load(Load::point_force(2.0, 1.0));
    /// if let Outcome::Equilibrium(solution) = solve(&model)? {
    ///     let tip = 8.0 / 9.0 + 2.0 / 4.0;
    ///     assert!((solution.value(Field::Deflection, 2.0) - tip).abs() < 1e-10);
    /// }
    /// # Ok::<(), groundbeam::Error>(())
    /// ```
    pub fn with_shear_stiffness(mut self, shear_stiffness: f64) -> Self {
        self.shear_stiffness = Some(shear_stiffness);
        self
    }

    /// Returns the beam with another bending stiffness \[N·m²\] between two positions.
    pub fn with_segment(self, from: f64, to: f64, bending_stiffness: f64) -> Self {
        self.with_varying_segment(from, to, Profile::constant(bending_stiffness))
    }

    /// Returns the beam with a bending stiffness \[N·m²\] that varies between two positions.
    ///
    /// ```
    /// use groundbeam::{Beam, model::Profile};
    ///
    /// let beam = Beam::uniform(4.0, 1.0).with_varying_segment(0.0, 4.0, Profile::linear(1.0, 3.0));
    /// assert_eq!(beam.bending_stiffness_at(1.0), 1.5);
    /// ```
    pub fn with_varying_segment(mut self, from: f64, to: f64, bending_stiffness: Profile) -> Self {
        self.segments.push(BeamSegment { from, to, bending_stiffness, shear_stiffness: None });
        self
    }

    /// Returns the beam with another bending stiffness \[N·m²\] and shear stiffness \[N\] between two positions. Each
    /// stiffness is a number or a [`Profile`].
    pub fn with_shearing_segment(
        mut self,
        from: f64,
        to: f64,
        bending_stiffness: impl Into<Profile>,
        shear_stiffness: impl Into<Profile>,
    ) -> Self {
        let (bending_stiffness, shear_stiffness) =
            (bending_stiffness.into(), Some(shear_stiffness.into()));
        self.segments.push(BeamSegment { from, to, bending_stiffness, shear_stiffness });
        self
    }

    /// Bending stiffness EI \[N·m²\] at `x`. At a joint of two segments, the value of the right segment applies.
    pub fn bending_stiffness_at(&self, x: f64) -> f64 {
        let segment = self.segments.iter().find(|s| s.from <= x && x < s.to);
        segment.map_or(self.bending_stiffness, |s| s.bending_stiffness_at(x))
    }

    /// Whether any part of the beam has shear deformation.
    pub fn shears(&self) -> bool {
        self.shear_stiffness.is_some() || self.segments.iter().any(|s| s.shear_stiffness.is_some())
    }

    /// Shear stiffness S \[N\] at `x`; `None` where the beam has no shear deformation. At a joint of two segments,
    /// the value of the right segment applies.
    pub fn shear_stiffness_at(&self, x: f64) -> Option<f64> {
        let segment = self.segments.iter().find(|s| s.from <= x && x < s.to);
        let own = segment.and_then(|s| Some(s.shear_stiffness?.at_position([s.from, s.to], x)));
        own.or(self.shear_stiffness)
    }

    /// Returns the beam with its shear stiffness multiplied by `times`.
    pub(crate) fn stiffened_in_shear(mut self, times: f64) -> Self {
        self.shear_stiffness = self.shear_stiffness.map(|stiffness| stiffness * times);
        for segment in &mut self.segments {
            segment.shear_stiffness = segment.shear_stiffness.map(|shear| shear.scaled(times));
        }
        self
    }

    /// Returns the beam without shear deformation.
    pub(crate) fn without_shear(mut self) -> Self {
        self.shear_stiffness = None;
        self.segments.iter_mut().for_each(|segment| segment.shear_stiffness = None);
        self
    }

    /// Upper bound of the bending stiffness \[N·m²\] along the beam: the largest control value (Bernstein
    /// coefficient) of its profiles.
    pub(crate) fn stiffest(&self) -> f64 {
        let segments = self.segments.iter().map(|s| s.bending_stiffness.largest());
        segments.fold(self.bending_stiffness, f64::max)
    }

    /// Returns the beam with its bending stiffness and its shear stiffness multiplied by `times`.
    pub(crate) fn stiffened(mut self, times: f64) -> Self {
        self.bending_stiffness *= times;
        for segment in &mut self.segments {
            segment.bending_stiffness = segment.bending_stiffness.scaled(times);
        }
        self.stiffened_in_shear(times)
    }

    pub(super) fn mirrored(&self) -> Self {
        let l = self.length;
        let segments = self.segments.iter().rev();
        Beam {
            segments: segments
                .map(|s| BeamSegment {
                    from: l - s.to,
                    to: l - s.from,
                    bending_stiffness: s.bending_stiffness.mirrored(),
                    shear_stiffness: s.shear_stiffness.map(Profile::mirrored),
                })
                .collect(),
            ..*self
        }
    }
}

impl BeamSegment {
    /// Bending stiffness EI \[N·m²\] at `x` on the segment.
    pub fn bending_stiffness_at(&self, x: f64) -> f64 {
        self.bending_stiffness.at_position([self.from, self.to], x)
    }

    /// Polynomial of the bending stiffness EI on a stretch of the segment.
    pub(crate) fn course(&self, x: [f64; 2]) -> CellPolynomial {
        self.bending_stiffness.on([self.from, self.to], x)
    }
}
