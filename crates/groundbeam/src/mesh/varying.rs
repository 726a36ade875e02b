//! Computes ground pressure, energy integrals and two-ports (equivalent springs) for a cell whose beam or ground data vary.

use crate::ground::link::TwoPort;
use crate::mesh::cell::Cell;
use crate::numeric::polynomial::{Coefficients, derivative, inner, product, rescale};
use crate::numeric::real::Real;

/// Computes the [`TwoPort`] of the ground out of contact in a part of a cell, from the two-ports of short stretches in
/// series.
pub(crate) fn link<R: Real>(cell: &Cell<R>, part: [f64; 2]) -> TwoPort<R> {
    // The local coordinates of the part give its length more accurately than the rounded positions of its ends.
    let half = 0.25 * (part[1] - part[0]) * cell.length();
    cell.ground().part(part).two_port(half)
}

/// Computes the coefficients of the pressure kψ − (μψ')' under a ground settlement ψ, from the coefficients of ψ on a
/// stretch of half length `half`.
pub(crate) fn pressure<R: Real>(cell: &Cell<R>, half: f64, obstacle: &[R]) -> Coefficients<R> {
    let flux = product(&cell.shear_layer_along(), &derivative(obstacle));
    let mut pressure = product(&cell.subgrade_along(), obstacle);
    for (pressure, c) in pressure.iter_mut().zip(derivative(&flux).iter()) {
        *pressure -= *c / (half * half);
    }
    pressure
}

/// Computes the bending integral ∫ EI f″ g″ ds over \[−1, 1\], with derivatives with respect to s.
pub(crate) fn bending<R: Real>(cell: &Cell<R>, f: &[R], g: &[R]) -> R {
    let bend = |c: &[R]| derivative(&derivative(c));
    inner(&product(&cell.stiffness_along(), &bend(f)), &bend(g), 0)
}

/// Computes the ground integral ∫ (k f g + μ f' g') dx over a part of a cell.
pub(crate) fn energy_form<R: Real>(cell: &Cell<R>, part: [f64; 2], f: &[R], g: &[R]) -> R {
    let (middle, quarter) = (0.5 * (part[0] + part[1]), 0.5 * (part[1] - part[0]));
    let half = 0.5 * cell.length() * quarter;
    let (spring, shear) = (cell.subgrade_along(), cell.shear_layer_along());
    let [f, g, spring, shear] = [f, g, &spring, &shear].map(|c| rescale(c, middle, quarter));
    let [df, dg] = [&f, &g].map(|c| derivative(c));
    inner(&product(&spring, &f), &g, 0) * half + inner(&product(&shear, &df), &dg, 0) / half
}
