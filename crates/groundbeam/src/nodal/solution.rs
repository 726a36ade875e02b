//! Solution of a long beam at the nodes of its mesh, and the check of equilibrium, tension and penetration in this solution.

use crate::model::support::Reaction;
use crate::nodal::grid::Grid;
use crate::nodal::newton::Work;
use crate::numeric::tolerance::NODES;

/// Solution of a long beam at every node of its mesh. The ground forces act at the nodes only.
#[derive(Debug, Clone, Default)]
pub struct NodalSolution {
    /// Deflection w at every node \[m\].
    pub deflection: Vec<f64>,
    /// Rotation of the cross-sections at every node \[rad\]. It equals w' if the beam has no shear deformation. At a
    /// hinge, it is the rotation on the right side.
    pub rotation: Vec<f64>,
    /// Settlement u of the ground at every node \[m\].
    pub settlement: Vec<f64>,
    /// Force of the ground on the beam at every node, positive upwards \[N\].
    pub force: Vec<f64>,
    /// Reactions of the supports, in the order of the model.
    pub reactions: Vec<Reaction>,
    /// First and last node of each contact zone.
    pub contact: Vec<[usize; 2]>,
    /// Work of the solve.
    pub work: Work,
    /// Residuals of equilibrium, largest tensile ground force and largest penetration at the nodes. `None` before a
    /// solve and for a beam bonded to the ground.
    pub check: Option<NodalCheck>,
    pub(crate) grid: Option<Grid>,
}

impl NodalSolution {
    /// The position of a node \[m\].
    pub fn position(&self, node: usize) -> f64 {
        self.grid.as_ref().map_or(0.0, |grid| grid.x(node))
    }

    /// Returns the rows of equal elements. Each row has the position \[m\] and the index of its first node, the
    /// number of its elements, and the length of an element \[m\].
    pub fn rows(&self) -> Vec<(f64, usize, usize, f64)> {
        let runs = self.grid.iter().flat_map(|grid| &grid.runs);
        runs.map(|run| (run.cell.x[0], run.first, run.count, run.h)).collect()
    }
}

/// Residuals of equilibrium, largest tensile ground force and largest penetration in a [`NodalSolution`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NodalCheck {
    /// Residual |ΣF| of the forces, relative to Σ|F| + Σ|M|/l with the beam length l.
    pub force_balance: f64,
    /// Residual |ΣM| of the moments about the middle of the beam, relative to l Σ|F| + Σ|M|.
    pub moment_balance: f64,
    /// Largest tensile ground force with negative sign, relative to the largest compressive ground force. It is
    /// zero if no ground force is tensile.
    pub smallest_force: f64,
    /// Largest penetration w − u − g₀ of the beam into the ground, relative to the largest deflection.
    pub deepest_penetration: f64,
}

impl NodalCheck {
    /// Whether the relative residuals of forces and moments, the relative tensile force and the relative penetration
    /// are all at most 1e-7.
    pub fn holds(&self) -> bool {
        let NodalCheck { force_balance, moment_balance, smallest_force, deepest_penetration } =
            *self;
        let worst = [force_balance, moment_balance, -smallest_force, deepest_penetration];
        worst.iter().all(|part| *part <= NODES)
    }
}
