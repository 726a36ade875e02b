//! Checks the nodal values of a solution: balance of forces and moments, signs of the ground forces, and no penetration.

use crate::model::{Extent, Load, Model, triangles};
use crate::nodal::solution::NodalCheck;
use crate::nodal::solution::NodalSolution;

/// Number of independent partial sums. In a single sum, each addition would have to wait for the previous addition.
const WIDTH: usize = 4;

/// Partial sums and maxima over the nodes of a row. Entry i of each array is for node i and every [`WIDTH`]-th
/// node after it.
#[derive(Debug, Clone, Copy, Default)]
struct Sums {
    sum: [f64; WIDTH],
    lever: [f64; WIDTH],
    size: [f64; WIDTH],
    tension: [f64; WIDTH],
    compression: [f64; WIDTH],
    depth: [f64; WIDTH],
    deflection: [f64; WIDTH],
}

impl Sums {
    /// Adds the ground forces `f`, deflections `w` and ground displacements `u` at the nodes from number `from` of a
    /// row. `gap` is the gap with free-field settlement at the row's first node, and its increment per node.
    #[inline(always)]
    fn add(&mut self, from: usize, gap: [f64; 2], f: &[f64], w: &[f64], u: &[f64]) {
        let most = |a: f64, b: f64| if b > a { b } else { a };
        for i in 0..f.len() {
            let at = (from + i) as f64;
            self.sum[i] += f[i];
            self.lever[i] += f[i] * at;
            self.size[i] += f[i].abs();
            self.tension[i] = most(self.tension[i], -f[i]);
            self.compression[i] = most(self.compression[i], f[i]);
            self.depth[i] = most(self.depth[i], w[i] - u[i] - (gap[0] + gap[1] * at));
            self.deflection[i] = most(self.deflection[i], w[i].abs());
        }
    }
}

/// Sums of the forces and moments on the beam.
struct Balance {
    /// Length of the beam.
    length: f64,
    /// Sum of the forces, positive downwards.
    force: f64,
    /// Sum of the moments about the middle of the beam, positive clockwise.
    moment: f64,
    /// Σ|F| + Σ|M|/l with the forces F, the moments M and the length l of the beam.
    size: f64,
}

impl Balance {
    fn add_force(&mut self, force: f64, x: f64) {
        self.force += force;
        self.moment += force * (x - 0.5 * self.length);
        self.size += force.abs();
    }

    fn add_moment(&mut self, moment: f64) {
        self.moment += moment;
        self.size += moment.abs() / self.length;
    }

    fn add_load(&mut self, load: &Load) {
        match (load.action.derivative(), load.extent) {
            (0, Extent::Point { at, size }) => self.add_force(size, at),
            (0, extent) => {
                for (force, x) in triangles(extent.ends(), extent.sizes()) {
                    self.add_force(force, x);
                }
            }
            (1, Extent::Point { size, .. }) => self.add_moment(size),
            (1, Extent::Distributed { from, to, start, end }) => {
                self.add_moment(0.5 * (start + end) * (to - from));
            }
            // An imposed curvature adds neither a force nor a moment to the loads.
            _ => {}
        }
    }
}

pub(crate) fn check(model: &Model, solution: &NodalSolution) -> NodalCheck {
    let length = model.beam.length;
    let mut balance = Balance { length, force: 0.0, moment: 0.0, size: 0.0 };
    model.beam_loads().for_each(|load| balance.add_load(load));
    for reaction in &solution.reactions {
        balance.add_force(-reaction.force, reaction.at);
        balance.add_moment(reaction.moment);
    }
    // The moment of the axial force follows from the difference of the end deflections.
    let last = solution.deflection.len() - 1;
    let [left, right] = [0, last].map(|end| solution.deflection[end]);
    balance.add_moment(model.beam.axial_force * (left - right));
    let (mut smallest, mut largest) = (0.0_f64, 0.0_f64);
    let (mut deepest, mut deflection) = (0.0_f64, 0.0_f64);
    for row in solution.grid.iter().flat_map(|grid| &grid.runs) {
        let nodes = row.first..row.end() + usize::from(row.end() == last);
        let [gap, to] = row.gap;
        let rise = (to - gap) / row.count as f64;
        let mut sums = Sums::default();
        let [f, w, u] = [&solution.force, &solution.deflection, &solution.settlement]
            .map(|field| field[nodes.clone()].as_chunks::<WIDTH>());
        for (block, ((f, w), u)) in f.0.iter().zip(w.0).zip(u.0).enumerate() {
            sums.add(block * WIDTH, [gap, rise], f, w, u);
        }
        sums.add(f.0.len() * WIDTH, [gap, rise], f.1, w.1, u.1);
        let sum: f64 = sums.sum.iter().sum();
        let lever: f64 = sums.lever.iter().sum();
        let largest_of = |part: &[f64; WIDTH]| part.iter().fold(0.0_f64, |a, b| a.max(*b));
        smallest = smallest.min(-largest_of(&sums.tension));
        largest = largest.max(largest_of(&sums.compression));
        deepest = deepest.max(largest_of(&sums.depth));
        deflection = deflection.max(largest_of(&sums.deflection));
        balance.force -= sum;
        balance.moment -= sum * (row.cell.x[0] - 0.5 * length) + lever * row.h;
        balance.size += sums.size.iter().sum::<f64>();
    }
    let relative = |x: f64, scale: f64| if x == 0.0 { 0.0 } else { x / scale };
    NodalCheck {
        force_balance: relative(balance.force.abs(), balance.size),
        moment_balance: relative(balance.moment.abs(), balance.size * length),
        smallest_force: relative(smallest, largest),
        deepest_penetration: relative(deepest, deflection),
    }
}
