//! Tests error bounds between positions with known error bounds (anchors), and pressures and reactions that balance the loads.

#![cfg(test)]

use super::{along_slope, between, beyond, from_mean, parts_of};
use crate::answer::Piece;
use crate::frame::Span;
use crate::given_claim::with_fields;
use crate::pointwise::Pointwise;
use crate::random::numbers;
use crate::scalar::Scalar;
use crate::size::Size;
use crate::test_functions::tests::integral;
use crate::units::Units;
use crate::wide::Wide;
use serde_json::json;

/// The test writes the deflection error at a position as the sum of two integrals and of terms for the errors at the
/// anchors, which are positions with known error bounds. The integrands are the derivative of the rotation error and
/// the error of the shear strain, each multiplied by a kernel. By Cauchy's inequality, the bound of the deflection
/// error contains the norms of the two kernels.
#[test]
fn bounds_between_and_beyond_anchors_have_the_norms_of_the_kernels() {
    let mut random = numbers();
    for _ in 0..200 {
        let [h, over, s, sheared, near, far, slope] =
            [0; 7].map(|_| 10.0_f64.powf(2.0 * random() - 1.0));
        let [short, long] = [over, h].map(Size::of);
        let flexure = [s, sheared].map(Size::of);
        let is_bound = |bound: Size, exact: f64| {
            let ratio = bound.value() / exact;
            assert!((1.0 - 1e-12..1.001).contains(&ratio), "{ratio}");
        };
        // The function `between` applies to the midpoint between two anchors, which are positions with known error
        // bounds. The deflection error at the midpoint contains an integral between the anchors. The integrand is the
        // derivative of the rotation error times half the distance from the nearer anchor, plus the shear strain error
        // times ±½.
        let bent = (2.0 * integral(0.5 * h, |x| (0.5 * x).powi(2))).sqrt();
        is_bound(between(long, flexure), s * bent + sheared * (0.25 * h).sqrt());
        // The function `beyond` applies to the free end of an overhang of length `over`, next to two anchors at the
        // distance `h` from each other. Anchors are positions with known error bounds. The deflection error at the free
        // end contains two integrals. The first integrand is the derivative of the rotation error times a kernel. On
        // the overhang, this kernel is the distance from the free end; between the anchors, it decreases linearly from
        // `over` to zero. The second integrand is the shear strain error times a kernel, which is 1 on the overhang and
        // `over / h` between the anchors.
        let outside = integral(over, |x| (over - x).powi(2));
        let bent = (outside + integral(h, |x| (over * (1.0 - x / h)).powi(2))).sqrt();
        let slid = (over + integral(h, |_| (over / h).powi(2))).sqrt();
        let exact = near + (near + far) * over / h + s * bent + sheared * slid;
        is_bound(beyond([near, far].map(Size::of), short, [h; 2], flexure), exact);
        // The function `along_slope` applies to the free end of an overhang if the rotation error is bounded at a
        // position at the distance `h` from the overhang. The deflection error at the free end contains the integral of
        // the derivative of the rotation error times a kernel. On the overhang, this kernel is the distance from the
        // free end. Between the position and the overhang, it is the length `over` of the overhang.
        let bent = (outside + integral(h, |_| over * over)).sqrt();
        let exact = slope * over + s * bent + sheared * over.sqrt();
        is_bound(along_slope([slope, h].map(Size::of), short, flexure), exact);
    }
}

/// Compares the result of `from_mean`, a bound of the deflection error on an interval, with numerical integration. The
/// function b bounds the difference between the deflection error and its tangent at the midpoint of the interval.
///
/// The mean absolute value of the tangent is at most the mean absolute error plus the mean of b. The tangent is linear,
/// so it is at most 1 + √2 times its mean absolute value. The deflection error exceeds the tangent by at most the value
/// of b at the ends of the interval.
#[test]
fn a_bound_of_the_mean_gives_a_bound_of_both_ends() {
    let mut random = numbers();
    for _ in 0..200 {
        let [half, s, sheared, mean] = [0; 4].map(|_| 10.0_f64.powf(2.0 * random() - 1.0));
        // With the substitution y = v² for the distance y from the midpoint, all integrands are polynomials in v.
        let root = half.sqrt();
        let average = |f: &dyn Fn(f64) -> f64| integral(root, |v| 2.0 * v * f(v)) / half;
        let bent = |v: f64| s * v.powi(3) / 3.0_f64.sqrt();
        let slid = |v: f64| sheared * v;
        let off = average(&|v| bent(v) + slid(v));
        let exact = (1.0 + 2.0_f64.sqrt()) * (mean + off) + bent(root) + slid(root);
        let [curved, sheared] = [s * half * root, sheared * root].map(Size::of);
        let ratio = from_mean(Size::of(mean), curved, sheared).value() / exact;
        assert!((1.0 - 1e-12..1.001).contains(&ratio), "{ratio}");
    }
}

/// Checks that the pressure is bounded from below only on middle parts that lie within the piece. The half length that
/// is stored with a piece may be wrong. If it is 1 and the length of the piece is 1.6, the half length of a middle part
/// may be at most 0.8.
#[test]
fn pressures_are_bounded_within_the_piece_only() {
    for (half, wanted) in [(1.0, &[0.5, 0.25, 0.0625][..]), (0.8, &[0.9, 0.5, 0.25, 0.0625])] {
        let piece = Piece { x: [0.0, 1.6], half, deflection: vec![1.0], ..Piece::default() };
        let units = Units { length: 0, force: 0 };
        let span = Span::of(&piece, [0.0, 1.6].map(Wide::of), units).expect("a piece");
        assert_eq!(parts_of(&span).collect::<Vec<_>>(), wanted);
    }
    // One exact end of the piece lies 0.1 inside the stored end. A middle part is centred at the stored midpoint, so
    // its half length may be at most 0.8 − 0.1 = 0.7. This is 0.875 times the stored half length 0.8.
    for exact in [[0.0, 1.5], [0.1, 1.6]] {
        let piece = Piece { x: [0.0, 1.6], half: 0.8, deflection: vec![1.0], ..Piece::default() };
        let units = Units { length: 0, force: 0 };
        let span = Span::of(&piece, exact.map(Wide::of), units).expect("a piece");
        assert_eq!(parts_of(&span).collect::<Vec<_>>(), [0.5, 0.25, 0.0625]);
    }
}

/// Tests two models. In the first, the total load is 5/4 of the resultant of the claimed pressure. In the second, it is
/// 5/4 of the resultant of the claimed reactions. The correction for exact equilibrium is therefore ¼ of the claimed
/// values, and their lower bounds are ¾ of the claimed values.
#[test]
fn redistributed_pressures_and_reactions_keep_their_share() {
    let springs = "[[support]]\nat = 0\ntype = 'pinned'\nacts = 'up'\n[[support]]\nat = 2\ntype = 'pinned'\nacts = 'up'\n\
        [[gap]]\nat = 0\nvalue = 100\n";
    for (rest, load, touches) in [("", 1.25, true), (springs, 1.25, false)] {
        let text = format!(
            "[beam]\nlength = 2\nEI = 1\n[foundation]\nk = 1\n{rest}[[load]]\ndistributed = {load}\n"
        );
        let w = if touches { 1.0 } else { 0.0 };
        let reaction = |support: usize| json!({"support": support, "force": 1, "moment": 0});
        let reactions = if touches { Vec::new() } else { vec![reaction(0), reaction(1)] };
        let piece = json!({"x": [0, 2], "half": 1, "touches": touches, "deflection": [w]});
        let document = json!({"pieces": [piece], "reactions": reactions});
        with_fields(&text, &document, |fields| {
            let units = fields.frame.units;
            let (_, balanced) = fields.energy().expect("a balance");
            assert!((balanced.factor(0).value() - 0.25).abs() < 1e-12);
            let energy = Size::of(1e-3);
            let pointwise = Pointwise { fields, balanced: &balanced, energy };
            if touches {
                let least = units.restored(pointwise.least_pressure(0, 0.9), 1, -1);
                assert!(least <= 0.75 && least > 0.75 - 1e-12, "{least}");
            } else {
                let kept =
                    units.restored(1e-3 / pointwise.pushed(0).expect("a bound").value(), 1, 0);
                assert!(kept <= 0.75 && kept > 0.75 - 1e-12, "{kept}");
            }
        });
    }
}

/// In the first two cases, one elastic hinge and one free hinge join three parts of the beam. An anchor is a position
/// with a known bound of the deflection error. Each of the two parts at the elastic hinge has one anchor, its pin, so
/// these two parts together have two anchors. The third part has only one anchor, the free hinge, and can rotate.
#[test]
fn parts_beyond_a_free_hinge_have_no_common_bound() {
    let hinge =
        |at: usize, spring: usize| format!("[[hinge]]\nat = {at}\nrotational_spring = {spring}\n");
    let pin = |at: f64| format!("[[support]]\nat = {at}\ntype = 'pinned'\n");
    for (hinges, pins, bounded) in [
        ([1, 0], [0.0, 1.5], [true, true, false]),
        ([0, 1], [1.5, 3.0], [false, true, true]),
        ([1, 1], [0.0, 1.5], [true, true, true]),
        ([1, 1], [0.0, 3.0], [true, true, true]),
        ([0, 0], [0.0, 3.0], [false, false, false]),
    ] {
        let text = format!(
            "[foundation]\nk = 1\n[[gap]]\nat = 0\nvalue = 100\n{}{}{}{}[beam]\nlength = 3\nEI = 1\n",
            hinge(1, hinges[0]),
            hinge(2, hinges[1]),
            pin(pins[0]),
            pin(pins[1]),
        );
        let ends = [0.0, 1.0, 1.5, 2.0, 3.0];
        let piece = |i: usize| {
            let (from, to) = (ends[i], ends[i + 1]);
            json!({"x": [from, to], "half": 0.5 * (to - from), "touches": false, "deflection": [0]})
        };
        let pieces: Vec<_> = (0..4).map(piece).collect();
        with_fields(&text, &json!({"pieces": pieces}), |fields| {
            let balanced = crate::given_claim::balanced(4);
            let energy = Size::of(1e-3);
            let pointwise = Pointwise { fields, balanced: &balanced, energy };
            let parts = pointwise.parts();
            assert_eq!(parts, [0..1, 1..3, 3..4]);
            let found = pointwise.deflections(&parts);
            let finite = [0, 1, 2].map(|j: usize| found[j] < Size::INFINITE);
            assert_eq!(finite, bounded, "{hinges:?} {pins:?}: {found:?}");
        });
    }
}
