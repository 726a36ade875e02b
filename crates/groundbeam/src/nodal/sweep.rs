//! The beam glued to the ground at given nodes: one sweep from each end to a meeting node, both at once.
//!
//! S (with r) is the stiffness (and force) that everything behind a node offers to its x = (w, Lθ).
//! Crossing an element, ½(y − e)ᵗS(y − e) − rᵗ(y − e) and the element's own [form](super::form) are
//! least at e = gain·y + constant, and what is left is S and r in y. On the way back e comes out, the
//! element's deformation, and never a difference of deflections. The two sweeps do not wait for each
//! other: a processor works on both at the same time.

use super::form::Form;

/// ½ xᵀSx − rᵀx for x = (w, Lθ): S₁₁, S₁₂, S₂₂, r₁, r₂.
type Behind = [f64; 5];

/// e = gain·y + constant: gain by columns, then the constant.
type Gain = [f64; 6];

/// Elements of one form in a row, in the direction of their sweep.
#[derive(Debug, Clone, Copy)]
pub(super) struct Stretch {
    pub form: Form,
    pub count: usize,
    /// The first node.
    pub node: usize,
    /// What stands there.
    pub stand: Stand,
}

/// What stands at a node: force, moment, and the ground beyond an end of the beam.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Stand {
    pub force: f64,
    pub moment: f64,
    pub spring: f64,
    /// Spring times g₀.
    pub push: f64,
}

/// All that is behind the meeting node on one side.
#[derive(Debug, Clone, Default)]
pub(super) struct Side {
    pub stretches: Vec<Stretch>,
    gains: Vec<Gain>,
    /// (w, θ) at the first node of each stretch and its deformation (d₁, d₂): of the last of its elements.
    pub shapes: Vec<[f64; 4]>,
}

/// Where w, w' and the ground's forces go.
#[derive(Debug)]
pub(super) struct Fields<'a> {
    pub deflection: &'a mut [f64],
    pub slope: &'a mut [f64],
    pub force: &'a mut [f64],
}

/// The elimination met a pivot that is not positive: the contact cannot hold the beam.
#[derive(Debug, Clone, Copy)]
pub(super) struct Loose;

impl Side {
    pub fn clear(&mut self) {
        self.stretches.clear();
        self.shapes.clear();
    }

    fn elements(&self) -> usize {
        self.stretches.iter().map(|stretch| stretch.count).sum()
    }
}

/// Glues and solves; `stand` is what stands at the meeting node. Returns the elements crossed.
pub(super) fn solve(
    sides: &mut [Side; 2],
    meeting: usize,
    stand: Stand,
    fields: &mut Fields,
) -> Result<usize, Loose> {
    let count = sides.each_ref().map(Side::elements);
    for (side, count) in sides.iter_mut().zip(count) {
        side.gains.resize(count, [0.0; 6]);
        side.shapes.resize(side.stretches.len(), [0.0; 4]);
    }
    let [left, right] = inward(sides)?;
    let s = [left[0] + right[0] + stand.spring, left[1] - right[1], left[2] + right[2]];
    let r = [left[3] + right[3] + stand.force + stand.push, left[4] - right[4] + stand.moment];
    let determinant = s[0] * s[2] - s[1] * s[1];
    if !(s[0] > 0.0 && determinant > 1e-15 * s[0] * s[2]) {
        return Err(Loose);
    }
    let w = (s[2] * r[0] - s[1] * r[1]) / determinant;
    let theta = (s[0] * r[1] - s[1] * r[0]) / determinant;
    fields.deflection[meeting] = w;
    fields.slope[meeting] = theta;
    fields.force[meeting] = stand.spring * w - stand.push;
    outward(&mut sides[0], false, [w, theta], meeting, fields);
    outward(&mut sides[1], true, [w, -theta], meeting, fields);
    Ok(count[0] + count[1])
}

/// Both sweeps towards the meeting node, as far as possible at once. Returns what they offer to (w, θ).
fn inward(sides: &mut [Side; 2]) -> Result<[Behind; 2], Loose> {
    let mut state = [[0.0; 5]; 2];
    // Stretch, elements of it already crossed, elements crossed in all.
    let mut at = [[0_usize; 3]; 2];
    let [left, right] = sides;
    loop {
        let open = [at[0][0] < left.stretches.len(), at[1][0] < right.stretches.len()];
        for (side, lane) in [(&*left, 0), (&*right, 1)] {
            if open[lane] && at[lane][1] == 0 {
                enter(&mut state[lane], &side.stretches[at[lane][0]]);
            }
        }
        let rest = |side: &Side, at: &[usize; 3]| side.stretches[at[0]].count - at[1];
        let steps = match open {
            [true, true] => {
                let steps = rest(left, &at[0]).min(rest(right, &at[1]));
                let forms = [&left.stretches[at[0][0]].form, &right.stretches[at[1][0]].form];
                let gains =
                    [&mut left.gains[at[0][2]..][..steps], &mut right.gains[at[1][2]..][..steps]];
                cross(&mut state, forms, [at[0][1], at[1][1]], gains)?;
                steps
            }
            [true, false] => {
                let steps = rest(left, &at[0]);
                let gains = [&mut left.gains[at[0][2]..][..steps]];
                let mut one = [state[0]];
                cross(&mut one, [&left.stretches[at[0][0]].form], [at[0][1]], gains)?;
                state[0] = one[0];
                steps
            }
            [false, true] => {
                let steps = rest(right, &at[1]);
                let gains = [&mut right.gains[at[1][2]..][..steps]];
                let mut one = [state[1]];
                cross(&mut one, [&right.stretches[at[1][0]].form], [at[1][1]], gains)?;
                state[1] = one[0];
                steps
            }
            [false, false] => return Ok(state),
        };
        for (side, lane) in [(&*left, 0), (&*right, 1)] {
            if !open[lane] {
                continue;
            }
            let stretch = &side.stretches[at[lane][0]];
            at[lane][1] += steps;
            at[lane][2] += steps;
            if at[lane][1] == stretch.count {
                leave(&mut state[lane], stretch);
                at[lane] = [at[lane][0] + 1, 0, at[lane][2]];
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

/// Over as many elements as there are gains, each sweep within one form, from its element `first` on.
#[inline(always)]
fn cross<const SWEEPS: usize>(
    states: &mut [Behind; SWEEPS],
    forms: [&Form; SWEEPS],
    first: [usize; SWEEPS],
    gains: [&mut [Gain]; SWEEPS],
) -> Result<(), Loose> {
    let forms = forms.map(|form| *form);
    let mut state = *states;
    let steps = gains[0].len();
    let mut least = f64::INFINITY;
    let mut gains = gains.map(|gains| gains.iter_mut());
    for step in 0..steps {
        for lane in 0..SWEEPS {
            let form = &forms[lane];
            let [a, b, c, r1, r2] = state[lane];
            let q = form.load((first[lane] + step) as f64);
            let (a, r1) = (a + form.leak[0], r1 + q[4]);
            let (b_less, c_less) = (b - form.m[1], c - form.m[2]);
            let (g11, g12, g22) = (a + form.e[0], b + form.e[1], c + form.e[2]);
            let determinant = g11 * g22 - g12 * g12;
            least = least.min(determinant);
            let inverse = 1.0 / determinant;
            let (p11, p12, p22) = (g22 * inverse, -g12 * inverse, g11 * inverse);
            let (t1, t2) = (q[2] - r1, q[3] - r2);
            let k11 = p11 * a + p12 * b;
            let k21 = p12 * a + p22 * b;
            let k12 = p11 * b_less + p12 * c_less;
            let k22 = p12 * b_less + p22 * c_less;
            let c1 = p11 * t1 + p12 * t2;
            let c2 = p12 * t1 + p22 * t2;
            if let Some(gain) = gains[lane].next() {
                *gain = [k11, k21, k12, k22, c1, c2];
            }
            let s11 = a - (a * k11 + b * k21);
            let s12 = b - (a * k12 + b * k22);
            let s22 = (c + form.m[0]) - (b_less * k12 + c_less * k22);
            let f1 = r1 + q[0] + (a * c1 + b * c2);
            let f2 = r2 + q[1] + (b_less * c1 + c_less * c2);
            state[lane] = [
                s11 + form.leak[1],
                s12 - s11,
                (s22 - s12) - (s12 - s11),
                f1 + q[5],
                f2 - f1,
            ];
        }
    }
    *states = state;
    if least > 0.0 { Ok(()) } else { Err(Loose) }
}

/// From the meeting node to a side's end: w, w' and forces at all nodes that touch.
fn outward(side: &mut Side, mirrored: bool, x: [f64; 2], meeting: usize, fields: &mut Fields) {
    let sign = if mirrored { -1.0 } else { 1.0 };
    let [mut w, mut theta] = x;
    let mut gains = side.gains.iter().rev();
    // What the element crossed last takes at the node reached; the node itself adds it.
    let mut taken = fields.force[meeting];
    let mut node = meeting;
    for (stretch, shape) in side.stretches.iter().zip(&mut side.shapes).rev() {
        let form = &stretch.form;
        let (length, per_length) = (form.length, 1.0 / form.length);
        let mut turn = theta * length;
        let mut e = [0.0; 2];
        // A span is one element over many nodes.
        let next = |node: usize| if mirrored { node + 1 } else { node - 1 };
        for (i, gain) in (0..stretch.count).rev().zip(&mut gains) {
            let y = w - turn;
            e = [
                gain[0] * y + gain[2] * turn + gain[4],
                gain[1] * y + gain[3] * turn + gain[5],
            ];
            let pulled = form.coupling * (turn + e[0]) - form.rise;
            let at = i as f64;
            let [push, push_next] =
                [form.q[4] + at * form.dq[4], form.q[5] + at * form.dq[5]];
            fields.force[node] = taken + (form.leak[1] * w - push_next) + pulled;
            w = y - e[0];
            turn -= e[1];
            taken = (form.leak[0] * w - push) - pulled;
            node = if i == 0 { stretch.node } else { next(node) };
            fields.deflection[node] = w;
            fields.slope[node] = sign * turn * per_length;
        }
        theta = turn * per_length;
        taken += stretch.stand.spring * w - stretch.stand.push;
        *shape = [w, theta, e[0] + e[1], e[1] * per_length];
    }
    fields.force[node] = taken;
}
