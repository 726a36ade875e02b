//! What acts on the beam: the terms of (4.7).

/// A load. Forces are positive down; moments are positive where they turn the right side down,
/// doing the work M₀·w'(x) of (4.7).
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Load {
    /// A force at a point, fᵢ of (4.7).
    PointForce {
        /// Position \[m\].
        at: f64,
        /// Force F \[N\].
        force: f64,
    },
    /// A moment at a point, gᵢ of (4.7).
    PointMoment {
        /// Position \[m\].
        at: f64,
        /// Moment M₀ \[N·m\].
        moment: f64,
    },
    /// A force spread over a stretch, f(x) of (4.7), linear between its ends.
    Distributed {
        /// Left end \[m\].
        from: f64,
        /// Right end \[m\].
        to: f64,
        /// Intensity at the left end \[N/m\].
        start: f64,
        /// Intensity at the right end \[N/m\].
        end: f64,
    },
    /// A moment spread over a stretch, g(x) of (4.7), linear between its ends.
    DistributedMoment {
        /// Left end \[m\].
        from: f64,
        /// Right end \[m\].
        to: f64,
        /// Intensity at the left end \[N·m/m\].
        start: f64,
        /// Intensity at the right end \[N·m/m\].
        end: f64,
    },
    /// A curvature that the beam takes by itself over a stretch, linear between its ends: of a temperature
    /// gradient, of shrinkage, of a camber. M = −EI (w″ − κ₀); positive as w″ is, where it bends the beam's
    /// ends down. It does no work on rigid motions.
    Curvature {
        /// Left end \[m\].
        from: f64,
        /// Right end \[m\].
        to: f64,
        /// κ₀ at the left end \[1/m\].
        start: f64,
        /// κ₀ at the right end \[1/m\].
        end: f64,
    },
    /// A force on the ground's surface, not on the beam: a neighbour. It needs a shear layer.
    GroundForce {
        /// Position \[m\], under the beam or beside it.
        at: f64,
        /// Force \[N\], down.
        force: f64,
    },
    /// A force spread on the ground's surface, linear between its ends: q in −(μu′)′ + ku = p + q.
    GroundDistributed {
        /// Left end \[m\].
        from: f64,
        /// Right end \[m\].
        to: f64,
        /// Intensity at the left end \[N/m\].
        start: f64,
        /// Intensity at the right end \[N/m\].
        end: f64,
    },
}

impl Load {
    /// A force at a point \[N, m\].
    pub fn point(force: f64, at: f64) -> Self {
        Load::PointForce { at, force }
    }

    /// A moment at a point \[N·m, m\].
    pub fn moment(moment: f64, at: f64) -> Self {
        Load::PointMoment { at, moment }
    }

    /// An even load \[N/m\] between two positions \[m\].
    pub fn uniform(intensity: f64, from: f64, to: f64) -> Self {
        Load::Distributed { from, to, start: intensity, end: intensity }
    }

    /// An even imposed curvature κ₀ \[1/m\] between two positions \[m\].
    pub fn curvature(curvature: f64, from: f64, to: f64) -> Self {
        Load::Curvature { from, to, start: curvature, end: curvature }
    }

    /// Whether it acts on the ground and not on the beam.
    pub fn is_on_ground(&self) -> bool {
        matches!(self, Load::GroundForce { .. } | Load::GroundDistributed { .. })
    }

    /// The same load, `factor` times as large.
    pub fn scaled(self, factor: f64) -> Self {
        match self {
            Load::PointForce { at, force } => Load::PointForce { at, force: force * factor },
            Load::PointMoment { at, moment } => Load::PointMoment { at, moment: moment * factor },
            Load::Distributed { from, to, start, end } => {
                Load::Distributed { from, to, start: start * factor, end: end * factor }
            }
            Load::DistributedMoment { from, to, start, end } => {
                Load::DistributedMoment { from, to, start: start * factor, end: end * factor }
            }
            Load::Curvature { from, to, start, end } => {
                Load::Curvature { from, to, start: start * factor, end: end * factor }
            }
            Load::GroundForce { at, force } => Load::GroundForce { at, force: force * factor },
            Load::GroundDistributed { from, to, start, end } => {
                Load::GroundDistributed { from, to, start: start * factor, end: end * factor }
            }
        }
    }

    pub(super) fn mirrored(self, l: f64) -> Self {
        match self {
            Load::PointForce { at, force } => Load::PointForce { at: l - at, force },
            Load::PointMoment { at, moment } => Load::PointMoment { at: l - at, moment: -moment },
            Load::Distributed { from, to, start, end } => {
                Load::Distributed { from: l - to, to: l - from, start: end, end: start }
            }
            Load::DistributedMoment { from, to, start, end } => {
                Load::DistributedMoment { from: l - to, to: l - from, start: -end, end: -start }
            }
            Load::Curvature { from, to, start, end } => {
                Load::Curvature { from: l - to, to: l - from, start: end, end: start }
            }
            Load::GroundForce { at, force } => Load::GroundForce { at: l - at, force },
            Load::GroundDistributed { from, to, start, end } => {
                Load::GroundDistributed { from: l - to, to: l - from, start: end, end: start }
            }
        }
    }
}
