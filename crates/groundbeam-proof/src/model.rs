//! The model: beam, ground, loads, supports, hinges and initial gap, as exact numbers or balls.
//!
//! All numbers are in one coherent system of units (m, N, rad and their products). Positions are measured from the
//! beam's left end. Deflections, settlements and forces are positive down.

use crate::scalar::Scalar;

/// A beam, the ground under it, and the loads on them.
#[derive(Debug, Clone, PartialEq)]
pub struct Model<S> {
    /// The beam.
    pub beam: Beam<S>,
    /// The ground.
    pub ground: Ground<S>,
    /// The loads on the beam and on the ground.
    pub loads: Vec<Load<S>>,
    /// The supports of the beam. An answer refers to a support by its index in this list.
    pub supports: Vec<Support<S>>,
    /// Hinges inside the beam.
    pub hinges: Vec<Hinge<S>>,
    /// Corners of the initial clearance, from left to right. Empty: the clearance is zero.
    pub gap: Vec<GapCorner<S>>,
}

/// A straight beam.
#[derive(Debug, Clone, PartialEq)]
pub struct Beam<S> {
    /// Length l \[m\], positive.
    pub length: S,
    /// Bending stiffness EI \[N·m²\] outside the segments, positive.
    pub bending_stiffness: S,
    /// Shear stiffness S \[N\] outside the segments, positive; `None` for a beam without shear deformation.
    pub shear_stiffness: Option<S>,
    /// Stretches with other stiffnesses. They may adjoin, but not overlap.
    pub segments: Vec<BeamSegment<S>>,
    /// Axial force P \[N\], tension positive, constant along the beam.
    pub axial_force: S,
}

/// A stretch of the beam with stiffnesses of its own.
#[derive(Debug, Clone, PartialEq)]
pub struct BeamSegment<S> {
    /// Left end \[m\].
    pub from: S,
    /// Right end \[m\].
    pub to: S,
    /// Bending stiffness EI \[N·m²\] along the segment.
    pub bending_stiffness: Course<S>,
    /// Shear stiffness S \[N\] along the segment; `None` for the stiffness of the beam.
    pub shear_stiffness: Option<Course<S>>,
}

/// The ground: springs, connected by a shear layer where μ > 0.
#[derive(Debug, Clone, PartialEq)]
pub struct Ground<S> {
    /// Spring constant k \[N/m²\] outside the segments: force per length of beam and per settlement; positive.
    pub spring: S,
    /// Shear constant μ \[N\] outside the segments; not negative.
    pub shear: S,
    /// Stretches with other constants, under the beam and outside it. They may adjoin, but not overlap. The ground outside
    /// the beam has the constants of the beam's end until a segment begins; each segment continues outward until the next
    /// one.
    pub segments: Vec<GroundSegment<S>>,
    /// How the ground ends on the left and on the right.
    pub ends: [GroundEnd<S>; 2],
}

/// A stretch of ground with constants of its own.
#[derive(Debug, Clone, PartialEq)]
pub struct GroundSegment<S> {
    /// Left end \[m\].
    pub from: S,
    /// Right end \[m\].
    pub to: S,
    /// Spring constant k \[N/m²\] along the segment, positive.
    pub spring: Course<S>,
    /// Shear constant μ \[N\] along the segment: zero everywhere or positive everywhere.
    pub shear: Course<S>,
}

/// A number that is constant along a stretch, or a polynomial of the position.
#[derive(Debug, Clone, PartialEq)]
pub enum Course<S> {
    /// Constant along the stretch.
    Constant(S),
    /// At least two Bernstein coefficients from the left end to the right end; two coefficients make the number linear.
    Varying(Vec<S>),
}

impl<S: Copy> Course<S> {
    /// The value at the left or at the right end.
    pub(crate) fn end(&self, side: usize) -> Option<S> {
        match self {
            Course::Constant(value) => Some(*value),
            Course::Varying(values) if side == 0 => values.first().copied(),
            Course::Varying(values) => values.last().copied(),
        }
    }
}

/// The end of the ground outside one end of the beam.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum GroundEnd<S> {
    /// The ground is infinite.
    Endless,
    /// The surface ends at this position \[m\] and is free there: μu′ = 0. The position is the beam's end or
    /// outside the beam.
    Free(S),
    /// The surface is held at this position \[m\], outside the beam: u = 0.
    Held(S),
}

/// The effect of a load.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Action {
    /// A force \[N\] or \[N/m\], positive down.
    Force,
    /// A moment \[N·m\] or \[N\], positive if it rotates the right side down: it does the work M₀·w′.
    Moment,
    /// An imposed curvature κ₀ \[1/m\] along a stretch of the beam: M = −EI (w″ − κ₀).
    Curvature,
}

/// Position and size of a load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Extent<S> {
    /// At a point.
    Point {
        /// Position \[m\].
        at: S,
        /// Size: force \[N\] or moment \[N·m\].
        size: S,
    },
    /// Along a stretch, linear between its ends.
    Distributed {
        /// Left end \[m\].
        from: S,
        /// Right end \[m\].
        to: S,
        /// Size at the left end.
        start: S,
        /// Size at the right end.
        end: S,
    },
}

/// A load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Load<S> {
    /// Its effect.
    pub action: Action,
    /// Its position and size.
    pub extent: Extent<S>,
    /// Whether the load acts on the ground's surface instead of the beam.
    pub on_ground: bool,
}

/// A support at one point of the beam.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Support<S> {
    /// Position \[m\].
    pub at: S,
    /// The motions that the support restrains.
    pub kind: SupportKind<S>,
    /// Settlement δ \[m\], positive down.
    pub settlement: S,
    /// The directions in which the support acts.
    pub acts: Acts,
}

/// The motions that a support restrains.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SupportKind<S> {
    /// A rigid support without rotational restraint: w = δ.
    Pinned,
    /// A rigid support that also prevents rotation: w = δ and w′ = 0.
    Fixed,
    /// An elastic support: a force κ(w − δ) and a moment κ_θ w′ oppose the motion.
    Spring {
        /// κ \[N/m\], not negative.
        spring: S,
        /// κ_θ \[N·m/rad\], not negative.
        rotational_spring: S,
    },
}

/// The directions in which a support acts on the beam.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Acts {
    /// The support acts in both directions.
    Both,
    /// The support only pushes the beam up.
    Up,
    /// The support only pulls the beam down.
    Down,
}

impl Acts {
    /// The component of a deflection or of an upward force in the direction in which a one-way support acts.
    pub(crate) fn towards<S: Scalar>(self, x: S) -> S {
        match self {
            Acts::Both | Acts::Up => x,
            Acts::Down => -x,
        }
    }
}

/// A hinge inside the beam.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hinge<S> {
    /// Position \[m\].
    pub at: S,
    /// Rotational spring k_φ \[N·m/rad\]: the hinge transmits M = −k_φ\[w′\]. It is 0 for a free hinge.
    pub rotational_spring: S,
}

/// One corner of the initial clearance, which is linear between corners and constant beyond the outermost ones.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GapCorner<S> {
    /// Position \[m\].
    pub at: S,
    /// Clearance g₀ \[m\], positive where there is a gap between beam and ground.
    pub value: S,
}
