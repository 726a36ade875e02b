//! Relative tolerances of solutions, and the distance `same_place` within which two positions count as equal.

/// Distance within which two positions on a beam of length `l` count as equal and may share a node: 16 units in
/// the last place of `l`. The distance is 0 if `l` is not a positive number.
pub(crate) fn same_place(l: f64) -> f64 {
    let distance = 16.0 * f64::EPSILON * l;
    if distance.is_finite() { distance.max(0.0) } else { 0.0 }
}

/// Rounding error of a sum, relative to the sum of the absolute values of its terms.
pub(crate) const SUM_ROUNDING: f64 = 8.0 * f64::EPSILON;

/// Accuracy of the position of a turning point, as a fraction of the beam's length. It is larger than
/// [`same_place`]: the slope of a field is zero at a turning point, so rounding errors of the field have a large
/// effect on the position. This accuracy also applies to contact edges, where the slope of the gap is zero.
pub(crate) const TURNING_POINT: f64 = 1e-9;
/// Smallest distance, as a fraction of the beam's length, at which two extremes of equal size are distinct. Two
/// turning points with a smaller distance count as one extreme.
pub(crate) const OTHER_EXTREME: f64 = 1e-6;

/// Residual of the contact condition (5.10) at which Uzawa's iteration and PSOR stop.
pub(crate) const SWEEPS: f64 = 1e-11;
/// Displacement of a contact edge that counts as rounding error, as a fraction of the beam's length.
pub(crate) const EDGES: f64 = 1e-12;
/// The end of an equilibrium path is accepted as a limit point if its stability margin is at most this value. At the
/// exact limit point the margin is zero. Near this point the margin is proportional to the square root of the
/// distance from it, and the computed limit point has ten correct digits.
pub(crate) const BRANCH: f64 = 1e-3;
/// Relative change of the ratio ∫u'²/∫u² of the settlement u, between two solutions, at which the iteration for the
/// soil constants stops.
pub(crate) const SOIL: f64 = 1e-12;
/// Largest accepted violation of the equilibrium and sign conditions at the nodes of a long beam.
pub(crate) const NODES: f64 = 1e-7;
/// Largest relative energy gap with which the certificate accepts a solution of the exact method.
pub(crate) const GAP: f64 = 1e-9;
