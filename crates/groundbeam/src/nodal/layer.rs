//! Two-port of uniform ground out of contact, from k, μ and its length.

use crate::ground::link::TwoPort;
use crate::numeric::elementary::{asinh, exp, expm1};

/// Uniform ground, given by its stiffness √(kμ) and its rate of decay √(k/μ), or by their discrete equivalents.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Layer {
    stiffness: f64,
    pub rate: f64,
}

impl Layer {
    pub fn new(spring: f64, shear: f64) -> Self {
        if shear == 0.0 {
            return Layer::default();
        }
        Layer { stiffness: (spring * shear).sqrt(), rate: (spring / shear).sqrt() }
    }

    /// Creates uniform ground with springs at nodes at equal distances h and a shear layer that is linear between them.
    /// Unloaded, it has the displacements e^(±βi) at node i, with sinh(β/2) = h√(k/μ)/2.
    pub fn at_nodes(spring: f64, shear: f64, h: f64) -> Self {
        if shear == 0.0 {
            return Layer::default();
        }
        let half = 0.5 * h * (spring / shear).sqrt();
        // The force at the end node of infinite ground per unit displacement is (μ/h) sinh β = √(kμ) cosh(β/2), with
        // sinh(β/2) = `half`.
        let stiffness = (spring * shear).sqrt() * (1.0 + half * half).sqrt();
        Layer { stiffness, rate: 2.0 * asinh(half) / h }
    }

    /// Two-port of ground of a given length, out of contact. It equals [`TwoPort::uniform`] but needs only one
    /// exponential.
    pub fn open(&self, length: f64) -> TwoPort {
        if self.stiffness == 0.0 {
            return TwoPort::default();
        }
        let z = self.rate * length;
        let (decay, fall) = if z < 1.0 {
            let fall = -expm1(-z);
            (1.0 - fall, fall)
        } else {
            let decay = exp(-z);
            (decay, 1.0 - decay)
        };
        let shunt = self.stiffness * fall / (1.0 + decay);
        let series = self.stiffness * (2.0 * decay) / (fall * (1.0 + decay));
        TwoPort { series, shunt_left: shunt, shunt_right: shunt }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_form_with_one_exponential_agrees_with_the_two_port() {
        let layer = Layer { stiffness: 1.0, rate: 2.0 };
        for bh in [1e-12, 1e-6, 0.3, 0.999, 1.0, 5.0, 300.0] {
            let (ours, link) = (layer.open(0.5 * bh), TwoPort::uniform(2.0, 0.5, 0.5 * bh));
            assert!((ours.series - link.series).abs() <= 1e-15 * link.series, "{bh}");
            assert!((ours.shunt_left - link.shunt_left).abs() <= 1e-15 * link.shunt_left, "{bh}");
        }
    }

    /// The ground under three equal elements has the same equivalent springs as three two-ports in series, each of
    /// which represents the ground under one element.
    #[test]
    fn open_ground_at_nodes_is_its_links_in_series() {
        for h in [1e-3, 0.1, 1.0, 30.0] {
            let layer = Layer::at_nodes(2.0, 0.5, h);
            let link = layer.open(h);
            assert!((link.series - 0.5 / h).abs() <= 1e-12 / h, "{h}: {link:?}");
            assert!((link.shunt_left - h).abs() <= 1e-12 * h, "{h}: {link:?}");
            let (three, open) = (link.then(link).then(link), layer.open(3.0 * h));
            assert!((three.series - open.series).abs() <= 1e-12 * open.series, "{h}");
            assert!((three.shunt_left - open.shunt_left).abs() <= 1e-12 * open.shunt_left, "{h}");
        }
    }
}
