//! Defines the stiffness matrix and the load vector of one element in terms of its deformations.
//!
//! The unknowns are the deflection w and the section rotation θ of the left end, and the *deformation*: the motion of
//! the right end relative to the rigid motion of the left end. Bending depends on the deformation alone. See section 6
//! of `docs/methods.md`.

use crate::numeric::real::{Real, sum};

/// The meaning of the four unknowns v of an element.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) enum Basis {
    /// Deflection and rotation of the left end, and the deflection and rotation of the right end relative to the rigid
    /// motion of the left end.
    #[default]
    Deformation,
    /// Deflections and rotations of both ends. Elements with boundary layers and quiet elements have this basis.
    Ends,
}

/// Energy ½ vᵀKv − qᵀv of an element with the unknowns v, the stiffness matrix K and the load vector q.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Element<R = f64> {
    /// Length \[m\].
    pub length: f64,
    /// The meaning of the unknowns v.
    pub basis: Basis,
    /// The stiffness matrix K.
    pub stiffness: [[R; 4]; 4],
    /// The load vector q.
    pub load: [R; 4],
}

impl Element {
    /// Returns the coefficients of the unknowns v in the deflection w at the left or right end of the element.
    pub fn end_row(&self, right: bool) -> [f64; 4] {
        match (right, self.basis) {
            (false, _) => [1.0, 0.0, 0.0, 0.0],
            (true, Basis::Deformation) => [1.0, self.length, 1.0, 0.0],
            (true, Basis::Ends) => [0.0, 0.0, 1.0, 0.0],
        }
    }

    /// Returns the mirror image of the element. Its stiffness and its load are those for the unknowns of the mirrored
    /// element, see [`mirror_shape`].
    pub fn mirrored(&self) -> Self {
        let (h, basis) = (self.length, self.basis);
        let half: [[f64; 4]; 4] = self.stiffness.map(|row| mirror_row(&row, h, basis));
        let stiffness = std::array::from_fn(|j| {
            let column = [half[0][j], half[1][j], half[2][j], half[3][j]];
            mirror_row(&column, h, basis)
        });
        Element { stiffness, load: mirror_row(&self.load, h, basis), ..*self }
    }
}

impl<R: Real> Element<R> {
    /// Returns the coefficients of the unknowns v in the rotation θ at the left or right end of the element.
    pub fn rotation_row(&self, right: bool) -> [f64; 4] {
        match (right, self.basis) {
            (false, _) => [0.0, 1.0, 0.0, 0.0],
            (true, Basis::Deformation) => [0.0, 1.0, 0.0, 1.0],
            (true, Basis::Ends) => [0.0, 0.0, 0.0, 1.0],
        }
    }

    /// Returns the four unknowns v of the element for a unit deflection or a unit rotation of one end, with the other
    /// end fixed.
    pub fn moved_end(&self, right: bool, rotates: bool) -> [f64; 4] {
        match (right, self.basis, rotates) {
            (false, Basis::Deformation, false) => [1.0, 0.0, -1.0, 0.0],
            (false, Basis::Deformation, true) => [0.0, 1.0, -self.length, -1.0],
            (false, Basis::Ends, false) => [1.0, 0.0, 0.0, 0.0],
            (false, Basis::Ends, true) => [0.0, 1.0, 0.0, 0.0],
            (true, _, false) => [0.0, 0.0, 1.0, 0.0],
            (true, _, true) => [0.0, 0.0, 0.0, 1.0],
        }
    }

    /// Converts the element to another number type. The derivatives of its stiffness and load with respect to the
    /// parameters are dropped.
    pub fn still<S: Real>(&self) -> Element<S> {
        Element {
            length: self.length,
            basis: self.basis,
            stiffness: self.stiffness.map(|row| row.map(|k| S::from(k.value()))),
            load: self.load.map(|q| S::from(q.value())),
        }
    }

    /// Computes the forces K v − q of the element, with its stiffness matrix K and its load vector q. They are
    /// work-conjugate to the four unknowns v.
    pub fn forces(&self, v: &[R; 4]) -> [R; 4] {
        std::array::from_fn(|i| sum::<R, 4>(|j| self.stiffness[i][j] * v[j]) - self.load[i])
    }
}

/// Computes the four unknowns of an element from the unknowns of the mirrored element. The transformation is its own
/// inverse.
pub(crate) fn mirror_shape(v: &[f64; 4], h: f64, basis: Basis) -> [f64; 4] {
    let [w, theta, d1, d2] = *v;
    match basis {
        Basis::Deformation => [w + theta * h + d1, -(theta + d2), d2 * h - d1, d2],
        Basis::Ends => [d1, -d2, w, -theta],
    }
}

/// Transforms the coefficients of a linear function of an element's unknowns. The returned coefficients belong to the
/// unknowns of the mirrored element (see [`mirror_shape`]).
fn mirror_row(row: &[f64; 4], h: f64, basis: Basis) -> [f64; 4] {
    let [a, b, c, d] = *row;
    match basis {
        Basis::Deformation => [a, a * h - b, a - c, d - b + c * h],
        Basis::Ends => [c, -d, a, -b],
    }
}

/// Maximum length of an element, multiplied by the wave number of its deflection.
pub(crate) const LONGEST_SERIES: f64 = 2.0;

/// Maximum compression of a beam of length l, as a multiple of EI/l². Beyond this compression, the beam has more than
/// 10⁵ buckling waves.
pub(crate) const MOST_COMPRESSION: f64 = 1e11;
