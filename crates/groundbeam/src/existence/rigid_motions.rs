//! Finds the free rigid motions of the beam, (4.16), which are linear between its ends and its free hinges.
//!
//! The ends and free hinges are *nodes*, and a *piece* lies between two of them. The values at the nodes describe a
//! rigid motion. Elastic hinges resist kinks and are not nodes.

use crate::model::{Acts, Model, SupportKind};
use crate::numeric::tolerance::same_place;
use std::ops::Range;

/// The ends and free hinges of a beam, and the constraints that supports and tension impose on its rigid motions.
#[derive(Debug, Clone)]
pub(crate) struct Mechanism {
    /// The beam's ends and its free hinges, from left to right.
    pub nodes: Vec<f64>,
    /// Positions of the supports that restrain the deflection.
    held: Vec<f64>,
    /// Whether the rotation of each piece is prevented, by a support or by tension.
    straight: Vec<bool>,
}

impl Mechanism {
    /// Returns the nodes, and the constraints on upward motions of the beam. Any axial force counts as a constraint on
    /// the rotation of every piece. A support that only pushes up is not a constraint.
    pub fn of(model: &Model) -> Self {
        let mut mechanism = Self::on_supports(model, |acts| acts != Acts::Up);
        if model.beam.axial_force != 0.0 {
            mechanism.straight.fill(true);
        }
        mechanism
    }

    /// Returns the nodes of the model, with the constraints of those supports for which `counts` returns true.
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

    /// Returns the index of the piece that contains x. At a node between two pieces, this is the piece to the right of
    /// the node.
    fn piece_at(&self, x: f64) -> usize {
        let after = self.nodes.partition_point(|node| *node <= x);
        after.saturating_sub(1).min(self.straight.len() - 1)
    }

    fn is_at(&self, x: f64, node: usize) -> bool {
        let l = self.nodes[self.nodes.len() - 1];
        (x - self.nodes[node]).abs() <= same_place(l)
    }

    /// Returns the smallest groups of neighbouring nodes that can rise together while all other nodes stay at rest.
    /// Every free rigid motion is a sum of positive multiples of these lifts.
    pub fn free_groups(&self) -> Vec<Range<usize>> {
        let mut fixed = vec![false; self.nodes.len()];
        for &x in &self.held {
            match (0..self.nodes.len()).find(|node| self.is_at(x, *node)) {
                Some(node) => fixed[node] = true,
                // A linear function r ≤ 0 that is zero inside a piece is zero on the whole piece.
                None => {
                    let piece = self.piece_at(x);
                    (fixed[piece], fixed[piece + 1]) = (true, true);
                }
            }
        }
        let mut groups = Vec::new();
        let mut first = 0;
        for node in 0..self.nodes.len() {
            // Both nodes of a piece that cannot rotate rise equally.
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

    /// Returns the weights of the values at the nodes in the value at x of a motion.
    pub fn weights_at(&self, x: f64) -> [(usize, f64); 2] {
        let piece = self.piece_at(x);
        let [from, to] = [self.nodes[piece], self.nodes[piece + 1]];
        let share = if self.is_at(x, piece) {
            0.0
        } else if self.is_at(x, piece + 1) {
            1.0
        } else {
            (x - from) / (to - from)
        };
        [(piece, 1.0 - share), (piece + 1, share)]
    }

    /// Returns the constraints on the values at the nodes of a rigid motion, from left to right, one row each: zero at
    /// the held positions, and equal values at both nodes of a piece that cannot rotate.
    pub fn constraints(&self) -> Vec<Vec<f64>> {
        let row = |entries: [(usize, f64); 2]| {
            let mut row = vec![0.0; self.nodes.len()];
            for (node, weight) in entries {
                row[node] = weight;
            }
            row
        };
        let mut rows = Vec::new();
        for piece in 0..self.straight.len() {
            if self.straight[piece] {
                rows.push(row([(piece, 1.0), (piece + 1, -1.0)]));
            }
            let held = self.held.iter().filter(|x| self.piece_at(**x) == piece);
            rows.extend(held.map(|x| row(self.weights_at(*x))));
        }
        rows
    }

    /// Returns the position of the first support that restrains the deflection. Without such a support, returns
    /// the first position in `more`, if any.
    pub fn point_held(&self, more: &[f64]) -> Option<f64> {
        self.held.iter().chain(more).next().copied()
    }

    /// Returns the ends of the first piece that can move if the beam is also held at the positions `more`, or `None`. A
    /// piece with two constraints holds its neighbours. See *Uniqueness* in `docs/existence.md`.
    pub fn first_free_piece(&self, more: &[f64]) -> Option<[f64; 2]> {
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
        let mut free: Vec<usize> = (0..own.len()).collect();
        loop {
            let before = free.len();
            free.retain(|&i| {
                let held = own[i] + usize::from(fixed[i]) + usize::from(fixed[i + 1]);
                if held >= 2 {
                    (fixed[i], fixed[i + 1]) = (true, true);
                }
                held < 2
            });
            if free.len() == before {
                return free.first().map(|&i| [self.nodes[i], self.nodes[i + 1]]);
            }
        }
    }
}

/// Returns whether the two-way supports alone, without the ground, prevent every rigid motion of the beam.
pub(crate) fn held_rigidly(model: &Model) -> bool {
    Mechanism::on_supports(model, |acts| acts == Acts::Both).first_free_piece(&[]).is_none()
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::model::{Beam, Foundation, Hinge, Support};

    /// A beam from 0 to 8 with free hinges.
    fn beam(hinges: &[f64]) -> Model {
        let mut model = Model::new(Beam::uniform(8.0, 1.0), Foundation::winkler(1.0));
        model.hinges = hinges.iter().map(|x| Hinge::free(*x)).collect();
        model
    }

    /// Returns, for each group of nodes that can rise together, the index of its first node and the index after
    /// its last node.
    fn groups(of: &Mechanism) -> Vec<[usize; 2]> {
        of.free_groups().into_iter().map(|group| [group.start, group.end]).collect()
    }

    /// Distance along the beam at which two positions just count as different. Up to 16 machine epsilons times
    /// the beam length 8, they count as equal.
    const DISTINCT: f64 = 17.0 * f64::EPSILON * 8.0;

    #[test]
    fn nodes_are_the_ends_and_the_free_hinges_from_left_to_right() {
        let model = beam(&[6.0, 2.0]).with_hinge(Hinge::elastic(4.0, 1.0));
        assert_eq!(Mechanism::of(&model).nodes, [0.0, 2.0, 6.0, 8.0]);
        let pieces = [0.0, 1.0, 2.0, 5.0, 6.0, 7.0, 8.0].map(|x| Mechanism::of(&model).piece_at(x));
        assert_eq!(pieces, [0, 0, 1, 1, 2, 2, 2]);
    }

    #[test]
    fn constraints_of_each_support() {
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
        // A hold-down prevents lifting. A one-way bearing does not.
        assert_eq!(seen(Support::pinned(3.0).acting(Acts::Down)), (vec![3.0], none.clone()));
        assert_eq!(seen(Support::pinned(3.0).acting(Acts::Up)), (vec![], none));
    }

    #[test]
    fn tension_prevents_rotation_of_every_piece() {
        let mut model = beam(&[2.0, 6.0]);
        model.beam.axial_force = 1.0;
        let found = Mechanism::of(&model);
        assert_eq!(found.straight, [true; 3]);
        // The whole beam can lift as one group, unless a support prevents it.
        assert_eq!(groups(&found), [[0, 4]]);
        let held = Mechanism::of(&model.with_support(Support::pinned(7.0)));
        assert!(held.free_groups().is_empty());
        assert_eq!(held.first_free_piece(&[]), None);
    }

    /// Returns all mechanisms of up to three pieces, for every set of supports at a few positions and every set
    /// of pieces that cannot rotate.
    pub(crate) fn mechanisms() -> Vec<Mechanism> {
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

    /// Returns the rank of a matrix by Gaussian elimination. The entries of the matrix are simple fractions, so a pivot
    /// below 10⁻⁹ is a rounding error and counts as zero.
    pub(crate) fn rank(mut rows: Vec<Vec<f64>>) -> usize {
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

    /// A piece can move if and only if the constraint r = 0 at one of its nodes raises the rank of the constraints on
    /// the motion r.
    #[test]
    fn the_first_free_piece_follows_from_the_rank_of_the_constraints() {
        for of in mechanisms() {
            let rows = of.constraints();
            let own = rank(rows.clone());
            let moves = |node: usize| {
                let mut unit = vec![0.0; of.nodes.len()];
                unit[node] = 1.0;
                rank(rows.iter().cloned().chain([unit]).collect()) > own
            };
            let piece = (0..of.straight.len()).find(|i| moves(*i) || moves(*i + 1));
            let wanted = piece.map(|i| [of.nodes[i], of.nodes[i + 1]]);
            assert_eq!(of.first_free_piece(&[]), wanted, "{of:?}");
            // A position held by contact gives the same constraint as a position held by a support.
            let bare = Mechanism { held: vec![], ..of.clone() };
            assert_eq!(bare.first_free_piece(&of.held), wanted, "{of:?}");
            assert_eq!(bare.point_held(&of.held), of.held.first().copied());
        }
    }

    /// The test tries all motions in which each node rests or rises by one. The groups must be the smallest sets of
    /// nodes that rise in a free motion.
    #[test]
    fn the_groups_are_the_smallest_free_lifts() {
        for of in mechanisms() {
            let rows = of.constraints();
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

    /// A support within rounding error of a hinge prevents the lift-off of this hinge only. A support farther away
    /// prevents the lift-off of both ends of the piece on which it stands.
    #[test]
    fn a_support_at_a_hinge_holds_the_hinge_alone() {
        for x in [4.0 - 2.0 * f64::EPSILON, 4.0, 4.0 + 4.0 * f64::EPSILON] {
            let found = Mechanism::of(&beam(&[4.0]).with_support(Support::pinned(x)));
            assert_eq!(groups(&found), [[0, 1], [2, 3]], "{x}");
            // With a further support at x = 7, the right piece is held at two positions. The left piece can
            // still rotate about the hinge.
            assert_eq!(found.first_free_piece(&[7.0]), Some([0.0, 4.0]), "{x}");
            assert_eq!(found.first_free_piece(&[1.0, 7.0]), None, "{x}");
            // With a further support at x = 1, the left piece is held at two positions. The right piece is
            // held only at the hinge, so it can still rotate about the hinge.
            assert_eq!(found.first_free_piece(&[1.0]), Some([4.0, 8.0]), "{x}");
        }
        let left = Mechanism::of(&beam(&[4.0]).with_support(Support::pinned(4.0 - DISTINCT)));
        assert_eq!(groups(&left), [[2, 3]]);
        assert_eq!(left.first_free_piece(&[1.0]), Some([4.0, 8.0]));
        let right = Mechanism::of(&beam(&[4.0]).with_support(Support::pinned(4.0 + DISTINCT)));
        assert_eq!(groups(&right), [[0, 1]]);
        assert_eq!(right.first_free_piece(&[1.0]), Some([0.0, 4.0]));
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
        // Compression does not prevent rotation.
        let mut pushed = beam(&[]).with_support(Support::pinned(0.0));
        pushed.beam.axial_force = -1.0;
        assert!(!held_rigidly(&pushed));
    }
}
