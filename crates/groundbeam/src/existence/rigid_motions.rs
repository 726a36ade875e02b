//! How a beam may move without bending: straight between its ends and its free hinges.
//!
//! A rigid motion is given by its values at these *nodes*; between two of them is a *piece*, straight. An
//! elastic hinge resists a kink, and is no node. Since r is straight in between, r ≤ 0 all along exactly if
//! r ≤ 0 at every node.

use crate::model::{Acts, Extent, Load, Model, SupportKind, triangles};
use crate::numeric::tolerance::same_place;
use std::ops::Range;

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
        (x - self.nodes[node]).abs() <= same_place(l)
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
        // What acts on the ground does no work on the beam.
        if load.on_ground {
            continue;
        }
        match (load.action.derivative(), load.extent) {
            (0, Extent::Point { at, size }) => force_at(holding(at), size, at),
            (0, Extent::Distributed { from, to, start, end }) => {
                for (piece, ends, sizes) in cut(nodes, [from, to], [start, end]) {
                    for (force, x) in triangles(ends, sizes) {
                        force_at(piece, force, x);
                    }
                }
            }
            (1, Extent::Point { at, size }) => moments.push((holding(at), size)),
            (1, Extent::Distributed { from, to, start, end }) => {
                for (piece, [a, b], [start, end]) in cut(nodes, [from, to], [start, end]) {
                    moments.push((piece, 0.5 * (start + end) * (b - a)));
                }
            }
            // A rigid motion has no curvature.
            _ => {}
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Action;
    use crate::model::{Beam, Foundation, Hinge, Support};

    /// A beam from 0 to 8 with free hinges.
    fn beam(hinges: &[f64]) -> Model {
        let mut model = Model::new(Beam::uniform(8.0, 1.0), Foundation::winkler(1.0));
        model.hinges = hinges.iter().map(|x| Hinge::free(*x)).collect();
        model
    }

    /// The first node of each free group, and the one after its last.
    fn groups(of: &Mechanism) -> Vec<[usize; 2]> {
        of.free_groups().into_iter().map(|group| [group.start, group.end]).collect()
    }

    /// The smallest distance that makes two positions of the beam different.
    const APART: f64 = 17.0 * f64::EPSILON * 8.0;

    #[test]
    fn nodes_are_the_ends_and_the_free_hinges_from_left_to_right() {
        let model = beam(&[6.0, 2.0]).with_hinge(Hinge::elastic(4.0, 1.0));
        assert_eq!(Mechanism::of(&model).nodes, [0.0, 2.0, 6.0, 8.0]);
        let pieces = [0.0, 1.0, 2.0, 5.0, 6.0, 7.0, 8.0].map(|x| Mechanism::of(&model).piece_at(x));
        assert_eq!(pieces, [0, 0, 1, 1, 2, 2, 2]);
    }

    #[test]
    fn what_each_support_keeps_from_moving() {
        let seen = |support: Support| {
            let found = Mechanism::of(&beam(&[2.0, 6.0]).with_support(support));
            (found.held, found.straight)
        };
        let none = vec![false; 3];
        let middle = vec![false, true, false];
        assert_eq!(seen(Support::pinned(3.0)), (vec![3.0], none.clone()));
        assert_eq!(seen(Support::fixed(3.0)), (vec![3.0], middle.clone()));
        assert_eq!(seen(Support::spring(3.0, 1.0, 0.0)), (vec![3.0], none.clone()));
        assert_eq!(seen(Support::spring(3.0, 0.0, 1.0)), (vec![], middle));
        assert_eq!(seen(Support::spring(3.0, 0.0, 0.0)), (vec![], none.clone()));
        // A hold-down keeps the beam from lifting, a bearing does not.
        assert_eq!(seen(Support::pinned(3.0).acting(Acts::Down)), (vec![3.0], none.clone()));
        assert_eq!(seen(Support::pinned(3.0).acting(Acts::Up)), (vec![], none));
    }

    #[test]
    fn tension_keeps_every_piece_from_turning() {
        let mut model = beam(&[2.0, 6.0]);
        model.beam.axial_force = 1.0;
        let found = Mechanism::of(&model);
        assert_eq!(found.straight, [true; 3]);
        // The whole beam still lifts as one, unless a place of it is held.
        assert_eq!(groups(&found), [[0, 4]]);
        let held = Mechanism::of(&model.with_support(Support::pinned(7.0)));
        assert!(held.free_groups().is_empty());
        assert_eq!(held.first_loose(&[]), None);
    }

    /// All mechanisms of up to three pieces on supports at any of a few places, with any pieces kept straight.
    fn mechanisms() -> Vec<Mechanism> {
        let mut all = Vec::new();
        for hinges in [vec![], vec![4.0], vec![2.0, 4.0]] {
            let nodes = Mechanism::of(&beam(&hinges)).nodes;
            let places: Vec<f64> = nodes.iter().copied().chain([1.0, 3.0, 5.0, 7.0]).collect();
            for held in 0..1_u32 << places.len() {
                let own = places.iter().enumerate().filter(|(i, _)| held >> i & 1 == 1);
                let own: Vec<f64> = own.map(|(_, x)| *x).collect();
                for straight in 0..1_u32 << (nodes.len() - 1) {
                    let straight = (0..nodes.len() - 1).map(|i| straight >> i & 1 == 1);
                    let straight = straight.collect();
                    all.push(Mechanism { nodes: nodes.clone(), held: own.clone(), straight });
                }
            }
        }
        all
    }

    /// The constraints on the values r at the nodes, one row each: r = 0 at the held places, equal values at both
    /// ends of a piece that may not turn.
    fn constraints(of: &Mechanism) -> Vec<Vec<f64>> {
        let row = |entries: &[(usize, f64)]| {
            let mut row = vec![0.0; of.nodes.len()];
            entries.iter().for_each(|(i, a)| row[*i] += a);
            row
        };
        let at = |x: f64| {
            let i = (1..of.nodes.len() - 1).take_while(|i| of.nodes[*i] <= x).count();
            let t = (x - of.nodes[i]) / (of.nodes[i + 1] - of.nodes[i]);
            row(&[(i, 1.0 - t), (i + 1, t)])
        };
        let straight = (0..of.straight.len()).filter(|i| of.straight[*i]);
        let even = straight.map(|i| row(&[(i, 1.0), (i + 1, -1.0)]));
        of.held.iter().map(|x| at(*x)).chain(even).collect()
    }

    /// Gauß–Jordan elimination. Its numbers are small fractions, so that what is zero is smaller than 10⁻⁹.
    fn rank(mut rows: Vec<Vec<f64>>) -> usize {
        let mut rank = 0;
        for column in 0..rows.first().map_or(0, Vec::len) {
            let size = |row: &Vec<f64>| row[column].abs();
            let Some(pivot) =
                (rank..rows.len()).max_by(|a, b| size(&rows[*a]).total_cmp(&size(&rows[*b])))
            else {
                break;
            };
            if size(&rows[pivot]) < 1e-9 {
                continue;
            }
            rows.swap(rank, pivot);
            let used = rows[rank].clone();
            for row in &mut rows[rank + 1..] {
                let factor = row[column] / used[column];
                row.iter_mut().zip(&used).for_each(|(a, b)| *a -= factor * b);
            }
            rank += 1;
        }
        rank
    }

    /// A piece cannot move exactly if r = 0 at both of its nodes follows from the constraints: as further rows these two
    /// conditions do not raise the rank.
    #[test]
    fn the_first_loose_piece_is_the_first_whose_nodes_the_constraints_leave_free() {
        for of in mechanisms() {
            let rows = constraints(&of);
            let own = rank(rows.clone());
            let moves = |node: usize| {
                let mut unit = vec![0.0; of.nodes.len()];
                unit[node] = 1.0;
                rank(rows.iter().cloned().chain([unit]).collect()) > own
            };
            let piece = (0..of.straight.len()).find(|i| moves(*i) || moves(*i + 1));
            let wanted = piece.map(|i| [of.nodes[i], of.nodes[i + 1]]);
            assert_eq!(of.first_loose(&[]), wanted, "{of:?}");
            // Places held by contact count like those held by supports.
            let bare = Mechanism { held: vec![], ..of.clone() };
            assert_eq!(bare.first_loose(&of.held), wanted, "{of:?}");
            assert_eq!(bare.point_held(&of.held), of.held.first().copied());
        }
    }

    /// The free lifts with r = 0 or r = −1 at each node are closed under sums, since r ≤ 0: of two that overlap, the
    /// nodes they share lift alone as well. The groups are those that contain no smaller one.
    #[test]
    fn the_groups_are_the_smallest_free_lifts() {
        for of in mechanisms() {
            let rows = constraints(&of);
            let is_free = |lift: u32| {
                let r = |i: usize| f64::from(lift >> i & 1);
                rows.iter()
                    .all(|row| row.iter().enumerate().map(|(i, a)| a * r(i)).sum::<f64>() == 0.0)
            };
            let free: Vec<u32> =
                (1..1_u32 << of.nodes.len()).filter(|lift| is_free(*lift)).collect();
            let smallest =
                |lift: &u32| !free.iter().any(|other| other != lift && other & lift == *other);
            let mut wanted: Vec<u32> = free.iter().copied().filter(smallest).collect();
            wanted.sort_unstable();
            let bits = |group: Range<usize>| group.map(|node| 1_u32 << node).sum::<u32>();
            let found: Vec<u32> = of.free_groups().into_iter().map(bits).collect();
            assert_eq!(found, wanted, "{of:?}");
        }
    }

    /// A support within rounding of a hinge holds the hinge, and one further away the piece.
    #[test]
    fn a_support_at_a_hinge_holds_the_hinge_alone() {
        for x in [4.0 - 2.0 * f64::EPSILON, 4.0, 4.0 + 4.0 * f64::EPSILON] {
            let found = Mechanism::of(&beam(&[4.0]).with_support(Support::pinned(x)));
            assert_eq!(groups(&found), [[0, 1], [2, 3]], "{x}");
            // Held at 7 as well the right piece has two places; the left one turns about the hinge.
            assert_eq!(found.first_loose(&[7.0]), Some([0.0, 4.0]), "{x}");
            assert_eq!(found.first_loose(&[1.0, 7.0]), None, "{x}");
            // At 1 and at the hinge the left piece is held, by two places on it; the right one then by its hinge alone.
            assert_eq!(found.first_loose(&[1.0]), Some([4.0, 8.0]), "{x}");
        }
        let left = Mechanism::of(&beam(&[4.0]).with_support(Support::pinned(4.0 - APART)));
        assert_eq!(groups(&left), [[2, 3]]);
        assert_eq!(left.first_loose(&[1.0]), Some([4.0, 8.0]));
        let right = Mechanism::of(&beam(&[4.0]).with_support(Support::pinned(4.0 + APART)));
        assert_eq!(groups(&right), [[0, 1]]);
        assert_eq!(right.first_loose(&[1.0]), Some([0.0, 4.0]));
    }

    #[test]
    fn only_supports_that_act_both_ways_hold_a_beam_in_compression() {
        let fixed = beam(&[]).with_support(Support::fixed(0.0));
        assert!(held_rigidly(&fixed));
        assert!(!held_rigidly(&beam(&[]).with_support(Support::pinned(0.0))));
        assert!(!held_rigidly(&fixed.with_hinge(Hinge::free(4.0))));
        let pinned = |acts| {
            let end = Support::pinned(8.0).acting(acts);
            beam(&[]).with_support(Support::pinned(0.0)).with_support(end)
        };
        assert!(held_rigidly(&pinned(Acts::Both)));
        assert!(!held_rigidly(&pinned(Acts::Up)) && !held_rigidly(&pinned(Acts::Down)));
        // Compression itself stops no rotation.
        let mut pushed = beam(&[]).with_support(Support::pinned(0.0));
        pushed.beam.axial_force = -1.0;
        assert!(!held_rigidly(&pushed));
    }

    fn sum(terms: &[f64]) -> Sum {
        let mut sum = Sum::default();
        terms.iter().for_each(|term| sum.add(*term));
        sum.finished()
    }

    /// What a plain sum loses, Neumaier's keeps. A hundredth of 2⁻⁵² is lost beside 1 in each addition.
    #[test]
    fn sums_are_right_to_the_last_bit() {
        let small = 0.01 * f64::EPSILON;
        let many = vec![small; 400];
        let exact = 1.0 + 4.0 * f64::EPSILON;
        let first = [vec![1.0], many.clone()].concat();
        let last = [many, vec![1.0]].concat();
        for sign in [1.0, -1.0] {
            let signed = |terms: &[f64]| terms.iter().map(|term| sign * term).collect::<Vec<_>>();
            assert_eq!(sum(&signed(&first)).sum, sign * exact);
            assert_eq!(sum(&signed(&last)).sum, sign * exact);
        }
        assert_eq!(sum(&[3.0, -4.0]).size, 7.0);
    }

    /// 8 ε of the sizes is rounding, more is not. Rounding becomes 0.
    #[test]
    fn zero_is_told_from_rounding_by_the_sizes() {
        let eps = f64::EPSILON;
        let of = |sum: f64| Sum { sum, compensation: 0.0, size: 2.0 };
        for (value, zero) in [(16.0 * eps, true), (17.0 * eps, false), (0.0, true), (1.0, false)] {
            assert_eq!(of(value).is_zero(), zero);
            assert_eq!(of(-value).is_zero(), zero);
            assert_eq!(of(-value).is_negative(), !zero);
            assert!(!of(value).is_negative());
            assert_eq!(of(value).finished().sum, if zero { 0.0 } else { value });
        }
        assert!(Sum::default().is_zero());
        let both = of(3.0).plus(Sum { sum: -5.0, compensation: 0.0, size: 5.0 });
        assert_eq!((both.sum, both.size), (-2.0, 7.0));
    }

    /// The work of a load in a motion r that is straight between nodes, by Simpson's rule on each piece: the work
    /// of a linear load there is the integral of a parabola.
    fn work(load: &Load, nodes: &[f64], r: &[f64]) -> f64 {
        let piece = |x: f64| nodes.partition_point(|node| *node <= x).clamp(1, nodes.len() - 1) - 1;
        let slope = |i: usize| (r[i + 1] - r[i]) / (nodes[i + 1] - nodes[i]);
        let value = |i: usize, x: f64| r[i] + slope(i) * (x - nodes[i]);
        let spread =
            |[from, to]: [f64; 2], [start, end]: [f64; 2], of: &dyn Fn(usize, f64) -> f64| {
                let parts = (0..nodes.len() - 1).map(|i| {
                    let (a, b) = (nodes[i].max(from), nodes[i + 1].min(to));
                    let f = |x: f64| (start + (end - start) * (x - from) / (to - from)) * of(i, x);
                    (b - a).max(0.0) / 6.0 * (f(a) + 4.0 * f(0.5 * (a + b)) + f(b))
                });
                parts.sum::<f64>()
            };
        if load.is_on_ground() {
            return 0.0;
        }
        match (load.action(), load.extent()) {
            (Action::Force, Extent::Point { at, size }) => size * value(piece(at), at),
            (Action::Moment, Extent::Point { at, size }) => size * slope(piece(at)),
            (Action::Force, extent) => spread(extent.ends(), extent.sizes(), &value),
            (Action::Moment, extent) => spread(extent.ends(), extent.sizes(), &|i, _| slope(i)),
            _ => 0.0,
        }
    }

    /// R at each node is F(φ) of its hat function, and the moments of all R about 0 are those of the load.
    #[test]
    fn static_reactions_are_the_work_of_the_loads_in_the_hat_functions() {
        let spread = |from: f64, to: f64, start: f64, end: f64| {
            [
                Load::distributed_force(from, to, start, end),
                Load::distributed_moment(from, to, start, end),
            ]
        };
        let mut loads = vec![Load::uniform_curvature(0.0, 8.0, 1.0)];
        loads.push(Load::ground_force(1.0, 5.0));
        loads.push(Load::distributed_ground_force(1.0, 2.0, 3.0, 5.0));
        for x in [0.0, 0.5, 2.0, 3.0, 6.5, 8.0] {
            loads.extend([Load::point_force(x, 3.0), Load::point_force(x, -2.0)]);
        }
        loads.extend([0.5, 3.0, 7.0].map(|x| Load::point_moment(x, 3.0)));
        for [from, to] in [[0.0, 8.0], [1.0, 7.0], [2.0, 5.0], [5.0, 8.0], [0.5, 1.5], [2.5, 4.5]] {
            loads.extend(spread(from, to, 1.0, 4.0));
            loads.extend(spread(from, to, -2.0, 1.0));
        }
        for nodes in [vec![0.0, 8.0], vec![0.0, 2.0, 5.0, 8.0]] {
            for load in &loads {
                let reactions = static_reactions(&[*load], &nodes);
                for (i, found) in reactions.iter().enumerate() {
                    let mut hat = vec![0.0; nodes.len()];
                    hat[i] = 1.0;
                    let wanted = work(load, &nodes, &hat);
                    assert!((found.sum - wanted).abs() < 1e-14 * 32.0, "{load:?} {i}: {found:?}");
                }
            }
            // A force is shared by the two nodes beside it, and so is its size.
            let shared = static_reactions(&[Load::point_force(3.0, -3.0)], &nodes);
            assert_eq!(shared.iter().map(|found| found.size).sum::<f64>(), 3.0);
            // Of all together the sum.
            let all = static_reactions(&loads, &nodes);
            for (i, found) in all.iter().enumerate() {
                let each = loads.iter().map(|load| static_reactions(&[*load], &nodes)[i].sum);
                assert!((found.sum - each.sum::<f64>()).abs() < 1e-14 * found.size);
            }
        }
    }

    /// A load is cut at the nodes, with the values of its straight line there, and those given at its ends.
    #[test]
    fn a_spread_load_is_cut_at_the_nodes() {
        let nodes = [0.0, 2.0, 4.0, 8.0];
        let found = cut(&nodes, [1.0, 5.0], [3.0, 7.0]);
        let wanted =
            [(0, [1.0, 2.0], [3.0, 4.0]), (1, [2.0, 4.0], [4.0, 6.0]), (2, [4.0, 5.0], [6.0, 7.0])];
        assert_eq!(found, wanted);
        // From node to node: nothing of it on the pieces beside.
        assert_eq!(cut(&nodes, [2.0, 4.0], [0.1, 0.7]), [(1, [2.0, 4.0], [0.1, 0.7])]);
    }
}
