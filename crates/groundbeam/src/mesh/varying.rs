//! Pressures, integrals and two-ports of a cell whose beam or ground data vary.

use crate::ground::link::TwoPort;
use crate::mesh::cell::{Cell, GROUND, ZERO_FREE_RADIUS, values};
use crate::numeric::polynomial::{
    Coefficients, derivative, inner, product, rescale, rescale_in_place, value,
};
use crate::numeric::real::Real;
use crate::numeric::roots::is_free_of_zeros;

/// Maximum number of halvings of a stretch of ground when its two-port is computed.
const MOST_HALVINGS: u32 = 40;

/// Computes the equivalent springs, a [`TwoPort`], of the ground out of contact in a part of a cell. The part is
/// divided into stretches in which a power series with few terms represents the ground displacement. The two-ports of
/// the stretches are connected in series.
pub(crate) fn link<R: Real>(cell: &Cell<R>, part: [f64; 2]) -> TwoPort<R> {
    // The local coordinates of the part give its length more accurately than the rounded positions of its ends.
    let half = 0.25 * (part[1] - part[0]) * cell.length();
    chain(cell.ground().part(part), half, MOST_HALVINGS)
}

fn chain<R: Real>(ground: GroundStretch<R>, half: f64, halvings: u32) -> TwoPort<R> {
    if halvings == 0 || (ground.is_short(half) && ground.is_smooth()) {
        return TwoPort::varying(&ground.subgrade, &ground.shear_layer, half);
    }
    let [left, right] =
        [[-1.0, 0.0], [0.0, 1.0]].map(|s| chain(ground.part(s), 0.5 * half, halvings - 1));
    left.then(right)
}

/// k and μ along a stretch of ground, as polynomials of the coordinate s ∈ \[−1, 1\] of the stretch.
#[derive(Debug, Clone, Copy)]
pub(crate) struct GroundStretch<R> {
    pub subgrade: [R; GROUND],
    pub shear_layer: [R; GROUND],
}

impl<R: Real> GroundStretch<R> {
    /// The part of the stretch between two values of s.
    pub fn part(mut self, s: [f64; 2]) -> Self {
        let (middle, half) = (0.5 * (s[0] + s[1]), 0.5 * (s[1] - s[0]));
        rescale_in_place(&mut self.subgrade, middle, half);
        rescale_in_place(&mut self.shear_layer, middle, half);
        self
    }

    /// Whether k and μ vary little enough for short power series.
    pub fn is_smooth(&self) -> bool {
        let is_free = |c: &[R; GROUND]| is_free_of_zeros(&values(c), ZERO_FREE_RADIUS);
        is_free(&self.subgrade)
            && (self.shear_layer[0].value() == 0.0 || is_free(&self.shear_layer))
    }

    /// Whether one short power series represents the surface of the ground without contact. `half` is half the length
    /// of the stretch.
    pub fn is_short(&self, half: f64) -> bool {
        if self.shear_layer[0].value() == 0.0 {
            return true;
        }
        let squared = [-1.0, 0.0, 1.0].map(|s| {
            let [k, mu] = [&self.subgrade, &self.shear_layer].map(|c| value(c, s));
            (k / mu).value() * half * half
        });
        squared.into_iter().fold(0.0, f64::max) <= 1.0
    }
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
