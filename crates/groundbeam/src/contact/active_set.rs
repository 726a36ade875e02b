//! The contact problem on a mesh of cubic elements: Newton's method on a convex energy.
//!
//! Eliminating the ground from (3.9), exactly, leaves the beam's deflection alone:
//!
//! Φ(w) = ½∫(EI w″² + P w'²) − F(w) + ½ min { b(u, u) : u ≥ w − g₀ },
//!
//! convex and once continuously differentiable, with the contact pressure as the derivative of the last
//! term. The inner minimum is the [obstacle problem](crate::contact::obstacle), solved without iteration. Where it touches
//! the ground acts as if bonded to the beam, elsewhere not at all: Newton's step is one solve of the
//! bonded [chain](crate::chain::elimination). If the full step does not settle the slope of Φ along its line, the zero
//! of that slope is searched for. Φ falls with every accepted step, so no deflection comes back; what that
//! proves about the number of steps, and what it does not, is in `docs/methods.md`.

use super::layout::Layout;
use super::surface::Surface;
use crate::cancel::Cancel;
use crate::chain::elimination::Chain;
use crate::chain::node::NotDefinite;
use crate::contact::obstacle;
use crate::contact::state::{ContactState, Step, Unconverged};
use crate::element::cubic::{self, TERMS};
use crate::element::element::Element;
use crate::error::NotConverged;
use crate::mesh::deflection::{Deflection, MeshZone};
use crate::mesh::energy::{Motion, beam_form, ground_work};
use crate::mesh::mesh::Mesh;
use crate::numeric::line_search::settle;
use crate::numeric::tolerance::ENERGY;
use crate::options::Pressure;

/// Steps before a solve is given up. A few dozen are the rule; soft beams hundreds of waves long, lifted to a
/// million times what they settle, take up to a thousand.
const MOST_STEPS: usize = 4000;
/// The same on a mesh that only gives the next one its start.
const COARSE_STEPS: usize = 200;
/// The decrement that rounding leaves: no step can be smaller.
const LEAST: f64 = 1e-30;
/// What is left to fall where rounding decides between two contacts that mean the same, as at a clamp that
/// the beam leaves flat: accepted when [`PATIENCE`] steps have not halved it. The certificate judges.
const ROUNDED: f64 = 1e-14;
const PATIENCE: usize = 24;
/// The part of the bonded ground that first damps a step.
const LEAST_DAMPING: f64 = 1e-6;

/// Solves on one mesh, from the bonded beam or from the solution on another mesh.
pub(crate) fn solve(
    mesh: Mesh,
    pressure: Pressure,
    start: Option<&ContactState>,
    close: f64,
    cancel: &Cancel,
) -> Result<ContactState, Unconverged> {
    let newton = Newton::new(&mesh, pressure);
    let mut history = Vec::new();
    let mut now = match start {
        Some(found) => newton.unfold(super::transfer::interpolated(&mesh, found)),
        None => {
            let nothing_holds = |NotDefinite| Unconverged::SINGULAR;
            newton.unfold(newton.solve_bonded(&newton.bonded(), None).map_err(nothing_holds)?)
        }
    };
    let mut zones = newton.contact(&now.coefficients);
    let mut before = f64::INFINITY;
    let mut least_damping = 0.0;
    let (mut least, mut since) = (f64::INFINITY, 0);
    let most_steps = if close > ENERGY { COARSE_STEPS } else { MOST_STEPS };
    for _ in 0..most_steps {
        if cancel.is_cancelled() {
            break;
        }
        let (next, damping) = newton.step(&now, &zones, least_damping)?;
        let target = newton.unfold(next);
        let line = Line::new(&newton, &now, &target, &zones, damping);
        history.push(Step { zones: zones.len(), step: 1.0, decrement: line.decrement });
        let settled = before <= close && (close > ENERGY || line.decrement > 0.5 * before);
        since = if line.decrement < 0.5 * least { 0 } else { since + 1 };
        least = least.min(line.decrement);
        let idle = since >= PATIENCE && least <= ROUNDED && line.decrement <= ROUNDED;
        if settled || idle || line.decrement <= LEAST {
            zones = newton.contact(&target.coefficients);
            let State { shapes, coefficients } = target;
            let terms = TERMS;
            return Ok(ContactState {
                rotation: Vec::new(),
                mesh,
                terms,
                shapes,
                coefficients,
                zones,
                history,
                pressure,
                surface: None,
                edge_error: Default::default(),
            });
        }
        let t = if line.decrement > 1e-20 { settle(line.fall, |t| line.slope(t)) } else { 1.0 };
        if let Some(step) = history.last_mut() {
            step.step = t;
        }
        // A vanishing step means that the bonded system is numerically singular in this direction.
        least_damping = if t < 1e-9 { (100.0 * damping).max(LEAST_DAMPING) } else { 0.0 };
        let full = t == 1.0 && damping == 0.0;
        before = if full { line.decrement } else { f64::INFINITY };
        now = if t == 1.0 { target } else { now.towards(&target, t) };
        zones = newton.contact(&now.coefficients);
    }
    let reached = history.last().map_or(f64::NAN, |step| step.decrement);
    Err(Unconverged { iterations: history.len(), why: NotConverged::Energy(reached) })
}

/// The nodal pressures (5.5) of the bilateral problem, its pulls left out: a start for (5.15).
pub(crate) fn bilateral_pressure(mesh: &Mesh) -> Vec<f64> {
    let newton = Newton::new(mesh, Pressure::Dirac);
    let zones = newton.bonded();
    let Ok(shapes) = newton.solve_bonded(&zones, None) else {
        return vec![0.0; mesh.nodes.len()];
    };
    let state = newton.unfold(shapes);
    let w = Deflection { mesh, terms: TERMS, coefficients: &state.coefficients };
    Surface::of(&w, &zones)
        .point_forces
        .iter()
        .map(|point_force| point_force.force.max(0.0))
        .collect()
}

/// A deflection: element by element and as polynomials.
#[derive(Debug, Clone)]
struct State {
    shapes: Vec<[f64; 4]>,
    coefficients: Vec<f64>,
}

impl State {
    fn towards(&self, target: &State, t: f64) -> State {
        let mix = |a: f64, b: f64| a + t * (b - a);
        State {
            shapes: self
                .shapes
                .iter()
                .zip(&target.shapes)
                .map(|(a, b)| std::array::from_fn(|i| mix(a[i], b[i])))
                .collect(),
            coefficients: self
                .coefficients
                .iter()
                .zip(&target.coefficients)
                .map(|(a, b)| mix(*a, *b))
                .collect(),
        }
    }
}

/// The mesh's elements without ground, made once.
struct Newton<'a> {
    mesh: &'a Mesh,
    pressure: Pressure,
    elements: Vec<Element>,
}

impl<'a> Newton<'a> {
    fn new(mesh: &'a Mesh, pressure: Pressure) -> Self {
        let element = |cell| cubic::element(cell, mesh.axial_force);
        Newton { mesh, pressure, elements: mesh.cells.iter().map(element).collect() }
    }

    fn contact(&self, coefficients: &[f64]) -> Vec<MeshZone> {
        let w = Deflection { mesh: self.mesh, terms: TERMS, coefficients };
        match self.pressure {
            Pressure::Distributed => obstacle::contact(&w),
            Pressure::Dirac => obstacle::nodal_contact(&w),
        }
    }

    fn bonded(&self) -> Vec<MeshZone> {
        obstacle::everywhere(self.mesh, self.pressure == Pressure::Dirac)
    }

    fn unfold(&self, shapes: Vec<[f64; 4]>) -> State {
        let coefficients =
            shapes.iter().zip(&self.mesh.cells).flat_map(|(v, c)| cubic::unfold(v, c.length()));
        State { coefficients: coefficients.collect(), shapes }
    }

    /// The beam bonded to the ground on `zones`. With `near`, the step from there is damped by a part of
    /// the fully bonded ground.
    fn solve_bonded(
        &self,
        zones: &[MeshZone],
        near: Option<(f64, &State)>,
    ) -> Result<Vec<[f64; 4]>, NotDefinite> {
        let layout = Layout::of(self.mesh, zones);
        let cells = self.mesh.cells.iter().enumerate().map(|(i, cell)| {
            let mut element = self.elements[i];
            for part in layout.parts(i) {
                if part[1] > part[0] {
                    cubic::add_ground(&mut element, cell, part);
                }
            }
            if let Some((weight, state)) = near {
                damp(&mut element, self.mesh, i, weight, &state.shapes[i]);
            }
            layout.chain_cell(self.mesh, i, element, |s| {
                cubic::deflection(0.5 * (1.0 + s), cell.length())
            })
        });
        let cells = cells.collect();
        let nodes = layout.nodes(self.mesh);
        let chain = Chain { nodes, cells, meeting: layout.meeting_node(self.mesh) };
        chain.solve()
    }

    /// Newton's step: the bonded solve, damped only if the contact alone cannot hold the beam.
    fn step(
        &self,
        now: &State,
        zones: &[MeshZone],
        least_damping: f64,
    ) -> Result<(Vec<[f64; 4]>, f64), Unconverged> {
        if least_damping == 0.0
            && let Ok(shapes) = self.solve_bonded(zones, None)
            && shapes.iter().flatten().all(|v| v.is_finite())
        {
            return Ok((shapes, 0.0));
        }
        let mut weight = least_damping.max(LEAST_DAMPING);
        while weight < 10.0 {
            if let Ok(shapes) = self.solve_bonded(zones, Some((weight, now))) {
                return Ok((shapes, weight));
            }
            weight *= 100.0;
        }
        Err(Unconverged::SINGULAR)
    }

    /// ψ = w − g₀ as coefficients.
    fn obstacle(&self, coefficients: &[f64]) -> Vec<f64> {
        let w = Deflection { mesh: self.mesh, terms: TERMS, coefficients };
        (0..self.mesh.cells.len()).flat_map(|i| w.obstacle(i).to_vec()).collect()
    }

    fn beam_form(&self, a: &State, b: &State) -> f64 {
        let [a, b] = [a, b].map(|state| Motion {
            terms: TERMS,
            deflection: &state.coefficients,
            rotation: &[],
        });
        beam_form(self.mesh, a, b)
    }

    fn ground_form(&self, zones: &[MeshZone], psi: &[f64], delta: &[f64]) -> f64 {
        ground_work(self.mesh, TERMS, zones, psi, delta)
    }
}

/// Adds `weight` times the bonded ground, about a given state.
fn damp(element: &mut Element, mesh: &Mesh, i: usize, weight: f64, about: &[f64; 4]) {
    let mut cell = mesh.cells[i];
    cell.stiffen_ground(weight);
    cell.gap = [0.0; 2];
    cell.gap_slope = 0.0;
    let mut extra = Element { length: element.length, ..Element::default() };
    cubic::add_ground(&mut extra, &cell, [-1.0, 1.0]);
    let pull = extra.forces(about);
    for j in 0..4 {
        element.load[j] += pull[j];
        for k in 0..4 {
            element.stiffness[j][k] += extra.stiffness[j][k];
        }
    }
}

/// The energy along the line from one state to the bonded one.
struct Line<'a> {
    newton: &'a Newton<'a>,
    now: &'a State,
    target: &'a State,
    delta: Vec<f64>,
    /// δᵀKδ of the beam, and the damping's part.
    beam: f64,
    damping: f64,
    /// The bonded ground's work on δ at the target.
    bonded_work: f64,
    /// −Φ'(now)·δ, and the same relative to twice the strain energy.
    fall: f64,
    decrement: f64,
}

impl<'a> Line<'a> {
    fn new(
        newton: &'a Newton<'a>,
        now: &'a State,
        target: &'a State,
        zones: &[MeshZone],
        damping: f64,
    ) -> Self {
        let difference = State {
            shapes: Vec::new(),
            coefficients: now
                .coefficients
                .iter()
                .zip(&target.coefficients)
                .map(|(a, b)| b - a)
                .collect(),
        };
        let delta = &difference.coefficients;
        let beam = newton.beam_form(&difference, &difference);
        let damping = if damping > 0.0 {
            damping * newton.ground_form(&newton.bonded(), delta, delta)
        } else {
            0.0
        };
        let psi = newton.obstacle(&target.coefficients);
        let fall = beam + damping + newton.ground_form(zones, delta, delta);
        let energy = newton.beam_form(target, target) + newton.ground_form(zones, &psi, &psi);
        let bonded_work = newton.ground_form(zones, &psi, delta);
        let decrement = if fall == 0.0 { 0.0 } else { fall / energy.abs() };
        let delta = difference.coefficients;
        Line { newton, now, target, delta, beam, damping, bonded_work, fall, decrement }
    }

    /// dΦ/dt at now + t δ.
    fn slope(&self, t: f64) -> f64 {
        let state = self.now.towards(self.target, t);
        let zones = self.newton.contact(&state.coefficients);
        let psi = self.newton.obstacle(&state.coefficients);
        let ground = self.newton.ground_form(&zones, &psi, &self.delta);
        (ground - self.bonded_work) - (1.0 - t) * self.beam - self.damping
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::deflection::BeamPoint;
    use crate::model::{Beam, Foundation, Load, Model};

    /// The paper's own ten elements and nodal pressures: w(0) of cases I and IV as its figures' data give
    /// them, 0.29882 and 0.01341.
    #[test]
    fn the_papers_mesh() {
        for (moment, printed) in [(0.1, 0.29882), (0.49, 0.01341)] {
            let model = Model::new(Beam::uniform(1.0, 1.0), Foundation::pasternak(1.0, 1.0))
                .with_load(Load::point_force(0.5, 1.0))
                .with_load(Load::point_moment(0.5, moment));
            let mesh = Mesh::uniform(&model, 10);
            let found =
                solve(mesh, Pressure::Dirac, None, ENERGY, &Cancel::default()).expect("a solution");
            let end = found.deflection().obstacle_at(BeamPoint { cell: 0, s: -1.0 });
            assert!((end - printed).abs() < 5.1e-6, "{end}");
        }
    }
}
