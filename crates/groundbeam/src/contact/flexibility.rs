//! Computes products with the flexibility matrix G of the ground, (5.8) of Kikuchi's paper, without forming the matrix.
//!
//! Below and above the diagonal, an entry is its neighbour in the column times a factor of the row. So a product costs
//! O(n).

use crate::ground::link::TwoPort;
use crate::nodal::grid::{Grid, Run};

/// The flexibility matrix G of the ground, equation (5.8) of the paper, stored as three numbers per node.
#[derive(Debug)]
pub(crate) struct Flexibility {
    /// Gᵢᵢ.
    pub diagonal: Vec<f64>,
    /// Gᵢⱼ/Gᵢ₋₁ⱼ for j < i.
    pub rightward: Vec<f64>,
    /// Gᵢ₋₁ⱼ/Gᵢⱼ for j ≥ i.
    pub leftward: Vec<f64>,
}

impl Flexibility {
    pub fn of(grid: &Grid) -> Self {
        let each = |run: &Run| std::iter::repeat_n(run.link, run.count);
        let links: Vec<TwoPort> = grid.runs.iter().flat_map(each).collect();
        let n = links.len() + 1;
        // Stiffness of the ground to the left and to the right of each node.
        let mut from_left = vec![grid.outside[0]; n];
        for i in 1..n {
            let link = links[i - 1];
            let hold = from_left[i - 1] + link.shunt_left;
            from_left[i] = link.shunt_right + link.series * (hold / (hold + link.series));
        }
        let mut from_right = vec![grid.outside[1]; n];
        for i in (0..n - 1).rev() {
            let link = links[i];
            let hold = from_right[i + 1] + link.shunt_right;
            from_right[i] = link.shunt_left + link.series * (hold / (hold + link.series));
        }
        let ratio = |series: f64, hold: f64| series / (series + hold);
        let rightward = (0..n).map(|i| match i {
            0 => 0.0,
            _ => ratio(links[i - 1].series, links[i - 1].shunt_right + from_right[i]),
        });
        let leftward = (0..n).map(|i| match i {
            0 => 0.0,
            _ => ratio(links[i - 1].series, links[i - 1].shunt_left + from_left[i - 1]),
        });
        Flexibility {
            diagonal: (0..n).map(|i| 1.0 / (from_left[i] + from_right[i])).collect(),
            rightward: rightward.collect(),
            leftward: leftward.collect(),
        }
    }

    /// u = G p.
    pub fn settlement(&self, pressure: &[f64]) -> Vec<f64> {
        let n = pressure.len();
        let mut u = vec![0.0; n];
        let mut carried = 0.0;
        for i in (0..n).rev() {
            u[i] = carried + self.diagonal[i] * pressure[i];
            carried = u[i] * self.leftward[i];
        }
        carried = 0.0;
        for i in 0..n {
            carried *= self.rightward[i];
            u[i] += carried;
            carried += self.diagonal[i] * pressure[i];
        }
        u
    }
}
