//! Shear and moment from loads and pressures alone, from the left end to the right.

use super::balance::Remains;
use super::{Claim, ClaimedPiece};
use crate::model::{Action, Extent, Load, Model};
use crate::numeric::polynomial::{Coefficients, integral};

/// What acts at one point: force down, moment.
#[derive(Debug, Clone, Copy)]
struct Event {
    x: f64,
    force: f64,
    moment: f64,
    /// The moment EI κ₀ with which an imposed curvature begins or ends: no force, but felt as one.
    felt: f64,
}

impl Event {
    fn of(x: f64, force: f64, moment: f64) -> Self {
        Event { x, force, moment, felt: 0.0 }
    }
}

/// The internal forces just right of the position reached, and the events still ahead.
#[derive(Debug)]
pub(super) struct Events {
    /// Sorted from right to left; the next one is the last.
    ahead: Vec<Event>,
    /// Positions this close are the same: nodes within rounding of each other were one node.
    near: f64,
    /// T = V + P w' − g, with T' = p − f.
    shear: f64,
    moment: f64,
    /// Σ|F| and Σ|M|, to judge the balance by; the lever between them is the beam's length.
    pub forces: f64,
    pub moments: f64,
    /// The same since T and m were last taken from elsewhere, with what they were then,
    since: [f64; 2],
    /// and what was left out there of force and moment, up to a position.
    left_over: [f64; 3],
    length: f64,
}

impl Events {
    pub fn of(model: &Model, claim: &Claim) -> Self {
        let most = model.loads.len() + claim.forces.len() + claim.reactions.len();
        let mut ahead = Vec::with_capacity(most);
        for load in model.beam_loads() {
            match (load.action(), load.extent()) {
                (Action::Force, Extent::Point { at, size }) => ahead.push(Event::of(at, size, 0.0)),
                (Action::Moment, Extent::Point { at, size }) => {
                    ahead.push(Event::of(at, 0.0, size));
                }
                (Action::Curvature, extent) => {
                    let felt = curling(model, load);
                    let event = |at: f64| Event { felt, ..Event::of(at, 0.0, 0.0) };
                    ahead.extend(extent.ends().map(event));
                }
                (Action::Force | Action::Moment, Extent::Distributed { .. }) => {}
            }
        }
        let up = |&(x, force): &(f64, f64)| Event::of(x, -force, 0.0);
        ahead.extend(claim.forces.iter().map(up));
        let held = |&(x, force, moment): &(f64, f64, f64)| Event::of(x, -force, moment);
        ahead.extend(claim.reactions.iter().map(held));
        ahead.sort_by(|a, b| b.x.total_cmp(&a.x));
        let near = super::NEAR * model.beam.length;
        let length = model.beam.length;
        Events {
            ahead,
            near,
            shear: 0.0,
            moment: 0.0,
            forces: 0.0,
            moments: 0.0,
            since: [0.0; 2],
            left_over: [0.0; 3],
            length,
        }
    }

    /// Applies everything up to and at x.
    pub fn advance(&mut self, x: f64) {
        while let Some(event) = self.ahead.pop_if(|event| event.x <= x + self.near) {
            self.shear -= event.force;
            self.moment += event.moment;
            self.count(event.force.abs(), event.moment.abs() + event.felt);
        }
    }

    fn count(&mut self, force: f64, moment: f64) {
        self.forces += force;
        self.moments += moment;
        self.since = [self.since[0] + force, self.since[1] + moment];
    }

    /// Integrates over a piece; returns the coefficients of V(s) = m'(s) and of m(s).
    pub fn integrate(
        &mut self,
        piece: &ClaimedPiece,
        load: &SpreadLoad,
        axial: f64,
    ) -> [Coefficients; 2] {
        let half = piece.half;
        let mut net = Coefficients::from(piece.pressure).at_least(2);
        let size = |c: &[f64]| c.iter().map(|c| c.abs()).sum::<f64>() * 2.0 * half;
        self.count(size(piece.pressure) + size(&load.force), size(&load.moment));
        for j in 0..2 {
            net[j] -= load.force[j];
        }
        // T' = p − f, then M' = V = T − P w' + g.
        let total = integral(&net, half, self.shear);
        let mut shear = total.at_least(piece.deflection.len());
        let tension = if axial == 0.0 { &[] } else { piece.deflection };
        for (j, c) in tension.iter().enumerate().skip(1) {
            shear[j - 1] -= axial * (j as f64) * c / half;
        }
        for j in 0..2 {
            shear[j] += load.moment[j];
        }
        let moment = integral(&shear, half, self.moment);
        self.shear = total.iter().sum();
        self.moment = moment.iter().sum();
        [shear, moment]
    }

    /// T and m just right of the position reached.
    pub fn inner(&self) -> [f64; 2] {
        [self.shear, self.moment]
    }

    /// What remains of T and m where a beam that has these of its own goes on, and its rounding.
    pub fn remains(&self, own: [f64; 2], length: f64, axial: f64) -> Remains {
        let [forces, moments] = self.since;
        Remains {
            force: self.shear - own[0],
            moment: self.moment - own[1],
            force_noise: f64::EPSILON * forces,
            moment_noise: f64::EPSILON * (moments + (forces + axial.abs()) * length),
        }
    }

    /// Goes on with other T and m.
    pub fn restart(&mut self, x: f64, remains: &Remains) {
        self.moved(x, remains);
        self.shear -= remains.force;
        self.moment -= remains.moment;
        self.since = [self.shear.abs(), self.moment.abs()];
    }

    fn moved(&mut self, x: f64, remains: &Remains) {
        let [force, moment, from] = self.left_over;
        let moment = moment + force * (x - from) + remains.moment;
        self.left_over = [force + remains.force, moment, x];
    }

    /// |ΣF| and |ΣM| that remain at the right end, relative to what was summed.
    pub fn balance(&mut self) -> [f64; 2] {
        self.moved(self.length, &self.remains([0.0; 2], 0.0, 0.0));
        let [force, moment, _] = self.left_over;
        let relative = |x: f64, scale: f64| if x == 0.0 { 0.0 } else { x.abs() / scale };
        let moments = self.moments + self.forces * self.length;
        [relative(force, moments / self.length), relative(moment, moments)]
    }
}

/// The sum of all loads' sizes, moments over the length.
pub(super) fn size(model: &Model) -> f64 {
    let l = model.beam.length;
    let sizes = model.beam_loads().map(|load| match (load.action(), load.extent()) {
        (Action::Force, extent) => extent.total(),
        (Action::Moment, Extent::Point { size, .. }) => size.abs() / l,
        (Action::Moment, Extent::Distributed { from, to, start, end }) => {
            0.5 * (start.abs() + end.abs()) * ((to - from) / l)
        }
        (Action::Curvature, _) => 2.0 * curling(model, load) / l,
    });
    sizes.sum()
}

/// A bound of the moment EI κ₀ of an imposed curvature.
fn curling(model: &Model, load: &Load) -> f64 {
    load.extent().largest() * model.beam.stiffest()
}

/// The distributed loads on the beam.
pub(super) fn spread(model: &Model) -> Vec<Load> {
    model.beam_loads().filter(|load| load.extent().is_distributed()).copied().collect()
}

/// f, g and κ₀ on a piece: value at the middle and half the rise.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct SpreadLoad {
    pub force: [f64; 2],
    pub moment: [f64; 2],
    pub curvature: [f64; 2],
}

impl SpreadLoad {
    pub fn on(loads: &[Load], x: [f64; 2]) -> Self {
        let middle = 0.5 * (x[0] + x[1]);
        let mut sum = SpreadLoad::default();
        for load in loads {
            let Extent::Distributed { from, to, start, end } = load.extent() else { continue };
            if middle <= from || middle >= to {
                continue;
            }
            let rate = (end - start) / (to - from);
            let terms = [start + rate * (middle - from), rate * 0.5 * (x[1] - x[0])];
            let into = match load.action() {
                Action::Force => &mut sum.force,
                Action::Moment => &mut sum.moment,
                Action::Curvature => &mut sum.curvature,
            };
            for (sum, term) in into.iter_mut().zip(terms) {
                *sum += term;
            }
        }
        sum
    }

    pub fn force(&self, s: f64) -> f64 {
        self.force[0] + self.force[1] * s
    }

    pub fn moment(&self, s: f64) -> f64 {
        self.moment[0] + self.moment[1] * s
    }

    pub fn curvature(&self, s: f64) -> f64 {
        self.curvature[0] + self.curvature[1] * s
    }
}
