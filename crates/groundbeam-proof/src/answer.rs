//! The claimed solution to be proven: deflection and pressure on pieces of the beam, contact forces and reactions.

/// The claimed solution to be proven, as given by a program or a document. Its numbers are exact doubles.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Answer {
    /// Pieces from left to right, which cover the beam. The left end of each piece is exactly equal to the right end of
    /// the previous piece.
    pub pieces: Vec<Piece>,
    /// Concentrated contact forces, including those under the ends of the beam.
    pub forces: Vec<Force>,
    /// Reactions of the supports. A support that is not listed has the reaction zero.
    pub reactions: Vec<Reaction>,
}

/// A part of the beam from x₀ to x₁. Its deflection is a polynomial in t = (x − (x₀ + x₁)/2)/`half` at the position x.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Piece {
    /// Positions x₀ and x₁ of the left and the right end of the piece \[m\].
    pub x: [f64; 2],
    /// Half length \[m\] of the piece, which scales the local coordinate t = (x − (x₀ + x₁)/2)/`half`. It can differ
    /// from (x₁ − x₀)/2 by rounding error.
    pub half: f64,
    /// Whether beam and ground are in contact on the piece.
    pub touches: bool,
    /// Coefficients of the deflection w \[m\] as a polynomial in the local coordinate t, the constant coefficient
    /// first.
    pub deflection: Vec<f64>,
    /// Coefficients of the rotation φ \[rad\] of the cross-sections in the local coordinate t, the constant first.
    /// Without shear deformation, the list is empty, and φ is the slope of the deflection.
    pub rotation: Vec<f64>,
    /// Coefficients of the contact pressure \[N/m\] as a polynomial in the local coordinate t, the constant coefficient
    /// first; empty if the pressure is not stored.
    pub pressure: Vec<f64>,
    /// Displacement u of the ground at both ends of a piece without contact \[m\]; `None` if it is not stored.
    pub open: Option<[f64; 2]>,
    /// Coefficients of the ground displacement u \[m\] in the local coordinate t, the constant first. The list is empty
    /// unless k or μ varies on a piece without contact.
    pub settlement: Vec<f64>,
}

/// A concentrated contact force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Force {
    /// Position \[m\].
    pub x: f64,
    /// Contact force \[N\], positive if it pushes the beam up.
    pub force: f64,
}

/// Force and moment that a support exerts on the beam.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reaction {
    /// Index of the support in the model's list.
    pub support: usize,
    /// Force of the support on the beam \[N\], positive if it pushes the beam up.
    pub force: f64,
    /// Moment of the support on the beam \[N·m\], positive if it rotates the right side of the beam down.
    pub moment: f64,
}
