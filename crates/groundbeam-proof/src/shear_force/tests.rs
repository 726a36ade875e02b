//! Compares the bounds of the shear force with closed forms.

#![cfg(test)]

use super::*;
use crate::contact_set::EdgeShift;
use crate::given_claim::{balanced, with_fields};
use crate::wide::Wide;
use serde_json::json;

/// The lower bound of 1 + P/S uses the largest shear stiffness S if P is a tension, and the smallest S if P is a
/// compression.
#[test]
fn the_axial_force_stiffens_a_beam_with_shear_deformation() {
    for (axial, expected) in [(1.0, 1.25), (0.0, 1.0), (-1.0, 0.5)] {
        let model = format!(
            "[beam]\nlength = 1\nEI = 1\naxial_force = {axial:?}\n[[beam.segment]]\nfrom = 0\nto = 1\n\
             shear_stiffness = [4, 2]\n[foundation]\nk = 1\nmu = 1\n\
             [[support]]\nat = 0\ntype = 'pinned'\n[[support]]\nat = 1\ntype = 'pinned'\n"
        );
        let piece =
            json!({"x": [0, 1], "half": 0.5, "touches": true, "deflection": [0], "rotation": [0]});
        with_fields(&model, &json!({"pieces": [piece]}), |fields| {
            let balanced = balanced(1);
            let pointwise = Pointwise { fields, balanced: &balanced, energy: Size::ZERO };
            let stiffness = fields.frame.spans[0].stiffness.as_ref().expect("a stiffness");
            let found = pointwise.stiffened(stiffness);
            assert!(found <= expected && found > expected - 1e-12, "{axial} {found}");
        });
    }
}

/// `size_beside` bounds |a + bt| within a distance of one end of a piece, or on the whole piece if the distance is at
/// least half its length.
#[test]
fn a_line_is_bounded_within_a_distance_of_an_end() {
    let model = "[beam]\nlength = 1\nEI = 1\n[foundation]\nk = 1\n";
    let piece = json!({"x": [0, 1], "half": 0.5, "touches": false, "deflection": [0]});
    with_fields(model, &json!({"pieces": [piece]}), |fields| {
        let span = &fields.frame.spans[0];
        for [a, b] in [[1.0, 2.0], [-1.0, 2.0], [3.0, -2.0], [0.0, 1.0]] {
            let line = Polynomial::from_coefficients([a, b].map(Wide::of));
            for (side, end) in [(0, -1.0), (1, 1.0)] {
                for distance in [0.0, 0.01, 0.25, 0.45, 0.5, 0.75] {
                    let part = [end, end - end * distance / 0.5];
                    let exact = match distance < 0.5 {
                        true => part.map(|t| f64::abs(a + b * t)).into_iter().fold(0.0, f64::max),
                        false => a.abs() + b.abs(),
                    };
                    let found = size_beside(span, &line, side, Size::of(distance)).value();
                    let what = format!("{a} {b} {side} {distance}: {found} {exact}");
                    assert!(exact <= found && found <= exact + 1e-12, "{what}");
                }
            }
        }
        // The linear function `line` is zero at the end of the piece. Its bound near this end is so small that the
        // rounding error of the position would show in it.
        let distance = 1e-10;
        for (side, b) in [(0, 1.0), (1, -1.0)] {
            let line = Polynomial::from_coefficients([1.0, b].map(Wide::of));
            let found = size_beside(span, &line, side, Size::of(distance)).value();
            assert!((0.0..1e-14).contains(&(found - 2.0 * distance)), "{side} {found:e}");
        }
    });
}

/// On ground with k = 4 and μ = 1 under a load q, the settlement is u = q/k + v with v″ = 4v. The pressure 4v + 2 of a
/// beam with w″ = −2 changes by at most 4d max|v′| within the distance d of an end.
#[test]
fn the_pressure_over_loaded_open_ground_is_bounded_near_an_end() {
    for rise in [1.0, -1.0] {
        let ends = [1.0 - 0.5 * rise, 1.0 + 0.5 * rise];
        let model = format!(
            "[beam]\nlength = 1\nEI = 1\n[foundation]\nk = 4\nmu = 1\n[[gap]]\nat = 0\nvalue = 100\n\
             [[ground_load]]\ndistributed = {ends:?}\nfrom = 0\nto = 1\n"
        );
        let piece =
            json!({"x": [0, 1], "half": 0.5, "touches": false, "deflection": [1, 0, -0.25]});
        // Beyond the piece, the settlement u of the unloaded ground decays at the rate √(k/μ) = 2. On the piece,
        // v = u − q/k is the sum of an even and an odd function of the distance y from the middle.
        let tangent = 1.0_f64.tanh();
        let even = -0.25 / (1.0 + tangent);
        let odd = -0.25 * rise / (1.0 + 1.0 / tangent);
        let (cosine, sine) = (1.0_f64.cosh(), 1.0_f64.sinh());
        let v = |y: f64| even * (2.0 * y).cosh() / cosine + odd * (2.0 * y).sinh() / sine;
        let slopes = [-1.0, 1.0].map(|sign| sign * 2.0 * even * tangent + 2.0 * odd / tangent);
        let steep = slopes[0].abs().max(slopes[1].abs());
        with_fields(&model, &json!({"pieces": [piece]}), |fields| {
            let balanced = balanced(1);
            let pointwise = Pointwise { fields, balanced: &balanced, energy: Size::ZERO };
            for (side, sign) in [(0, -1.0), (1, 1.0)] {
                let end = 0.5 * sign;
                for distance in [0.0, 0.01, 0.1] {
                    let found = pointwise.open_pressure_beside(0, side, Size::of(distance)).value();
                    let exact = 4.0 * v(end) + 2.0 + 4.0 * steep * distance;
                    assert!((found - exact).abs() < 1e-12, "{side} {distance}: {found} {exact}");
                    assert!(4.0 * v(end - sign * distance) + 2.0 <= found + 1e-12);
                }
            }
        });
    }
}

/// One half of the beam is in contact; p is its contact pressure. The errors of the loads are those of (15) in
/// `docs/proof.md`: ε_p + γp + (1 + γ)η in contact, θ(p_o + ε_p) outside an edge, and θ′(1 + γ)p inside an edge.
#[test]
fn the_errors_of_the_loads_are_those_of_the_pressure_and_of_the_edges() {
    for (mirrored, layer) in [(false, "mu = 1\n"), (true, "mu = 1\n"), (false, "")] {
        let model = format!("[beam]\nlength = 1\nEI = 1\n[foundation]\nk = 1\n{layer}");
        let slope = if mirrored { 0.25 } else { -0.25 };
        let half = |i: usize| {
            let (from, touches) = (0.5 * i as f64, (i == 1) == mirrored);
            let middle = if touches { 1.75 } else { 1.25 };
            json!({"x": [from, from + 0.5], "half": 0.25, "touches": touches, "deflection": [middle, slope]})
        };
        with_fields(&model, &json!({"pieces": [half(0), half(1)]}), |fields| {
            let [inner, outer] = if mirrored { [1, 0] } else { [0, 1] };
            fields.pressures[inner].depth = Size::of(0.1);
            let mut balanced = balanced(2);
            balanced.factors[2 * inner] = Wide::of(-0.5);
            let mut bounds = [PieceBounds::EXACT; 2];
            (bounds[inner].pressure, bounds[outer].pressure) = (Size::of(0.1), Size::of(0.2));
            let pointwise = Pointwise { fields, balanced: &balanced, energy: Size::ZERO };
            let mut shown = Shown::nothing(3);
            let errors = pointwise.load_errors(&shown, &bounds);
            let is = |found: Size, exact: f64| {
                assert!((found.value() - exact).abs() < 1e-12, "{found:?} {exact}");
            };
            is(errors[inner].spread, 0.1 + 0.5 * 2.0 + 1.5 * 0.1);
            is(errors[outer].spread, if layer.is_empty() { 0.2 } else { 0.0 });
            assert!(errors.iter().all(|error| error.edges == Size::ZERO));
            if layer.is_empty() {
                return;
            }
            let side = 1 - inner;
            let beyond = [Size::ZERO; 2];
            let [outside, inside] = [0.01, 0.02].map(Size::of);
            shown.edges = vec![EdgeShift { node: 1, side, outside, inside, beyond }];
            let errors = pointwise.load_errors(&shown, &bounds);
            is(errors[inner].edges, 0.02 * 1.5 * 1.52);
            let open = pointwise.open_pressure_beside(outer, inner, outside).value();
            is(errors[outer].edges, 0.01 * (open + 0.2));
            // An edge of contact whose exact position is known adds no error.
            let [outside, inside] = [Size::ZERO; 2];
            shown.edges = vec![EdgeShift { node: 1, side, outside, inside, beyond }];
            let errors = pointwise.load_errors(&shown, &bounds);
            assert!(errors.iter().all(|error| error.edges == Size::ZERO));
        });
    }
}
