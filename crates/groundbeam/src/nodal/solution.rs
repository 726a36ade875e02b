//! The solution of a long beam at the nodes of its mesh, and what holds of it there.

use crate::nodal::grid::Grid;
use crate::nodal::newton::Work;
use crate::numeric::tolerance::NODES;

/// A beam whose ground presses at nodes alone: values at every node.
#[derive(Debug, Clone, Default)]
pub struct NodalSolution {
    /// w at every node \[m\].
    pub deflection: Vec<f64>,
    /// w' at every node \[rad\].
    pub slope: Vec<f64>,
    /// u at every node \[m\].
    pub settlement: Vec<f64>,
    /// What the ground presses at every node, up positive \[N\].
    pub force: Vec<f64>,
    /// The nodes that touch: the first and the last of each row.
    pub contact: Vec<[usize; 2]>,
    /// What was done to find it.
    pub work: Work,
    /// Balance and signs at the nodes; `None` of a beam that is bonded to the ground, and before a solve.
    pub check: Option<NodalCheck>,
    pub(crate) grid: Option<Grid>,
}

impl NodalSolution {
    /// The position of a node \[m\].
    pub fn position(&self, node: usize) -> f64 {
        self.grid.as_ref().map_or(0.0, |grid| grid.x(node))
    }

    /// Rows of equal elements: position of the first node, its number, elements, their length.
    pub fn rows(&self) -> Vec<(f64, usize, usize, f64)> {
        let runs = self.grid.iter().flat_map(|grid| &grid.runs);
        runs.map(|run| (run.cell.x[0], run.first, run.count, run.h)).collect()
    }
}

/// Balance and signs of a [`NodalSolution`].
#[derive(Debug, Clone, Copy, PartialEq)]
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

impl NodalCheck {
    /// Whether every figure is at most 1e-7.
    pub fn holds(&self) -> bool {
        let NodalCheck { force_balance, moment_balance, smallest_force, deepest_penetration } =
            *self;
        let worst = [force_balance, moment_balance, -smallest_force, deepest_penetration];
        worst.iter().all(|part| *part <= NODES)
    }
}
