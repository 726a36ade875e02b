//! The ground as a chain of links. Section 3 of the theory: the inverse of (5.8) is tridiagonal.
//!
//! Between two points where its surface is held, ground without load, −(μu')' + ku = 0, acts like a
//! triangle of three springs: one between the points (`coupling`) and one under each (`leak`). For a
//! uniform stretch of length h, with b = √(k/μ), these are √(kμ)/sinh(bh) and √(kμ)·tanh(bh/2). All
//! three are positive, two links in a row make another by sums and products of positive numbers,
//! and so no digit is ever lost, however short or long or uneven the ground.

/// A stretch of unloaded ground between two points of its surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Link {
    /// Spring between the two points \[N/m\].
    pub coupling: f64,
    /// Spring under the left point \[N/m\].
    pub leak_left: f64,
    /// Spring under the right point \[N/m\].
    pub leak_right: f64,
}

impl Link {
    /// A uniform stretch of length h: k > 0, μ > 0.
    pub fn uniform(k: f64, mu: f64, h: f64) -> Self {
        let stiffness = (k * mu).sqrt();
        let bh = (k / mu).sqrt() * h;
        // e^(−bh) rather than sinh: never overflows.
        let decay = (-bh).exp();
        let coupling = stiffness * 2.0 * decay / -(-2.0 * bh).exp_m1();
        let leak = stiffness * (0.5 * bh).tanh();
        Link { coupling, leak_left: leak, leak_right: leak }
    }

    /// Two links in a row, the point between them free.
    pub fn then(self, next: Link) -> Self {
        let loose = self.leak_right + next.leak_left;
        let whole = self.coupling + next.coupling + loose;
        if whole <= 0.0 {
            return Link { coupling: 0.0, ..self };
        }
        Link {
            coupling: self.coupling * (next.coupling / whole),
            leak_left: self.leak_left + self.coupling * (loose / whole),
            leak_right: next.leak_right + next.coupling * (loose / whole),
        }
    }

    /// The force the ground takes at the left point, held at `left`, the other at `right`.
    pub fn force_left(&self, left: f64, right: f64) -> f64 {
        self.leak_left * left + self.coupling * (left - right)
    }

    /// The force the ground takes at the right point.
    pub fn force_right(&self, left: f64, right: f64) -> f64 {
        self.leak_right * right + self.coupling * (right - left)
    }
}

/// What the endless ground beyond a beam's end adds under that end: one spring √(kμ).
pub(crate) fn outside(k: f64, mu: f64) -> f64 {
    (k * mu).sqrt()
}

/// u at a fraction `t` of an unloaded uniform stretch with bh = `length`, from its end values.
pub(crate) fn between(left: f64, right: f64, length: f64, t: f64) -> f64 {
    sinh_ratio(length, 1.0 - t) * left + sinh_ratio(length, t) * right
}

/// du/dx·(1/b) at a fraction `t` of that stretch.
pub(crate) fn slope_between(left: f64, right: f64, length: f64, t: f64) -> f64 {
    // (right cosh(t·bh) − left cosh((1−t)bh))/sinh(bh), written so that equal ends lose nothing.
    let coupling = 2.0 * (-length).exp() / -(-2.0 * length).exp_m1();
    let cosh_less_one = |z: f64| 2.0 * (0.5 * z).sinh().powi(2);
    if length < 1.0 {
        coupling
            * ((right - left) + right * cosh_less_one(t * length)
                - left * cosh_less_one((1.0 - t) * length))
    } else {
        let cosh_ratio = |r: f64| {
            ((-(1.0 - r) * length).exp() + (-(1.0 + r) * length).exp()) / -(-2.0 * length).exp_m1()
        };
        cosh_ratio(t) * right - cosh_ratio(1.0 - t) * left
    }
}

/// sinh(r·z)/sinh(z) for 0 ≤ r ≤ 1, for any z > 0 without overflow.
fn sinh_ratio(z: f64, r: f64) -> f64 {
    (-(1.0 - r) * z).exp() * (-2.0 * r * z).exp_m1() / (-2.0 * z).exp_m1()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_halves_make_a_whole() {
        for bh in [1e-9, 1e-3, 1.0, 30.0, 700.0] {
            let whole = Link::uniform(2.0, 0.5, bh);
            let parts = Link::uniform(2.0, 0.5, 0.3 * bh).then(Link::uniform(2.0, 0.5, 0.7 * bh));
            for (a, b) in [
                (whole.coupling, parts.coupling),
                (whole.leak_left, parts.leak_left),
                (whole.leak_right, parts.leak_right),
            ] {
                // exp(−bh) itself carries bh·ε of relative error.
                assert!((a - b).abs() <= 4e-16 * (4.0 + 2.0 * bh) * a, "{bh}: {a} {b}");
            }
        }
    }

    #[test]
    fn a_link_is_the_differential_equation() {
        let (k, mu, h) = (3.0, 0.7, 0.9);
        let link = Link::uniform(k, mu, h);
        let b = f64::sqrt(k / mu);
        let slope = b * slope_between(0.4, -0.2, b * h, 0.0);
        assert!((link.force_left(0.4, -0.2) + mu * slope).abs() < 1e-15);
        let middle = between(0.4, -0.2, b * h, 0.5);
        let exact = 0.1 / (0.5 * b * h).cosh();
        assert!((middle - exact).abs() < 1e-16);
    }
}
