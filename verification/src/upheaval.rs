//! Compression by brute force: a mesh of cubic elements on nodal springs that only push, Newton's method step by step.
//!
//! Nothing here is shared with the library: stiffness and geometric stiffness as textbooks print them, the
//! ground as one spring per node, stability by Cholesky's elimination of the whole matrix. For uniform
//! beams on uniform separate springs, of which it is an approximation of second order.

use crate::element;
use groundbeam::{Load, Model};

/// Newton's steps that one compression may take.
const MOST_STEPS: usize = 40;

/// A uniform beam on springs at its nodes.
#[derive(Debug, Clone)]
pub struct Meshed {
    length: f64,
    elements: usize,
    bending: Vec<[f64; WIDTH]>,
    geometric: Vec<[f64; WIDTH]>,
    load: Vec<f64>,
    /// Spring constant of every node, and its clearance.
    springs: Vec<[f64; 2]>,
}

/// The lower band of a symmetric matrix, row by row: the diagonal stands last.
const WIDTH: usize = 4;

impl Meshed {
    /// The mesh of a model that has uniform beam and ground, μ = 0, no supports, and even loads or forces
    /// and moments at nodes.
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
            match *l {
                Load::PointForce { at, force } => load[2 * node(at)] += force,
                Load::PointMoment { at, moment } => load[2 * node(at) + 1] += moment,
                Load::Distributed { start, .. } => {
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
            [share * h * model.foundation.spring, clearance(model, i as f64 * h)]
        };
        let springs = (0..=elements).map(spring).collect();
        Meshed { length, elements, bending, geometric, load, springs }
    }

    /// w at the nodes where the second variation is positive and Newton's steps from given w and θ settle;
    /// none if there is no such state.
    pub fn settle(&self, compression: f64, start: &[f64]) -> Option<Vec<f64>> {
        let mut w = start.to_vec();
        let mut touching: Option<Vec<bool>> = None;
        for _ in 0..MOST_STEPS {
            let now: Vec<bool> =
                self.springs.iter().enumerate().map(|(i, [_, gap])| w[2 * i] > *gap).collect();
            if touching.as_ref() == Some(&now) {
                return Some(w);
            }
            let (matrix, mut force) = self.glued(compression, &now);
            let factor = cholesky(matrix)?;
            substitute(&factor, &mut force);
            w = force;
            touching = Some(now);
        }
        None
    }

    /// Matrix and force of the beam glued to the springs that touch.
    fn glued(&self, compression: f64, touching: &[bool]) -> (Vec<[f64; WIDTH]>, Vec<f64>) {
        let mut matrix = self.bending.clone();
        for (row, turn) in matrix.iter_mut().zip(&self.geometric) {
            for (entry, turn) in row.iter_mut().zip(turn) {
                *entry -= compression * turn;
            }
        }
        let mut force = self.load.clone();
        for (i, [spring, gap]) in self.springs.iter().enumerate() {
            if touching[i] {
                matrix[2 * i][WIDTH - 1] += spring;
                force[2 * i] += spring * gap;
            }
        }
        (matrix, force)
    }

    /// Whether the beam glued to springs where a function says so is stable.
    pub fn is_stable(&self, compression: f64, touches: impl Fn(f64) -> bool) -> bool {
        let h = self.length / self.elements as f64;
        let touching: Vec<bool> = (0..=self.elements).map(|i| touches(i as f64 * h)).collect();
        cholesky(self.glued(compression, &touching).0).is_some()
    }

    /// w and θ where nothing acts and nothing is pressed: the start without compression.
    pub fn at_rest(&self) -> Vec<f64> {
        let deepest = self.springs.iter().map(|[_, gap]| *gap).fold(0.0, f64::max);
        (0..self.load.len()).map(|i| if i % 2 == 0 { deepest + 1.0 } else { 0.0 }).collect()
    }

    /// w and θ under a compression, reached in so many steps.
    pub fn branch(&self, compression: f64, steps: usize) -> Option<Vec<f64>> {
        let mut w = self.settle(0.0, &self.at_rest())?;
        for step in 1..=steps {
            w = self.settle(compression * step as f64 / steps as f64, &w)?;
        }
        Some(w)
    }

    /// The compression at which the branch that begins without any ends, in steps that shrink to a part of it.
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

/// g₀ at x, linear between its corners.
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

/// L of L Lᵀ for a banded matrix; none if it is not positive.
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
