//! Computes from the loads the static reactions at the beam ends and free hinges, by equation (4.25) of Kikuchi's paper.

use crate::model::{Action, Extent, Load, triangles};
use crate::numeric::sum::Sum;

/// Returns the static reaction at each node: the work of the loads in the hat function of the node, which is 1 there
/// and 0 at other nodes. It is the force of a support there if all pieces are rigid.
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
        // Loads on the ground do no work on the beam.
        if load.on_ground {
            continue;
        }
        match (load.action, load.extent) {
            (Action::Force, Extent::Point { at, size }) => force_at(holding(at), size, at),
            (Action::Force, Extent::Distributed { from, to, start, end }) => {
                for (piece, ends, sizes) in cut(nodes, [from, to], [start, end]) {
                    for (force, x) in triangles(ends, sizes) {
                        force_at(piece, force, x);
                    }
                }
            }
            (Action::Moment, Extent::Point { at, size }) => moments.push((holding(at), size)),
            (Action::Moment, Extent::Distributed { from, to, start, end }) => {
                for (piece, [a, b], [start, end]) in cut(nodes, [from, to], [start, end]) {
                    moments.push((piece, 0.5 * (start + end) * (b - a)));
                }
            }
            // An imposed curvature does no work in a rigid motion.
            (Action::Curvature, _) => {}
        }
    }
    for (piece, moment) in moments {
        let length = nodes[piece + 1] - nodes[piece];
        reactions[piece].add(-moment / length);
        reactions[piece + 1].add(moment / length);
    }
    reactions.into_iter().map(Sum::finished).collect()
}

/// Cuts a linearly varying load at the nodes. Returns, for each part, the index of its piece, its end positions and its
/// end values.
pub(crate) fn cut(
    nodes: &[f64],
    [from, to]: [f64; 2],
    ends: [f64; 2],
) -> Vec<(usize, [f64; 2], [f64; 2])> {
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

    /// Returns the work of a load in a motion r that is linear between nodes, by Simpson's rule on each piece.
    /// The rule is exact, because the integrand of a linear load is a parabola.
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
            (Action::Curvature, _) => 0.0,
        }
    }

    /// The static reaction at each node is the work F(φ) of the load in the hat function φ of the node.
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
            // The lever rule divides a force between the two neighbouring nodes. `size` is the absolute value
            // of each node's share, so the sizes sum to the absolute force 3.
            let shared = static_reactions(&[Load::point_force(3.0, -3.0)], &nodes);
            assert_eq!(shared.iter().map(|found| found.size).sum::<f64>(), 3.0);
            // The reaction to all loads together is the sum of the reactions to each load.
            let all = static_reactions(&loads, &nodes);
            for (i, found) in all.iter().enumerate() {
                let each = loads.iter().map(|load| static_reactions(&[*load], &nodes)[i].sum);
                assert!((found.sum - each.sum::<f64>()).abs() < 1e-14 * found.size);
            }
        }
    }

    /// A load is cut at the nodes. Its parts have interpolated values at the nodes and the given values at the
    /// ends of the load.
    #[test]
    fn a_distributed_load_is_cut_at_the_nodes() {
        let nodes = [0.0, 2.0, 4.0, 8.0];
        let found = cut(&nodes, [1.0, 5.0], [3.0, 7.0]);
        let wanted =
            [(0, [1.0, 2.0], [3.0, 4.0]), (1, [2.0, 4.0], [4.0, 6.0]), (2, [4.0, 5.0], [6.0, 7.0])];
        assert_eq!(found, wanted);
        // A load from node to node has no part on the neighbouring pieces.
        assert_eq!(cut(&nodes, [2.0, 4.0], [0.1, 0.7]), [(1, [2.0, 4.0], [0.1, 0.7])]);
    }
}
