//! Back-substitution of both sweeps from the node where they meet to the ends of the beam: w, w′ and the nodal ground forces.

use super::form::Form;
use super::lanes::Lanes;
use super::stretch::{Gain, Side, Stretch};

/// Arrays for w, w' and the ground forces. Back-substitution overwrites w and w', and adds to the forces.
#[derive(Debug)]
pub(crate) struct Fields<'a> {
    pub deflection: &'a mut [f64],
    pub slope: &'a mut [f64],
    pub force: &'a mut [f64],
}

/// Sign of the direction of back-substitution along the beam. To the right, the coordinate is mirrored, so slopes have
/// the opposite sign.
const LEFT: f64 = -1.0;
const RIGHT: f64 = 1.0;

/// State of one sweep during back-substitution.
#[derive(Debug, Clone, Copy)]
struct Back {
    node: usize,
    w: f64,
    /// Rotation of the beam at the current node. Within a stretch, this field contains the rotation times the element
    /// length, which has the unit of a deflection.
    turn: f64,
    /// Force at the current node from the ground under the previous element and from the springs at the node.
    taken: f64,
    /// Deformation variables (e₁, e₂) of the previous element, as defined for [`Form`].
    e: [f64; 2],
    /// Number of stretches of the beam that the back-substitution has not yet completed.
    stretches: usize,
    /// Number of elements of the current stretch that the back-substitution has not yet processed.
    within: usize,
    /// Number of elements of all stretches that the back-substitution has not yet processed.
    elements: usize,
}

/// Back-substitutes from the node `meeting`, where the eliminations from both ends meet, to both ends. Writes the
/// deflection, the slope and the ground forces at the nodes in contact to `fields`.
pub(super) fn unfold(
    sides: &mut [Side; 2],
    w: f64,
    [left, right]: [f64; 2],
    meeting: usize,
    fields: &mut Fields,
) {
    let mut backs = [(&sides[0], left), (&sides[1], right)].map(|(side, turn)| Back {
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
            if stretch.stand.pinned {
                back.w = stretch.stand.settlement;
                fields.deflection[stretch.node] = back.w;
            }
            back.taken += stretch.stand.spring * back.w - stretch.stand.push;
            sides[lane].shapes[back.stretches] =
                [back.w, back.turn, back.e[0] + back.e[1], back.e[1] * per_length];
            if let Some([by_w, by_turn, rest]) = stretch.turned {
                back.turn = by_w * back.w + by_turn * back.turn + rest;
                // At a hinge, the right side has the slope of the node.
                if lane == 1 {
                    fields.slope[stretch.node] = -back.turn;
                }
            }
        }
    }
    for back in &backs {
        fields.force[back.node] += back.taken;
    }
}

/// Back-substitutes over the next `steps` elements, in one direction or in both directions at the same time.
/// `towards` contains the directions, LEFT or RIGHT.
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
        let layer_force = series * (turn + e[0]) - rise;
        let force = taken + (shunt[1] * w - push[1]) + layer_force;
        w = y - e[0];
        turn = turn - e[1];
        taken = (shunt[0] * w - push[0]) - layer_force;
        let slope = turn * per_length;
        for lane in 0..SWEEPS {
            fields.force[node[lane]] += force.0[lane];
            // Each step leads to the neighbouring node. The last step in a stretch leads to the stored end of the
            // stretch, because a span out of contact is one element over many nodes.
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
