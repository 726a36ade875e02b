//! Exact balance: a moment in equilibrium with the loads, after pressures and reactions change by small factors.
//!
//! The beam is cut at its ends, at free hinges and at chosen nodes. In each cell a moment δ balances the
//! residual. δ vanishes at the cuts (at a free hinge M + δ vanishes). A force E_j remains at cut j. It is
//! distributed over the forces that carry the beam. Pressures and concentrated forces are multiplied by 1 +
//! λ, with λ continuous and linear between the cuts. Supports carry a share by their weights W_i for force
//! and W_θi for rotation. With φ_j the hat functions of the cuts
//!
//! ```text
//! Σ_k M_jk λ_k = E_j,   M_jk = ∫φ_jφ_k p + Σ a_i φ_jφ_k + Σ W_i φ_jφ_k + Σ W_θi φ_j′φ_k′.
//! ```
//!
//! Tensile pressures are omitted; the intervals of E_j and M_jk grow by at most their resultant ηω.
//!
//! The tension can also carry a share: with any B > 0 it adds ∫Bφ_j′φ_k′ to M_jk and the transverse force β =
//! Bλ′ to each cell. A single pressure, force or support then makes the system positive definite. The tension
//! is used only if pressures and supports alone cannot balance the loads, because it adds ∫β²/P to the bound.

use crate::frame::Frame;
use crate::ground::Surface;
use crate::pressure::Pressure;
use crate::refusal::NotProven;
use crate::residual::Residual;
use crate::scalar::Scalar;
use crate::size::Size;

/// Input of the balance: the fields of the answer and the cuts of the beam.
pub(crate) struct Balance<'a, S> {
    pub frame: &'a Frame<S>,
    pub surface: &'a Surface<S>,
    pub pressures: &'a [Pressure<S>],
    pub residual: &'a Residual<S>,
    /// Indices of the nodes, including the first and the last one.
    pub cuts: Vec<usize>,
    /// B; 0 if the tension carries no load.
    pub carrier: f64,
}

/// The exact balance.
#[derive(Debug)]
pub(crate) struct Balanced<S> {
    /// The nodes at which the beam is cut.
    pub cuts: Vec<usize>,
    /// B; 0 if the tension carries no load.
    pub carrier: f64,
    /// λ at the nodes.
    pub factors: Vec<S>,
    pub pieces: Vec<BalancedPiece<S>>,
}

/// The exact balance on one piece.
#[derive(Debug, Clone, Copy)]
pub(crate) struct BalancedPiece<S> {
    /// |λ′| in the cell of the piece.
    pub steepness: Size,
    /// δ at both ends, without the contribution of the redistributed forces.
    pub moments: [S; 2],
    /// −δ′ at both ends, without the contribution of the redistributed forces.
    pub shears: [S; 2],
    /// Bounds of the moment and of the shear force that the redistributed forces add in the cell.
    pub added: [Size; 2],
    /// |β|, the transverse force carried by the tension.
    pub drawn: Size,
}

impl<S: Scalar> Balanced<S> {
    /// max|λ| on a piece.
    pub fn factor(&self, piece: usize) -> Size {
        Size::of(self.factors[piece].size()).worst(Size::of(self.factors[piece + 1].size()))
    }
}

/// One cell between two cuts.
struct Cell<S> {
    pieces: std::ops::Range<usize>,
    ends: [S; 2],
    length: S,
}

/// The tridiagonal system for λ at the cuts.
struct System<S> {
    rows: Vec<Row<S>>,
}

/// The equation of one cut.
#[derive(Clone, Copy)]
struct Row<S> {
    diagonal: S,
    /// The matrix entry that couples this cut with the next one.
    beside: S,
    right: S,
}

impl<S: Scalar> System<S> {
    fn of(cuts: usize) -> Self {
        let zero = S::zero();
        System { rows: vec![Row { diagonal: zero, beside: zero, right: zero }; cuts] }
    }

    /// Gaussian elimination; `None` if a pivot may be zero or negative.
    fn solved(mut self) -> Option<Vec<S>> {
        let rows = &mut self.rows;
        if rows.iter().all(|row| row.right == S::zero()) {
            // No force remains to be distributed.
            return Some(rows.iter().map(|row| row.right).collect());
        }
        for j in 0..rows.len() {
            let row = rows[j];
            if !(row.diagonal.low() > 0.0) {
                return None;
            }
            if let Some(next) = rows.get_mut(j + 1) {
                let factor = row.beside.div(row.diagonal);
                next.diagonal = next.diagonal - factor * row.beside;
                next.right = next.right - factor * row.right;
            }
        }
        let mut solution = vec![S::zero(); rows.len()];
        for (j, row) in rows.iter().enumerate().rev() {
            let right = match solution.get(j + 1) {
                Some(next) => row.right - row.beside * *next,
                None => row.right,
            };
            solution[j] = right.div(row.diagonal);
        }
        Some(solution)
    }
}

impl<S: Scalar> Balance<'_, S> {
    pub fn solve(&self) -> Result<Balanced<S>, NotProven> {
        let pieces = self.frame.spans.len();
        let nothing = BalancedPiece {
            steepness: Size::ZERO,
            moments: [S::zero(); 2],
            shears: [S::zero(); 2],
            added: [Size::ZERO; 2],
            drawn: Size::ZERO,
        };
        let mut balanced = Balanced {
            cuts: self.cuts.clone(),
            carrier: self.carrier,
            factors: vec![S::zero(); pieces + 1],
            pieces: vec![nothing; pieces],
        };
        let mut system = System::of(self.cuts.len());
        for (j, node) in self.cuts.iter().enumerate() {
            system.rows[j].right = system.rows[j].right + self.residual.nodes[*node][0];
            system.rows[j].diagonal = system.rows[j].diagonal + self.carried_at(*node);
        }
        for j in 0..self.cuts.len() - 1 {
            let cell = self.cell(j);
            let [left, right] = self.shear_forces(&cell, &mut balanced);
            system.rows[j].right = system.rows[j].right - left;
            system.rows[j + 1].right = system.rows[j + 1].right + right;
            self.masses(&cell, j, &mut system);
        }
        let no_lever = || {
            NotProven::new("contact pressure and supports cannot balance the moment of the loads")
        };
        let factors = system.solved().ok_or_else(no_lever)?;
        for j in 0..self.cuts.len() - 1 {
            self.give_back(&self.cell(j), [factors[j], factors[j + 1]], &mut balanced);
        }
        let unsafe_factor = |i: &usize| {
            let presses =
                self.surface.nodes[*i].force.size() > 0.0 || self.residual.pushing[*i].size() > 0.0;
            presses && !(balanced.factors[*i].size() < 0.5)
        };
        let piece = (0..pieces)
            .find(|i| self.frame.spans[*i].touches && !(balanced.factor(*i).value() < 0.5));
        match piece.or_else(|| (0..=pieces).find(unsafe_factor)) {
            Some(node) => Err(no_lever().at(self.frame.place(node))),
            None => Ok(balanced),
        }
    }

    fn cell(&self, j: usize) -> Cell<S> {
        let pieces = self.cuts[j]..self.cuts[j + 1];
        let ends = [self.frame.nodes[pieces.start].x, self.frame.nodes[pieces.end].x];
        Cell { pieces, ends, length: ends[1] - ends[0] }
    }

    /// The weight at a node: its concentrated force, the weights of its supports, and the reaction of a one-way
    /// support.
    fn carried_at(&self, node: usize) -> S {
        let weights = &self.frame.nodes[node].weights;
        self.surface.nodes[node].force
            + S::of(weights.rigid)
            + S::of(weights.spring)
            + self.residual.pushing[node]
    }

    /// The weight for rotation of a cell: the clamps and rotational springs at its left end and inside; in the last
    /// cell also those at the right end of the beam.
    fn turned_in(&self, cell: &Cell<S>) -> S {
        let nodes = &self.frame.nodes;
        let last = cell.pieces.end + 1 == nodes.len();
        let all = cell.pieces.start..cell.pieces.end + usize::from(last);
        let weights = nodes[all].iter().map(|node| &node.weights);
        weights.fold(S::zero(), |sum, weights| sum + S::of(weights.clamp) + S::of(weights.turning))
    }

    /// δ just inside the two ends of a cell.
    fn end_moments(&self, cell: &Cell<S>) -> [S; 2] {
        let (first, last) = (cell.pieces.start, cell.pieces.end);
        let nodes = &self.frame.nodes;
        let left = if nodes[first].is_free_hinge() {
            -self.residual.pieces[first].bending[0]
        } else {
            self.residual.nodes[first][1]
        };
        let right = if nodes[last].is_free_hinge() {
            -self.residual.pieces[last - 1].bending[1]
        } else if last + 1 == nodes.len() {
            -self.residual.nodes[last][1]
        } else {
            S::zero()
        };
        [left, right]
    }

    /// Computes δ along a cell, and −δ′ at the two ends of each piece.
    fn shear_forces(&self, cell: &Cell<S>, balanced: &mut Balanced<S>) -> [S; 2] {
        let [left, right] = self.end_moments(cell);
        let inner = |i: usize| {
            if i > cell.pieces.start { self.residual.nodes[i] } else { [S::zero(); 2] }
        };
        let mut moment = left - right;
        for i in cell.pieces.clone() {
            let (piece, [force, turn]) = (&self.residual.pieces[i], inner(i));
            let end = self.frame.nodes[i + 1].x;
            let levers = [cell.ends[1] - self.frame.nodes[i].x, cell.ends[1] - end];
            moment = moment + turn - force * levers[0] - piece.moment - piece.force * levers[1];
        }
        let first = moment.div(cell.length);
        let (mut shear, mut delta) = (first, left);
        for i in cell.pieces.clone() {
            let (piece, [force, turn]) = (&self.residual.pieces[i], inner(i));
            (shear, delta) = (shear + force, delta + turn);
            let after = delta - shear * self.frame.spans[i].h - piece.moment;
            balanced.pieces[i].moments = [delta, after];
            balanced.pieces[i].shears = [shear, shear + piece.force];
            (shear, delta) = (shear + piece.force, after);
        }
        [first, shear]
    }

    /// Adds ∫φ_jφ_k p, the forces at inner nodes and the clamps to the system. Widens the intervals for
    /// tensile pressures.
    fn masses(&self, cell: &Cell<S>, j: usize, system: &mut System<S>) {
        let per_length = S::one().div(cell.length);
        let mut add = |mass: S, [a, b]: [S; 2]| {
            system.rows[j].diagonal = system.rows[j].diagonal + mass * a * a;
            system.rows[j + 1].diagonal = system.rows[j + 1].diagonal + mass * b * b;
            system.rows[j].beside = system.rows[j].beside + mass * a * b;
        };
        for node in cell.pieces.start + 1..cell.pieces.end {
            let x = self.frame.nodes[node].x;
            let hats = [(cell.ends[1] - x) * per_length, (x - cell.ends[0]) * per_length];
            add(self.carried_at(node), hats);
        }
        add(self.turned_in(cell), [-per_length, per_length]);
        if self.carrier > 0.0 {
            add(S::of(self.carrier) * cell.length, [-per_length, per_length]);
        }
        let mut tensile = Size::ZERO;
        for i in cell.pieces.clone().filter(|i| self.frame.spans[*i].touches) {
            let span = &self.frame.spans[i];
            let slope = span.half * per_length;
            let hats = [
                [(cell.ends[1] - span.middle) * per_length, -slope],
                [(span.middle - cell.ends[0]) * per_length, slope],
            ];
            // ∫(a + bt)(c + dt)p.
            let [whole, turned, spread] = self.pressures[i].masses;
            let mass = |[a, b]: [S; 2], [c, d]: [S; 2]| {
                a * c * whole + (a * d + b * c) * turned + b * d * spread
            };
            system.rows[j].diagonal = system.rows[j].diagonal + mass(hats[0], hats[0]);
            system.rows[j].beside = system.rows[j].beside + mass(hats[0], hats[1]);
            system.rows[j + 1].diagonal = system.rows[j + 1].diagonal + mass(hats[1], hats[1]);
            tensile += self.pressures[i].tensile_force();
        }
        for row in system.rows.iter_mut().skip(j).take(2) {
            row.diagonal = row.diagonal.widened(tensile.value());
            row.right = row.right.widened(tensile.value());
        }
        system.rows[j].beside = system.rows[j].beside.widened(tensile.value());
    }

    /// λ on a cell, and bounds of the moment and shear force that the redistributed forces add there. On a
    /// simply supported cell of length h, a load F causes a moment of at most Fh/4 and a shear force of at
    /// most F. A couple C causes a moment of at most C and a shear force of at most C/h.
    fn give_back(&self, cell: &Cell<S>, ends: [S; 2], balanced: &mut Balanced<S>) {
        let per_length = S::one().div(cell.length);
        let slope = (ends[1] - ends[0]) * per_length;
        for i in cell.pieces.start..=cell.pieces.end {
            let x = self.frame.nodes[i].x;
            // Each hat function is computed separately, because 1 − φ has a large relative radius near an
            // end.
            let hats = [(cell.ends[1] - x) * per_length, (x - cell.ends[0]) * per_length];
            balanced.factors[i] = match i {
                _ if i == cell.pieces.start => ends[0],
                _ if i == cell.pieces.end => ends[1],
                _ => hats[0] * ends[0] + hats[1] * ends[1],
            };
        }
        let mut load = Size::ZERO;
        for i in cell.pieces.clone() {
            let factor = balanced.factor(i);
            let pressure = &self.pressures[i];
            load += factor * Size::of(pressure.masses[0].size());
            load += (Size::of(1.0) + factor) * pressure.tensile_force();
            if i > cell.pieces.start {
                let at_node = Size::of(balanced.factors[i].size());
                load += at_node * Size::of(self.carried_at(i).size());
            }
        }
        let couple = Size::of(self.turned_in(cell).size()) * Size::of(slope.size());
        let (high, low) = (Size::of(cell.length.high()), cell.length.low());
        let added = [0.25 * (high * load) + couple, load + couple.over(low)];
        for i in cell.pieces.clone() {
            balanced.pieces[i].added = added;
            balanced.pieces[i].steepness = Size::of(slope.size());
            balanced.pieces[i].drawn = Size::of(self.carrier) * balanced.pieces[i].steepness;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Balance;
    use crate::cuts::fewest_cuts;
    use crate::fields::Fields;
    use crate::given_claim::with_fields;
    use crate::scalar::Scalar;
    use crate::size::Size;
    use serde_json::json;

    /// A claim that pulls on the ground, p = x − 0.1, under an equal load: without the tension 0.005 of the load is not balanced.
    /// It is a load of the beam, as are the redistributed pressures.
    #[test]
    fn omitted_tension_is_a_load_of_the_beam() {
        let text = "[beam]\nlength = 2\nEI = 1\n[foundation]\nk = 1\n[[load]]\ndistributed = [-0.1, 1.9]\n";
        let document = json!({"pieces": [
            {"x": [0, 2], "half": 1, "touches": true, "deflection": [0.9, 1.0]},
        ]});
        with_fields(text, &document, |fields| {
            let Fields { frame, surface, pressures, residual, .. } = fields;
            let cuts = fewest_cuts(frame);
            let balance = Balance { frame, surface, pressures, residual, cuts, carrier: 0.0 };
            let balanced = balance.solve().expect("a balance");
            let factor = balanced.factor(0);
            let pressing = factor * Size::of(pressures[0].masses[0].size());
            let load = pressing + (Size::of(1.0) + factor) * pressures[0].tensile_force();
            let [moment, shear] = balanced.pieces[0].added;
            let lever = 0.25 * frame.length.high();
            for (bound, exact) in [(shear, load.value()), (moment, lever * load.value())] {
                assert!((bound.value() / exact - 1.0).abs() < 1e-12, "{bound:?} {exact}");
            }
            let least = frame.units.scaled(0.005, 1, 0);
            assert!((1.0..4.0).contains(&(pressures[0].tensile_force().value() / least)));
            assert!(
                balanced.factors.iter().all(|factor| 0.002 < factor.size() && factor.size() < 0.2)
            );
        });
    }
}
