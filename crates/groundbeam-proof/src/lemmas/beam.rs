//! Compares the bounds of test functions, deflections and moments of the beam with exact integrals.

#![cfg(test)]

use super::{COUNT, beam, claim, force, framed, integral, load, polynomial};
use crate::anchors::{between, beyond, from_mean};
use crate::balance::Balance;
use crate::ball::Ball;
use crate::compression::Compression;
use crate::cuts::fewest_cuts;
use crate::fields::Fields;
use crate::model::{Acts, Support, SupportKind};
use crate::pointwise::Pointwise;
use crate::random::numbers;
use crate::scalar::Scalar;
use crate::size::Size;
use crate::test_functions::kink;

/// Checks the bound of K² (section 4 of docs/proof.md) for the test function z = t(1 − t/h)². Springs lie where z and
/// z′ are largest.
#[test]
fn the_energy_of_test_functions_is_bounded() {
    let mut random = numbers();
    for _ in 0..200 {
        let mut number = || 10.0_f64.powf(2.0 * random());
        let [bending, layer, ground, spring, turning, available] = [0; 6].map(|_| number());
        let exact = |h: f64| {
            let z = |x: f64| x * (1.0 - x / h).powi(2);
            let slope = |x: f64| (1.0 - x / h) * (1.0 - 3.0 * x / h);
            let bent = |x: f64| -4.0 / h + 6.0 * x / (h * h);
            integral(h, |x| {
                bending * bent(x).powi(2) + layer * slope(x).powi(2) + ground * z(x).powi(2)
            }) + spring * z(h / 3.0).powi(2)
                + turning
        };
        let least =
            (0..24).map(|i| exact(available * 0.5_f64.powi(i))).fold(f64::INFINITY, f64::min);
        let sizes = [bending, layer, ground].map(Size::of);
        let bound = kink(sizes, [spring, turning].map(Size::of), available).value();
        assert!(least <= bound * (1.0 + 1e-5) && bound <= 1.01 * least, "{least} {bound}");
    }
}

/// Checks the bound of K² (section 4 of docs/proof.md) for test functions that are zero on one side of x and linear on
/// the other side. On each piece, x is the end with the larger K².
#[test]
fn the_energy_of_linear_test_functions_is_bounded() {
    let mut random = numbers();
    for _ in 0..50 {
        let [k, mu] = [1, 2].map(|_| 10.0_f64.powf(random()));
        let ground = [[0.4, k, mu], [0.5, k, mu], [0.6, k, mu]];
        let mut model = beam(1.0, &ground);
        let [spring, turning] = [0, 1].map(|_| 0.7 + 0.5 * random());
        let kind =
            SupportKind::Spring { spring: Ball::of(spring), rotational_spring: Ball::of(turning) };
        let support =
            Support { at: Ball::of(0.4), kind, settlement: Ball::zero(), acts: Acts::Both };
        model.supports = vec![support];
        // The following loads cause the constant deflection w = 1. The ground beyond each end of the beam reacts with
        // the force √(kμ).
        let outside = (k * mu).sqrt();
        model.loads = vec![
            load([0.0, 1.5], [k; 2]),
            force(0.0, outside),
            force(0.4, spring),
            force(1.5, outside),
        ];
        let frame = framed(&model, &claim(&ground, &vec![(true, vec![1.0]); 3], &[]));
        let fields = Fields::of(&frame).expect("fields");
        let (energy, balanced) = fields.energy().expect("a bound");
        let pointwise = Pointwise { fields: &fields, balanced: &balanced, energy };
        for side in [0, 1] {
            let mut stiffness = vec![Size::INFINITE; 3];
            pointwise.long_kinks(side, &mut stiffness);
            for (i, found) in stiffness.iter().enumerate() {
                let [from, to] = [frame.nodes[i].x.middle(), frame.nodes[i + 1].x.middle()];
                let length = if side == 0 { to } else { frame.length.middle() - from };
                let [k, mu] = [frame.spans[0].spring.middle(), frame.spans[0].shear.middle()];
                let node = &frame.nodes[1];
                let lever = if side == 0 { to - 0.4 } else { 0.4 - from };
                let held = if lever > 1e-9 { 1.0 } else { 0.0 };
                let spring = node.spring.map_or(0.0, |[spring, _]| spring.middle());
                let exact = integral(length, |x| k * x * x + mu)
                    + frame.outside[side].middle() * length * length
                    + held * spring * lever * lever
                    + held * node.turning.map_or(0.0, Ball::middle);
                let found = found.value();
                assert!(exact <= found * (1.0 + 1e-6), "{side} {i}: {exact} {found}");
                assert!(
                    found <= 1.001 * exact,
                    "side {side}, piece {i}: the bound {found} of {exact} is not sharp"
                );
            }
        }
    }
}

/// Returns a random error of the deflection on 0 ≤ x ≤ h: its values on a grid, and the norms (∫e_φ′²)^½ and (∫γ²)^½.
/// Its slope is the sum of a rotation e_φ and a shear strain γ.
fn random_error(random: &mut impl FnMut() -> f64, h: f64, slides: bool) -> (Vec<f64>, [f64; 2]) {
    let step = h / COUNT as f64;
    let bent = [random(), random(), random(), random()].map(|c| c * 3.0);
    let slid = [random(), random()].map(|c| if slides { c } else { 0.0 });
    let (mut turn, mut value) = (random(), random());
    let mut values = vec![value];
    let (mut s, mut sheared) = (0.0, 0.0);
    for i in 0..COUNT {
        let x = (i as f64 + 0.5) / COUNT as f64;
        let (q, g) = (polynomial(&bent, 2.0 * x - 1.0), polynomial(&slid, 2.0 * x - 1.0));
        value += step * (turn + 0.5 * step * q + g);
        turn += step * q;
        (s, sheared) = (s + step * q * q, sheared + step * g * g);
        values.push(value);
    }
    (values, [s.sqrt(), sheared.sqrt()])
}

/// Checks the bounds of the error of the deflection in section 4 of docs/proof.md: (12) from its mean, and the bounds
/// between and beyond two anchors.
#[test]
fn errors_of_the_deflection_are_bounded_by_their_anchors() {
    let mut random = numbers();
    let mut sharpest = [0.0_f64; 3];
    for case in 0..2000 {
        let h = 10.0_f64.powf(random());
        let (values, curved) = random_error(&mut random, h, case % 2 == 1);
        let [s, sheared] = curved.map(Size::of);
        let most = |range: std::ops::Range<usize>| {
            values[range].iter().fold(0.0_f64, |most, e| most.max(e.abs()))
        };
        let mean = values.iter().map(|e| e.abs()).sum::<f64>() / values.len() as f64;
        let half = Size::of(0.5 * h);
        let in_mean = from_mean(Size::of(mean), s * half * half.root(), sheared * half.root());
        let ends = [values[0], values[COUNT]].map(|e| Size::of(e.abs()));
        let inside = ends[0].worst(ends[1]) + between(Size::of(h), [s, sheared]);
        // The errors e(h/4) and e(3h/4) of the deflection bound the error e on the last quarter of the interval,
        // from 3h/4 to h.
        let [far, near] = [COUNT / 4, 3 * COUNT / 4].map(|i| Size::of(values[i].abs()));
        let over = Size::of(0.25 * h);
        let beyond = beyond([near, far], over, [0.5 * h; 2], [s, sheared]);
        let all = [
            (most(0..COUNT + 1), in_mean),
            (most(0..COUNT + 1), inside),
            (most(3 * COUNT / 4..COUNT + 1), beyond),
        ];
        for ((most, bound), sharpest) in all.into_iter().zip(&mut sharpest) {
            assert!(most <= bound.value() * 1.001, "{case}: {most} {bound:?}");
            *sharpest = sharpest.max(most / bound.value());
        }
    }
    assert!(sharpest.iter().all(|ratio| *ratio > 0.6), "{sharpest:?}");
}

/// Compares the bound (7) of docs/proof.md with the exact moment in a cell due to the redistributed pressure.
#[test]
fn the_moment_of_redistributed_loads_is_bounded() {
    let mut random = numbers();
    let mut sharpest = 0.0_f64;
    for _ in 0..100 {
        let ground = [[0.7, 2.0, 0.0], [0.8, 2.0, 0.0]];
        // The load is `part`·(a + b(x − 0.35)), and the claimed pressure is 2(a + b(x − 0.35)). A relative change of
        // the pressure restores equilibrium.
        let [a, b] = [1.0 + 0.3 * random(), 0.4 * random()];
        let pieces = [(true, vec![a, 0.35 * b]), (true, vec![a + 0.75 * b, 0.4 * b])];
        let mut model = beam(1.0, &ground);
        let part = 2.0 + 0.4 * random();
        model.loads = vec![load([0.0, 1.5], [0.0, 1.5].map(|x| part * (a + b * (x - 0.35))))];
        let frame = framed(&model, &claim(&ground, &pieces, &[]));
        let fields = Fields::of(&frame).expect("fields");
        let balance = Balance {
            frame: &frame,
            surface: &fields.surface,
            pressures: &fields.pressures,
            residual: &fields.residual,
            cuts: fewest_cuts(&frame),
            carrier: 0.0,
        };
        let balanced = balance.solve().expect("balanced");
        let factor = |x: f64| {
            let ends = [balanced.factors[0].middle(), balanced.factors[2].middle()];
            ends[0] + (ends[1] - ends[0]) * x / 1.5
        };
        let k = frame.spans[0].spring.middle();
        let changed = |x: f64| factor(x) * k * (a + b * (x - 0.35));
        let about_right = integral(1.5, |x| changed(x) * (1.5 - x)) / 1.5;
        let mut most = 0.0_f64;
        for i in 1..50 {
            let x = 1.5 * f64::from(i) / 50.0;
            let moment = about_right * x - integral(x, |y| changed(y) * (x - y));
            most = most.max(moment.abs());
        }
        let bound = balanced.pieces[0].added[0].value();
        assert!(most <= bound, "{most} {bound}");
        sharpest = sharpest.max(most / bound);
    }
    assert!(sharpest > 0.3, "{sharpest}");
}

/// Checks the effect of a compression on bounds from test functions, for random numbers and for a stiffness at which
/// the bound is exact.
#[test]
fn the_compression_in_test_functions_is_bounded_and_sharp() {
    let mut random = numbers();
    for _ in 0..1000 {
        let [force, energy, turned, slope] = [0; 4].map(|_| 10.0_f64.powf(3.0 * random()));
        let margin = 0.5 + 0.49 * random();
        let compression = Compression { force: Ball::of(force), margin };
        let [e, t] = [energy, turned].map(Size::of);
        let (factor, tension) = (compression.test_factor(e, t), compression.as_tension(e, t));
        let [factor, tension] = [factor, tension].map(Size::value);
        let root = (2.0 * energy).sqrt();
        let misfit = ((1.0 - margin) * force * turned).sqrt();
        let is_bound = |stiffness: f64| {
            let exact = (root + misfit) * stiffness / margin.sqrt()
                + root * ((1.0 - margin) * force * slope / margin).sqrt()
                + force * (slope * turned).sqrt();
            let bound = factor * (stiffness * stiffness + tension * slope).sqrt();
            assert!(exact <= bound * (1.0 + 1e-12), "{exact} {bound}");
            exact / bound
        };
        is_bound(10.0_f64.powf(3.0 * random()));
        let sharp = is_bound((root + misfit) / root * (tension * slope).sqrt());
        assert!(sharp >= 1.0 - 1e-12, "{sharp}");
    }
    let compression = Compression { force: Ball::of(4.0), margin: 0.75 };
    let [none, energy] = [0.0, 0.5].map(Size::of);
    assert!((compression.as_tension(energy, none).value() - 1.0).abs() < 1e-12);
}
