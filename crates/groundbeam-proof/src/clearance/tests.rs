//! Compares the clearance between beam and ground, and the correction that removes penetrations, with exact and sampled values.

#![cfg(test)]

use super::{OpenPiece, Stretch, above_springs};
use crate::answer::Piece;
use crate::coefficient::Coefficient;
use crate::fields::Fields;
use crate::frame::Span;
use crate::given_claim::with_fields;
use crate::model::Course;
use crate::polynomial::{Budget, Line};
use crate::random::numbers;
use crate::scalar::Scalar;
use crate::size::Size;
use crate::units::Units;
use crate::wide::Wide;
use serde_json::json;

/// Checks the bound of the depth by which a beam penetrates loaded Winkler ground, with constant and varying k.
#[test]
fn the_depth_of_a_beam_in_loaded_springs_is_bounded() {
    let mut random = numbers();
    let mut deep = 0;
    for i in 0..300 {
        let units = Units { length: 0, force: 0 };
        let w = [0; 4].map(|_| random());
        let piece = Piece { x: [0.0, 2.0], half: 1.0, deflection: w.to_vec(), ..Piece::default() };
        let mut span = Span::of(&piece, [0.0, 2.0].map(Wide::of), units).expect("a piece");
        let k = [0; 2].map(|_| if i % 3 == 0 { 1.5 } else { 1.5 + random() });
        let line = Line::from_coefficients([0.5, 0.5].map(Wide::of));
        let course = Course::Varying(k.map(Wide::of).to_vec());
        span.spring = Coefficient::of(&course, &line, [Wide::zero(), Wide::one()], |x| x);
        let q = [1.0 + 0.5 * random(), 0.4 * random()];
        span.ground_load = Some(Line::from_coefficients(q.map(Wide::of)));
        let closed = 0.1 * random().abs();
        let above = |t: f64| {
            let spring = 0.5 * (k[0] + k[1]) + 0.5 * (k[1] - k[0]) * t;
            w[0] + t * (w[1] + t * (w[2] + t * w[3])) - (q[0] + q[1] * t) / spring + closed
        };
        let places = (0..=4000).map(|j| f64::from(j) / 2000.0 - 1.0);
        let most = places.clone().map(above).fold(0.0, f64::max);
        let width = places.filter(|t| above(*t) > 0.0).count() as f64 / 2000.0;
        let found = above_springs(&span, Size::of(closed), Size::ZERO, &mut Budget::new(1));
        let [low, high] = [k[0].min(k[1]), k[0].max(k[1])];
        let most_found = 1.3 * high / low * (most + if most > 0.0 { closed } else { 0.0 });
        let depth = found.depth.value();
        assert!(
            most - 1e-9 <= depth && (depth <= most_found + 1e-9 || most < 0.1),
            "{most} {depth}"
        );
        assert!(width - 2e-3 <= found.width.value(), "{width} {found:?}");
        deep += i32::from(most > 0.0);
    }
    assert!((50..290).contains(&deep), "{deep}");
}

/// Checks that the slope of the clearance at x = 1 uses the corrected slope −0.2 of the beam. The claimed slope jumps
/// there by `jump`.
#[test]
fn the_slope_of_the_clearance_is_that_of_the_corrected_beam() {
    let text = "[beam]\nlength = 2\nEI = 1\n[foundation]\nk = 1\nmu = 1\n\
        [[gap]]\nat = 1\nvalue = 0\n[[gap]]\nat = 2\nvalue = 0.5\n";
    for jump in [0.0, 0.5, -0.5] {
        let document = json!({"pieces": [
            {"x": [0, 1], "half": 0.5, "touches": true, "deflection": [1.1, -0.1]},
            {"x": [1, 2], "half": 0.5, "touches": false, "deflection": [0.9 + 0.5 * jump, -0.1 + 0.5 * jump]},
        ]});
        with_fields(text, &document, |fields| {
            let Fields { frame, deflection, surface, .. } = fields;
            let stretch =
                Stretch { frame, deflection, surface, first: 1, end: 2, negligible: Size::ZERO };
            // The surface is u = exp(1 − x), so u′ = −1 at x = 1. The gap has g₀′ = 0.5, and the beam
            // w′ = −0.2.
            let exact = Wide::of(-1.0 + 0.5 + 0.2);
            let found = stretch.slope_at(1, 0);
            assert!((found - exact).size() < 1e-14, "{jump}: {found:?}");
        });
    }
}

/// Checks that the shear-layer force μu′ at the ends of a piece between two contacts follows from the corrected
/// deflection. No contact force acts at x = 1, where the layer begins.
#[test]
fn the_surface_joins_the_corrected_beam() {
    let text = "[beam]\nlength = 4\nEI = 1e6\n[foundation]\nk = 1\nmu = 1\n\
        [[foundation.segment]]\nfrom = 0\nto = 1\nk = 1\nmu = 0\n";
    for jump in [0.0, 0.25, -0.25] {
        let w = [vec![1.0], vec![1.0], vec![1.0 + jump, 0.125 * jump], vec![1.0 - jump]];
        let piece =
            |i: usize| json!({"x": [i, i + 1], "half": 0.5, "touches": i != 2, "deflection": w[i]});
        let pieces = [0, 1, 2, 3].map(piece);
        let document = json!({ "pieces": pieces });
        with_fields(text, &document, |fields| {
            let Fields { frame, deflection, surface, .. } = fields;
            let [left, right] = [2, 3].map(|node: usize| deflection.values[node].middle());
            let z = frame.spans[2].h.middle()
                * (frame.spans[2].spring.middle() / frame.spans[2].shear.middle()).sqrt();
            let factor =
                (frame.spans[2].spring.middle() * frame.spans[2].shear.middle()).sqrt() / z.sinh();
            let exact = [factor * (right - left * z.cosh()), factor * (right * z.cosh() - left)];
            for (flux, exact) in surface.pieces[2].flux.iter().zip(exact) {
                assert!((flux.middle() - exact).abs() < 1e-12 * factor, "{jump}: {flux:?} {exact}");
            }
            assert!(surface.nodes[1].jump.size() < 1e-12 * factor, "{:?}", surface.nodes[1]);
        });
    }
}

/// Checks the norm of the correction for a beam that penetrates Winkler ground by up to 0.1 on the length 0.75.
#[test]
fn the_correction_of_open_springs_has_the_norm_of_depth_and_length() {
    let text = "[beam]\nlength = 1.5\nEI = 1\n[foundation]\nk = 2\n[[load]]\npoint = 1\nat = 0\n";
    let piece = json!({"x": [0, 1.5], "half": 0.75, "touches": false, "deflection": [0, 0.1]});
    with_fields(text, &json!({"pieces": [piece]}), |fields| {
        let exact = (2.0_f64 * 0.01 * 0.75).sqrt();
        let found = fields.clearance.risen.value();
        assert!((1.0..1.03).contains(&(found / exact)), "{found} {exact}");
    });
}

/// Checks the lower bound of u″ = 16u for u = −sinh(2t)/sinh 2 with t = 2x − 1. On an interval, u is at least −1, and
/// at least a parabola with the value and slope of u in its middle.
#[test]
fn the_curvature_of_open_ground_is_bounded_by_a_tangent() {
    let text = "[beam]\nlength = 1\nEI = 1\n[foundation]\nk = 16\nmu = 1\n";
    let piece = json!({"x": [0, 1], "half": 0.5, "touches": false, "deflection": [0]});
    with_fields(text, &json!({"pieces": [piece]}), |fields| {
        let span = &fields.frame.spans[0];
        let open = OpenPiece::of(span, [1.0, -1.0].map(Wide::of), None, [Size::ZERO; 3]);
        let u = |t: f64| -(2.0 * t).sinh() / 2.0_f64.sinh();
        for (m, r) in [(-0.5, 0.25), (-0.75, 0.25), (0.0, 0.125), (-0.25, 0.5), (0.5, 0.5)] {
            let slope = 4.0 * (2.0_f64 * m).cosh() / 2.0_f64.sinh();
            let tangent = u(m) - slope * 0.5 * r - 8.0 * (0.5 * r).powi(2);
            let found = open.curvature(m, r, open.settlement(m));
            let exact = 16.0 * tangent.max(-1.0);
            assert!(
                (found - exact).abs() < 1e-12 && found <= 16.0 * u(m + r),
                "{m} {r}: {found} {exact}"
            );
        }
    });
}

/// Checks (10) of docs/proof.md for a straight beam that penetrates half of its shear layer, with k = μ = 1. The beam
/// touches the ground at one end of this half, or at both ends if `pressed` is true.
#[test]
fn the_correction_of_an_open_layer_has_the_norm_of_its_ramps() {
    let text = "[beam]\nlength = 1\nEI = 1\n[foundation]\nk = 1\nmu = 1\n";
    let piece = |i: usize, mirrored: bool| {
        let from = 0.5 * i as f64;
        let touches = (i == 0) != mirrored;
        let slope = if mirrored { 0.125 } else { -0.125 };
        let middle = if touches { 1.125 } else { 0.875 };
        json!({"x": [from, from + 0.5], "half": 0.25, "touches": touches, "deflection": [middle, slope]})
    };
    for mirrored in [false, true] {
        for (pressed, stiffness) in [(false, 0.5 + 1.0 / 0.5 + 1.0), (true, 0.5 + 2.0 / 0.25)] {
            let at = if mirrored { 0.0 } else { 1.0 };
            let forces = if pressed { json!([{"x": at, "force": 1}]) } else { json!([]) };
            let document =
                json!({"pieces": [piece(0, mirrored), piece(1, mirrored)], "forces": forces});
            with_fields(text, &document, |fields| {
                let Fields { frame, deflection, surface, .. } = fields;
                let first = usize::from(!mirrored);
                let negligible = Size::ZERO;
                let stretch =
                    Stretch { frame, deflection, surface, first, end: first + 1, negligible };
                let mut budget = Budget::new(2);
                budget.begin();
                let (depth, norm) = stretch.lift(&mut budget);
                let ratio = (norm.value() / depth.value()).powi(2) / stiffness;
                assert!((ratio - 1.0).abs() < 1e-9, "{mirrored} {pressed}: {ratio} {depth:?}");
            });
        }
    }
}

/// The penetration (1 ∓ t)²(2 ± t)/4 falls from 1 to 0. Its bound must be less than 1.3; without halving it would be 2.
#[test]
fn the_depth_on_a_piece_is_found_by_halving() {
    let text = "[beam]\nlength = 1\nEI = 1\n[foundation]\nk = 1\nmu = 1\n";
    for sign in [1.0, -1.0] {
        let w = [0.5, -0.75 * sign, 0.0, 0.25 * sign];
        let piece = json!({"x": [0, 1], "half": 0.5, "touches": false, "deflection": w});
        with_fields(text, &json!({"pieces": [piece]}), |fields| {
            let span = &fields.frame.spans[0];
            let open = OpenPiece::of(span, [Wide::zero(); 2], None, [Size::ZERO; 3]);
            let mut budget = Budget::new(1);
            budget.begin();
            let depth = open.deepest(span.interval(), Size::ZERO, &mut budget).value();
            assert!((1.0..1.3).contains(&depth), "{sign}: {depth}");
        });
    }
}

/// Checks that the search at the double zero of the clearance t² ends early: two searches use at most 120 halvings.
#[test]
fn a_double_zero_of_the_clearance_needs_few_halvings() {
    let text = "[beam]\nlength = 1\nEI = 1\n[foundation]\nk = 1\nmu = 1\n";
    let piece = json!({"x": [0, 1], "half": 0.5, "touches": false, "deflection": [0, 0, -1]});
    with_fields(text, &json!({"pieces": [piece]}), |fields| {
        let span = &fields.frame.spans[0];
        let open = OpenPiece::of(span, [Wide::zero(); 2], None, [Size::ZERO; 3]);
        let mut budget = Budget::new(1);
        budget.begin();
        for interval in [[-1.0, 1.0], [-0.9, 1.0]] {
            let depth = open.deepest(interval, Size::ZERO, &mut budget).value();
            assert!(depth < 1e-15, "{depth:e}");
        }
        let left = (0..1000).filter(|_| budget.take()).count();
        assert!(left >= 80, "{left}");
    });
}

#[test]
fn the_negligible_penetration_follows_the_largest_deflection() {
    let text = "[beam]\nlength = 1\nEI = 1\n[foundation]\nk = 1\n";
    for (middles, largest) in [([0.5, -2.0, 1.0], 2.0), ([3.0, 1.0, 0.0], 3.0), ([0.0; 3], 0.0)] {
        let piece = |i: usize| {
            let x = [[0.0, 0.25], [0.25, 0.75], [0.75, 1.0]][i];
            let half = 0.5 * (x[1] - x[0]);
            json!({"x": x, "half": half, "touches": true, "deflection": [middles[i], 9]})
        };
        with_fields(text, &json!({"pieces": [piece(0), piece(1), piece(2)]}), |fields| {
            let found = fields.frame.negligible().value();
            assert!((found - 1e-24 * largest).abs() <= 1e-36, "{middles:?}: {found:e}");
        });
    }
}
