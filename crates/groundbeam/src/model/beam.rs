//! The beam: EI(x) by segments, (4.1), under a constant axial force P, (2.1).

use super::profile::{Course, Profile};

/// A straight beam that bends.
#[derive(Debug, Clone, PartialEq)]
pub struct Beam {
    /// Length l \[m\], positive.
    pub length: f64,
    /// Bending stiffness EI \[N·m²\] wherever no segment says otherwise, positive.
    pub bending_stiffness: f64,
    /// Stretches with another bending stiffness. They may touch, not overlap.
    pub segments: Vec<BeamSegment>,
    /// Axial force P \[N\], tension positive, constant along the beam.
    pub axial_force: f64,
}

/// A stretch of the beam with a bending stiffness of its own.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BeamSegment {
    /// Left end \[m\].
    pub from: f64,
    /// Right end \[m\].
    pub to: f64,
    /// Bending stiffness EI \[N·m²\] from the left end to the right one, positive.
    pub bending_stiffness: Profile,
}

impl Beam {
    /// A uniform beam without axial force.
    pub fn uniform(length: f64, bending_stiffness: f64) -> Self {
        Beam { length, bending_stiffness, segments: Vec::new(), axial_force: 0.0 }
    }

    /// The same beam under an axial force P \[N\], tension positive.
    pub fn with_axial_force(mut self, axial_force: f64) -> Self {
        self.axial_force = axial_force;
        self
    }

    /// The same beam with another bending stiffness \[N·m²\] between two positions.
    pub fn with_segment(self, from: f64, to: f64, bending_stiffness: f64) -> Self {
        self.with_varying_segment(from, to, Profile::constant(bending_stiffness))
    }

    /// The same beam with a bending stiffness \[N·m²\] that varies between two positions.
    ///
    /// ```
    /// use groundbeam::{Beam, Profile};
    ///
    /// let beam = Beam::uniform(4.0, 1.0).with_varying_segment(0.0, 4.0, Profile::linear(1.0, 3.0));
    /// assert_eq!(beam.bending_stiffness_at(1.0), 1.5);
    /// ```
    pub fn with_varying_segment(mut self, from: f64, to: f64, bending_stiffness: Profile) -> Self {
        self.segments.push(BeamSegment { from, to, bending_stiffness });
        self
    }

    /// Bending stiffness EI \[N·m²\] at `x`; at the joint of two segments that of the right one.
    pub fn bending_stiffness_at(&self, x: f64) -> f64 {
        let segment = self.segments.iter().find(|s| s.from <= x && x < s.to);
        segment
            .map_or(self.bending_stiffness, |s| s.bending_stiffness.at_position([s.from, s.to], x))
    }

    /// The largest bending stiffness given: it is nowhere more.
    pub(crate) fn stiffest(&self) -> f64 {
        let segments = self.segments.iter().map(|s| s.bending_stiffness.largest());
        segments.fold(self.bending_stiffness, f64::max)
    }

    /// EI on a stretch of the beam within which no segment ends.
    pub(crate) fn bending_stiffness_on(&self, x: [f64; 2]) -> Course {
        let middle = 0.5 * (x[0] + x[1]);
        let segment = self.segments.iter().find(|s| s.from <= middle && middle < s.to);
        segment.map_or(Course::constant(self.bending_stiffness), |s| s.course(x))
    }

    /// The same beam, as many times as stiff.
    pub(crate) fn stiffened(mut self, times: f64) -> Self {
        self.bending_stiffness *= times;
        for segment in &mut self.segments {
            segment.bending_stiffness = segment.bending_stiffness.scaled(times);
        }
        self
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
                })
                .collect(),
            ..*self
        }
    }
}

impl BeamSegment {
    /// EI on a stretch of the segment.
    pub(crate) fn course(&self, x: [f64; 2]) -> Course {
        self.bending_stiffness.on([self.from, self.to], x)
    }
}
