//! What holds at the nodes of a nodal solution, from its numbers and the model's own.

use super::NodalSolution;
use crate::model::{Load, Model};

/// Balance and signs of a [`NodalSolution`].
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct NodalCheck {
    /// |ΣF| relative to the sum of all forces' sizes.
    pub force_balance: f64,
    /// |ΣM| about the middle, relative to that sum times the length.
    pub moment_balance: f64,
    /// The smallest force of the ground relative to the largest: a pull would be negative.
    pub smallest_force: f64,
    /// The deepest w − u − g₀ relative to the largest deflection.
    pub deepest_penetration: f64,
}

const WIDTH: usize = 4;

#[derive(Debug, Clone, Copy, Default)]
struct Sums {
    sum: f64,
    lever: f64,
    size: f64,
    smallest: f64,
    largest: f64,
    deepest: f64,
    deflection: f64,
}

impl Sums {
    #[inline(always)]
    fn add(&mut self, at: f64, force: f64, deflection: f64, depth: f64) {
        let most = |a: f64, b: f64| if b > a { b } else { a };
        self.sum += force;
        self.lever += force * at;
        self.size += force.abs();
        self.smallest = -most(-self.smallest, -force);
        self.largest = most(self.largest, force);
        self.deepest = most(self.deepest, depth);
        self.deflection = most(self.deflection, deflection.abs());
    }
}

impl NodalCheck {
    /// Whether all of it holds to rounding: [`Certificate::TOLERANCE`](crate::Certificate::TOLERANCE).
    pub fn holds(&self) -> bool {
        let NodalCheck { force_balance, moment_balance, smallest_force, deepest_penetration } =
            *self;
        let worst = [force_balance, moment_balance, -smallest_force, deepest_penetration];
        worst.iter().all(|part| *part <= crate::Certificate::TOLERANCE)
    }
}

pub(super) fn check(model: &Model, solution: &NodalSolution) -> NodalCheck {
    let middle = 0.5 * model.beam.length;
    let (mut force, mut moment, mut size) = (0.0, 0.0, 0.0);
    let mut act = |f: f64, x: f64| {
        force += f;
        moment += f * (x - middle);
        size += f.abs();
    };
    let mut turns = 0.0;
    for load in &model.loads {
        match *load {
            Load::PointForce { at, force } => act(force, at),
            Load::PointMoment { moment, .. } => turns += moment,
            Load::Distributed { from, to, start, end } => {
                act(0.5 * start * (to - from), from + (to - from) / 3.0);
                act(0.5 * end * (to - from), to - (to - from) / 3.0);
            }
            Load::DistributedMoment { from, to, start, end } => {
                turns += 0.5 * (start + end) * (to - from);
            }
        }
    }
    // The axial force has a lever too.
    let last = solution.deflection.len() - 1;
    turns += model.beam.axial_force * (solution.deflection[0] - solution.deflection[last]);
    let (mut smallest, mut largest) = (0.0_f64, 0.0_f64);
    let (mut deepest, mut deflection) = (0.0_f64, 0.0_f64);
    for row in solution.grid.iter().flat_map(|grid| &grid.runs) {
        let nodes = row.first..row.end() + usize::from(row.end() == last);
        let [gap, to] = row.given.gap;
        let rise = (to - gap) / row.count as f64;
        // Several sums side by side: one would wait for itself.
        let mut sums = [Sums::default(); WIDTH];
        let blocks = [&solution.force, &solution.deflection, &solution.settlement]
            .map(|field| field[nodes.clone()].chunks(WIDTH));
        let [forces, deflections, settlements] = blocks;
        for (block, ((f, w), u)) in forces.zip(deflections).zip(settlements).enumerate() {
            for (i, sums) in sums.iter_mut().enumerate().take(f.len()) {
                let at = (block * WIDTH + i) as f64;
                sums.add(at, f[i], w[i], w[i] - u[i] - (gap + rise * at));
            }
        }
        let (mut sum, mut lever, mut sizes) = (0.0, 0.0, 0.0);
        for part in &sums {
            sum += part.sum;
            lever += part.lever;
            sizes += part.size;
            smallest = smallest.min(part.smallest);
            largest = largest.max(part.largest);
            deepest = deepest.max(part.deepest);
            deflection = deflection.max(part.deflection);
        }
        force -= sum;
        moment -= sum * (row.x[0] - middle) + lever * row.h;
        size += sizes;
    }
    let relative = |x: f64, scale: f64| if x == 0.0 { 0.0 } else { x / scale };
    NodalCheck {
        force_balance: relative(force.abs(), size),
        moment_balance: relative((moment + turns).abs(), size * model.beam.length),
        smallest_force: relative(smallest, largest),
        deepest_penetration: relative(deepest, deflection),
    }
}
