//! Compares the bounds of contact edges and contact forces with closed forms, and checks which contact regions are proven.

#![cfg(test)]

use super::{balanced_inside, pressed_beside};
use crate::approach::Approach;
use crate::ball::Ball;
use crate::contact_set::{Contact, Shown};
use crate::fields::Fields;
use crate::given_claim::with_fields;
use crate::pointwise::PieceBounds;
use crate::polynomial::Polynomial;
use crate::random::numbers;
use crate::scalar::Scalar;
use crate::size::Size;
use crate::wide::Wide;
use serde_json::json;

/// Checks that the pressure on the length from `balanced_inside` balances the force `missing`. If the pressure is
/// nearly constant, the length must be the shortest possible.
#[test]
fn the_length_inside_an_edge_balances_the_missing_force() {
    let mut random = numbers();
    let mut found = 0;
    for i in 0..1000 {
        let (side, half) = (i % 2, 3.0_f64.powf(random()));
        let sign = if side == 0 { -1.0 } else { 1.0 };
        let steep = if i % 3 == 0 { 1e-6 } else { 2.0 };
        let c = [1.0 + 0.5 * random(), steep * random(), steep * random()];
        let p = |t: f64| c[0] + t * (c[1] + t * c[2]);
        let error = 0.3 * random().abs();
        let missing = half * 10.0_f64.powf(2.0 * random() - 2.0);
        let field = <Polynomial<Ball>>::from_coefficients(c.map(Ball::of));
        let inside =
            balanced_inside(&field, Size::of(error), Size::of(missing), (sign, half), side);
        let (near, whole) = (p(sign) - error, inside.value());
        if steep < 1.0 {
            let wanted = missing / near;
            let ratio = whole / wanted;
            let fits = wanted < 0.999 * half;
            assert!(
                if fits {
                    (1.0 - 1e-5..1.0 + 1e-5).contains(&ratio)
                } else {
                    wanted > 0.99 * half || ratio < 1.1
                },
                "{ratio}"
            );
        }
        if whole < f64::INFINITY {
            found += 1;
            let places = (0..=100).map(|j| sign * (1.0 - whole / half * f64::from(j) / 100.0));
            let least = places.map(p).fold(f64::INFINITY, f64::min) - error;
            assert!(
                whole <= half && whole * least >= missing * (1.0 - 1e-12),
                "{whole} {least} {missing}"
            );
        }
    }
    assert!(found > 500, "{found}");
}

/// Checks the length for a pressure that falls from 1 at an end of the piece to 0 in its middle. For a small force, the
/// length is nearly equal to the force.
#[test]
fn the_length_inside_an_edge_uses_the_pressure_near_the_edge() {
    for (side, sign) in [(0, -1.0), (1, 1.0)] {
        let field = <Polynomial<Ball>>::from_coefficients([0.0, sign].map(Ball::of));
        for missing in [1e-3, 1e-6, 1e-9] {
            let small = Size::of(missing);
            let inside = balanced_inside(&field, Size::ZERO, small, (sign, 1.0), side).value();
            let ratio = inside / missing;
            assert!((1.0..1.0 + 5.0 * missing + 1e-6).contains(&ratio), "{missing} {ratio}");
        }
    }
}

/// The pressure is zero at an end of the piece and increases inward. The lower bound on a short part at this end must
/// not be positive.
#[test]
fn the_pressure_on_a_short_part_is_not_above_that_at_the_end() {
    for (side, sign) in [(0, -1.0), (1, 1.0)] {
        let field = <Polynomial<Ball>>::from_coefficients([1.0, -sign].map(Ball::of));
        for part in [4e-12, 1e-10, 1e-8] {
            let [least, length] = pressed_beside(&field, Size::ZERO, (sign, 2.0), side, part);
            assert!((-1e-14..=0.0).contains(&least), "{part} {least}");
            assert!((0.7 * part..2.0 * part).contains(&length), "{part} {length}");
        }
    }
}

/// Passes a claimed solution with w = 1 on four pieces of length ¼ to `of`. Only the third piece is in contact, with
/// the pressure 1. Its stored half length is 0.15, so t runs from −5/6 to 5/6.
fn with_region<T>(of: impl FnOnce(&mut Fields<Wide>) -> T) -> T {
    let model = "[beam]\nlength = 1\nEI = 1\n[foundation]\nk = 1\nmu = 1\n";
    let piece = |i: usize| {
        let (from, half) = (0.25 * i as f64, if i == 2 { 0.15 } else { 0.125 });
        json!({"x": [from, from + 0.25], "half": half, "touches": i == 2, "deflection": [1]})
    };
    let pieces: Vec<_> = (0..4).map(piece).collect();
    with_fields(model, &json!({"pieces": pieces}), of)
}

fn is(what: &str, found: Size, exact: f64) {
    assert!((found.value() / exact - 1.0).abs() < 1e-9, "{what}: {found:?} {exact}");
}

/// Checks that a contact edge moves inward by at most 0.25 − F under the pressure 1. The concentrated force F has the
/// error bound 0.2 from outside plus 0.05 from inside the region.
#[test]
fn an_edge_moves_inward_by_the_missing_force() {
    with_region(|fields| {
        let mut beside = [[None; 2]; 5];
        let [theta, flux, steep] = [0.01, 0.2, 0.3].map(Size::of);
        let approach = Approach { theta, flux, steep, reach: 0.0 };
        (beside[2][0], beside[3][1]) = (Some(approach), Some(approach));
        let bounds = [PieceBounds { slope: Size::of(0.05), ..PieceBounds::EXACT }; 4];
        for (node, side) in [(2, 0), (3, 1)] {
            for jump in [0.15, 0.3, 0.05] {
                fields.surface.nodes[node].jump = Wide::of(jump);
                let contact = Contact { fields, bounds: &bounds };
                let found = contact.edge(node, side, &beside);
                // For F = 0.05, the pressure must balance 0.2. On the searched length 0.15 it balances only 0.15, so no
                // bound is found.
                let Ok(found) = found else {
                    assert_eq!(jump, 0.05);
                    continue;
                };
                assert_eq!((found.node, found.side, found.outside), (node, side, theta));
                is("outside", found.beyond[0], 0.5);
                if jump == 0.3 {
                    assert_eq!([found.inside, found.beyond[1]], [Size::ZERO; 2]);
                } else {
                    is("inside", found.inside, 0.1);
                    is("force", found.beyond[1], 0.05);
                }
            }
        }
    });
}

/// Checks that a contact region of length 0.25 is proven if its edges move inward by less than 0.25 together.
#[test]
fn a_region_is_longer_than_the_bounds_of_its_edges() {
    with_region(|fields| {
        let [theta, flux, steep] = [Size::ZERO; 3];
        let approach = Approach { theta, flux, steep, reach: 0.0 };
        let mut beside = [[None; 2]; 5];
        (beside[2][0], beside[3][1]) = (Some(approach), Some(approach));
        let bounds = [PieceBounds::EXACT; 4];
        for ([left, right], longer) in [
            ([0.12, 0.12], true),
            ([0.14, 0.1], true),
            ([0.13, 0.13], false),
            ([0.14, 0.12], false),
        ] {
            fields.surface.nodes[2].jump = Wide::of(-left);
            fields.surface.nodes[3].jump = Wide::of(-right);
            let contact = Contact { fields, bounds: &bounds };
            let found = contact.region([2, 3], &beside, &mut Shown::nothing(5));
            assert_eq!(found.is_ok(), longer, "{left} {right}");
        }
    });
}

/// Checks the interval F ± ε of a concentrated force F, without negative values. The interval begins at zero unless
/// contact is proven.
#[test]
fn a_concentrated_force_is_positive_only_if_proven() {
    with_region(|fields| {
        fields.surface.nodes[2].jump = Wide::of(1.0);
        let bounds = [PieceBounds::EXACT; 4];
        let contact = Contact { fields, bounds: &bounds };
        for (tolerance, touches, [low, high]) in [
            (0.25, true, [0.75, 1.25]),
            (0.25, false, [0.0, 1.25]),
            (1.0, true, [0.0, 2.0]),
            (2.0, true, [0.0, 3.0]),
        ] {
            let mut shown = Shown::nothing(5);
            contact.force(2, Size::of(tolerance), touches, &mut shown);
            let [found] = &shown.set.forces[..] else { panic!("one force") };
            assert!((found.force[0] - low).abs() < 1e-12, "{found:?}");
            assert!((found.force[1] - high).abs() < 1e-12, "{found:?}");
            assert_eq!(shown.pressed, [false, false, low > 0.0, false, false]);
        }
    });
}

/// Checks the error bound of the shear-layer force μu′: that of the settlement times √(kμ) = 1 beside the beam, that of
/// the slope times μ = 1 under it, and zero on Winkler ground.
#[test]
fn the_error_of_the_flux_beside_the_beam_is_that_of_the_settlement_at_its_end() {
    let text = "[beam]\nlength = 1\nEI = 1\n[foundation]\nk = 1\nmu = 1\n\
        [[foundation.segment]]\nfrom = 0.25\nto = 0.5\nk = 1\nmu = 0\n";
    let piece = |i: usize| {
        let from = 0.25 * i as f64;
        json!({"x": [from, from + 0.25], "half": 0.125, "touches": true, "deflection": [1]})
    };
    let pieces: Vec<_> = (0..4).map(piece).collect();
    with_fields(text, &json!({ "pieces": pieces }), |fields| {
        let bounds = [1, 2, 3, 4].map(|i| PieceBounds {
            settlement: Size::of(f64::from(i)),
            slope: Size::of(10.0 * f64::from(i)),
            ..PieceBounds::EXACT
        });
        let force = fields.frame.units.scaled(Wide::one(), 1, 0).middle();
        let contact = Contact { fields, bounds: &bounds };
        for (node, [left, right]) in [
            (0, [1.0, 10.0]),
            (1, [10.0, 0.0]),
            (2, [0.0, 30.0]),
            (3, [30.0, 40.0]),
            (4, [40.0, 4.0]),
        ] {
            for (side, exact) in [left, right].into_iter().enumerate() {
                let found = contact.tolerance_beside(node, side, &[[None; 2]; 5]).value();
                let off = (found - exact * force).abs();
                assert!(off <= 1e-12 * force, "{node} {side}: {found} {exact}");
            }
        }
    });
}
