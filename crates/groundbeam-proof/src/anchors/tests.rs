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

/// By Cauchy's inequality, the bounds contain the norms of the kernels that multiply the errors of curvature and shear
/// strain.
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
        // `between`: at the midpoint, the kernels are half the distance to the nearer anchor, and ±½.
        let bent = (2.0 * integral(0.5 * h, |x| (0.5 * x).powi(2))).sqrt();
        is_bound(between(long, flexure), s * bent + sheared * (0.25 * h).sqrt());
        // `beyond`, at the free end: the kernel of the curvature is the distance to this end on the overhang, and
        // decreases from `over` to zero between the anchors.
        let outside = integral(over, |x| (over - x).powi(2));
        let bent = (outside + integral(h, |x| (over * (1.0 - x / h)).powi(2))).sqrt();
        // The kernel of the shear strain is 1 on the overhang and `over / h` between the anchors.
        let slid = (over + integral(h, |_| (over / h).powi(2))).sqrt();
        let exact = near + (near + far) * over / h + s * bent + sheared * slid;
        is_bound(beyond([near, far].map(Size::of), short, [h; 2], flexure), exact);
        // `along_slope`, at the free end: the kernel is the distance to this end on the overhang, and `over` from there
        // to the position with the known rotation error.
        let bent = (outside + integral(h, |_| over * over)).sqrt();
        let exact = slope * over + s * bent + sheared * over.sqrt();
        is_bound(along_slope([slope, h].map(Size::of), short, flexure), exact);
    }
}

/// Compares `from_mean`, (12) of docs/proof.md, with numerical integration of the deviation from the tangent at the
/// midpoint.
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

/// Checks that middle parts lie within the piece, even if its stored half length is wrong: at a length of 1.6 and a
/// stored half length of 1, they may reach 0.8.
#[test]
fn pressures_are_bounded_within_the_piece_only() {
    for (half, wanted) in [(1.0, &[0.5, 0.25, 0.0625][..]), (0.8, &[0.9, 0.5, 0.25, 0.0625])] {
        let piece = Piece { x: [0.0, 1.6], half, deflection: vec![1.0], ..Piece::default() };
        let units = Units { length: 0, force: 0 };
        let span = Span::of(&piece, [0.0, 1.6].map(Wide::of), units).expect("a piece");
        assert_eq!(parts_of(&span).collect::<Vec<_>>(), wanted);
    }
    // An exact end lies 0.1 inside the stored end. A middle part may extend 0.7 from the stored midpoint, 0.875 of 0.8.
    for exact in [[0.0, 1.5], [0.1, 1.6]] {
        let piece = Piece { x: [0.0, 1.6], half: 0.8, deflection: vec![1.0], ..Piece::default() };
        let units = Units { length: 0, force: 0 };
        let span = Span::of(&piece, exact.map(Wide::of), units).expect("a piece");
        assert_eq!(parts_of(&span).collect::<Vec<_>>(), [0.5, 0.25, 0.0625]);
    }
}

/// The load is 5/4 of the claimed pressure or reactions. The correction is ¼, and the lower bounds are ¾ of the claimed
/// values.
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

/// In the first two cases, the two parts at an elastic hinge have one pin each and a common bound. The part beyond the
/// free hinge can rotate.
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
