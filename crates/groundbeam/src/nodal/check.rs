//! Checks the nodal values of a solution: balance of forces and moments, signs of the ground forces, and no penetration.

use crate::model::{Extent, Model, triangles};
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

pub(crate) fn check(model: &Model, solution: &NodalSolution) -> NodalCheck {
    let middle = 0.5 * model.beam.length;
    let (mut force, mut moment, mut size) = (0.0, 0.0, 0.0);
    let mut act = |f: f64, x: f64| {
        force += f;
        moment += f * (x - middle);
        size += f.abs();
    };
    let mut turns = 0.0;
    for load in model.beam_loads() {
        match (load.action.derivative(), load.extent) {
            (0, Extent::Point { at, size }) => act(size, at),
            (0, extent) => {
                for (force, x) in triangles(extent.ends(), extent.sizes()) {
                    act(force, x);
                }
            }
            (1, Extent::Point { size, .. }) => turns += size,
            (1, Extent::Distributed { from, to, start, end }) => {
                turns += 0.5 * (start + end) * (to - from);
            }
            // An imposed curvature adds neither a force nor a moment to the loads.
            _ => {}
        }
    }
    // The moment of the axial force follows from the difference of the end deflections.
    let last = solution.deflection.len() - 1;
    turns += model.beam.axial_force * (solution.deflection[0] - solution.deflection[last]);
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
        force -= sum;
        moment -= sum * (row.cell.x[0] - middle) + lever * row.h;
        size += sums.size.iter().sum::<f64>();
    }
    let relative = |x: f64, scale: f64| if x == 0.0 { 0.0 } else { x / scale };
    NodalCheck {
        force_balance: relative(force.abs(), size),
        moment_balance: relative((moment + turns).abs(), size * model.beam.length),
        smallest_force: relative(smallest, largest),
        deepest_penetration: relative(deepest, deflection),
    }
}
