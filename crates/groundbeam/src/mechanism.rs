//! How a beam may move without bending: straight between its ends and its free hinges.
//!
//! A rigid motion is given by its values at these *nodes*; between two of them is a *piece*, straight. An
//! elastic hinge resists a kink, and is no node. Since r is straight in between, r ≤ 0 all along exactly if
//! r ≤ 0 at every node.

use crate::model::{Acts, Load, Model, SupportKind};
use std::ops::Range;

/// Positions closer than this part of the beam's length are one position.
const SAME_PLACE: f64 = 4.0 * f64::EPSILON;

/// The nodes of a beam, and what keeps its pieces where they are.
#[derive(Debug, Clone)]
pub(crate) struct Mechanism {
    /// The beam's ends and its free hinges, from left to right.
    pub nodes: Vec<f64>,
    /// Where supports hold it.
    held: Vec<f64>,
    /// Whether anything keeps each piece from turning: a support or tension.
    straight: Vec<bool>,
}

impl Mechanism {
    /// The beam with what keeps it from lifting besides the ground; tension keeps all of it from turning. A
    /// support that only pushes up does not.
    pub fn of(model: &Model) -> Self {
        let mut mechanism = Self::on_supports(model, |acts| acts != Acts::Up);
        if model.beam.axial_force != 0.0 {
            mechanism.straight.fill(true);
        }
        mechanism
    }

    /// The same by some of its supports alone.
    fn on_supports(model: &Model, counts: impl Fn(Acts) -> bool) -> Self {
        let l = model.beam.length;
        let free = model.hinges.iter().filter(|hinge| hinge.is_free());
        let mut nodes: Vec<f64> = free.map(|hinge| hinge.at).chain([0.0, l]).collect();
        nodes.sort_by(f64::total_cmp);
        let straight = vec![false; nodes.len() - 1];
        let mut mechanism = Mechanism { nodes, held: Vec::new(), straight };
        for support in model.supports.iter().filter(|support| counts(support.acts)) {
            let (holds, stops_turning) = match support.kind {
                SupportKind::Pinned => (true, false),
                SupportKind::Fixed => (true, true),
                SupportKind::Spring { spring, rotational_spring } => {
                    (spring > 0.0, rotational_spring > 0.0)
                }
            };
            if holds {
                mechanism.held.push(support.at);
            }
            if stops_turning {
                let piece = mechanism.piece_at(support.at);
                mechanism.straight[piece] = true;
            }
        }
        mechanism
    }

    /// The piece that holds x; of two that meet there the right one.
    fn piece_at(&self, x: f64) -> usize {
        let after = self.nodes.partition_point(|node| *node <= x);
        after.saturating_sub(1).min(self.straight.len() - 1)
    }

    fn is_at(&self, x: f64, node: usize) -> bool {
        let l = self.nodes[self.nodes.len() - 1];
        (x - self.nodes[node]).abs() <= SAME_PLACE * l
    }

    /// The nodes that may lift, r < 0, without work against supports or tension and without pressing on the
    /// ground anywhere: group by group, each as one. Any r ≤ 0 that is free is a sum of such lifts.
    ///
    /// Where r ≤ 0 vanishes within a piece it vanishes along all of it; a piece that may not turn lifts both
    /// of its nodes alike.
    pub fn free_groups(&self) -> Vec<Range<usize>> {
        let mut fixed = vec![false; self.nodes.len()];
        for &x in &self.held {
            match (0..self.nodes.len()).find(|node| self.is_at(x, *node)) {
                Some(node) => fixed[node] = true,
                None => {
                    let piece = self.piece_at(x);
                    (fixed[piece], fixed[piece + 1]) = (true, true);
                }
            }
        }
        let mut groups = Vec::new();
        let mut first = 0;
        for node in 0..self.nodes.len() {
            if self.straight.get(node) == Some(&true) {
                continue;
            }
            let group = first..node + 1;
            if !fixed[group.clone()].contains(&true) {
                groups.push(group);
            }
            first = node + 1;
        }
        groups
    }

    /// A place at which the beam is held.
    pub fn point_held(&self, more: &[f64]) -> Option<f64> {
        self.held.iter().chain(more).next().copied()
    }

    /// The first piece that may still move, in either direction, when the beam is held at more places as
    /// well; none if all of it is held.
    ///
    /// A piece is held at two places, or at one where it may not turn, and then holds its nodes for its
    /// neighbours. That finds all: n pieces that hang together have n + 1 degrees of freedom, so that if
    /// nothing moves some piece among them has two constraints of its own.
    pub fn first_loose(&self, more: &[f64]) -> Option<[f64; 2]> {
        let places: Vec<f64> = self.held.iter().chain(more).copied().collect();
        let nodes = 0..self.nodes.len();
        let mut fixed: Vec<bool> =
            nodes.map(|node| places.iter().any(|x| self.is_at(*x, node))).collect();
        let inside = |piece: usize| {
            let [from, to] = [self.nodes[piece], self.nodes[piece + 1]];
            let own = places.iter().filter(|x| {
                from < **x && **x < to && !self.is_at(**x, piece) && !self.is_at(**x, piece + 1)
            });
            let [low, high] = own.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| {
                [low.min(*x), high.max(*x)]
            });
            usize::from(low <= high) + usize::from(low < high)
        };
        let own: Vec<usize> =
            (0..self.straight.len()).map(|i| inside(i) + usize::from(self.straight[i])).collect();
        let mut loose: Vec<usize> = (0..own.len()).collect();
        loop {
            let before = loose.len();
            loose.retain(|&i| {
                let held = own[i] + usize::from(fixed[i]) + usize::from(fixed[i + 1]);
                if held >= 2 {
                    (fixed[i], fixed[i + 1]) = (true, true);
                }
                held < 2
            });
            if loose.len() == before {
                return loose.first().map(|&i| [self.nodes[i], self.nodes[i + 1]]);
            }
        }
    }
}

/// Whether supports leave no rigid motion at all, pressing on the ground or not: what a beam in
/// compression needs. Supports that it may leave do not count.
pub(crate) fn held_rigidly(model: &Model) -> bool {
    Mechanism::on_supports(model, |acts| acts == Acts::Both).first_loose(&[]).is_none()
}

/// A sum with the size of what was added, so that zero can be told from rounding.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Sum {
    pub sum: f64,
    compensation: f64,
    /// The sum of the sizes of all terms.
    pub size: f64,
}

impl Sum {
    fn add(&mut self, term: f64) {
        // Neumaier's summation: the sum of the given numbers is right to the last bit or two.
        let sum = self.sum + term;
        self.compensation += if self.sum.abs() >= term.abs() {
            (self.sum - sum) + term
        } else {
            (term - sum) + self.sum
        };
        self.sum = sum;
        self.size += term.abs();
    }

    fn finished(mut self) -> Self {
        self.sum += self.compensation;
        self.compensation = 0.0;
        if self.is_zero() {
            self.sum = 0.0;
        }
        self
    }

    pub fn plus(self, other: Sum) -> Sum {
        Sum { sum: self.sum + other.sum, compensation: 0.0, size: self.size + other.size }
    }

    pub fn is_zero(&self) -> bool {
        self.sum.abs() <= 8.0 * f64::EPSILON * self.size
    }

    pub fn is_negative(&self) -> bool {
        self.sum < 0.0 && !self.is_zero()
    }
}

/// The work F(φ) of the loads in each node's hat function, 1 there, 0 at all others, straight in between:
/// what a support under each node would carry if the pieces were rigid. Without hinges these are
/// R₀ = F(1 − x/l) and R_l = F(x/l).
pub(crate) fn static_reactions(loads: &[Load], nodes: &[f64]) -> Vec<Sum> {
    let pieces = nodes.len() - 1;
    let mut reactions = vec![Sum::default(); nodes.len()];
    let holding = |x: f64| nodes.partition_point(|node| *node <= x).clamp(1, pieces) - 1;
    let mut force_at = |piece: usize, force: f64, x: f64| {
        let [from, to] = [nodes[piece], nodes[piece + 1]];
        let length = to - from;
        reactions[piece].add(force * ((to - x) / length));
        reactions[piece + 1].add(force * ((x - from) / length));
    };
    let mut moments: Vec<(usize, f64)> = Vec::new();
    for load in loads {
        match *load {
            Load::PointForce { at, force } => force_at(holding(at), force, at),
            Load::PointMoment { at, moment } => moments.push((holding(at), moment)),
            Load::Distributed { from, to, start, end } => {
                for (piece, [a, b], [start, end]) in cut(nodes, [from, to], [start, end]) {
                    // Two triangles, each at its own third.
                    let length = b - a;
                    force_at(piece, 0.5 * start * length, a + length / 3.0);
                    force_at(piece, 0.5 * end * length, b - length / 3.0);
                }
            }
            Load::DistributedMoment { from, to, start, end } => {
                for (piece, [a, b], [start, end]) in cut(nodes, [from, to], [start, end]) {
                    moments.push((piece, 0.5 * (start + end) * (b - a)));
                }
            }
            // A rigid motion has no curvature, and what acts on the ground does no work on it.
            Load::Curvature { .. } | Load::GroundForce { .. } | Load::GroundDistributed { .. } => {}
        }
    }
    for (piece, moment) in moments {
        let length = nodes[piece + 1] - nodes[piece];
        reactions[piece].add(-moment / length);
        reactions[piece + 1].add(moment / length);
    }
    reactions.into_iter().map(Sum::finished).collect()
}

/// The parts of a linear load on each piece: piece, ends, values at both.
fn cut(nodes: &[f64], [from, to]: [f64; 2], ends: [f64; 2]) -> Vec<(usize, [f64; 2], [f64; 2])> {
    let [start, end] = ends;
    let at = |x: f64| {
        if x == from {
            start
        } else if x == to {
            end
        } else {
            (start * (to - x) + end * (x - from)) / (to - from)
        }
    };
    let part = |(piece, node): (usize, &[f64])| {
        let x = [node[0].max(from), node[1].min(to)];
        (x[0] < x[1]).then(|| (piece, x, x.map(at)))
    };
    let first = nodes.partition_point(|node| *node <= from).saturating_sub(1);
    let end = nodes.partition_point(|node| *node < to).max(first + 1);
    let pieces = nodes[first..nodes.len().min(end + 1)].windows(2);
    pieces.enumerate().filter_map(|(i, ends)| part((first + i, ends))).collect()
}
