//! How far the ground gives under forces that nobody claims.

use super::outside::Outside;
use crate::model::Model;

/// ⟨r, Gr⟩ for concentrated forces r that stand on the ground unclaimed: b(u − Gp, u − Gp).
///
/// Softer ground gives more, so it is bounded on ground with the smallest k and the smallest μ > 0 of the
/// model, where G is the exponential (2.4). A shear layer of length L with a free end gives at
/// most coth(bL)/√(kμ) to a unit force, which bounds it by (Σ|r|)².
#[derive(Debug)]
pub(super) struct Unclaimed {
    spring: f64,
    shear: f64,
    length: f64,
    finished: f64,
    /// The layer now passed over: Σ|r|, Σ rᵢ e^(−b(x − xᵢ)), ⟨r, Gr⟩·2√(kμ), and whether it began at the
    /// beam's end.
    sum: f64,
    carried: f64,
    square: f64,
    x: f64,
    start: f64,
    endless: bool,
    inside: bool,
    /// Whether the layer goes on beyond the beam's ends without a free end of its own.
    goes_on: [bool; 2],
}

impl Unclaimed {
    pub fn new(model: &Model, outside: &Outside) -> Self {
        let ground = &model.foundation;
        let segments =
            ground.segments.iter().map(|s| (s.subgrade.smallest(), s.shear_layer.smallest()));
        let (mut spring, mut shear) = (ground.subgrade, f64::INFINITY);
        for (k, mu) in segments.chain([(ground.subgrade, ground.shear_layer)]) {
            spring = spring.min(k);
            if mu > 0.0 {
                shear = shear.min(mu);
            }
        }
        let goes_on = outside.is_free().map(|free| !free);
        Unclaimed {
            spring,
            shear,
            length: model.beam.length,
            finished: 0.0,
            sum: 0.0,
            carried: 0.0,
            square: 0.0,
            x: 0.0,
            start: 0.0,
            endless: goes_on[0],
            inside: true,
            goes_on,
        }
    }

    /// The next piece lies on a shear layer or not.
    pub fn enter(&mut self, layer: bool, x: f64) {
        if layer != self.inside {
            self.close(x, false);
            (self.start, self.endless, self.inside) = (x, x == 0.0 && self.goes_on[0], layer);
        }
    }

    pub fn add(&mut self, x: f64, force: f64) {
        if force == 0.0 {
            return;
        }
        let b = (self.spring / self.shear).sqrt();
        self.carried = self.carried * (-b * (x - self.x)).exp() + force;
        self.x = x;
        self.square += force * (2.0 * self.carried - force);
        self.sum += force.abs();
    }

    fn close(&mut self, end: f64, endless: bool) {
        if self.sum > 0.0 {
            let give = 1.0 / (self.spring * self.shear).sqrt();
            self.finished += if endless && self.endless {
                // A sum of squares in exact arithmetic.
                0.25 * give * self.square.max(0.0)
            } else {
                let b = (self.spring / self.shear).sqrt();
                0.5 * give * self.sum * self.sum / (b * (end - self.start)).tanh()
            };
        }
        (self.sum, self.carried, self.square) = (0.0, 0.0, 0.0);
    }

    /// ‖Gr‖ in the norm of b.
    pub fn norm(&self) -> f64 {
        let mut all = Unclaimed { ..*self };
        all.close(self.length, self.goes_on[1]);
        (2.0 * all.finished).sqrt()
    }
}
