//! The beam glued to the ground at given nodes: one sweep from each end to a meeting node, both at once.
//!
//! S (with r) is the stiffness (and force) that everything behind a node offers to its x = (w, Lθ).
//! Crossing an element, ½(y − e)ᵗS(y − e) − rᵗ(y − e) and the element's own [form](super::form) are
//! least at e = gain·y + constant, and what is left is S and r in y. On the way back e comes out, the
//! element's deformation, and never a difference of deflections. The two sweeps do not wait for each
//! other: a processor works on both at the same time.

use super::form::Form;
use super::lanes::Lanes;

/// ½ xᵀSx − rᵀx for x = (w, Lθ): S₁₁, S₁₂, S₂₂, r₁, r₂.
type Behind = [f64; 5];

/// e = gain·y + constant: gain by columns, then the constant.
type Gain = [f64; 6];

/// Elements of one form in a row, in the direction of their sweep.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Stretch {
    pub form: Form,
    pub count: usize,
    /// The first node.
    pub node: usize,
    /// What stands there.
    pub stand: Stand,
}

/// Elements of one form that are crossed in one go: the number of the first, and where their gains go.
struct Elements<'a> {
    form: &'a Form,
    first: usize,
    gains: &'a mut [Gain],
}

/// What stands at a node: force, moment, and the ground beyond an end of the beam.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Stand {
    pub force: f64,
    pub moment: f64,
    pub spring: f64,
    /// Spring times g₀.
    pub push: f64,
}

/// All that is behind the meeting node on one side.
#[derive(Debug, Clone, Default)]
pub(crate) struct Side {
    pub stretches: Vec<Stretch>,
    gains: Vec<Gain>,
    /// (w, θ) at the first node of each stretch and its deformation (d₁, d₂): of the last of its elements.
    pub shapes: Vec<[f64; 4]>,
}

/// Where w, w' and the ground's forces go; these are added.
#[derive(Debug)]
pub(crate) struct Fields<'a> {
    pub deflection: &'a mut [f64],
    pub slope: &'a mut [f64],
    pub force: &'a mut [f64],
}

/// The elimination met a pivot that is not positive: the contact cannot hold the beam.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Loose;

impl Side {
    pub fn clear(&mut self) {
        self.stretches.clear();
        self.shapes.clear();
    }

    /// The next elements to cross.
    fn next(&mut self, reached: Reached, steps: usize) -> Elements<'_> {
        Elements {
            form: &self.stretches[reached.stretch].form,
            first: reached.within,
            gains: &mut self.gains[reached.elements..][..steps],
        }
    }

    fn elements(&self) -> usize {
        self.stretches.iter().map(|stretch| stretch.count).sum()
    }
}

/// Both sweeps towards the meeting node, and w and θ there; `stand` is what stands there.
pub(crate) fn inward(sides: &mut [Side; 2], stand: Stand) -> Result<[f64; 2], Loose> {
    for side in sides.iter_mut() {
        side.gains.resize(side.elements(), [0.0; 6]);
        side.shapes.resize(side.stretches.len(), [0.0; 4]);
    }
    let [left, right] = offers(sides)?;
    let s = [left[0] + right[0] + stand.spring, left[1] - right[1], left[2] + right[2]];
    let r = [left[3] + right[3] + stand.force + stand.push, left[4] - right[4] + stand.moment];
    let determinant = s[0] * s[2] - s[1] * s[1];
    if !(s[0] > 0.0 && determinant > 1e-15 * s[0] * s[2]) {
        return Err(Loose);
    }
    let w = (s[2] * r[0] - s[1] * r[1]) / determinant;
    let theta = (s[0] * r[1] - s[1] * r[0]) / determinant;
    Ok([w, theta])
}

/// From the meeting node to both ends. Returns the elements crossed.
pub(crate) fn outward(
    sides: &mut [Side; 2],
    meeting: usize,
    stand: Stand,
    [w, theta]: [f64; 2],
    fields: &mut Fields,
) -> usize {
    fields.deflection[meeting] = w;
    fields.slope[meeting] = theta;
    fields.force[meeting] += stand.spring * w - stand.push;
    unfold(sides, [w, theta], meeting, fields);
    sides.iter().map(|side| side.gains.len()).sum()
}

/// How far a sweep has come.
#[derive(Debug, Clone, Copy, Default)]
struct Reached {
    stretch: usize,
    /// Elements crossed of this stretch, and in all.
    within: usize,
    elements: usize,
}

/// Both sweeps towards the meeting node, as far as possible at once. Returns what they offer to (w, θ).
fn offers(sides: &mut [Side; 2]) -> Result<[Behind; 2], Loose> {
    let mut states = [[0.0; 5]; 2];
    let mut reached = [Reached::default(); 2];
    loop {
        let mut rest = [0; 2];
        for lane in 0..2 {
            if let Some(stretch) = sides[lane].stretches.get(reached[lane].stretch) {
                if reached[lane].within == 0 {
                    enter(&mut states[lane], stretch);
                }
                rest[lane] = stretch.count - reached[lane].within;
            }
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
            let stretch = &sides[lane].stretches[now.stretch];
            if now.within == stretch.count {
                leave(&mut states[lane], stretch);
                (now.stretch, now.within) = (now.stretch + 1, 0);
            }
        }
    }
}

/// What acts at a stretch's first node, and from θ to Lθ.
fn enter(state: &mut Behind, stretch: &Stretch) {
    let per_length = 1.0 / stretch.form.length;
    let Stand { force, moment, spring, push } = stretch.stand;
    state[0] += spring;
    state[3] += force + push;
    state[4] += moment;
    state[1] *= per_length;
    state[2] *= per_length * per_length;
    state[4] *= per_length;
}

fn leave(state: &mut Behind, stretch: &Stretch) {
    let length = stretch.form.length;
    state[1] *= length;
    state[2] *= length * length;
    state[4] *= length;
}

/// Over elements, as many in each sweep.
#[inline(always)]
fn cross<const SWEEPS: usize>(
    states: [&mut Behind; SWEEPS],
    elements: [Elements; SWEEPS],
) -> Result<(), Loose> {
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
        // The division takes longest: everything that does not need it comes before.
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
    if least.0.iter().all(|least| *least > 0.0) { Ok(()) } else { Err(Loose) }
}

/// Which way a sweep goes back. A mirror turns slopes.
const LEFT: f64 = -1.0;
const RIGHT: f64 = 1.0;

/// A sweep on its way back.
#[derive(Debug, Clone, Copy)]
struct Back {
    node: usize,
    w: f64,
    /// θ, or Lθ within a stretch.
    turn: f64,
    /// What the element crossed last takes at the node reached.
    taken: f64,
    /// The deformation of the element crossed last.
    e: [f64; 2],
    /// Stretches left, elements left of the last of them, and in all.
    stretches: usize,
    within: usize,
    elements: usize,
}

/// From the meeting node to both ends: w, w' and forces at all nodes that touch.
fn unfold(sides: &mut [Side; 2], [w, theta]: [f64; 2], meeting: usize, fields: &mut Fields) {
    let mut backs = [(&sides[0], theta), (&sides[1], -theta)].map(|(side, turn)| Back {
        node: meeting,
        w,
        turn,
        taken: 0.0,
        e: [0.0; 2],
        stretches: side.stretches.len(),
        within: 0,
        elements: side.gains.len(),
    });
    loop {
        for lane in 0..2 {
            let (back, side) = (&mut backs[lane], &sides[lane]);
            if back.within == 0 && back.stretches > 0 {
                let stretch = &side.stretches[back.stretches - 1];
                back.within = stretch.count;
                back.turn *= stretch.form.length;
            }
        }
        let rest = [backs[0].within, backs[1].within];
        let steps = match rest {
            [0, 0] => break,
            [0, steps] | [steps, 0] => steps,
            [left, right] => left.min(right),
        };
        let [left, right] = &mut backs;
        let [first, second] = &*sides;
        match rest {
            [_, 0] => recross([left], [first], [LEFT], steps, fields),
            [0, _] => recross([right], [second], [RIGHT], steps, fields),
            _ => recross([left, right], [first, second], [LEFT, RIGHT], steps, fields),
        }
        for lane in 0..2 {
            let back = &mut backs[lane];
            if rest[lane] == 0 || back.within > 0 {
                continue;
            }
            back.stretches -= 1;
            let stretch = &sides[lane].stretches[back.stretches];
            let per_length = 1.0 / stretch.form.length;
            back.turn *= per_length;
            back.taken += stretch.stand.spring * back.w - stretch.stand.push;
            sides[lane].shapes[back.stretches] =
                [back.w, back.turn, back.e[0] + back.e[1], back.e[1] * per_length];
        }
    }
    for back in &backs {
        fields.force[back.node] += back.taken;
    }
}

/// Back over as many elements, each sweep within one stretch; `towards` its end, LEFT or RIGHT.
#[inline(always)]
fn recross<const SWEEPS: usize>(
    backs: [&mut Back; SWEEPS],
    sides: [&Side; SWEEPS],
    towards: [f64; SWEEPS],
    steps: usize,
    fields: &mut Fields,
) {
    let mut now = backs.each_ref().map(|back| **back);
    let stretches: [&Stretch; SWEEPS] =
        std::array::from_fn(|lane| &sides[lane].stretches[now[lane].stretches - 1]);
    let forms = stretches.map(|stretch| &stretch.form);
    let of = |number: &dyn Fn(&Form) -> f64| Lanes::of(|lane| number(forms[lane]));
    let shunt: [_; 2] = std::array::from_fn(|i| of(&|form| form.shunt[i]));
    let (series, rise) = (of(&|form| form.series), of(&|form| form.rise));
    let per_length = Lanes::of(|lane| -towards[lane] / forms[lane].length);
    let even = forms.iter().all(|form| form.is_even());
    let push_at = |within: &[usize; SWEEPS]| {
        [4, 5].map(|i| Lanes::of(|lane| forms[lane].q[i] + within[lane] as f64 * forms[lane].dq[i]))
    };
    let mut gains: [_; SWEEPS] = std::array::from_fn(|lane| {
        let end = now[lane].elements;
        sides[lane].gains[end - steps..end].iter().rev()
    });
    let mut within = now.map(|back| back.within);
    let mut node = now.map(|back| back.node);
    let mut w = Lanes::of(|lane| now[lane].w);
    let mut turn = Lanes::of(|lane| now[lane].turn);
    let mut taken = Lanes::of(|lane| now[lane].taken);
    let mut e = [Lanes([0.0; SWEEPS]); 2];
    let mut push = push_at(&within);
    for _ in 0..steps {
        let gain: [Gain; SWEEPS] =
            std::array::from_fn(|lane| gains[lane].next().copied().unwrap_or_default());
        let gain: [Lanes<SWEEPS>; 6] = std::array::from_fn(|i| Lanes::of(|lane| gain[lane][i]));
        let y = w - turn;
        e = [gain[0] * y + gain[2] * turn + gain[4], gain[1] * y + gain[3] * turn + gain[5]];
        within = within.map(|within| within - 1);
        if !even {
            push = push_at(&within);
        }
        let pulled = series * (turn + e[0]) - rise;
        let force = taken + (shunt[1] * w - push[1]) + pulled;
        w = y - e[0];
        turn = turn - e[1];
        taken = (shunt[0] * w - push[0]) - pulled;
        let slope = turn * per_length;
        for lane in 0..SWEEPS {
            fields.force[node[lane]] += force.0[lane];
            // A span is one element over many nodes.
            node[lane] = match (within[lane], towards[lane] == LEFT) {
                (0, _) => stretches[lane].node,
                (_, true) => node[lane] - 1,
                _ => node[lane] + 1,
            };
            fields.deflection[node[lane]] = w.0[lane];
            fields.slope[node[lane]] = slope.0[lane];
        }
    }
    for (lane, back) in now.iter_mut().enumerate() {
        (back.node, back.within) = (node[lane], within[lane]);
        (back.w, back.turn, back.taken) = (w.0[lane], turn.0[lane], taken.0[lane]);
        back.e = e.map(|e| e.0[lane]);
    }
    for (back, mut now) in backs.into_iter().zip(now) {
        now.elements -= steps;
        *back = now;
    }
}
