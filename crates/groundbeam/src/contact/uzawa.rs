//! Solves the nodal problem by Uzawa's iteration, (5.14)–(5.18) of Kikuchi's paper, or by successive over-relaxation.
//!
//! The relaxation parameters follow from a bound of the beam's flexibility, so that the iteration converges. A sweep
//! costs O(n r²) operations for n nodes and r free rigid motions. See section 9 of `docs/methods.md`.

use super::free_beam::FreeBeam;
use super::surface::{PointForce, Surface};
use crate::cancel::Cancel;
use crate::contact::flexibility::Flexibility;
use crate::contact::nodes;
use crate::contact::state::{ContactState, Unconverged, rotation_terms};
use crate::element::ExactElement;
use crate::element::operator::ZoneKind;
use crate::error::NotConverged;
use crate::mesh::deflection::MeshZone;
use crate::mesh::mesh::Mesh;
use crate::model::Model;
use crate::nodal::grid::Grid;
use crate::nodal::newton::Workspace;
use crate::nodal::quadratic::NotSolved;
use crate::numeric::step::Step;
use crate::numeric::tolerance::{SUM_ROUNDING, SWEEPS};

/// Ratio of a relaxation parameter to the largest value for which convergence is proved.
const SAFE: f64 = 0.95;

/// Maximum number of Newton steps for the amplitudes of the rigid motions in a sweep. Usually two or three steps are
/// sufficient.
const MOST_NEWTON: usize = 200;

/// Damping of a Newton step after one that increased the imbalance, and of a step from a singular matrix, relative to the
/// matrix with all nodes in contact.
const LEAST_DAMPING: f64 = 1e-3;

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
    model: &Model,
    grid: &Grid,
    relaxation: Relaxation,
    from_bilateral: bool,
    most_sweeps: usize,
    cancel: &Cancel,
) -> Result<ContactState, Unconverged> {
    let all: Vec<usize> = (0..=grid.last()).collect();
    let mesh = nodes::mesh(grid, &all);
    let ground = Flexibility::of(grid);
    let beam = FreeBeam::of(model, &mesh);
    let flexibility = beam.largest_flexibility();
    let rho = relaxed(&ground.diagonal, flexibility, relaxation);
    let gap = all.iter().map(|node| grid.gap(*node)).collect();
    let iteration = Iteration::new(&ground, &beam, rho, gap);
    let mut pressure =
        if from_bilateral { bilateral_pressure(grid) } else { vec![0.0; mesh.nodes.len()] };
    let mut rigid = vec![0.0; beam.motions.len()];
    let mut history = Vec::new();
    let mut residual = f64::INFINITY;
    for _ in 0..most_sweeps {
        if cancel.is_cancelled() {
            break;
        }
        let deflection = beam.deflection(&pressure);
        let next = iteration.sweep(&deflection, &pressure, &mut rigid);
        residual = change(&pressure, &next, &iteration.rho, &ground.diagonal);
        pressure = next;
        let touching = pressure.windows(2).filter(|p| p[0] == 0.0 && p[1] > 0.0).count();
        let zones = touching + usize::from(pressure[0] > 0.0);
        history.push(Step { zones, step: iteration.rho[0], decrement: residual });
        if residual <= SWEEPS || !residual.is_finite() {
            break;
        }
    }
    if residual.is_nan() || residual > SWEEPS {
        let iterations = history.len();
        return Err(Unconverged { iterations, why: NotConverged::Sweeps(residual) });
    }
    Ok(found(mesh.clone(), &ground, &beam, &pressure, &rigid, history))
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

/// The data of all sweeps.
struct Iteration<'a> {
    ground: &'a Flexibility,
    beam: &'a FreeBeam<'a>,
    rho: Vec<f64>,
    gap: Vec<f64>,
    /// Σ ρᵢ r(xᵢ)² over the nodes for each rigid motion r, the scale of its diagonal entry in Newton's method.
    whole: Vec<f64>,
}

impl<'a> Iteration<'a> {
    fn new(ground: &'a Flexibility, beam: &'a FreeBeam, rho: Vec<f64>, gap: Vec<f64>) -> Self {
        let whole = |r: &Vec<f64>| rho.iter().zip(r).map(|(rho, r)| rho * r * r).sum();
        let whole = beam.motions.iter().map(whole).collect();
        Iteration { ground, beam, rho, gap, whole }
    }

    /// Performs one sweep (5.17), with the rigid motion for which the new pressure satisfies the equilibrium conditions
    /// (5.19), in the nodal form (5.20). `rigid` has the amplitudes of the rigid motions.
    fn sweep(&self, deflection: &[f64], before: &[f64], rigid: &mut Vec<f64>) -> Vec<f64> {
        let behind = self.settlement_behind(before);
        let swept =
            |rigid: &[f64]| self.swept(&self.beam.moved(deflection, rigid), before, &behind);
        let mut found = swept(rigid);
        let mut damping = 0.0;
        for _ in 0..MOST_NEWTON {
            let size = found.pressure.iter().sum::<f64>().max(self.beam.size);
            if found.balance.iter().all(|b| b.abs() <= SUM_ROUNDING * size) {
                break;
            }
            let step = newton(&found, &self.whole, damping);
            let largest = rigid.iter().fold(0.0, |m: f64, r| m.max(r.abs()));
            if step.iter().all(|s| s.abs() <= f64::EPSILON * 0.5 * largest) {
                break;
            }
            let moved: Vec<f64> = rigid.iter().zip(step).map(|(r, s)| r + s).collect();
            let next = swept(&moved);
            // The balances are monotone functions of the amplitudes, so a sufficiently damped step does not increase
            // them.
            if next.imbalance(&self.whole) <= found.imbalance(&self.whole) {
                (*rigid, found) = (moved, next);
                damping = if damping > LEAST_DAMPING { 0.1 * damping } else { 0.0 };
            } else {
                damping = (10.0 * damping).max(LEAST_DAMPING);
            }
        }
        found.pressure
    }

    /// Computes the sum Σ_{j ≥ i} Gᵢⱼ pⱼ at each node i, with the flexibility matrix G of the ground and the pressure p.
    fn settlement_behind(&self, pressure: &[f64]) -> Vec<f64> {
        let mut behind = vec![0.0; pressure.len()];
        let mut carried = 0.0;
        for i in (0..pressure.len()).rev() {
            behind[i] = self.ground.diagonal[i] * pressure[i] + carried;
            carried = self.ground.leftward[i] * behind[i];
        }
        behind
    }

    /// Computes the pressure after one sweep, if `w` is the deflection. `behind` is the
    /// [`settlement_behind`](Self::settlement_behind) for the pressure `before` this sweep.
    fn swept(&self, w: &[f64], before: &[f64], behind: &[f64]) -> Swept {
        let Iteration { ground, beam, rho, gap, .. } = self;
        let count = beam.motions.len();
        let mut pressure = vec![0.0; before.len()];
        let mut balance = beam.wanted.clone();
        let mut slope = vec![vec![0.0; count]; count];
        // Settlement Σ Gᵢⱼ pⱼ of node i under the new pressures of the nodes j < i, with the flexibility matrix G of the
        // ground, and its derivatives with respect to the amplitudes of the rigid motions.
        let mut ahead = 0.0;
        let mut ahead_by = vec![0.0; count];
        for i in 0..before.len() {
            ahead *= ground.rightward[i];
            ahead_by.iter_mut().for_each(|a| *a *= ground.rightward[i]);
            let value = before[i] - rho[i] * (ahead + behind[i] + gap[i] - w[i]);
            // The new nodal pressure is the positive part of `value`, (5.13) of Kikuchi's paper.
            if value <= 0.0 {
                continue;
            }
            pressure[i] = value;
            ahead += ground.diagonal[i] * value;
            for k in 0..count {
                let derivative = rho[i] * (beam.motions[k][i] - ahead_by[k]);
                ahead_by[k] += ground.diagonal[i] * derivative;
                balance[k] -= value * beam.motions[k][i];
                for (row, motion) in slope.iter_mut().zip(&beam.motions) {
                    row[k] += motion[i] * derivative;
                }
            }
        }
        Swept { pressure, balance, slope }
    }
}

/// The result of a sweep for given amplitudes of the rigid motions.
struct Swept {
    pressure: Vec<f64>,
    /// Work of the loads minus work of the pressure in each rigid motion. It is zero in equilibrium.
    balance: Vec<f64>,
    /// Derivative of the work of the pressure in each rigid motion (rows) with respect to each amplitude (columns).
    slope: Vec<Vec<f64>>,
}

impl Swept {
    /// Sum of the squares of all balances, each relative to the scale of its rigid motion.
    fn imbalance(&self, whole: &[f64]) -> f64 {
        self.balance.iter().zip(whole).map(|(b, whole)| b * b / whole).sum()
    }
}

/// Solves (`slope` + `damping`·diag(`whole`))·step = `balance` by Gaussian elimination. With few nodes in contact, `slope`
/// is singular. A pivot of rounding size is then replaced. The symmetric part of `slope` is positive semidefinite, so no
/// rows have to be exchanged.
fn newton(swept: &Swept, whole: &[f64], damping: f64) -> Vec<f64> {
    let (mut step, mut slope) = (swept.balance.clone(), swept.slope.clone());
    let n = step.len();
    for k in 0..n {
        let (above, rest) = slope.split_at_mut(k);
        let row = &mut rest[0];
        row[k] += damping * whole[k];
        let diagonal = row[k];
        for (j, other) in above.iter().enumerate() {
            let factor = row[j] / other[j];
            for m in j..n {
                row[m] -= factor * other[m];
            }
            step[k] -= factor * step[j];
        }
        if row[k] <= 1e-12 * diagonal.max(1e-12 * whole[k]) {
            row[k] = LEAST_DAMPING * whole[k];
        }
    }
    for k in (0..n).rev() {
        let known: f64 = (k + 1..n).map(|m| slope[k][m] * step[m]).sum();
        step[k] = (step[k] - known) / slope[k][k];
    }
    step
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

/// Converts the pressure and the rigid motion of the converged iteration to a [`ContactState`].
fn found(
    mesh: Mesh,
    ground: &Flexibility,
    beam: &FreeBeam,
    pressure: &[f64],
    rigid: &[f64],
    history: Vec<Step>,
) -> ContactState {
    let mut shapes = beam.shapes(pressure);
    let moved = beam.moved(&vec![0.0; mesh.nodes.len()], rigid);
    for (i, v) in shapes.iter_mut().enumerate() {
        v[0] += moved[i];
        v[1] += (moved[i + 1] - moved[i]) / mesh.cells[i].length();
    }
    let (mut coefficients, mut rotation, shears) = (Vec::new(), Vec::new(), mesh.shears());
    for (v, cell) in shapes.iter().zip(&mesh.cells) {
        let element = ExactElement::of(cell, mesh.axial_force, ZoneKind::Open);
        let (w, _) = element.unfold(v);
        coefficients.extend(w);
        if shears {
            rotation.extend_from_slice(&rotation_terms(element.rotation(v), cell, &w));
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
