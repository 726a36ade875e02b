//! Solves the discrete problem (5.10)–(5.11) of Kikuchi's paper with dense matrices.
//!
//! The mesh is uniform, and all point loads act at nodes. This file shares no code with the library. The element
//! matrices are from textbooks, and the flexibility of the ground is Green's function (2.4) of the paper. Under
//! tension, exact elements replace the cubic elements (5.2).

use crate::element;
use groundbeam::{
    Model,
    model::{Action, Extent},
};

/// Matrices and load vector of the Lagrangian (5.9) of Kikuchi's paper. Between the nodes, the deflection is (5.3) and
/// the settlement is (5.6).
#[derive(Debug, Clone)]
pub struct Dense {
    /// Number of nodes.
    pub nodes: usize,
    /// Stiffness matrix (5.4) of the beam. Its unknowns are deflection and slope of each node, then the slope to the
    /// right of each hinge.
    pub stiffness: Vec<Vec<f64>>,
    /// Load vector F, with one entry for each unknown.
    pub load: Vec<f64>,
    /// Flexibility matrix G of the ground, (5.7) and (5.8) of Kikuchi's paper. Entry (i, j) is the settlement of node i
    /// under a unit force at node j.
    pub flexibility: Vec<Vec<f64>>,
}

impl Dense {
    /// Assembles the problem of a uniform beam on a uniform Pasternak foundation.
    pub fn new(model: &Model, elements: usize) -> Self {
        let nodes = elements + 1;
        let h = model.beam.length / elements as f64;
        let (ei, p) = (model.beam.bending_stiffness, model.beam.axial_force);
        let u = h * (p / ei).sqrt();
        let own_stiffness = |i: usize, j: usize| match p > 0.0 {
            true => ei * element::in_tension(h, u)[i][j],
            false => {
                let (bend, pull) = (element::bending(h), element::geometric(h));
                ei / h.powi(3) * bend[i][j] + p / (30.0 * h) * pull[i][j]
            }
        };
        // `clamped` is the end moment of an element that is clamped at both ends under a unit uniform load.
        let clamped = match p > 0.0 {
            true => (h / u).powi(2) * (0.5 * u / (0.5 * u).tanh() - 1.0),
            false => h * h / 12.0,
        };
        let node = |x: f64| (x / h).round() as usize;
        let size = 2 * nodes + model.hinges.len();
        let mut stiffness = vec![vec![0.0; size]; size];
        for (i, hinge) in model.hinges.iter().enumerate() {
            let [left, right] = [2 * node(hinge.at) + 1, 2 * nodes + i];
            for (a, b, sign) in
                [(left, left, 1.0), (right, right, 1.0), (left, right, -1.0), (right, left, -1.0)]
            {
                stiffness[a][b] += sign * hinge.rotational_spring;
            }
        }
        for e in 0..elements {
            let hinge = model.hinges.iter().position(|hinge| node(hinge.at) == e);
            let slope = hinge.map_or(2 * e + 1, |i| 2 * nodes + i);
            let own = [2 * e, slope, 2 * e + 2, 2 * e + 3];
            for i in 0..4 {
                for j in 0..4 {
                    stiffness[own[i]][own[j]] += own_stiffness(i, j);
                }
            }
        }
        let mut load = vec![0.0; size];
        for l in &model.loads {
            match (l.action(), l.extent()) {
                (Action::Force, Extent::Point { at, size: force }) => load[2 * node(at)] += force,
                (Action::Moment, Extent::Point { at, size: moment }) => {
                    load[2 * node(at) + 1] += moment
                }
                (Action::Force, Extent::Distributed { start, .. }) => {
                    for e in 0..elements {
                        load[2 * e] += 0.5 * start * h;
                        load[2 * e + 1] += start * clamped;
                        load[2 * e + 2] += 0.5 * start * h;
                        load[2 * e + 3] -= start * clamped;
                    }
                }
                // An imposed curvature κ₀ is equivalent to the moments EI κ₀ at both ends of each element, in
                // opposite directions.
                (Action::Curvature, Extent::Distributed { start, .. }) => {
                    for e in 0..elements {
                        load[2 * e + 1] -= ei * start;
                        load[2 * e + 3] += ei * start;
                    }
                }
                _ => unreachable!("not drawn for this problem"),
            }
        }
        let (k, mu) = (model.foundation.subgrade, model.foundation.shear_layer);
        let b = (k / mu).sqrt();
        let g = |i: usize, j: usize| (-b * h * i.abs_diff(j) as f64).exp() / (2.0 * mu * b);
        let flexibility = (0..nodes).map(|i| (0..nodes).map(|j| g(i, j)).collect()).collect();
        Dense { nodes, stiffness, load, flexibility }
    }

    /// Tries every set of touching nodes, and returns w and p of the one that satisfies all sign conditions.
    pub fn by_exhaustion(&self) -> Option<(Vec<f64>, Vec<f64>)> {
        (1..1_usize << self.nodes).find_map(|set| {
            let touching: Vec<usize> = (0..self.nodes).filter(|i| set >> i & 1 == 1).collect();
            self.with_contact(&touching)
        })
    }

    /// Solves the problem with contact at the given nodes. Returns the deflections and the contact forces; `None` if a
    /// contact force is tensile or the beam penetrates the ground.
    fn with_contact(&self, touching: &[usize]) -> Option<(Vec<f64>, Vec<f64>)> {
        let (n, m) = (self.load.len(), touching.len());
        let mut a = vec![vec![0.0; n + m + 1]; n + m];
        for i in 0..n {
            a[i][..n].copy_from_slice(&self.stiffness[i]);
            a[i][n + m] = self.load[i];
        }
        for (j, &node) in touching.iter().enumerate() {
            a[2 * node][n + j] = 1.0;
            a[n + j][2 * node] = -1.0;
            for (i, &other) in touching.iter().enumerate() {
                a[n + j][n + i] = self.flexibility[node][other];
            }
        }
        let x = solve(a)?;
        let w: Vec<f64> = (0..self.nodes).map(|i| x[2 * i]).collect();
        let mut p = vec![0.0; self.nodes];
        for (j, &node) in touching.iter().enumerate() {
            p[node] = x[n + j];
        }
        let largest = w.iter().fold(0.0, |m: f64, w| m.max(w.abs()));
        let force = p.iter().fold(0.0, |m: f64, p| m.max(p.abs()));
        let u = |i: usize| self.flexibility[i].iter().zip(&p).map(|(g, p)| g * p).sum::<f64>();
        let clear = (0..self.nodes).all(|i| u(i) - w[i] >= -1e-9 * largest);
        (p.iter().all(|p| *p >= -1e-9 * force) && clear).then_some((w, p))
    }
}

/// Solves a linear system by Gaussian elimination with partial pivoting; `None` for a singular matrix.
fn solve(mut a: Vec<Vec<f64>>) -> Option<Vec<f64>> {
    let n = a.len();
    let scale = a.iter().flatten().fold(0.0, |m: f64, x| m.max(x.abs()));
    for p in 0..n {
        let best = (p..n).max_by(|&i, &j| a[i][p].abs().total_cmp(&a[j][p].abs()))?;
        a.swap(p, best);
        if a[p][p].abs() < 1e-13 * scale {
            return None;
        }
        for i in p + 1..n {
            let factor = a[i][p] / a[p][p];
            for j in p..=n {
                a[i][j] -= factor * a[p][j];
            }
        }
    }
    let mut x = vec![0.0; n];
    for i in (0..n).rev() {
        let sum: f64 = (i + 1..n).map(|j| a[i][j] * x[j]).sum();
        x[i] = (a[i][n] - sum) / a[i][i];
    }
    Some(x)
}
