//! Checks lengths that balance a missing force, regions, point contacts, edges and contact forces in closed form.

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

/// Checks that the pressure minus its error has at least the resultant `missing` on the length θ′ from an end
/// of the piece. Where the pressure is nearly constant, θ′ is the smallest such length.
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

/// p decreases inward from 1 to 0 on half of the piece. The length that balances a small force is the force over
/// the pressure at the end.
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

/// The bounds of a pressure that increases inward from zero include the rounding errors of the position.
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

/// Passes a claim of four pieces of length ¼ to `of`. The beam w = 1 is in contact on the third piece of a layer
/// with k = μ = 1, so p = 1 there. t lies between −5/6 and 5/6 on this piece, and one unit of t is the length 0.15.
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

/// The region ends at nodes 2 and 3. The errors of the flux are 0.2 outside and 0.05 inside. A force a leaves a
/// length θ′ = 0.25 − a, and a part 0.2 − a of the jump of the flux that does not depend on the slope.
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
                // One unit of t is too short for the missing force 0.2.
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

/// The region has the length 0.25. The exact beam is in contact somewhere if both θ′ together are shorter.
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

/// The interval of a concentrated force is a ± ε_a, and it contains zero where contact is not proven. Only a
/// positive force holds the beam.
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
