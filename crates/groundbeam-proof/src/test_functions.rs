//! The energy K² of the test functions z that bound the errors of the moment and of the reactions.
//!
//! ```text
//! K² = ∫EI z″² + ∫(P + μ)z′² + ∫kz² + K₀z(0)² + K_lz(l)² + Σκz² + Σκ_θz′².
//! ```
//!
//! K₀ and K_l are the stiffnesses of the ground beyond the left and the right end of the beam. κ and κ_θ are the
//! stiffnesses of translational and rotational springs.

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

/// Returns the smallest energy K² of the test function z = t(1 − t/h)² on 0 ≤ t ≤ h, for the lengths h = `available`,
/// `available`/2, `available`/4, …. The energy is K² = 4EI/h + (2/15)(P + μ)h + kh³/105 + Σκ(4h/27)² + Σκ_θ, with the
/// tension P and the stiffnesses κ of translational and κ_θ of rotational springs.
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
    /// Returns an upper bound of the energy K² of a test function that begins with a kink. The bound holds for every
    /// position of the kink between the first and the last of `nodes`. The test function must vanish at these two
    /// nodes. It is z = t(1 − t/h)² for 0 ≤ t ≤ h, where t is the distance from the kink towards the farther of the two
    /// nodes, and zero elsewhere. The length h is at most half the distance between the two nodes.
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

    /// For each piece, replaces the bound of the energy K² by that of a second test function, if the second bound is
    /// smaller. For a position x on the piece, the second function is z(s) = |s − x| between x and one end of the beam,
    /// and zero on the other side of x. No rigid support may lie between x and this end. The energy of the second
    /// function is K² = (P + μ)L + kL³/3 + K_eL² + Σ(κ(x − x_j)² + κ_θ). P is the tension, L the distance from x to the
    /// end, and K_e the stiffness of the ground beyond the end. κ and κ_θ are the stiffnesses of the springs at the
    /// positions x_j. K² does not contain EI, so it is small for stiff beams.
    pub(crate) fn long_kinks(&self, side: usize, stiffness: &mut [Size]) {
        let frame = self.fields.frame;
        let count = frame.spans.len();
        let (mut layer, mut springs) = (Size::ZERO, Size::ZERO);
        let mut held: Vec<usize> = Vec::new();
        for step in 0..count {
            let i = if side == 0 { step } else { count - 1 - step };
            // `outer` is the node of the piece nearer to the end of the beam that `side` selects, and `inner` is its
            // other node. The energy K² is computed for a test function that begins at `inner`. It is an upper bound of
            // K² for every position on the piece.
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

    /// Computes by numerical integration the energy K² of the beam, ground and springs for the test function
    /// z = t(1 − t/h)² on 0 ≤ t ≤ h. The translational springs are placed where |z| is largest, and the rotational
    /// springs where |z′| is largest.
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

    /// Two pins are 1.5 apart. Every position between them is at least 0.75 away from one of the pins, so a test
    /// function that begins at this position may have the length h = 0.75. On soft ground the energy K² of this test
    /// function is nearly 4EI/h, which is smallest for the largest h.
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
