//! Bounds of the errors of the reactions of supports.
//!
//! The error of a spring force follows from the error of the deflection or from the error energy. The error of a rigid
//! support's force or moment follows from the energy of a test function. See *Reactions* in section 6 of
//! `docs/proof.md`.

use crate::frame::Held;
use crate::model::Acts;
use crate::pointwise::{PieceBounds, Pointwise};
use crate::scalar::{Scalar, positive_part};
use crate::size::Size;
use crate::test_functions::{kink, least_of_halves};

impl<S: Scalar> Pointwise<'_, S> {
    /// Returns the error bounds of the reaction force and of the reaction moment of each support of the model.
    pub fn reactions(&self, bounds: &[PieceBounds]) -> Vec<[Size; 2]> {
        let frame = self.fields.frame;
        let rigid_at = |node: usize| {
            let others = frame.supports.iter();
            others.filter(|other| other.node == Some(node) && other.springs.is_none()).count()
        };
        let of = |held: &Held<S>| match (held.node, held.springs) {
            // The exact reaction of an inactive support is zero.
            (None, _) => held.claimed.map(|claimed| Size::of(claimed.size())),
            (Some(node), Some(springs)) => self.of_springs(held, node, springs, bounds),
            // The distribution of the load between two rigid supports at one position is indeterminate.
            (Some(node), None) if rigid_at(node) > 1 => [Size::INFINITE; 2],
            (Some(node), None) => [self.of_rigid_support(node), self.of_clamp(node)],
        };
        frame.supports.iter().map(of).collect()
    }

    /// Error bounds of the force and the moment of a support with a translational and a rotational spring. The bounds
    /// include the difference between the claimed reaction and the reaction at the claimed deflection.
    fn of_springs(
        &self,
        held: &Held<S>,
        node: usize,
        springs: [S; 2],
        bounds: &[PieceBounds],
    ) -> [Size; 2] {
        let [w, slope] = self.fields.deflection.at_support(node);
        // The spring forces follow from deflection and rotation of one adjacent piece. At a hinge, the other piece can
        // have different bounds.
        let [piece, _] = self.fields.deflection.felt[node];
        let closed = self.fields.deflection.pieces[piece].bounds;
        let errors = [bounds[piece].deflection, bounds[piece].rotation];
        let force = springs[0] * (w - held.settlement);
        let force = match held.acts {
            Acts::Both => force,
            acts => acts.towards(positive_part(acts.towards(force))),
        };
        let computed = [force, -(springs[1] * slope)];
        let mut found = [Size::ZERO; 2];
        for j in [0, 1] {
            let stiffness = Size::of(springs[j].high());
            if stiffness == Size::ZERO {
                found[j] = Size::of(held.claimed[j].size());
                continue;
            }
            let energy =
                (2.0 * self.beam_energy()).root() * stiffness.root() + stiffness * closed[j];
            let differs = Size::of((held.claimed[j] - computed[j]).size());
            found[j] = (stiffness * errors[j]).least(energy) + differs;
        }
        found
    }

    fn of_rigid_support(&self, node: usize) -> Size {
        let here = &self.fields.frame.nodes[node];
        let own = here.spring.map_or(Size::ZERO, |[spring, _]| Size::of(spring.high()));
        let sides = self.lifted_side(node, 0) + self.lifted_side(node, 1);
        let stiffness = (sides + own).least(self.tilted(node));
        let factor = Size::of(self.balanced.factors[node].size());
        let given_back = match here.acts {
            Acts::Both => Size::of(here.weights.rigid),
            _ => Size::of(here.reaction[0].size()),
        };
        self.test_factor() * stiffness.root() + factor * given_back
    }

    fn of_clamp(&self, node: usize) -> Size {
        let here = &self.fields.frame.nodes[node];
        if !here.clamped {
            // A pin has no moment. `held.rs` refuses a claimed moment of a pin.
            return Size::ZERO;
        }
        let own = here.turning.map_or(Size::ZERO, |turning| Size::of(turning.high()));
        let sides = self.turned_side(node, 0) + self.turned_side(node, 1) + own;
        let stiffness = sides.least(self.turned(node));
        let last = self.balanced.pieces.len() - 1;
        let left = self.balanced.pieces[node.saturating_sub(1)].steepness;
        let steep = left.worst(self.balanced.pieces[node.min(last)].steepness);
        self.test_factor() * stiffness.root() + steep * Size::of(here.weights.clamp)
    }

    /// Returns the node of the next rigid support on one side of a node, and `true`. If no rigid support lies on
    /// this side, returns the node at the end of the beam, and `false`.
    fn next(&self, node: usize, side: usize) -> (usize, bool) {
        let nodes = &self.fields.frame.nodes;
        let mut next = node;
        while next != [0, nodes.len() - 1][side] {
            next = if side == 0 { next - 1 } else { next + 1 };
            if nodes[next].rigid.is_some() {
                return (next, true);
            }
        }
        (next, false)
    }

    /// Returns the largest EI, P + μ and k between `node` and `next`, the length, and the sums of the translational and
    /// of the rotational spring stiffnesses, without the springs at `node`.
    fn beside(&self, node: usize, next: usize) -> ([Size; 3], S, [Size; 2]) {
        let frame = self.fields.frame;
        let (from, to) = if next < node { (next, node) } else { (node, next) };
        let mut springs = [Size::ZERO; 2];
        for other in (from..=to).filter(|other| *other != node) {
            let here = &frame.nodes[other];
            springs[0] += here.spring.map_or(Size::ZERO, |[spring, _]| Size::of(spring.high()));
            springs[1] += here.turning.map_or(Size::ZERO, |turning| Size::of(turning.high()));
        }
        (self.largest(from..to), frame.nodes[to].x - frame.nodes[from].x, springs)
    }

    /// The smaller energy of two test functions on one side of a rigid support. One decreases from 1 to 0 before the
    /// next rigid support. The other is 1 up to the end of the beam, if no rigid support follows.
    fn lifted_side(&self, node: usize, side: usize) -> Size {
        let (next, held) = self.next(node, side);
        let ([bending, layer, ground], available, [springs, turning]) = self.beside(node, next);
        let mut least = Size::INFINITE;
        if !held {
            let outside = Size::of(self.fields.frame.outside[side].high());
            least = ground * Size::of(available.high()) + outside + springs;
        }
        if next == node {
            return least;
        }
        least.least(lift([bending, layer, ground], [springs, turning], available.low()))
    }

    /// The contribution of one side of a clamp to the energy K² of the test function z = t(1 − t/h)², where t is the
    /// distance from the clamp and h a length.
    fn turned_side(&self, node: usize, side: usize) -> Size {
        let (next, _) = self.next(node, side);
        if next == node {
            return Size::ZERO;
        }
        let (largest, available, springs) = self.beside(node, next);
        kink(largest, springs, available.low())
    }

    /// The energy of the linear test function that is 1 at a rigid support and 0 at the other one. It is infinite
    /// unless the beam has exactly two rigid supports and no clamp.
    fn tilted(&self, node: usize) -> Size {
        let nodes = &self.fields.frame.nodes;
        let rigid: Vec<usize> = (0..nodes.len()).filter(|i| nodes[*i].rigid.is_some()).collect();
        let other = rigid.iter().find(|other| **other != node);
        match other {
            Some(other) if rigid.len() == 2 && rigid.iter().all(|i| !nodes[*i].clamped) => {
                let base = nodes[*other].x;
                let slope = S::one().div(nodes[node].x - base);
                self.straight(|x| (x - base) * slope, slope)
            }
            _ => Size::INFINITE,
        }
    }

    /// The energy K² of the test function z = x − x_i, where x_i is the position of a clamp. The result is infinite if
    /// the beam has another rigid support.
    fn turned(&self, node: usize) -> Size {
        let nodes = &self.fields.frame.nodes;
        if nodes.iter().filter(|node| node.rigid.is_some()).count() > 1 {
            return Size::INFINITE;
        }
        self.straight(|x| x - nodes[node].x, S::one())
    }

    /// Upper bound of the energy K² of a test function `z` that is linear along the whole beam, with K² as in
    /// `test_functions.rs`.
    fn straight(&self, z: impl Fn(S) -> S, slope: S) -> Size {
        let frame = self.fields.frame;
        let count = frame.spans.len();
        let [_, layer, ground] = self.largest(0..count);
        let ends = [frame.nodes[0].x, frame.nodes[count].x].map(|x| Size::of(z(x).size()));
        let (long, steep) = (Size::of(frame.length.high()), Size::of(slope.size()).square());
        let mut sum = layer * long * steep + ground * long * ends[0].worst(ends[1]).square();
        for side in [0, 1] {
            sum += Size::of(frame.outside[side].high()) * ends[side].square();
        }
        for node in &frame.nodes {
            let spring = node.spring.map_or(0.0, |[spring, _]| spring.high());
            sum += Size::of(spring) * Size::of(z(node.x).size()).square();
            sum += Size::of(node.turning.map_or(0.0, |turning| turning.high())) * steep;
        }
        sum
    }
}

/// Returns the least bound of the energy of the test function z = 1 − 3τ² + 2τ³ over lengths h up to `available`, with
/// τ = t/h at the distance t from a support. At springs, z is at most 1 and |z′| at most 3/(2h).
fn lift(
    [bending, layer, ground]: [Size; 3],
    [springs, turning]: [Size; 2],
    available: f64,
) -> Size {
    least_of_halves(available, |h| {
        let steep = Size::of(1.5).over(h).square();
        (12.0 * bending).over(h).over(h).over(h)
            + (1.2 * layer).over(h)
            + 0.3715 * (ground * Size::of(h))
            + springs
            + turning * steep
    })
}

#[cfg(test)]
mod tests {
    use super::lift;
    use crate::given_claim::{balanced, with_fields};
    use crate::pointwise::{PieceBounds, Pointwise};
    use crate::random::numbers;
    use crate::size::Size;
    use crate::test_functions::tests::integral;
    use serde_json::json;

    /// Computes the energy K² of the test function z by numerical integration. The springs are at the positions where
    /// |z| and |z′| are largest.
    fn exact([bending, layer, ground]: [f64; 3], [springs, turning]: [f64; 2], h: f64) -> f64 {
        let z = |t: f64| 1.0 - 3.0 * (t / h).powi(2) + 2.0 * (t / h).powi(3);
        let slope = |t: f64| 6.0 * (t / h) * (t / h - 1.0) / h;
        let bent = |t: f64| 6.0 * (2.0 * t / h - 1.0) / (h * h);
        integral(h, |t| {
            bending * bent(t).powi(2) + layer * slope(t).powi(2) + ground * z(t).powi(2)
        }) + springs
            + turning * slope(0.5 * h).powi(2)
    }

    #[test]
    fn the_test_function_of_a_reaction_has_the_least_k_over_lengths() {
        let mut random = numbers();
        for _ in 0..300 {
            let numbers = [0; 5].map(|_| 10.0_f64.powf(3.0 * random()));
            let [bending, layer, ground, springs, turning] = numbers;
            let (stiff, held) = ([bending, layer, ground], [springs, turning]);
            let available = 10.0_f64.powf(random());
            let lengths = (0..24).map(|j| available / 2.0_f64.powi(j));
            let least = lengths.map(|h| exact(stiff, held, h)).fold(f64::INFINITY, f64::min);
            let bound = lift(stiff.map(Size::of), held.map(Size::of), available).value();
            assert!(least <= bound * (1.0 + 1e-9) && bound <= 1.001 * least, "{least} {bound}");
        }
    }

    /// At w = ½ and w′ = ⅛, the springs κ = 4 and κ_θ = 8 have the force 2 and the moment −1. The error bound is the
    /// smaller of stiffness times error and (2E times stiffness)^½, plus the deviation of the claimed value.
    #[test]
    fn the_error_of_a_spring_follows_from_the_deflection_or_from_the_energy() {
        let model = "[beam]\nlength = 1\nEI = 1\n[foundation]\nk = 1\n[[load]]\npoint = 1\nat = 0\n\
                     [[support]]\nat = 0\nspring = 4\nrotational_spring = 8\n";
        let piece =
            json!({"x": [0, 1], "half": 0.5, "touches": false, "deflection": [0.5625, 0.0625]});
        for (force, moment, energy, expected) in [
            (2.0, -1.0, 1.0, [0.04, 0.16]),
            (2.5, -1.25, 1.0, [0.54, 0.41]),
            (2.0, -1.0, 5e-9, [2e-4, 8e-8_f64.sqrt()]),
        ] {
            let reaction = json!({"support": 0, "force": force, "moment": moment});
            let document = json!({"pieces": [piece], "reactions": [reaction]});
            with_fields(model, &document, |fields| {
                let (balanced, energy) = (balanced(1), Size::of(energy));
                let pointwise = Pointwise { fields, balanced: &balanced, energy };
                let [deflection, rotation] = [0.01, 0.02].map(Size::of);
                let bounds = [PieceBounds { deflection, rotation, ..PieceBounds::EXACT }];
                for (found, expected) in pointwise.reactions(&bounds)[0].into_iter().zip(expected) {
                    assert!((found.value() / expected - 1.0).abs() < 1e-12, "{found:?} {expected}");
                }
            });
        }
    }

    /// The moment of the only clamp of a stiff beam is tested by a rotation of the beam about the clamp. The energy of
    /// this test function is at most kl³.
    #[test]
    fn the_moment_of_a_single_clamp_is_tested_by_a_rotation_about_it() {
        for at in [0.0, 1.5] {
            let model = format!(
                "[beam]\nlength = 1.5\nEI = 1e6\n[foundation]\nk = 2\n[[load]]\npoint = 1\nat = 0\n\
                 [[support]]\nat = {at:?}\ntype = 'fixed'\n"
            );
            let piece = json!({"x": [0, 1.5], "half": 0.75, "touches": false, "deflection": [0]});
            with_fields(&model, &json!({"pieces": [piece]}), |fields| {
                let (balanced, energy) = (balanced(1), Size::of(0.5));
                let pointwise = Pointwise { fields, balanced: &balanced, energy };
                let [_, moment] = pointwise.reactions(&[PieceBounds::EXACT])[0];
                let expected = (2.0_f64 * 1.5_f64.powi(3)).sqrt();
                assert!(
                    (moment.value() / expected - 1.0).abs() < 1e-9,
                    "{at} {moment:?} {expected}"
                );
            });
        }
    }
}
