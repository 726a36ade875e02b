//! The tolerances of solutions, all relative; `same_place` is the distance within which two positions count as equal.

/// The distance within which two positions count as equal on a beam of length `l`, so that they may share a
/// node: 16 units in the last place of `l`. It is 0 if `l` is not a positive number.
pub(crate) fn same_place(l: f64) -> f64 {
    let distance = 16.0 * f64::EPSILON * l;
    if distance.is_finite() { distance.max(0.0) } else { 0.0 }
}

/// The rounding error of a sum, relative to the sum of the absolute values.
pub(crate) const SUM_ROUNDING: f64 = 8.0 * f64::EPSILON;

/// The accuracy of the position of a turning point, as a fraction of the beam's length. It is larger than
/// [`same_place`]: a field is flat at a turning point, and the gap is flat at an edge of contact as well, so
/// that rounding of values moves the point by more than rounding of positions.
pub(crate) const TURNING_POINT: f64 = 1e-9;
/// The smallest distance, as a fraction of the beam's length, at which two extremes of equal size are
/// distinct. Two turning points closer than this are one extreme.
pub(crate) const OTHER_EXTREME: f64 = 1e-6;

/// The residual of the contact condition (5.10) at which Uzawa's iteration and PSOR stop.
pub(crate) const SWEEPS: f64 = 1e-11;
/// The displacement of a contact edge that is rounding error, as a fraction of the beam's length.
pub(crate) const EDGES: f64 = 1e-12;
/// The stability margin below which a path of equilibria has ended at a limit point. A limit point is known
/// to ten digits, and the margin decreases with the square root of the distance from it.
pub(crate) const BRANCH: f64 = 1e-3;
/// The tolerated change of the soil's rate r from one solution to the next.
pub(crate) const SOIL: f64 = 1e-12;
/// The largest accepted violation of equilibrium and sign conditions at the nodes of a long beam.
pub(crate) const NODES: f64 = 1e-7;
/// The largest relative energy gap with which the certificate accepts a solution of the exact method.
pub(crate) const GAP: f64 = 1e-9;
