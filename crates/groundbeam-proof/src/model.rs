//! The model: beam, ground, loads, supports, hinges and initial gap, as exact numbers or balls.
//!
//! The units are m, N, rad and their products. Positions are measured from the beam's left end. Deflections,
//! settlements and forces are positive down.

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
    /// The supports of the beam. A claimed solution refers to a support by its index in this list.
    pub supports: Vec<Support<S>>,
    /// Hinges inside the beam.
    pub hinges: Vec<Hinge<S>>,
    /// Corners of the initial clearance g₀, from left to right. The clearance is zero if the list is empty.
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
    /// Segments of the beam with their own stiffnesses. Segments may adjoin but must not overlap.
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
    /// Shear stiffness S \[N\] along the segment; `None` if the segment has the shear stiffness of the beam.
    pub shear_stiffness: Option<Course<S>>,
}

/// The ground: springs that are connected by a shear layer where μ > 0.
#[derive(Debug, Clone, PartialEq)]
pub struct Ground<S> {
    /// Subgrade modulus k \[N/m²\] outside the segments, positive: the force per unit length of beam and unit
    /// settlement.
    pub spring: S,
    /// Stiffness μ \[N\] of the shear layer outside the segments, not negative.
    pub shear: S,
    /// Segments of the ground with their own k and μ, which must not overlap. Outside the beam, the values of a segment
    /// or of the beam's end hold outward up to the next segment.
    pub segments: Vec<GroundSegment<S>>,
    /// End conditions of the ground on the left and on the right.
    pub ends: [GroundEnd<S>; 2],
}

/// A segment of the ground with its own k and μ.
#[derive(Debug, Clone, PartialEq)]
pub struct GroundSegment<S> {
    /// Left end \[m\].
    pub from: S,
    /// Right end \[m\].
    pub to: S,
    /// Subgrade modulus k \[N/m²\] along the segment, positive.
    pub spring: Course<S>,
    /// Stiffness μ \[N\] of the shear layer along the segment, zero everywhere or positive everywhere.
    pub shear: Course<S>,
}

/// A quantity along a stretch: a constant, or a polynomial in the position.
#[derive(Debug, Clone, PartialEq)]
pub enum Course<S> {
    /// The quantity has this constant value along the stretch.
    Constant(S),
    /// Bernstein coefficients of the polynomial, from the left end of the stretch to the right end; at least two.
    Varying(Vec<S>),
}

impl<S: Copy> Course<S> {
    /// The value at the left end of the stretch (`side` is 0) or at its right end (`side` is 1).
    pub(crate) fn end(&self, side: usize) -> Option<S> {
        match self {
            Course::Constant(value) => Some(*value),
            Course::Varying(values) if side == 0 => values.first().copied(),
            Course::Varying(values) => values.last().copied(),
        }
    }
}

/// Where and how the ground ends on one side of the beam.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum GroundEnd<S> {
    /// The ground is infinite.
    Endless,
    /// The surface of the ground has a free end at this position \[m\]: μu′ = 0. The position is the beam's end or
    /// outside the beam.
    Free(S),
    /// The surface of the ground is held at this position \[m\] outside the beam: u = 0.
    Held(S),
}

/// The effect of a load.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Action {
    /// A point force \[N\] or a distributed force \[N/m\], positive down.
    Force,
    /// A point moment M₀ \[N·m\] or a distributed moment \[N\], positive if it rotates the right side down. A point
    /// moment does the work M₀·w′.
    Moment,
    /// An imposed curvature κ₀ \[1/m\] along a stretch of the beam: M = −EI (w″ − κ₀).
    Curvature,
}

/// Position and size of a load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Extent<S> {
    /// A load at a point.
    Point {
        /// Position \[m\].
        at: S,
        /// Size of the point force \[N\] or of the point moment \[N·m\].
        size: S,
    },
    /// A load along a stretch, linear between the ends of the stretch.
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
    /// Whether the support is pinned, fixed or elastic.
    pub kind: SupportKind<S>,
    /// Settlement δ \[m\] of the support, positive down.
    pub settlement: S,
    /// The directions in which the support acts.
    pub acts: Acts,
}

/// Restraint of deflection and rotation by a support.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SupportKind<S> {
    /// A rigid support without rotational restraint: the deflection w is the settlement δ of the support.
    Pinned,
    /// A rigid support that also prevents rotation: w is the settlement δ of the support, and w′ = 0.
    Fixed,
    /// An elastic support with the settlement δ. It applies the force κ(w − δ) against the deflection and the moment
    /// κ_θ w′ against the rotation.
    Spring {
        /// Stiffness κ \[N/m\] of the translational spring, not negative.
        spring: S,
        /// Stiffness κ_θ \[N·m/rad\] of the rotational spring, not negative.
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
    /// Reverses the sign of the deflection or upward reaction `x` if the support only pulls the beam down. A positive
    /// result means that the beam is pressed against a one-way support.
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
    /// Stiffness k_φ \[N·m/rad\] of the rotational spring, 0 for a free hinge. The hinge transmits the moment M =
    /// −k_φ\[w′\], where \[w′\] is the hinge rotation.
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
