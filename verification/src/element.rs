//! Stiffness matrices of the cubic beam element of textbooks; the unknowns are w, θ at the left and w, θ at the right end.

/// Returns the bending stiffness matrix of an element of length h, divided by EI/h³.
pub fn bending(h: f64) -> [[f64; 4]; 4] {
    [
        [12.0, 6.0 * h, -12.0, 6.0 * h],
        [6.0 * h, 4.0 * h * h, -6.0 * h, 2.0 * h * h],
        [-12.0, -6.0 * h, 12.0, -6.0 * h],
        [6.0 * h, 2.0 * h * h, -6.0 * h, 4.0 * h * h],
    ]
}

/// Returns the stiffness matrix of an element of length h under the tension P, divided by EI. It uses stability
/// functions of u = h √(P/EI).
pub fn in_tension(h: f64, u: f64) -> [[f64; 4]; 4] {
    let (sinh, cosh) = (u.sinh(), u.cosh());
    let d = 2.0 - 2.0 * cosh + u * sinh;
    let shear = u.powi(3) * sinh / (d * h.powi(3));
    let moment = u * u * (cosh - 1.0) / (d * h * h);
    let near = u * (u * cosh - sinh) / (d * h);
    let far = u * (sinh - u) / (d * h);
    [
        [shear, moment, -shear, moment],
        [moment, near, -moment, far],
        [-shear, -moment, shear, -moment],
        [moment, far, -moment, near],
    ]
}

/// Returns the geometric stiffness matrix of an element of length h under the axial force P, divided by P/(30 h).
pub fn geometric(h: f64) -> [[f64; 4]; 4] {
    [
        [36.0, 3.0 * h, -36.0, 3.0 * h],
        [3.0 * h, 4.0 * h * h, -3.0 * h, -h * h],
        [-36.0, -3.0 * h, 36.0, -3.0 * h],
        [3.0 * h, -h * h, -3.0 * h, 4.0 * h * h],
    ]
}
