//! The stiffness and load of one element, in element deformations.
//!
//! The four unknowns of an element are the deflection and slope of its left end, and the *deformation* d =
//! x_right − T x_left, with x = (w, θ) and T = \[\[1, h\], \[0, 1\]\]: the displacement of the right end
//! relative to the rigid motion of the left end. The bending energy depends on d alone, and the energy of the
//! ground mainly on the rigid motion, so the two stiffnesses are never added. A sum of EI/h³ and kh loses
//! digits as the mesh is refined. θ is the rotation of the sections: w' where the beam has no shear
//! flexibility.

use crate::numeric::real::{Real, sum};

/// The meaning of the four unknowns v of an element.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) enum Basis {
    /// (w_left, θ_left, d₁, d₂).
    #[default]
    Deformation,
    /// (w_left, θ_left, w_right, θ_right), for elements with boundary layers. Such an element is flexible
    /// against rotations of its ends and stiff against a difference of their deflections.
    Ends,
}

/// Energy ½ vᵀKv − qᵀv of an element.
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
    /// The coefficients of v in w at the element's left or right end.
    pub fn end_row(&self, right: bool) -> [f64; 4] {
        match (right, self.basis) {
            (false, _) => [1.0, 0.0, 0.0, 0.0],
            (true, Basis::Deformation) => [1.0, self.length, 1.0, 0.0],
            (true, Basis::Ends) => [0.0, 0.0, 1.0, 0.0],
        }
    }

    /// The mirrored element, in the unknowns of the mirrored element.
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
    /// The coefficients of v in θ at the element's left or right end.
    pub fn rotation_row(&self, right: bool) -> [f64; 4] {
        match (right, self.basis) {
            (false, _) => [0.0, 1.0, 0.0, 0.0],
            (true, Basis::Deformation) => [0.0, 1.0, 0.0, 1.0],
            (true, Basis::Ends) => [0.0, 0.0, 0.0, 1.0],
        }
    }

    /// v for a unit deflection or a unit rotation of one end, with the other end fixed.
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

    /// The same element in another number type, without derivatives.
    pub fn still<S: Real>(&self) -> Element<S> {
        Element {
            length: self.length,
            basis: self.basis,
            stiffness: self.stiffness.map(|row| row.map(|k| S::from(k.value()))),
            load: self.load.map(|q| S::from(q.value())),
        }
    }

    /// K v − q: the forces that do work on the four unknowns v.
    pub fn forces(&self, v: &[R; 4]) -> [R; 4] {
        std::array::from_fn(|i| sum::<R, 4>(|j| self.stiffness[i][j] * v[j]) - self.load[i])
    }
}

/// The four unknowns of an element from those of the mirrored element. The same transformation leads back.
pub(crate) fn mirror_shape(v: &[f64; 4], h: f64, basis: Basis) -> [f64; 4] {
    let [w, theta, d1, d2] = *v;
    match basis {
        Basis::Deformation => [w + theta * h + d1, -(theta + d2), d2 * h - d1, d2],
        Basis::Ends => [d1, -d2, w, -theta],
    }
}

/// Coefficients of the mirrored element's unknowns v': row·v = row·(Q v') with Q of [`mirror_shape`].
fn mirror_row(row: &[f64; 4], h: f64, basis: Basis) -> [f64; 4] {
    let [a, b, c, d] = *row;
    match basis {
        Basis::Deformation => [a, a * h - b, a - c, d - b + c * h],
        Basis::Ends => [c, -d, a, -b],
    }
}

/// The longest element, as a multiple of 1/|r|.
pub(crate) const LONGEST_SERIES: f64 = 2.0;

/// Maximum compression as a multiple of EI/l². Beyond it, the beam has more than 10⁵ buckling waves.
pub(crate) const MOST_COMPRESSION: f64 = 1e11;
