//! The cubic element as in textbooks: w, θ at the left end, w, θ at the right end.

/// Bending stiffness of an element of length h, without EI/h³.
pub fn bending(h: f64) -> [[f64; 4]; 4] {
    [
        [12.0, 6.0 * h, -12.0, 6.0 * h],
        [6.0 * h, 4.0 * h * h, -6.0 * h, 2.0 * h * h],
        [-12.0, -6.0 * h, 12.0, -6.0 * h],
        [6.0 * h, 2.0 * h * h, -6.0 * h, 4.0 * h * h],
    ]
}

/// Geometric stiffness of an element of length h, without P/(30 h).
pub fn geometric(h: f64) -> [[f64; 4]; 4] {
    [
        [36.0, 3.0 * h, -36.0, 3.0 * h],
        [3.0 * h, 4.0 * h * h, -3.0 * h, -h * h],
        [-36.0, -3.0 * h, 36.0, -3.0 * h],
        [3.0 * h, -h * h, -3.0 * h, 4.0 * h * h],
    ]
}
