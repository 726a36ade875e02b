//! k and μ along a stretch of ground: a test for short power series, and the two-port of the ground out of contact.

use crate::ground::link::TwoPort;
use crate::model::Foundation;
use crate::numeric::polynomial::{rescale_in_place, value, values};
use crate::numeric::real::Real;
use crate::numeric::roots::varies_little;

/// Number of coefficients that are stored for each of k and μ, as polynomials of the position in a cell.
pub(crate) const GROUND: usize = Foundation::MOST_CONTROL_VALUES;

/// Maximum number of halvings of a stretch of ground when its two-port is computed.
const MOST_HALVINGS: u32 = 40;

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
        varies_little(&values(&self.subgrade))
            && (self.shear_layer[0].value() == 0.0 || varies_little(&values(&self.shear_layer)))
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

    /// Computes the [`TwoPort`] of the ground out of contact. A stretch of half length `half` is halved until one short
    /// power series represents the ground displacement.
    pub fn two_port(self, half: f64) -> TwoPort<R> {
        self.halved(half, MOST_HALVINGS)
    }

    fn halved(self, half: f64, halvings: u32) -> TwoPort<R> {
        if halvings == 0 || (self.is_short(half) && self.is_smooth()) {
            return TwoPort::varying(&self.subgrade, &self.shear_layer, half);
        }
        let [left, right] =
            [[-1.0, 0.0], [0.0, 1.0]].map(|s| self.part(s).halved(0.5 * half, halvings - 1));
        left.then(right)
    }
}
