//! Compares bounds of the ground's error energy with exact energies, for residual forces, tensile pressures and beam penetration.

#![cfg(test)]

use super::{COUNT, Stretch, beam, claim, framed, integral, polynomial};
use crate::ball::Ball;
use crate::clearance::clearance;
use crate::deflection::admissible;
use crate::fields::Fields;
use crate::frame::Frame;
use crate::ground::surface;
use crate::model::{Acts, Support, SupportKind};
use crate::polynomial::Budget;
use crate::pressure::{pressures, tension_norm};
use crate::random::numbers;
use crate::scalar::Scalar;

/// Returns the coefficients of the polynomial Σcⱼyʲ as a polynomial of t, with y = `middle` + `half` t, by Horner's
/// rule.
fn of_t(c: &[f64], middle: f64, half: f64) -> Vec<f64> {
    let mut sum = Vec::new();
    for c in c.iter().rev() {
        let mut next = vec![0.0; sum.len() + 1];
        for (j, s) in sum.iter().enumerate() {
            next[j] += s * middle;
            next[j + 1] += s * half;
        }
        next[0] += c;
        sum = next;
    }
    sum
}

/// Returns an upper bound of the ground stiffness at one end of a stretch, by linear finite elements. `stiffness` is
/// the stiffness of the ground beyond the other end.
fn behind(stiffness: f64, [length, k, mu]: Stretch) -> f64 {
    let h = length / COUNT as f64;
    let [own, across] = [k * h / 3.0 + mu / h, k * h / 6.0 - mu / h];
    (0..COUNT).fold(stiffness, |sum, _| own - across * across / (sum + own))
}

/// Returns a lower bound of the settlement of a node out of contact under a unit force at the node, by linear finite
/// elements.
fn flexibility(frame: &Frame<Ball>, ground: &[Stretch], node: usize) -> f64 {
    let left = ground[..node].iter().fold(frame.outside[0].middle(), |sum, s| behind(sum, *s));
    let right = ground[node..].iter().rev();
    let right = right.fold(frame.outside[1].middle(), |sum, s| behind(sum, *s));
    1.0 / (left + right)
}

/// Checks the bound |r|√g of the norm of a residual force r on ground with the flexibility g, see (4a) of
/// docs/proof.md. The claimed surface is raised at one node by a tensile force r.
#[test]
fn the_energy_of_a_residual_force_is_bounded() {
    let mut random = numbers();
    let mut sharpest = 0.0_f64;
    for case in 0..200 {
        let count = 1 + case % 4;
        let mut ground: Vec<Stretch> = (0..count)
            .map(|_| [1.2 / count as f64; 3].map(|x| x * 10.0_f64.powf(random())))
            .collect();
        let scale = 1.5 / ground.iter().map(|s| s[0]).sum::<f64>();
        ground.iter_mut().for_each(|s| s[0] *= scale);
        let node = (case / 4) % (count + 1);
        let place = ground[..node].iter().map(|s| s[0]).sum::<f64>();
        let pieces = vec![(false, vec![-0.3]); count];
        let frame = framed(&beam(1.0, &ground), &claim(&ground, &pieces, &[place]));
        let surface = surface(&frame, &admissible(&frame).expect("a deflection"));
        let exact = flexibility(&frame, &ground, node);
        let bound = surface.flexibility_at(node).value();
        // The tolerance allows for rounding errors of the finite elements.
        assert!(exact <= bound * bound * (1.0 + 1e-6), "{case}: {exact} {}", bound * bound);
        let force = surface.nodes[node].jump.middle();
        assert!(
            (force + frame.units.scaled(Ball::of(0.3), 0, 1).middle() / exact).abs() < 1e-3 / exact
        );
        let energy = force * force * exact;
        let cost = surface.unclaimed.value();
        assert!(energy <= cost * cost * (1.0 + 1e-6), "{case}: {energy} {}", cost * cost);
        sharpest = sharpest.max(energy / (cost * cost));
    }
    assert!(sharpest > 0.999, "{sharpest}");
}

/// Returns the energy ⟨q, Gq⟩ of a load q on infinite ground with constant k and μ, by the kernel
/// e^{−b|x−y|}/(2√(kμ)) with b = √(k/μ).
fn energy_of_load(length: f64, [k, mu]: [f64; 2], load: impl Fn(f64) -> f64) -> f64 {
    let h = length / COUNT as f64;
    let fall = (-(k / mu).sqrt() * h).exp();
    let at = |i: usize| load((i as f64 + 0.5) * h) * h;
    let (mut sum, mut before) = (0.0, 0.0);
    for i in 0..COUNT {
        // The interval adds the square of its load, and twice its load times `before`, the decayed sum of the loads to
        // its left.
        sum += at(i) * (2.0 * before + at(i));
        before = (before + at(i)) * fall;
    }
    sum / (2.0 * (k * mu).sqrt())
}

/// Checks the bounds ηω of the resultant and η²ω/k of the energy of the tensile part of a pressure p. Here p ≥ −η, and
/// p < 0 on the length ω.
#[test]
fn the_energy_of_tensile_pressures_is_bounded() {
    let mut random = numbers();
    let mut sharpest = 0.0_f64;
    for case in 0..300 {
        let [k, mu] = [1, 2].map(|_| 10.0_f64.powf(1.5 * random()));
        let mu = if case % 3 == 0 { 0.0 } else { mu };
        let ground = [[1.5, k, mu]];
        let mut w = vec![-0.5 + random(), random(), random(), random()];
        if case % 10 == 1 {
            w = vec![-0.3];
        }
        let frame = framed(&beam(1.0, &ground), &claim(&ground, &[(true, w.clone())], &[]));
        let pressures = pressures(&frame, &mut Budget::new(1));
        let bent = |t: f64| {
            let second = w.iter().enumerate().skip(2);
            second.map(|(j, c)| (j * (j - 1)) as f64 * c * t.powi(j as i32 - 2)).sum::<f64>()
        };
        let tension = |x: f64| {
            let t = x / 0.75 - 1.0;
            (mu * bent(t) / (0.75 * 0.75) - k * polynomial(&w, t)).max(0.0)
        };
        let units = frame.units;
        let load = units.restored(pressures[0].tensile_force().value(), 1, 0);
        assert!(integral(1.5, tension) <= load * 1.001 + 1e-9, "{case}");
        let energy = match mu > 0.0 {
            true => energy_of_load(1.5, [k, mu], tension),
            false => integral(1.5, |x| tension(x) * tension(x)) / k,
        };
        let cost = tension_norm(&frame, &pressures).value();
        let cost = units.restored(cost * cost, 1, 1);
        assert!(energy <= cost * 1.001 + 1e-9, "{case}: {energy} {cost}");
        sharpest = sharpest.max(energy / cost);
    }
    assert!(sharpest > 0.9, "{sharpest}");
}

/// Checks a stiff beam of length l that supports hold at the height w above the ground. The claim is that the ground
/// follows the beam. The bound of the error energy is at least ½w²(kl + 2√(kμ)), the energy of the lifted ground.
#[test]
fn the_energy_of_a_surface_under_tension_is_bounded() {
    for [k, mu] in [[1.0, 1.0], [30.0, 0.02], [0.02, 30.0]] {
        let (length, w) = (1.5, 0.3);
        let ground = [[length, k, mu]];
        let mut model = beam(1e20, &ground);
        let support = |at: f64| Support {
            at: Ball::of(at),
            kind: SupportKind::Pinned,
            settlement: Ball::of(-w),
            acts: Acts::Both,
        };
        model.supports = [0.0, length].map(support).to_vec();
        let frame = framed(&model, &claim(&ground, &[(true, vec![-w])], &[]));
        let (energy, _) = Fields::of(&frame).and_then(|f| f.energy()).expect("a bound");
        let energy = frame.units.restored(energy.value(), 1, 1);
        let exact = 0.5 * w * w * (k * length + 2.0 * (k * mu).sqrt());
        assert!(exact <= energy && energy <= 2.001 * exact, "{exact} {energy}");
    }
}

/// Checks (10) of docs/proof.md on random stretches that the beam penetrates.
///
/// If a correction is c at the distance y from a contact, its squared norm is at least c²(√(kμ) coth(by) + S). Here
/// b = √(k/μ), and S is the stiffness of the ground beyond y.
#[test]
fn the_energy_of_the_raised_ground_is_bounded() {
    let mut random = numbers();
    let mut ratios = Vec::new();
    for case in 0..400 {
        let both = case % 2 == 0;
        let [k, mu] = [1, 2].map(|_| 10.0_f64.powf(1.5 * random()));
        let (rate, root) = ((k / mu).sqrt(), (k * mu).sqrt());
        let long = 0.5 + 0.4 * random();
        let mut ground = vec![[0.5, k, mu], [long, k, mu]];
        if both {
            ground.push([0.5, k, mu]);
        }
        // The deflection out of contact is a straight line plus a polynomial. The polynomial and its slope are zero at
        // each contact.
        let (start, slope) = (2.0 + random(), 2.0 * random() * rate);
        let (a, b) = (10.0 * random(), 10.0 * random());
        let sunk = |y: f64| {
            let end = if both { long - y } else { 1.0 };
            start + slope * y + y * y * end * end * (a + b * y)
        };
        let square = [0.0, 0.0, 1.0];
        let l = long;
        let ends = if both { vec![l * l, -2.0 * l, 1.0] } else { vec![1.0] };
        let product = |p: &[f64], q: &[f64]| {
            let mut all = vec![0.0; p.len() + q.len() - 1];
            for (i, p) in p.iter().enumerate() {
                for (j, q) in q.iter().enumerate() {
                    all[i + j] += p * q;
                }
            }
            all
        };
        let mut open = product(&product(&square, &ends), &[a, b]);
        open[0] += start;
        open[1] += slope;
        let line = |middle: f64, half: f64| vec![start + slope * middle, slope * half];
        let mut pieces = vec![(true, line(-0.25, 0.25)), (false, of_t(&open, 0.5 * l, 0.5 * l))];
        if both {
            pieces.push((true, line(l + 0.25, 0.25)));
        }
        let frame = framed(&beam(1.0, &ground), &claim(&ground, &pieces, &[]));
        let deflection = admissible(&frame).expect("a deflection");
        let surface = surface(&frame, &deflection);
        let found = clearance(&frame, &deflection, &surface, &mut Budget::new(3));
        let (raised, cost) = (found.raised[1].value(), found.lifted.value());
        let raised = frame.units.restored(raised, 0, 1);
        let cost = frame.units.restored(cost * cost, 1, 1);
        let settled = |y: f64| match both {
            true => {
                let whole = (rate * l).sinh();
                (sunk(0.0) * (rate * (l - y)).sinh() + sunk(l) * (rate * y).sinh()) / whole
            }
            false => sunk(0.0) * (-rate * y).exp(),
        };
        let mut least = 0.0_f64;
        for i in 1..COUNT {
            let y = l * i as f64 / COUNT as f64;
            let deep = sunk(y) - settled(y);
            assert!(deep <= raised * (1.0 + 1e-9) + 1e-9, "{case}: {deep} {raised}");
            let after = if both { root / (rate * (l - y)).tanh() } else { root };
            least = least.max(deep.max(0.0).powi(2) * (root / (rate * y).tanh() + after));
        }
        assert!(least <= cost * (1.0 + 1e-9) + 1e-9, "{case}: {least} {cost}");
        if least > 1e-3 {
            ratios.push(least / cost);
        }
    }
    ratios.sort_by(f64::total_cmp);
    assert!(ratios.len() > 200 && ratios[ratios.len() / 2] > 0.1, "{ratios:?}");
}
