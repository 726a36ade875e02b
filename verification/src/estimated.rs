//! Estimated error bounds of a solution by the crate `groundbeam_proof` in doubles, from model and solution only.

use groundbeam::Solution;
use groundbeam::proof::{Ball, prove};

/// Error bounds of settlement \[m\], moment \[N·m\] and shear force \[N\] at every point of the beam; infinite if no
/// bound is found.
pub fn estimated_bounds(solution: &Solution) -> [f64; 3] {
    let (model, answer) = solution.claim::<Ball>();
    let bounds = prove(&model, &answer).map(|proof| proof.bounds);
    bounds.map_or([f64::INFINITY; 3], |bounds| {
        [bounds.settlement, bounds.moment, bounds.shear_force].map(|bound| bound.error)
    })
}
