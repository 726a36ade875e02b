//! Bounds of the error of a solution by the crate `groundbeam_proof` in doubles: estimates, from model and answer alone.

use groundbeam::Solution;
use groundbeam::proof::prove;

/// Bounds of the error of settlement \[m\], moment \[N·m\] and shear force \[N\] at every point of the beam; infinite if none is found.
pub fn estimated_bounds(solution: &Solution) -> [f64; 3] {
    let (model, answer) = solution.claim::<f64>();
    let bounds = prove(&model, &answer).map(|proof| proof.bounds);
    bounds.map_or([f64::INFINITY; 3], |bounds| {
        [bounds.settlement, bounds.moment, bounds.shear_force].map(|bound| bound.error)
    })
}
