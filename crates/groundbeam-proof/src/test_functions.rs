//! The energy K² of the test functions z that bound the errors of the moment and of the reactions.
//!
//! ```text
//! K² = ∫EI z″² + ∫(P + μ)z′² + ∫kz² + K₀z(0)² + K_lz(l)² + Σκz² + Σκ_θz′².
//! ```
//!
//! K₀ and K_l are the stiffnesses of the ground beyond both ends of the beam, κ and κ_θ those of the springs.

use crate::pointwise::Pointwise;
use crate::scalar::Scalar;
use crate::size::Size;
use std::ops::Range;

/// Maximum number of halvings of a length in the search for the smallest bound.
const HALVINGS: usize = 24;

/// Returns the smallest value of a bound over the lengths h, h/2, h/4, ….
pub(crate) fn least_of_halves(mut h: f64, bound: impl Fn(f64) -> Size) -> Size {
    let mut least = Size::INFINITE;
    for _ in 0..HALVINGS {
        least = least.least(bound(h));
        h *= 0.5;
    }
    least
}

/// Returns the least energy K² of the test function z = t(1 − t/h)² on 0 ≤ t ≤ h over lengths h up to `available`. At
/// springs, z is at most 4h/27 and |z′| at most 1.
pub(crate) fn kink(
    [bending, layer, ground]: [Size; 3],
    [springs, turning]: [Size; 2],
    available: f64,
) -> Size {
    least_of_halves(available, |h| {
        let long = Size::of(h);
        (4.0 * bending).over(h)
            + 0.134 * (layer * long)
            + (ground * (long.square() * long)).over(105.0)
            + springs * (0.1482 * long).square()
            + turning
    })
}

impl<S: Scalar> Pointwise<'_, S> {
    /// Upper bound of the energy K² of the test function of [`kink`] for every position of the kink between the first
    /// and the last of `nodes`. The function extends towards the farther of both nodes, so h may be half their
    /// distance.
    pub(crate) fn short_kink(&self, nodes: Range<usize>) -> Size {
        let frame = self.fields.frame;
        let available = (frame.nodes[nodes.end].x - frame.nodes[nodes.start].x).scaled(-1);
        let [bending, layer, springs] = self.largest(nodes.clone());
        let (mut supports, mut turning) = (Size::ZERO, Size::ZERO);
        for node in &frame.nodes[nodes.start..=nodes.end] {
            supports += node.spring.map_or(Size::ZERO, |[spring, _]| Size::of(spring.high()));
            turning += node.turning.map_or(Size::ZERO, |turning| Size::of(turning.high()));
        }
        kink([bending, layer, springs], [supports, turning], available.low())
    }

    /// The tension P. Under compression, `Compression::as_tension` replaces P.
    fn tension(&self) -> Size {
        let frame = self.fields.frame;
        match &frame.compression {
            None => Size::of(frame.tension.map_or(0.0, S::high)),
            Some(compression) => compression.as_tension(self.energy, self.fields.closing[1]),
        }
    }

    /// The factor s₂ = √(2E) with the bound E of the energy of the error. Under compression,
    /// `Compression::test_factor` replaces s₂.
    pub(crate) fn test_factor(&self) -> Size {
        match &self.fields.frame.compression {
            None => self.s2(),
            Some(compression) => compression.test_factor(self.energy, self.fields.closing[1]),
        }
    }

    /// The largest EI, P + μ and k of the pieces between two nodes.
    pub(crate) fn largest(&self, nodes: Range<usize>) -> [Size; 3] {
        let frame = self.fields.frame;
        let tension = self.tension();
        let mut largest = [Size::ZERO; 3];
        for span in &frame.spans[nodes] {
            let layer = tension + Size::of(span.shear.size());
            let here = [Size::of(span.bending.high()), layer, Size::of(span.spring.high())];
            for (most, here) in largest.iter_mut().zip(here) {
                *most = most.worst(here);
            }
        }
        largest
    }

    /// Lowers the bounds of the energy K² by a second test function, which is linear from the kink to one end of the
    /// beam if no rigid support lies between. This K² does not contain EI, so it is small for stiff beams.
    pub(crate) fn long_kinks(&self, side: usize, stiffness: &mut [Size]) {
        let frame = self.fields.frame;
        let count = frame.spans.len();
        let (mut layer, mut springs) = (Size::ZERO, Size::ZERO);
        let mut held: Vec<usize> = Vec::new();
        for step in 0..count {
            let i = if side == 0 { step } else { count - 1 - step };
            // `outer` is the node of the piece nearer to the end of the beam. The energy K² for a kink at `inner` is an
            // upper bound for every position on the piece.
            let (outer, inner) = (i + side, i + 1 - side);
            let node = &frame.nodes[outer];
            if node.rigid.is_some() {
                return;
            }
            if node.spring.is_some() || node.turning.is_some() {
                held.push(outer);
            }
            let [_, more_layer, more_springs] = self.largest(i..i + 1);
            (layer, springs) = (layer.worst(more_layer), springs.worst(more_springs));
            let from = frame.nodes[inner].x;
            let reach = |x: S| Size::of((x - from).size());
            let long = reach(frame.nodes[[0, count][side]].x);
            let mut sum = layer * long + (springs * long.square() * long).over(3.0);
            sum += Size::of(frame.outside[side].high()) * long.square();
            for node in held.iter().map(|node| &frame.nodes[*node]) {
                let spring = node.spring.map_or(0.0, |[spring, _]| spring.high());
                sum += Size::of(spring) * reach(node.x).square();
                sum += Size::of(node.turning.map_or(0.0, |turning| turning.high()));
            }
            stiffness[i] = stiffness[i].least(sum);
        }
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::kink;
    use crate::given_claim::{balanced, with_fields};
    use crate::pointwise::Pointwise;
    use crate::random::numbers;
    use crate::size::Size;
    use serde_json::json;

    /// Integral of f from 0 to h by the 5-point Gauss rule, which is exact for polynomials of degree 9 or less.
    pub(crate) fn integral(h: f64, f: impl Fn(f64) -> f64) -> f64 {
        let [a, b] =
            [2.0, -2.0].map(|sign: f64| (5.0 + sign * (10.0_f64 / 7.0).sqrt()).sqrt() / 3.0);
        let [v, w] = [-13.0, 13.0].map(|sign: f64| (322.0 + sign * 70.0_f64.sqrt()) / 900.0);
        let points = [(0.0, 128.0 / 225.0), (a, v), (-a, v), (b, w), (-b, w)];
        points.iter().map(|(x, w)| 0.5 * h * w * f(0.5 * h * (1.0 + x))).sum()
    }

    /// Computes by numerical integration the energy K² of the test function z = t(1 − t/h)². The springs are placed
    /// where |z| and |z′| are largest.
    fn exact([bending, layer, ground]: [f64; 3], [springs, turning]: [f64; 2], h: f64) -> f64 {
        let z = |t: f64| t * (1.0 - t / h).powi(2);
        let slope = |t: f64| (1.0 - t / h) * (1.0 - 3.0 * t / h);
        let bent = |t: f64| (6.0 * t / h - 4.0) / h;
        let largest = (0..=3000).map(|i| z(h * f64::from(i) / 3000.0)).fold(0.0, f64::max);
        integral(h, |t| {
            bending * bent(t).powi(2) + layer * slope(t).powi(2) + ground * z(t).powi(2)
        }) + springs * largest * largest
            + turning
    }

    #[test]
    fn the_test_function_of_the_moment_has_the_least_k_over_lengths() {
        let mut random = numbers();
        for _ in 0..300 {
            let numbers = [0; 5].map(|_| 10.0_f64.powf(3.0 * random()));
            let [bending, layer, ground, springs, turning] = numbers;
            let (stiff, held) = ([bending, layer, ground], [springs, turning]);
            let available = 10.0_f64.powf(random());
            let lengths = (0..24).map(|j| available / 2.0_f64.powi(j));
            let least = lengths.map(|h| exact(stiff, held, h)).fold(f64::INFINITY, f64::min);
            let bound = kink(stiff.map(Size::of), held.map(Size::of), available).value();
            assert!(least <= bound * (1.0 + 1e-9) && bound <= 1.01 * least, "{least} {bound}");
        }
    }

    /// Every position between two pins at the distance 1.5 is at least 0.75 away from one of them, so h = 0.75 is
    /// possible. On soft ground the energy K² is nearly 4EI/h, which is smallest for the largest h.
    #[test]
    fn a_test_function_ends_before_the_next_support() {
        let pin = |at: f64| format!("[[support]]\nat = {at}\ntype = 'pinned'\n");
        let model = format!(
            "[beam]\nlength = 1.75\nEI = 1\n[foundation]\nk = 1e-9\n{}{}",
            pin(0.25),
            pin(1.75)
        );
        let piece = |x: [f64; 2]| json!({"x": x, "half": 0.5 * (x[1] - x[0]), "touches": false, "deflection": [0]});
        let document =
            json!({"pieces": [piece([0.0, 0.25]), piece([0.25, 1.0]), piece([1.0, 1.75])]});
        with_fields(&model, &document, |fields| {
            let balanced = balanced(3);
            let pointwise = Pointwise { fields, balanced: &balanced, energy: Size::ZERO };
            assert_eq!(pointwise.obstacles(), [0, 1, 3]);
            for (nodes, available) in [(0..1, 0.125), (1..3, 0.75)] {
                let ratio = pointwise.short_kink(nodes).value() / (4.0 / available);
                assert!((1.0..1.0 + 1e-6).contains(&ratio), "{ratio}");
            }
        });
    }
}
