//! Solves the problem of the beam bonded to the ground at given nodes, by one sweep from each end to a meeting node.
//!
//! A sweep condenses the beam before a node to a stiffness S and a force r for the displacements of the node.
//! Elimination of the deformations from the [energy](super::form) of an element gives S and r of the next node. See
//! section 10 of docs/methods.md.

use super::back_sweep::{Fields, unfold};
use super::form::Form;
use super::lanes::Lanes;
use super::quadratic::{NotSolved, Quadratic, Row};
use super::stand::Stand;
use super::stretch::{Elements, Gain, Reached, Side, Stretch};

/// Coefficients S₁₁, S₁₂, S₂₂, r₁, r₂ of the energy ½ xᵀSx − rᵀx of the eliminated part. Between stretches, x is (w, θ)
/// of the last node; within a stretch, it is (w, Lθ) with the element length L.
type Behind = [f64; 5];

/// Eliminates the elements from both ends of the beam to the meeting node, which has the loads and supports `stand`.
/// Returns its deflection, and the rotations on its left and on its right.
pub(crate) fn inward(sides: &mut [Side; 2], stand: Stand) -> Result<[f64; 3], NotSolved> {
    for side in sides.iter_mut() {
        side.gains.resize(side.elements(), [0.0; 6]);
        side.shapes.resize(side.stretches.len(), [0.0; 4]);
    }
    let [mut left, right] = offers(sides)?;
    let turned = turn(&mut left, &stand)?;
    let s = [
        left[0] + right[0] + stand.spring + stand.support,
        left[1] - right[1],
        left[2] + right[2] + stand.turning,
    ];
    let r = [left[3] + right[3] + stand.load(), left[4] - right[4] + stand.moment];
    let (w, theta) = match (stand.pinned, stand.clamped) {
        (true, true) => (stand.settlement, 0.0),
        (true, false) if s[2] > 0.0 => (stand.settlement, (r[1] - s[1] * stand.settlement) / s[2]),
        (false, true) if s[0] > 0.0 => (r[0] / s[0], 0.0),
        (false, false) => {
            let determinant = s[0] * s[2] - s[1] * s[1];
            if !(s[0] > 0.0 && determinant > 1e-15 * s[0] * s[2]) {
                return Err(NotSolved);
            }
            let w = (s[2] * r[0] - s[1] * r[1]) / determinant;
            (w, (s[0] * r[1] - s[1] * r[0]) / determinant)
        }
        _ => return Err(NotSolved),
    };
    let behind = turned.map_or(theta, |[by_w, by_theta, rest]| by_w * w + by_theta * theta + rest);
    Ok([w, behind, theta])
}

/// Eliminates the rotation before a hinge. Returns this rotation as a linear function: the coefficients of the
/// deflection and of the rotation after the hinge, then the constant.
fn turn(state: &mut Behind, stand: &Stand) -> Result<Option<[f64; 3]>, NotSolved> {
    let Some(spring) = stand.hinge else { return Ok(None) };
    let [a, b, c, r1, r2] = *state;
    let held = c + spring;
    if held.is_nan() || held <= 0.0 {
        return Err(NotSolved);
    }
    let share = spring / held;
    *state = [a - b * (b / held), b * share, c * share, r1 - b * (r2 / held), r2 * share];
    Ok(Some([-b / held, share, r2 / held]))
}

/// Back-substitutes from the node `meeting`, where the eliminations from both ends of the beam meet, to both ends of
/// the beam. Returns the number of processed elements.
pub(crate) fn outward(
    sides: &mut [Side; 2],
    meeting: usize,
    stand: Stand,
    [w, behind, ahead]: [f64; 3],
    fields: &mut Fields,
) -> usize {
    fields.deflection[meeting] = w;
    fields.slope[meeting] = ahead;
    fields.force[meeting] += stand.spring * w - stand.push;
    unfold(sides, w, [behind, -ahead], meeting, fields);
    sides.iter().map(|side| side.gains.len()).sum()
}

/// Returns the stiffness S and the force r of each side, condensed to the meeting node. Both eliminations advance
/// together while both have elements left.
fn offers(sides: &mut [Side; 2]) -> Result<[Behind; 2], NotSolved> {
    let mut states = [[0.0; 5]; 2];
    let mut reached = [Reached::default(); 2];
    loop {
        let mut rest = [0; 2];
        for lane in 0..2 {
            rest[lane] = arrive(&mut sides[lane], &mut states[lane], &mut reached[lane])?;
        }
        let steps = match rest {
            [0, 0] => return Ok(states),
            [0, steps] | [steps, 0] => steps,
            [left, right] => left.min(right),
        };
        let [left, right] = sides;
        let [first, second] = states.each_mut();
        let [at, to] = reached;
        match rest {
            [_, 0] => cross([first], [left.next(at, steps)])?,
            [0, _] => cross([second], [right.next(to, steps)])?,
            _ => cross([first, second], [left.next(at, steps), right.next(to, steps)])?,
        }
        for lane in (0..2).filter(|lane| rest[*lane] > 0) {
            let now = &mut reached[lane];
            (now.within, now.elements) = (now.within + steps, now.elements + steps);
        }
    }
}

/// Eliminates spans, and first elements with a support, up to a row of equal elements. Returns the number of elements
/// left in this row; 0 at the meeting node.
fn arrive(side: &mut Side, state: &mut Behind, reached: &mut Reached) -> Result<usize, NotSolved> {
    while let Some(stretch) = side.stretches.get_mut(reached.stretch) {
        if reached.within == 0 {
            enter(state, stretch)?;
            if let Some(first) = stretch.first {
                side.gains[reached.elements] = cross_first(state, stretch, &first)?;
                (reached.within, reached.elements) = (1, reached.elements + 1);
            }
        }
        if reached.within < stretch.count {
            return Ok(stretch.count - reached.within);
        }
        leave(state, stretch);
        (reached.stretch, reached.within) = (reached.stretch + 1, 0);
    }
    Ok(0)
}

/// Adds the loads and springs at the first node of a stretch, and changes the unknown rotation θ to Lθ with the
/// element length L.
fn enter(state: &mut Behind, stretch: &mut Stretch) -> Result<(), NotSolved> {
    let per_length = 1.0 / stretch.form.length;
    let stand = &stretch.stand;
    stretch.turned = turn(state, stand)?;
    state[0] += stand.spring + stand.support;
    state[2] += stand.turning;
    state[3] += stand.load();
    state[4] += stand.moment;
    state[1] *= per_length;
    state[2] *= per_length * per_length;
    state[4] *= per_length;
    Ok(())
}

/// Eliminates the first node of `element`, which may have a support. The stiffer one of displacement and deformation is
/// eliminated, which avoids differences of large stiffnesses.
fn cross_first(
    state: &mut Behind,
    stretch: &Stretch,
    element: &Quadratic<4>,
) -> Result<Gain, NotSolved> {
    let Stretch { form, stand, .. } = stretch;
    let [a, b, c, r1, r2] = *state;
    let (a, r1) = (a + form.shunt[0], r1 + form.q[4]);
    let held = [stand.pinned, stand.clamped];
    let stiffer = [a > element.h[2][2], c > element.h[3][3]];
    let by_left = [0, 1].map(|i| held[i] || stiffer[i]);
    let unit = |i: usize| -> [f64; 4] { std::array::from_fn(|j| f64::from(u8::from(i == j))) };
    let rest = |i: usize| -> [f64; 4] { std::array::from_fn(|j| unit(i)[j] - unit(2 + i)[j]) };
    let [e, x] = [false, true]
        .map(|is_left| [0, 1].map(|i| if by_left[i] == is_left { unit(2 + i) } else { rest(i) }));
    let mut energy = Quadratic::<4>::ZERO;
    energy.add(&[unit(0), unit(1), e[0], e[1]], &element.h, &element.g);
    energy.add(&x, &[[a, b], [b, c]], &[r1, r2]);
    let size = [2, 3].map(|i| energy.h[i][i]);
    let at = [stand.settlement, 0.0];
    let mut back = [0, 1].map(|i| Row { by: [0.0; 4], constant: at[i] });
    for i in (0..2).filter(|i| held[*i]) {
        energy.hold(2 + i, back[i]);
    }
    for i in (0..2).filter(|i| !held[*i]) {
        back[i] = energy.eliminate(2 + i, size[i])?;
    }
    back[0] = back[0].with(3, &back[1]);
    let ([s11, s12], s22) = ([energy.h[0][0], energy.h[0][1]], energy.h[1][1]);
    let [f1, f2, ..] = energy.g;
    *state = [s11 + form.shunt[1], s12 - s11, (s22 - s12) - (s12 - s11), f1 + form.q[5], f2 - f1];
    let bent = |i: usize| Row { by: e[i], constant: 0.0 }.with(2, &back[0]).with(3, &back[1]);
    let [first, second] = [bent(0), bent(1)];
    let by = |i: usize| [first.by[i], second.by[i]];
    let [[k11, k21], [k12, k22]] = [by(0), by(1)];
    Ok([k11, k21, k12, k22, first.constant, second.constant])
}

fn leave(state: &mut Behind, stretch: &Stretch) {
    let length = stretch.form.length;
    state[1] *= length;
    state[2] *= length * length;
    state[4] *= length;
}

/// Eliminates the next elements of one row, or of two rows at the same time, one in each sweep. Elements of a row have
/// equal stiffness.
#[inline(always)]
fn cross<const SWEEPS: usize>(
    states: [&mut Behind; SWEEPS],
    elements: [Elements; SWEEPS],
) -> Result<(), NotSolved> {
    let of = |number: &dyn Fn(&Form) -> f64| Lanes::of(|lane| number(elements[lane].form));
    let m: [_; 3] = std::array::from_fn(|i| of(&|form| form.m[i]));
    let e: [_; 3] = std::array::from_fn(|i| of(&|form| form.e[i]));
    let shunt: [_; 2] = std::array::from_fn(|i| of(&|form| form.shunt[i]));
    let first = elements.each_ref().map(|elements| elements.first);
    let even = elements.iter().all(|elements| elements.form.is_even());
    let forms = elements.each_ref().map(|elements| elements.form);
    let load_at = |step: usize| -> [Lanes<SWEEPS>; 6] {
        let loads: [_; SWEEPS] =
            std::array::from_fn(|lane| forms[lane].load((first[lane] + step) as f64));
        std::array::from_fn(|i| Lanes::of(|lane| loads[lane][i]))
    };
    let mut load = load_at(0);
    let [mut a, mut b, mut c, mut r1, mut r2]: [Lanes<SWEEPS>; 5] =
        std::array::from_fn(|i| Lanes::of(|lane| states[lane][i]));
    let mut least = Lanes([f64::INFINITY; SWEEPS]);
    let steps = elements[0].gains.len();
    let mut gains = elements.map(|elements| elements.gains.iter_mut());
    for step in 0..steps {
        if !even {
            load = load_at(step);
        }
        (a, r1) = (a + shunt[0], r1 + load[4]);
        let (b_less, c_less) = (b - m[1], c - m[2]);
        let (g11, g12, g22) = (a + e[0], b + e[1], c + e[2]);
        let determinant = g11 * g22 - g12 * g12;
        // The division by `determinant` is slow. The values before `inverse` do not depend on it, so the processor
        // can compute them during the division.
        let (n11, n21) = (g22 * a - g12 * b, g11 * b - g12 * a);
        let (n12, n22) = (g22 * b_less - g12 * c_less, g11 * c_less - g12 * b_less);
        let (s11, s12) = (a * n11 + b * n21, a * n12 + b * n22);
        let s22 = b_less * n12 + c_less * n22;
        let (t1, t2) = (load[2] - r1, load[3] - r2);
        let (c1, c2) = (g22 * t1 - g12 * t2, g11 * t2 - g12 * t1);
        let inverse = determinant.inverse();
        let (s11, s12) = (a - s11 * inverse, b - s12 * inverse);
        let s22 = (c + m[0]) - s22 * inverse;
        let (k11, k21) = (n11 * inverse, n21 * inverse);
        let (k12, k22) = (n12 * inverse, n22 * inverse);
        let (c1, c2) = (c1 * inverse, c2 * inverse);
        let f1 = r1 + load[0] + (k11 * t1 + k21 * t2);
        let f2 = r2 + load[1] + (k12 * t1 + k22 * t2);
        for (lane, gains) in gains.iter_mut().enumerate() {
            if let Some(gain) = gains.next() {
                *gain = [k11, k21, k12, k22, c1, c2].map(|lanes| lanes.0[lane]);
            }
        }
        (a, b, c) = (s11 + shunt[1], s12 - s11, (s22 - s12) - (s12 - s11));
        (r1, r2) = (f1 + load[5], f2 - f1);
        least =
            Lanes::of(
                |i| if determinant.0[i] > least.0[i] { least.0[i] } else { determinant.0[i] },
            );
    }
    for (lane, state) in states.into_iter().enumerate() {
        *state = [a, b, c, r1, r2].map(|lanes| lanes.0[lane]);
    }
    if least.0.iter().all(|least| *least > 0.0) { Ok(()) } else { Err(NotSolved) }
}
