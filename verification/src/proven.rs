//! Computes proven error bounds of a solution from the model and the solution.

use groundbeam::Solution;

/// Returns the error bounds of settlement \[m\], moment \[N·m\] and shear force \[N\] at every point of the beam;
/// infinite if nothing is proven.
pub fn proven_bounds(solution: &Solution) -> [f64; 3] {
    let bounds = solution.prove().map(|proof| proof.bounds);
    bounds.map_or([f64::INFINITY; 3], |bounds| {
        [bounds.settlement, bounds.moment, bounds.shear_force].map(|bound| bound.error)
    })
}
