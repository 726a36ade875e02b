//! Solves the nodal problem by Uzawa's iteration, (5.14)–(5.18) of Kikuchi's paper, or by successive over-relaxation.
//!
//! The relaxation parameters follow from a bound of the beam's flexibility, so that the iteration converges. A sweep
//! costs O(n) operations. See section 9 of `docs/methods.md`.

use super::surface::{PointForce, Surface};
use crate::cancel::Cancel;
use crate::chain::elimination::Chain;
use crate::chain::node::{ChainCell, ChainNode};
use crate::contact::flexibility::Flexibility;
use crate::contact::nodes;
use crate::contact::state::{ContactState, Unconverged, turned};
use crate::element::ExactElement;
use crate::element::operator::{Operator, ZoneKind};
use crate::error::NotConverged;
use crate::mesh::cell::Cell;
use crate::mesh::deflection::MeshZone;
use crate::mesh::mesh::Mesh;
use crate::nodal::grid::Grid;
use crate::nodal::newton::Workspace;
use crate::nodal::quadratic::NotSolved;
use crate::numeric::polynomial::TERMS;
use crate::numeric::step::Step;
use crate::numeric::tolerance::SWEEPS;

/// Ratio of a relaxation parameter to the largest value for which convergence is proved.
const SAFE: f64 = 0.95;

/// Maximum number of Newton steps for the amplitudes of the rigid motions in a sweep. Usually two or three steps are
/// sufficient.
const MOST_NEWTON: usize = 200;

/// Choice of the relaxation parameters ρᵢ of the nodes i.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Relaxation {
    /// One relaxation parameter ρ for all nodes, (5.17) of Kikuchi's paper.
    Uniform,
    /// Relaxation parameters ρᵢ that are inversely proportional to the flexibility Gᵢᵢ of the ground at node i, (5.18)
    /// of Kikuchi's paper.
    Diagonal,
}

/// Solves the nodal problem by Uzawa's iteration. The iteration starts from the pressure of the bilateral problem if
/// `from_bilateral` is set, otherwise from zero pressure.
pub(crate) fn solve(
    grid: &Grid,
    relaxation: Relaxation,
    from_bilateral: bool,
    most_sweeps: usize,
    cancel: &Cancel,
) -> Result<ContactState, Unconverged> {
    let all: Vec<usize> = (0..=grid.last()).collect();
    let mesh = nodes::mesh(grid, &all);
    let ground = Flexibility::of(grid);
    let beam = FreeBeam::of(&mesh);
    let flexibility = beam.largest_flexibility();
    let rho = relaxed(&ground.diagonal, flexibility, relaxation);
    let gap: Vec<f64> = all.iter().map(|node| grid.gap(*node)).collect();
    let mut pressure =
        if from_bilateral { bilateral_pressure(grid) } else { vec![0.0; mesh.nodes.len()] };
    let mut rigid = [0.0; 2];
    let mut history = Vec::new();
    let mut residual = f64::INFINITY;
    for _ in 0..most_sweeps {
        if cancel.is_cancelled() {
            break;
        }
        let deflection = beam.deflection(&pressure);
        let next = sweep(&ground, &beam, &rho, &gap, &deflection, &pressure, &mut rigid);
        residual = change(&pressure, &next, &rho, &ground.diagonal);
        pressure = next;
        let touching = pressure.windows(2).filter(|p| p[0] == 0.0 && p[1] > 0.0).count();
        let zones = touching + usize::from(pressure[0] > 0.0);
        history.push(Step { zones, step: rho[0], decrement: residual });
        if residual <= SWEEPS || !residual.is_finite() {
            break;
        }
    }
    if residual.is_nan() || residual > SWEEPS {
        let iterations = history.len();
        return Err(Unconverged { iterations, why: NotConverged::Sweeps(residual) });
    }
    Ok(found(mesh.clone(), &ground, &beam, &pressure, rigid, history))
}

/// Computes the nodal pressures (5.5) for ground that can also pull, and sets tensile pressures to zero, as a start for
/// (5.15).
fn bilateral_pressure(grid: &Grid) -> Vec<f64> {
    let mut workspace = Workspace::default();
    workspace.bond(grid);
    workspace.resize(grid);
    match workspace.solve_bonded(grid, None) {
        Ok(()) => workspace.force.iter().map(|force| force.max(0.0)).collect(),
        Err(NotSolved) => vec![0.0; grid.last() + 1],
    }
}

/// Computes relaxation parameters slightly below 2/(Gᵢᵢ + |C|). `diagonal` has the flexibilities Gᵢᵢ of the ground, and
/// `flexibility` is a bound of the norm |C| of the beam's flexibility matrix.
fn relaxed(diagonal: &[f64], flexibility: f64, relaxation: Relaxation) -> Vec<f64> {
    let safe = diagonal.iter().map(|g| SAFE * 2.0 / (g + flexibility));
    match relaxation {
        Relaxation::Uniform => {
            let least = safe.fold(f64::INFINITY, f64::min);
            vec![least; diagonal.len()]
        }
        Relaxation::Diagonal => {
            let omega = safe.zip(diagonal).map(|(rho, g)| rho * g).fold(f64::INFINITY, f64::min);
            diagonal.iter().map(|g| omega / g).collect()
        }
    }
}

/// Performs one sweep (5.17), with the rigid motion for which the new pressure satisfies the equilibrium conditions
/// (5.19), in the nodal form (5.20).
fn sweep(
    ground: &Flexibility,
    beam: &FreeBeam,
    rho: &[f64],
    gap: &[f64],
    deflection: &[f64],
    before: &[f64],
    rigid: &mut [f64; 2],
) -> Vec<f64> {
    let n = before.len();
    // `behind` contains the sum Σ_{j ≥ i} Gᵢⱼ pⱼ at each node i, with the flexibility matrix G of the ground and the
    // old pressure p.
    let mut behind = vec![0.0; n];
    for i in (0..n).rev() {
        let carried = if i + 1 < n { ground.leftward[i + 1] * behind[i + 1] } else { 0.0 };
        behind[i] = ground.diagonal[i] * before[i] + carried;
    }
    let mut next = vec![0.0; n];
    for _ in 0..MOST_NEWTON {
        // Σ_{j < i} Gᵢⱼ pⱼ at node i for the new pressure p, and its derivatives with respect to the amplitudes of both
        // rigid motions.
        let mut ahead = [0.0; 3];
        let mut balance = beam.wanted;
        let mut slope = [[0.0; 2]; 2];
        for i in 0..n {
            if i > 0 {
                ahead = ahead.map(|a| a * ground.rightward[i]);
            }
            let r = beam.motions[i];
            let w = deflection[i] + r[0] * rigid[0] + r[1] * rigid[1];
            let value = before[i] - rho[i] * (ahead[0] + behind[i] + gap[i] - w);
            let mut derivative = [0.0; 2];
            // The new nodal pressure is the positive part of `value`, (5.13) of Kikuchi's paper.
            next[i] = value.max(0.0);
            if value > 0.0 {
                derivative = [0, 1].map(|k| rho[i] * (r[k] - ahead[1 + k]));
            }
            for k in 0..2 {
                balance[k] -= next[i] * r[k];
                for m in 0..2 {
                    slope[k][m] += r[k] * derivative[m];
                }
            }
            ahead[0] += ground.diagonal[i] * next[i];
            for k in 0..2 {
                ahead[1 + k] += ground.diagonal[i] * derivative[k];
            }
        }
        let size: f64 = next.iter().sum::<f64>().max(beam.size);
        if beam.free == 0 || balance.iter().all(|b| b.abs() <= 4.0 * f64::EPSILON * size) {
            break;
        }
        let step = newton(&balance, &slope, beam.free, rho[0] * n as f64);
        if step.iter().zip(rigid.iter()).all(|(s, r)| s.abs() <= f64::EPSILON * 0.5 * r.abs()) {
            break;
        }
        for k in 0..2 {
            rigid[k] += step[k];
        }
    }
    next
}

/// Solves `slope`·step = `balance`. With fewer than two nodes in contact, the singular `slope` gets a larger diagonal.
fn newton(balance: &[f64; 2], slope: &[[f64; 2]; 2], free: usize, whole: f64) -> [f64; 2] {
    let [a, b] = *balance;
    if free == 1 {
        return [a / slope[0][0].max(1e-6 * whole), 0.0];
    }
    let mut s = *slope;
    let determinant = |s: &[[f64; 2]; 2]| s[0][0] * s[1][1] - s[0][1] * s[1][0];
    if determinant(&s) <= 1e-12 * (s[0][0] * s[1][1]).max(1e-12 * whole * whole) {
        for k in 0..2 {
            s[k][k] += 1e-3 * whole;
        }
    }
    let d = determinant(&s);
    [(a * s[1][1] - b * s[0][1]) / d, (b * s[0][0] - a * s[1][0]) / d]
}

/// Computes the residual of the contact condition (5.10): the largest change of a nodal pressure, relative to the
/// largest pressure. Changes that are small due to a small relaxation parameter are scaled up.
fn change(before: &[f64], next: &[f64], rho: &[f64], diagonal: &[f64]) -> f64 {
    let largest = before.iter().chain(next).fold(0.0, |m: f64, p| m.max(p.abs()));
    let mut worst: f64 = 0.0;
    for i in 0..next.len() {
        let moved = (next[i] - before[i]).abs() / (rho[i] * diagonal[i]).min(1.0);
        worst = if moved.is_nan() { f64::NAN } else { worst.max(moved) };
    }
    if worst == 0.0 { 0.0 } else { worst / largest }
}

/// Returns the element of the beam in a cell, without the stiffness of the ground.
fn element(cell: &Cell, axial_force: f64) -> ExactElement {
    ExactElement::new(&Operator::of(cell, axial_force, ZoneKind::Open), cell.length())
}

/// The beam without ground. Additional pins prevent its free rigid motions. These pins carry no force if the pressure
/// balances the loads.
struct FreeBeam<'a> {
    mesh: &'a Mesh,
    chain: Chain,
    /// Number of rigid motions that only the ground prevents.
    free: usize,
    /// Deflections of the free rigid motions at the nodes.
    motions: Vec<[f64; 2]>,
    /// Work of the loads in each of the `free` rigid motions; the other entries are 0.
    wanted: [f64; 2],
    /// Sum of the magnitudes of the vertical loads \[N\].
    size: f64,
}

impl<'a> FreeBeam<'a> {
    fn of(mesh: &'a Mesh) -> Self {
        let last = mesh.nodes.len() - 1;
        let l = mesh.nodes[last].x;
        let turning_held = mesh.axial_force != 0.0
            || mesh.nodes.iter().any(|n| n.clamped || n.rotational_spring > 0.0);
        let held: Vec<f64> =
            mesh.nodes.iter().filter(|n| n.pinned || n.spring > 0.0).map(|n| n.x).collect();
        type Motion = Box<dyn Fn(f64) -> [f64; 2]>;
        // The number of free rigid motions, the nodes that are pinned to prevent these motions, and the motions as
        // functions of x depend on the supports.
        let (free, pins, motion): (usize, Vec<usize>, Motion) =
            match (held.as_slice(), turning_held) {
                ([], false) => (2, vec![0, last], Box::new(move |x| [1.0 - x / l, x / l])),
                ([], true) => (1, vec![0], Box::new(|_| [1.0, 0.0])),
                ([at], false) => {
                    let at = *at;
                    let pin = if at > 0.5 * l { 0 } else { last };
                    (1, vec![pin], Box::new(move |x| [(x - at) / l, 0.0]))
                }
                _ => (0, Vec::new(), Box::new(|_| [0.0; 2])),
            };
        let nodes = mesh.nodes.iter().enumerate().map(|(i, n)| ChainNode {
            force: n.force,
            moment: n.moment,
            pinned: n.pinned || pins.contains(&i),
            settlement: n.settlement,
            clamped: n.clamped,
            spring: n.spring,
            rotational_spring: n.rotational_spring,
            ..ChainNode::default()
        });
        let nodes: Vec<ChainNode> = nodes.collect();
        let cells: Vec<ChainCell> = mesh
            .cells
            .iter()
            .map(|c| ChainCell { element: element(c, mesh.axial_force).element, open: None })
            .collect();
        let meeting = nodes.iter().position(|n| n.pinned || n.spring > 0.0).unwrap_or(0);
        let chain = Chain { nodes, cells, meeting };
        let motions: Vec<[f64; 2]> = mesh.nodes.iter().map(|n| motion(n.x)).collect();
        let (wanted, size) = work_of_loads(mesh, &chain, &motions);
        FreeBeam { mesh, chain, free, motions, wanted, size }
    }

    fn shapes(&self, pressure: &[f64]) -> Vec<[f64; 4]> {
        let mut chain = self.chain.clone();
        for (node, p) in chain.nodes.iter_mut().zip(pressure) {
            node.force -= p;
        }
        let nothing = vec![[f64::NAN; 4]; self.mesh.cells.len()];
        chain.solve().unwrap_or(nothing)
    }

    /// Computes the deflection w at the nodes by (5.16) of Kikuchi's paper, without the free rigid motions.
    fn deflection(&self, pressure: &[f64]) -> Vec<f64> {
        let shapes = self.shapes(pressure);
        let mut w: Vec<f64> = shapes.iter().map(|v| v[0]).collect();
        let end = shapes.last().zip(self.mesh.cells.last());
        w.extend(end.map(|(v, cell)| v[0] + cell.length() * v[1] + v[2]));
        w
    }

    /// Bounds the norm of the beam's flexibility matrix: by the largest row sum if all entries are positive (no
    /// supports), otherwise by the trace.
    fn largest_flexibility(&self) -> f64 {
        let mut unloaded = self.chain.clone();
        for node in &mut unloaded.nodes {
            (node.force, node.moment, node.settlement) = (0.0, 0.0, 0.0);
        }
        for cell in &mut unloaded.cells {
            cell.element.load = [0.0; 4];
        }
        let own = FreeBeam { chain: unloaded, motions: Vec::new(), ..*self };
        let n = self.mesh.nodes.len();
        if self.free == 2 {
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

/// Computes the work of the loads in each of the rigid motions `motions`, and the sum of the magnitudes of the vertical
/// loads.
fn work_of_loads(mesh: &Mesh, chain: &Chain, motions: &[[f64; 2]]) -> ([f64; 2], f64) {
    let mut work = [0.0; 2];
    let mut size = 0.0;
    for (i, node) in mesh.nodes.iter().enumerate() {
        let other = if i == 0 { 1 } else { i - 1 };
        let run = node.x - mesh.nodes[other].x;
        for k in 0..2 {
            let slope = (motions[i][k] - motions[other][k]) / run;
            work[k] += node.force * motions[i][k] + node.moment * slope;
        }
        size += node.force.abs();
    }
    for (i, (cell, element)) in mesh.cells.iter().zip(&chain.cells).enumerate() {
        let q = element.element.load;
        for k in 0..2 {
            let slope = (motions[i + 1][k] - motions[i][k]) / cell.length();
            work[k] += q[0] * motions[i][k] + q[1] * slope;
        }
        size += q[0].abs();
    }
    (work, size)
}

/// Converts the pressure and the rigid motion of the converged iteration to a [`ContactState`].
fn found(
    mesh: Mesh,
    ground: &Flexibility,
    beam: &FreeBeam,
    pressure: &[f64],
    rigid: [f64; 2],
    history: Vec<Step>,
) -> ContactState {
    let mut shapes = beam.shapes(pressure);
    for (i, v) in shapes.iter_mut().enumerate() {
        let [a, b] = [beam.motions[i], beam.motions[i + 1]];
        let h = mesh.cells[i].length();
        for k in 0..2 {
            v[0] += rigid[k] * a[k];
            v[1] += rigid[k] * (b[k] - a[k]) / h;
        }
    }
    let (mut coefficients, mut rotation) = (Vec::new(), Vec::new());
    for (v, cell) in shapes.iter().zip(&mesh.cells) {
        let element = element(cell, mesh.axial_force);
        let (w, _) = element.unfold(v);
        coefficients.extend(w);
        if mesh.shears() {
            let own = element.rotation(v).map_or_else(|| turned(cell, &w), |own| own[..].into());
            rotation.extend_from_slice(&own.at_least(TERMS));
        }
    }
    let u = ground.settlement(pressure);
    let parts = nodes::surface_parts(&mesh, &coefficients, |cell| [u[cell], u[cell + 1]]);
    let last = mesh.cells.len();
    let at = |node: usize| nodes::point(node, last);
    let touching = pressure.iter().enumerate().filter(|(_, force)| **force > 0.0);
    let (mut point_forces, mut zones) = (Vec::new(), Vec::<MeshZone>::new());
    let mut before = None;
    for (node, force) in touching {
        point_forces.push(PointForce { point: at(node), force: *force });
        match zones.last_mut() {
            Some(zone) if before == node.checked_sub(1) => zone.to = at(node),
            _ => zones.push(MeshZone { from: at(node), to: at(node) }),
        }
        before = Some(node);
    }
    let surface = Surface { parts, point_forces };
    ContactState {
        rotation,
        mesh,
        coefficients,
        zones,
        history,
        nodal_elements: Some(last),
        surface: Some(surface),
        edge_error: Default::default(),
    }
}
