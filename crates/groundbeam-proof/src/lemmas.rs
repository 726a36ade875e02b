//! Compares the inequalities of docs/proof.md with exact energies of random functions and of forces on open ground.

#![cfg(test)]

use crate::anchors::{between, beyond, from_mean};
use crate::answer::{Answer, Force, Piece};
use crate::balance::{Balance, fewest_cuts};
use crate::ball::Ball;
use crate::clearance::clearance;
use crate::deflection::admissible;
use crate::fields::Fields;
use crate::frame::Frame;
use crate::given::frame;
use crate::ground::surface;
use crate::model::{
    Action, Acts, Beam, Course, Extent, Ground, GroundEnd, GroundSegment, Load, Model, Support,
    SupportKind,
};
use crate::pointwise::Pointwise;
use crate::polynomial::Budget;
use crate::pressure::{pressures, pulled};
use crate::random::numbers;
use crate::scalar::Scalar;
use crate::size::Size;
use crate::test_functions::kink;

/// Points of a numerical integral.
const COUNT: usize = 2000;

/// A stretch of ground: its length, k and μ.
type Stretch = [f64; 3];

/// A beam with the bending stiffness EI on infinite ground that consists of stretches.
fn beam(bending: f64, ground: &[Stretch]) -> Model<Ball> {
    let mut to = 0.0;
    let segment = |[length, k, mu]: &Stretch| {
        let from = to;
        to += length;
        let [spring, shear] = [*k, *mu].map(|x| Course::Constant(Ball::of(x)));
        GroundSegment { from: Ball::of(from), to: Ball::of(to), spring, shear }
    };
    let segments = ground.iter().map(segment).collect();
    Model {
        beam: Beam {
            length: Ball::of(to),
            bending_stiffness: Ball::of(bending),
            shear_stiffness: None,
            segments: Vec::new(),
            axial_force: Ball::zero(),
        },
        ground: Ground {
            spring: Ball::one(),
            shear: Ball::one(),
            segments,
            ends: [GroundEnd::Endless; 2],
        },
        loads: Vec::new(),
        supports: Vec::new(),
        hinges: Vec::new(),
        gap: Vec::new(),
    }
}

/// A load on the beam between two places, linear between its values there.
fn load([from, to]: [f64; 2], [start, end]: [f64; 2]) -> Load<Ball> {
    let [from, to, start, end] = [from, to, start, end].map(Ball::of);
    let extent = Extent::Distributed { from, to, start, end };
    Load { action: Action::Force, extent, on_ground: false }
}

fn force(at: f64, size: f64) -> Load<Ball> {
    let extent = Extent::Point { at: Ball::of(at), size: Ball::of(size) };
    Load { action: Action::Force, extent, on_ground: false }
}

/// An answer with one piece for each stretch. For each piece: whether it is in contact, and w as a polynomial
/// of t.
fn claim(ground: &[Stretch], pieces: &[(bool, Vec<f64>)], forces: &[f64]) -> Answer {
    let mut to = 0.0;
    let piece = |([length, ..], (touches, deflection)): (&Stretch, &(bool, Vec<f64>))| {
        let from = to;
        to += length;
        let half = 0.5 * (to - from);
        Piece {
            x: [from, to],
            half,
            touches: *touches,
            deflection: deflection.clone(),
            ..Piece::default()
        }
    };
    let pieces = ground.iter().zip(pieces).map(piece).collect();
    let forces = forces.iter().map(|x| Force { x: *x, force: 1.0 }).collect();
    Answer { pieces, forces, reactions: Vec::new() }
}

fn framed(model: &Model<Ball>, answer: &Answer) -> Frame<Ball> {
    frame(model, answer, None, &[]).expect("a claim that can be read")
}

/// A polynomial Σcⱼyʲ as a polynomial of t = y/half − 1 + shift/half, by Horner's rule.
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

fn polynomial(c: &[f64], x: f64) -> f64 {
    c.iter().rev().fold(0.0, |sum, c| sum * x + c)
}

/// The integral of a function over 0 ≤ x ≤ length, by the midpoint rule.
fn integral(length: f64, of: impl Fn(f64) -> f64) -> f64 {
    let h = length / COUNT as f64;
    (0..COUNT).map(|i| h * of((i as f64 + 0.5) * h)).sum()
}

/// An upper bound of the stiffness of the ground at the far end of a stretch, from the stiffness at the near
/// end, by linear elements.
fn behind(stiffness: f64, [length, k, mu]: Stretch) -> f64 {
    let h = length / COUNT as f64;
    let [own, across] = [k * h / 3.0 + mu / h, k * h / 6.0 - mu / h];
    (0..COUNT).fold(stiffness, |sum, _| own - across * across / (sum + own))
}

/// A lower bound of the flexibility g(x, x) of open ground at a node, from linear elements of its surface.
fn flexibility(frame: &Frame<Ball>, ground: &[Stretch], node: usize) -> f64 {
    let left = ground[..node].iter().fold(frame.outside[0].middle(), |sum, s| behind(sum, *s));
    let right = ground[node..].iter().rev();
    let right = right.fold(frame.outside[1].middle(), |sum, s| behind(sum, *s));
    1.0 / (left + right)
}

/// Checks (5) of docs/proof.md: a residual force r has the energy r²g on open ground. A node that is held
/// above the ground needs the tensile force r = w/g.
#[test]
fn a_force_that_is_left_unclaimed_costs_its_energy() {
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
        // The tolerance allows for rounding in the elements.
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

/// ⟨q, Gq⟩ of a load on infinite ground with constant k and μ, by the kernel e^{−b|x−y|}/(2√(kμ)).
fn energy_of_load(length: f64, [k, mu]: [f64; 2], load: impl Fn(f64) -> f64) -> f64 {
    let h = length / COUNT as f64;
    let fall = (-(k / mu).sqrt() * h).exp();
    let at = |i: usize| load((i as f64 + 0.5) * h) * h;
    let (mut sum, mut before) = (0.0, 0.0);
    for i in 0..COUNT {
        // Twice the products with all earlier loads, and the square of the load itself.
        sum += at(i) * (2.0 * before + at(i));
        before = (before + at(i)) * fall;
    }
    sum / (2.0 * (k * mu).sqrt())
}

/// For random polynomials p, the tensile part max(−p, 0) has at most the energy η²ω/k and the resultant ηω.
#[test]
fn pulls_cost_their_energy() {
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
        let pull = |x: f64| {
            let t = x / 0.75 - 1.0;
            (mu * bent(t) / (0.75 * 0.75) - k * polynomial(&w, t)).max(0.0)
        };
        let units = frame.units;
        let load = units.restored(pressures[0].pull().value(), 1, 0);
        assert!(integral(1.5, pull) <= load * 1.001 + 1e-9, "{case}");
        let energy = match mu > 0.0 {
            true => energy_of_load(1.5, [k, mu], pull),
            false => integral(1.5, |x| pull(x) * pull(x)) / k,
        };
        let cost = pulled(&frame, &pressures).value();
        let cost = units.restored(cost * cost, 1, 1);
        assert!(energy <= cost * 1.001 + 1e-9, "{case}: {energy} {cost}");
        sharpest = sharpest.max(energy / cost);
    }
    assert!(sharpest > 0.9, "{sharpest}");
}

/// A stiff beam between two supports above the ground. The answer claims contact everywhere, so the pressure
/// is tensile, and the forces at the ends are √(kμ)w. No pressure is compressive, so E is at least ½b(u, u)
/// of the claimed surface, ½w²(kl + 2√(kμ)).
#[test]
fn the_energy_of_a_surface_that_only_pulls_is_charged() {
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

/// Checks (10) on random open stretches that the beam penetrates, between a contact and an end of the beam or
/// a second contact. Let v be a surface that is zero at the contacts and c at a distance y from one of them.
/// Its energy is at least c²(√(kμ) coth(by) + S), S being the stiffness of the ground beyond this point.
#[test]
fn a_lift_costs_its_energy() {
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
        // A linear function, plus a function on the open stretch that is zero with zero slope at the
        // contacts.
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

/// Checks K² of (11) for z = t(1 − t/h)² with springs where z and z′ are largest.
#[test]
fn the_test_functions_have_their_energy() {
    let mut random = numbers();
    for _ in 0..200 {
        let mut number = || 10.0_f64.powf(2.0 * random());
        let [bending, layer, ground, spring, turning, room] = [0; 6].map(|_| number());
        let exact = |h: f64| {
            let z = |x: f64| x * (1.0 - x / h).powi(2);
            let slope = |x: f64| (1.0 - x / h) * (1.0 - 3.0 * x / h);
            let bent = |x: f64| -4.0 / h + 6.0 * x / (h * h);
            integral(h, |x| {
                bending * bent(x).powi(2) + layer * slope(x).powi(2) + ground * z(x).powi(2)
            }) + spring * z(h / 3.0).powi(2)
                + turning
        };
        let least = (0..24).map(|i| exact(room * 0.5_f64.powi(i))).fold(f64::INFINITY, f64::min);
        let sizes = [bending, layer, ground].map(Size::of);
        let bound = kink(sizes, [spring, turning].map(Size::of), room).value();
        assert!(least <= bound * (1.0 + 1e-5) && bound <= 1.01 * least, "{least} {bound}");
    }
}

/// Checks K² of (11) for z = the distance to one side of a place, at the inner end of each piece.
#[test]
fn long_test_functions_have_their_energy() {
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
        // These loads cause a deflection of 1 everywhere.
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
                assert!(found <= 1.001 * exact, "{side} {i}: {exact} {found} is not sharp");
            }
        }
    }
}

/// A random error e = ∫e_φ + ∫γ on 0 ≤ x ≤ h: its values on a grid, and s and s_γ.
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

/// Checks (12): bounds of e on an interval from the mean of |e|, and between and beyond two places from its
/// values at these places.
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
        // The last quarter is the overhang beyond two places at a distance of one half.
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

/// Checks (7): a load on a simply supported cell causes a moment of at most a quarter of load times length.
/// Compares the bound for the redistributed loads with their exact moment.
#[test]
fn loads_given_back_bend_a_cell_by_what_is_charged() {
    let mut random = numbers();
    let mut sharpest = 0.0_f64;
    for _ in 0..100 {
        let ground = [[0.7, 2.0, 0.0], [0.8, 2.0, 0.0]];
        // No load balances these linear pressures, so their whole resultant is redistributed.
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
