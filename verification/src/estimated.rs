//! Bounds of the error of a solution by the crate `groundbeam_proof` in doubles: estimates, from model and answer alone.

use groundbeam::Solution;
use groundbeam::proof::prove;

/// Bounds of the error of settlement \[m\] and moment \[N·m\] at every point of the beam; infinite if none is found.
pub fn estimated_bounds(solution: &Solution) -> [f64; 2] {
    let (model, answer) = solution.claim::<f64>();
    let bounds = prove(&model, &answer).map(|proof| proof.bounds);
    bounds.map_or([f64::INFINITY; 2], |bounds| [bounds.settlement.error, bounds.moment.error])
}
