//! Computes a basis of the free rigid motions of the beam from the constraints of its supports and hinges.

use crate::existence::rigid_motions::Mechanism;
use crate::model::Model;
use crate::numeric::tolerance::SUM_ROUNDING;

/// A basis of the rigid motions that only the ground prevents. Each motion has the value 1 at its own free node, and 0
/// at the other free nodes.
#[derive(Debug)]
pub(crate) struct FreeMotions {
    mechanism: Mechanism,
    /// The free nodes: ends and free hinges of the beam. Supports there prevent all motions of the basis, and carry no
    /// force if the loads are in equilibrium.
    free: Vec<usize>,
    /// Values of each motion at the ends and free hinges of the beam. No value is greater than 1.
    values: Vec<Vec<f64>>,
}

impl FreeMotions {
    pub fn of(model: &Model) -> Self {
        Self::of_mechanism(Mechanism::of(model))
    }

    /// Solves the constraints on the values at the nodes by Gaussian elimination. Each constraint determines the value
    /// with its largest coefficient. The values that remain are those at the free nodes.
    fn of_mechanism(mechanism: Mechanism) -> Self {
        // Each row has a 1 at its own determined node, and zeros at the determined nodes of the other rows.
        let mut rows: Vec<(usize, Vec<f64>)> = Vec::new();
        for mut row in mechanism.constraints() {
            for (node, other) in &rows {
                eliminate(&mut row, *node, other);
            }
            let largest = (0..row.len()).max_by(|a, b| row[*a].abs().total_cmp(&row[*b].abs()));
            // Nothing remains of a constraint that follows from the previous constraints.
            let Some(node) = largest.filter(|node| row[*node].abs() > SUM_ROUNDING) else {
                continue;
            };
            let pivot = row[node];
            row.iter_mut().for_each(|a| *a /= pivot);
            for (_, other) in &mut rows {
                eliminate(other, node, &row);
            }
            rows.push((node, row));
        }
        let nodes = mechanism.nodes.len();
        let is_free = |node: &usize| rows.iter().all(|(determined, _)| determined != node);
        let free: Vec<usize> = (0..nodes).filter(is_free).collect();
        let motion = |own: &usize| {
            let mut values = vec![0.0; nodes];
            values[*own] = 1.0;
            for (node, row) in &rows {
                values[*node] = -row[*own];
            }
            values
        };
        let values = free.iter().map(motion).collect();
        FreeMotions { mechanism, free, values }
    }

    /// Positions of the free nodes.
    pub fn positions(&self) -> impl Iterator<Item = f64> {
        self.free.iter().map(|node| self.mechanism.nodes[*node])
    }

    /// Whether supports do not restrain any motion, so that all ends and free hinges are free nodes.
    pub fn are_unrestrained(&self) -> bool {
        self.free.len() == self.mechanism.nodes.len()
    }

    /// Returns the deflections of each motion at the positions `x`.
    pub fn deflections(&self, x: &[f64]) -> Vec<Vec<f64>> {
        let at = |values: &Vec<f64>, x: f64| {
            let [a, b] = self.mechanism.weights_at(x).map(|(node, weight)| weight * values[node]);
            a + b
        };
        self.values.iter().map(|values| x.iter().map(|x| at(values, *x)).collect()).collect()
    }
}

/// Subtracts the multiple of `other` for which `row` is zero at `node`. There, `other` is 1.
fn eliminate(row: &mut [f64], node: usize, other: &[f64]) {
    let factor = row[node];
    row.iter_mut().zip(other).for_each(|(a, b)| *a -= factor * b);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::existence::rigid_motions::tests::{mechanisms, rank};
    use crate::model::{Beam, Foundation, Hinge, Support};

    /// The basis has as many motions as the constraints leave free, and every motion satisfies the constraints.
    #[test]
    fn the_motions_satisfy_the_constraints_and_none_is_missing() {
        for mechanism in mechanisms() {
            let rows = mechanism.constraints();
            let found = FreeMotions::of_mechanism(mechanism.clone());
            let count = mechanism.nodes.len() - rank(rows.clone());
            assert_eq!(found.free.len(), count, "{mechanism:?}");
            for (own, values) in found.free.iter().zip(&found.values) {
                let sum = |row: &Vec<f64>| row.iter().zip(values).map(|(a, r)| a * r).sum::<f64>();
                assert!(rows.iter().all(|row| sum(row).abs() < 1e-15), "{mechanism:?}");
                assert!(values.iter().all(|r| r.abs() <= 1.0 + 1e-15), "{mechanism:?}");
                for free in &found.free {
                    assert_eq!(values[*free], f64::from(u8::from(free == own)), "{mechanism:?}");
                }
            }
        }
    }

    /// The lever of the left piece turns about its pin, which lies nearer to the hinge. The right piece turns about
    /// the hinge.
    #[test]
    fn a_pin_makes_a_lever_of_its_piece() {
        let model = Model::new(Beam::uniform(8.0, 1.0), Foundation::winkler(1.0))
            .with_hinge(Hinge::free(4.0))
            .with_hinge(Hinge::elastic(6.0, 1.0))
            .with_support(Support::pinned(3.0));
        let found = FreeMotions::of(&model);
        assert!(!found.are_unrestrained());
        assert_eq!(found.positions().collect::<Vec<f64>>(), [0.0, 8.0]);
        let motions = found.deflections(&[0.0, 3.0, 4.0, 6.0, 8.0]);
        let wanted = [[1.0, 0.0, -1.0 / 3.0, -1.0 / 6.0, 0.0], [0.0, 0.0, 0.0, 0.5, 1.0]];
        for (found, wanted) in motions.iter().zip(wanted) {
            assert!(found.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 1e-15), "{motions:?}");
        }
    }
}
