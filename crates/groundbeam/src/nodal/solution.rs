//! Solution of a long beam at the nodes of its mesh, and the result of its check.

use crate::nodal::grid::Grid;
use crate::nodal::newton::Work;
use crate::numeric::tolerance::NODES;

/// Solution with ground forces at the nodes only: values at every node.
#[derive(Debug, Clone, Default)]
pub struct NodalSolution {
    /// w at every node \[m\].
    pub deflection: Vec<f64>,
    /// w' at every node \[rad\].
    pub slope: Vec<f64>,
    /// u at every node \[m\].
    pub settlement: Vec<f64>,
    /// Force of the ground on the beam at every node, positive upwards \[N\].
    pub force: Vec<f64>,
    /// Contact zones: the first and the last node of each.
    pub contact: Vec<[usize; 2]>,
    /// Work of the solve.
    pub work: Work,
    /// Check of equilibrium and signs at the nodes; `None` for a beam bonded to the ground and before a solve.
    pub check: Option<NodalCheck>,
    pub(crate) grid: Option<Grid>,
}

impl NodalSolution {
    /// The position of a node \[m\].
    pub fn position(&self, node: usize) -> f64 {
        self.grid.as_ref().map_or(0.0, |grid| grid.x(node))
    }

    /// Rows of equal elements: position and index of the first node, number of elements, length of an element.
    pub fn rows(&self) -> Vec<(f64, usize, usize, f64)> {
        let runs = self.grid.iter().flat_map(|grid| &grid.runs);
        runs.map(|run| (run.cell.x[0], run.first, run.count, run.h)).collect()
    }
}

/// Check of equilibrium and signs of a [`NodalSolution`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NodalCheck {
    /// |ΣF| relative to Σ|F|.
    pub force_balance: f64,
    /// |ΣM| about the middle, relative to Σ|F| times the length of the beam.
    pub moment_balance: f64,
    /// The smallest ground force relative to the largest: negative in tension, otherwise zero.
    pub smallest_force: f64,
    /// The largest w − u − g₀ relative to the largest deflection.
    pub deepest_penetration: f64,
}

impl NodalCheck {
    /// Whether the errors of equilibrium, tension and penetration are all at most 1e-7.
    pub fn holds(&self) -> bool {
        let NodalCheck { force_balance, moment_balance, smallest_force, deepest_penetration } =
            *self;
        let worst = [force_balance, moment_balance, -smallest_force, deepest_penetration];
        worst.iter().all(|part| *part <= NODES)
    }
}
