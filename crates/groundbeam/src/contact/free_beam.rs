//! Computes the deflection of the beam without ground under nodal pressures, and its free rigid motions.

use crate::chain::elimination::Chain;
use crate::chain::node::{ChainCell, ChainNode};
use crate::element::ExactElement;
use crate::element::operator::ZoneKind;
use crate::existence::free_motions::FreeMotions;
use crate::mesh::mesh::Mesh;
use crate::model::Model;

/// The beam without ground. Additional pins prevent its free rigid motions. These pins carry no force if the pressure
/// balances the loads.
pub(super) struct FreeBeam<'a> {
    mesh: &'a Mesh,
    chain: Chain,
    /// Deflections at the nodes of each rigid motion that only the ground prevents.
    pub motions: Vec<Vec<f64>>,
    /// Whether the additional pins support each piece between two free hinges at its two ends, and there are no other
    /// supports.
    simply_supported: bool,
    /// Work of the loads in each of the rigid motions.
    pub wanted: Vec<f64>,
    /// Sum of the magnitudes of the vertical loads \[N\].
    pub size: f64,
}

impl<'a> FreeBeam<'a> {
    pub fn of(model: &Model, mesh: &'a Mesh) -> Self {
        let free = FreeMotions::of(model);
        let mut nodes: Vec<ChainNode> = mesh.nodes.iter().map(ChainNode::of).collect();
        for pin in free.positions().map(|x| mesh.node_at(x)) {
            nodes[pin].pinned = true;
        }
        let cells: Vec<ChainCell> = mesh
            .cells
            .iter()
            .map(|c| ChainCell {
                element: ExactElement::of(c, mesh.axial_force, ZoneKind::Open).element,
                open: None,
            })
            .collect();
        let meeting = nodes.iter().position(|n| n.pinned || n.spring > 0.0).unwrap_or(0);
        let chain = Chain { nodes, cells, meeting };
        let x: Vec<f64> = mesh.nodes.iter().map(|n| n.x).collect();
        let motions = free.deflections(&x);
        let wanted = motions.iter().map(|r| work_of_loads(mesh, &chain, r)).collect();
        let size = size_of_loads(mesh, &chain);
        let simply_supported = free.are_unrestrained();
        FreeBeam { mesh, chain, motions, simply_supported, wanted, size }
    }

    pub fn shapes(&self, pressure: &[f64]) -> Vec<[f64; 4]> {
        let mut chain = self.chain.clone();
        for (node, p) in chain.nodes.iter_mut().zip(pressure) {
            node.force -= p;
        }
        let nothing = vec![[f64::NAN; 4]; self.mesh.cells.len()];
        chain.solve().unwrap_or(nothing)
    }

    /// Computes the deflection w at the nodes by (5.16) of Kikuchi's paper, without the free rigid motions.
    pub fn deflection(&self, pressure: &[f64]) -> Vec<f64> {
        let shapes = self.shapes(pressure);
        let mut w: Vec<f64> = shapes.iter().map(|v| v[0]).collect();
        let end = shapes.last().zip(self.mesh.cells.last());
        w.extend(end.map(|(v, cell)| v[0] + cell.length() * v[1] + v[2]));
        w
    }

    /// Adds the rigid motions with the amplitudes `rigid` to the deflections of the nodes.
    pub fn moved(&self, deflection: &[f64], rigid: &[f64]) -> Vec<f64> {
        let mut w = deflection.to_vec();
        for (amplitude, motion) in rigid.iter().zip(&self.motions) {
            w.iter_mut().zip(motion).for_each(|(w, r)| *w += amplitude * r);
        }
        w
    }

    /// Bounds the norm of the beam's flexibility matrix: by the largest row sum if no entry is negative (simply
    /// supported pieces), otherwise by the trace.
    pub fn largest_flexibility(&self) -> f64 {
        let mut unloaded = self.chain.clone();
        for node in &mut unloaded.nodes {
            (node.force, node.moment, node.settlement) = (0.0, 0.0, 0.0);
        }
        for cell in &mut unloaded.cells {
            cell.element.load = [0.0; 4];
        }
        let (motions, wanted) = (Vec::new(), Vec::new());
        let own = FreeBeam { chain: unloaded, motions, wanted, ..*self };
        let n = self.mesh.nodes.len();
        if self.simply_supported {
            let all = own.deflection(&vec![-1.0; n]);
            return all.into_iter().fold(0.0, f64::max);
        }
        let mut trace = 0.0;
        let mut one = vec![0.0; n];
        for i in 0..n {
            one[i] = -1.0;
            trace += own.deflection(&one)[i];
            one[i] = 0.0;
        }
        trace
    }
}

/// Computes the work of the loads in a rigid motion with the deflections `motion` at the nodes.
fn work_of_loads(mesh: &Mesh, chain: &Chain, motion: &[f64]) -> f64 {
    let slope = |cell: usize| (motion[cell + 1] - motion[cell]) / mesh.cells[cell].length();
    let mut work = 0.0;
    for (i, node) in mesh.nodes.iter().enumerate() {
        // The slope jumps only at free hinges, where no moment acts.
        work += node.force * motion[i] + node.moment * slope(i.saturating_sub(1));
    }
    for (i, cell) in chain.cells.iter().enumerate() {
        let q = cell.element.load;
        work += q[0] * motion[i] + q[1] * slope(i);
    }
    work
}

/// Returns the sum of the magnitudes of the vertical loads.
fn size_of_loads(mesh: &Mesh, chain: &Chain) -> f64 {
    let nodes: f64 = mesh.nodes.iter().map(|node| node.force.abs()).sum();
    nodes + chain.cells.iter().map(|cell| cell.element.load[0].abs()).sum::<f64>()
}
