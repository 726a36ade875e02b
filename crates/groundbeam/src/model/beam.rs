//! The beam: EI(x) by segments, (4.1), under a constant axial force P, (2.1).

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
    /// Bending stiffness EI \[N·m²\], positive.
    pub bending_stiffness: f64,
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
    pub fn with_segment(mut self, from: f64, to: f64, bending_stiffness: f64) -> Self {
        self.segments.push(BeamSegment { from, to, bending_stiffness });
        self
    }

    /// Bending stiffness EI \[N·m²\] at `x`; at the joint of two segments that of the right one.
    pub fn bending_stiffness_at(&self, x: f64) -> f64 {
        self.segments
            .iter()
            .find(|s| s.from <= x && x < s.to)
            .map_or(self.bending_stiffness, |s| s.bending_stiffness)
    }

    pub(super) fn mirrored(&self) -> Self {
        let l = self.length;
        let segments = self.segments.iter().rev();
        Beam {
            segments: segments
                .map(|s| BeamSegment { from: l - s.to, to: l - s.from, ..*s })
                .collect(),
            ..*self
        }
    }
}
