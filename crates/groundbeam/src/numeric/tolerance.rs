//! Relative tolerances of solutions, and the distance `same_place` within which two positions count as equal.

/// Distance within which two positions on a beam of length `l` count as equal: 16 units in the last place of `l`.
pub(crate) fn same_place(l: f64) -> f64 {
    let distance = 16.0 * f64::EPSILON * l;
    if distance.is_finite() { distance.max(0.0) } else { 0.0 }
}

/// Rounding error of a sum, relative to the sum of the absolute values of its terms.
pub(crate) const SUM_ROUNDING: f64 = 8.0 * f64::EPSILON;

/// Accuracy of the positions of turning points and contact edges, relative to the beam's length. Rounding errors have a
/// large effect there, because the slope of field or gap is zero.
pub(crate) const TURNING_POINT: f64 = 1e-9;
/// Smallest distance, as a fraction of the beam's length, at which two extremes of equal size are distinct. Two
/// turning points with a smaller distance count as one extreme.
pub(crate) const OTHER_EXTREME: f64 = 1e-6;

/// Residual of the contact condition (5.10) at which Uzawa's iteration and PSOR stop.
pub(crate) const SWEEPS: f64 = 1e-11;
/// Displacement of a contact edge that counts as rounding error, as a fraction of the beam's length.
pub(crate) const EDGES: f64 = 1e-12;
/// Largest stability margin at which the end of an equilibrium path counts as a limit point. Near a limit point, the
/// margin is proportional to the square root of the distance to this point.
pub(crate) const BRANCH: f64 = 1e-3;
/// Relative change of the ratio ∫u'²/∫u² of the settlement u, between two solutions, at which the iteration for the
/// soil constants stops.
pub(crate) const SOIL: f64 = 1e-12;
/// Largest accepted violation of the equilibrium and sign conditions at the nodes of a long beam.
pub(crate) const NODES: f64 = 1e-7;
/// Largest relative energy gap with which the certificate accepts a solution of the exact method.
pub(crate) const GAP: f64 = 1e-9;
