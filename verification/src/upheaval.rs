//! Solves beams under compression on one-way springs at the nodes of a mesh, by Newton's method in small steps of compression.
//!
//! This file shares no code with the library. The cubic elements are from textbooks, and each node has one ground
//! spring. An equilibrium is stable if the stiffness matrix has a Cholesky factorisation. Beam and Winkler ground must
//! be uniform. The error is of second order in the element length.

use crate::element;
use groundbeam::{
    Model, SupportKind,
    model::{Action, Acts, Extent},
};

/// Maximum number of Newton steps for each value of the axial compression.
const MOST_STEPS: usize = 40;

/// A spring at a node. A one-way spring that pushes up acts if the deflection is larger than `place`; one that pulls
/// down acts if the deflection is smaller than `place`.
#[derive(Debug, Clone, Copy)]
struct Spring {
    node: usize,
    constant: f64,
    place: f64,
    acts: Acts,
}

impl Spring {
    fn acts_at(&self, w: &[f64]) -> bool {
        let pressed = w[2 * self.node] - self.place;
        match self.acts {
            Acts::Both => true,
            Acts::Up => pressed > 0.0,
            Acts::Down => pressed < 0.0,
        }
    }
}

/// Spring constant that replaces a rigid support, as a multiple of EI/h³ with the element length h.
const RIGID: f64 = 1e4;

/// A uniform beam on springs at its nodes. The list of springs contains first those of the ground, then those of the
/// supports.
#[derive(Debug, Clone)]
pub struct Meshed {
    length: f64,
    elements: usize,
    bending: Vec<[f64; WIDTH]>,
    geometric: Vec<[f64; WIDTH]>,
    load: Vec<f64>,
    springs: Vec<Spring>,
}

/// Width of the lower band of a symmetric matrix. The matrix is stored row by row, with the diagonal entry last.
const WIDTH: usize = 4;

impl Meshed {
    /// Makes the mesh of a model with uniform beam and ground and μ = 0. Loads are uniform, or forces and moments at
    /// nodes; supports are pins or translational springs at nodes.
    pub fn new(model: &Model, elements: usize) -> Self {
        let length = model.beam.length;
        let h = length / elements as f64;
        let ei = model.beam.bending_stiffness;
        let (bend, turn) = (element::bending(h), element::geometric(h));
        let unknowns = 2 * (elements + 1);
        let (mut bending, mut geometric) =
            (vec![[0.0; WIDTH]; unknowns], vec![[0.0; WIDTH]; unknowns]);
        let mut load = vec![0.0; unknowns];
        for e in 0..elements {
            for i in 0..4 {
                for j in 0..=i {
                    bending[2 * e + i][WIDTH - 1 + j - i] += ei / h.powi(3) * bend[i][j];
                    geometric[2 * e + i][WIDTH - 1 + j - i] += turn[i][j] / (30.0 * h);
                }
            }
        }
        let node = |x: f64| (x / h).round() as usize;
        for l in &model.loads {
            match (l.action(), l.extent()) {
                (Action::Force, Extent::Point { at, size: force }) => load[2 * node(at)] += force,
                (Action::Moment, Extent::Point { at, size: moment }) => {
                    load[2 * node(at) + 1] += moment
                }
                (Action::Force, Extent::Distributed { start, .. }) => {
                    for e in 0..elements {
                        load[2 * e] += 0.5 * start * h;
                        load[2 * e + 1] += start * h * h / 12.0;
                        load[2 * e + 2] += 0.5 * start * h;
                        load[2 * e + 3] -= start * h * h / 12.0;
                    }
                }
                _ => unreachable!("not drawn for this problem"),
            }
        }
        let spring = |i: usize| {
            let share = if i == 0 || i == elements { 0.5 } else { 1.0 };
            let constant = share * h * model.foundation.subgrade;
            let place = clearance(model, i as f64 * h);
            Spring { node: i, constant, place, acts: Acts::Up }
        };
        let mut springs: Vec<Spring> = (0..=elements).map(spring).collect();
        for support in &model.supports {
            let constant = match support.kind {
                SupportKind::Spring { spring, .. } => spring,
                SupportKind::Pinned | SupportKind::Fixed => RIGID * ei / h.powi(3),
            };
            let (node, place) = (node(support.at), support.settlement);
            springs.push(Spring { node, constant, place, acts: support.acts });
        }
        Meshed { length, elements, bending, geometric, load, springs }
    }

    /// Returns the deflections w and the rotations θ of the nodes if Newton's method converges from `start` and the
    /// second variation of the energy is positive; otherwise `None`.
    pub fn settle(&self, compression: f64, start: &[f64]) -> Option<Vec<f64>> {
        let mut w = start.to_vec();
        let mut touching: Option<Vec<bool>> = None;
        for _ in 0..MOST_STEPS {
            let now: Vec<bool> = self.springs.iter().map(|spring| spring.acts_at(&w)).collect();
            if touching.as_ref() == Some(&now) {
                return Some(w);
            }
            let (matrix, mut force) = self.bonded(compression, &now);
            let factor = cholesky(matrix)?;
            substitute(&factor, &mut force);
            w = force;
            touching = Some(now);
        }
        None
    }

    /// Returns the stiffness matrix and the load vector of the beam bonded to the springs in contact.
    fn bonded(&self, compression: f64, touching: &[bool]) -> (Vec<[f64; WIDTH]>, Vec<f64>) {
        let mut matrix = self.bending.clone();
        for (row, turn) in matrix.iter_mut().zip(&self.geometric) {
            for (entry, turn) in row.iter_mut().zip(turn) {
                *entry -= compression * turn;
            }
        }
        let mut force = self.load.clone();
        for (spring, _) in self.springs.iter().zip(touching).filter(|(_, touches)| **touches) {
            let Spring { node, constant, place, .. } = *spring;
            matrix[2 * node][WIDTH - 1] += constant;
            force[2 * node] += constant * place;
        }
        (matrix, force)
    }

    /// Whether the beam is stable if it is bonded to the ground where `touches` is true and to the supports for which
    /// `acts` is true.
    pub fn is_stable(
        &self,
        compression: f64,
        touches: impl Fn(f64) -> bool,
        acts: impl Fn(usize) -> bool,
    ) -> bool {
        let h = self.length / self.elements as f64;
        let ground = (0..=self.elements).map(|i| touches(i as f64 * h));
        let supports = (0..self.springs.len() - self.elements - 1).map(acts);
        let touching: Vec<bool> = ground.chain(supports).collect();
        cholesky(self.bonded(compression, &touching).0).is_some()
    }

    /// Returns the deflections w and rotations θ of the nodes from which Newton's method starts at zero axial
    /// compression. The beam is level and in contact with all springs of the ground.
    pub fn at_rest(&self) -> Vec<f64> {
        let deepest = self.springs.iter().map(|spring| spring.place).fold(0.0, f64::max);
        (0..self.load.len()).map(|i| if i % 2 == 0 { deepest + 1.0 } else { 0.0 }).collect()
    }

    /// Increases the axial compression from zero in equal steps. Returns the deflections and rotations after the last
    /// step; `None` if a step has no stable solution.
    pub fn branch(&self, compression: f64, steps: usize) -> Option<Vec<f64>> {
        let mut w = self.settle(0.0, &self.at_rest())?;
        for step in 1..=steps {
            w = self.settle(compression * step as f64 / steps as f64, &w)?;
        }
        Some(w)
    }

    /// Returns the compression at which the equilibrium path from zero compression ends. Steps without a solution are
    /// halved, down to 10⁻⁹ of the first step.
    pub fn critical_compression(&self, first: f64) -> Option<f64> {
        let mut w = self.settle(0.0, &self.at_rest())?;
        let (mut reached, mut step) = (0.0, first);
        while step > 1e-9 * first {
            match self.settle(reached + step, &w) {
                Some(next) => (w, reached) = (next, reached + step),
                None => step *= 0.5,
            }
        }
        Some(reached)
    }
}

/// Returns the initial gap g₀ at x, which is linear between its corners.
fn clearance(model: &Model, x: f64) -> f64 {
    let gap = &model.gap;
    let next = gap.partition_point(|corner| corner.at < x);
    match (next.checked_sub(1).map(|i| gap[i]), gap.get(next)) {
        (Some(a), Some(b)) => a.value + (b.value - a.value) * (x - a.at) / (b.at - a.at),
        (Some(a), None) => a.value,
        (None, Some(b)) => b.value,
        (None, None) => 0.0,
    }
}

/// Returns the factor L of a banded matrix A = L Lᵀ; `None` if A is not positive definite.
fn cholesky(mut a: Vec<[f64; WIDTH]>) -> Option<Vec<[f64; WIDTH]>> {
    for i in 0..a.len() {
        for j in i.saturating_sub(WIDTH - 1)..=i {
            let at = |row: usize, column: usize| WIDTH - 1 + column - row;
            let first = i.saturating_sub(WIDTH - 1).max(j.saturating_sub(WIDTH - 1));
            let sum: f64 = (first..j).map(|m| a[i][at(i, m)] * a[j][at(j, m)]).sum();
            let rest = a[i][at(i, j)] - sum;
            a[i][at(i, j)] = if i == j {
                if rest.is_nan() || rest <= 0.0 {
                    return None;
                }
                rest.sqrt()
            } else {
                rest / a[j][WIDTH - 1]
            };
        }
    }
    Some(a)
}

/// Solves L Lᵀ x = b in place.
fn substitute(l: &[[f64; WIDTH]], b: &mut [f64]) {
    for i in 0..l.len() {
        let first = i.saturating_sub(WIDTH - 1);
        let sum: f64 = (first..i).map(|j| l[i][WIDTH - 1 + j - i] * b[j]).sum();
        b[i] = (b[i] - sum) / l[i][WIDTH - 1];
    }
    for i in (0..l.len()).rev() {
        b[i] /= l[i][WIDTH - 1];
        for j in i.saturating_sub(WIDTH - 1)..i {
            b[j] -= l[i][WIDTH - 1 + j - i] * b[i];
        }
    }
}
