//! The answer to be proven: its fields by piece, its concentrated contact forces and the reactions.

/// The answer to be proven, as a program or a document states it. Its numbers are exact doubles.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Answer {
    /// Pieces from left to right. They cover the beam: each piece begins with the double at which the
    /// previous piece ends.
    pub pieces: Vec<Piece>,
    /// Concentrated contact forces, including those under the ends of the beam.
    pub forces: Vec<Force>,
    /// Reactions of the supports. A support that is not listed has the reaction zero.
    pub reactions: Vec<Reaction>,
}

/// A part of the beam on which the deflection is a polynomial of t = (x − (x₀ + x₁)/2)/half.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Piece {
    /// Left and right end \[m\].
    pub x: [f64; 2],
    /// The half length \[m\] for which the coefficients are given; it can differ from (x₁ − x₀)/2 by rounding
    /// error.
    pub half: f64,
    /// Whether beam and ground are in contact on the piece.
    pub touches: bool,
    /// Coefficients of w(t) \[m\], the constant one first.
    pub deflection: Vec<f64>,
    /// Coefficients of the rotation φ(t) of the sections \[rad\]. Empty on a piece without shear deformation:
    /// φ = w′.
    pub rotation: Vec<f64>,
    /// Coefficients of the contact pressure p(t) \[N/m\]; empty if the pressure is not stored.
    pub pressure: Vec<f64>,
    /// On an open piece: the settlement u of the ground at both ends \[m\]; `None` if it is not stored.
    pub open: Option<[f64; 2]>,
    /// On an open piece over varying ground: the coefficients of u(t) \[m\]; empty if they are not stored.
    pub settlement: Vec<f64>,
}

/// A concentrated contact force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Force {
    /// Position \[m\].
    pub x: f64,
    /// Force \[N\], positive where it pushes the beam up.
    pub force: f64,
}

/// The force and the moment of a support on the beam.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reaction {
    /// Index of the support in the model's list.
    pub support: usize,
    /// Force \[N\], positive where it pushes the beam up.
    pub force: f64,
    /// Moment \[N·m\], positive if it rotates the right side down.
    pub moment: f64,
}
