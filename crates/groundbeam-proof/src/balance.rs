//! Computes a moment in exact equilibrium with the loads, after small relative changes of pressures and reactions.
//!
//! The beam is cut into cells. In each cell, a change of the claimed moment balances the residual of equilibrium. The
//! forces left at the cuts are distributed over pressures and supports by relative corrections λ, which solve (6) of
//! docs/proof.md. See *Balance* in its section 3.

use crate::frame::Frame;
use crate::ground::Surface;
use crate::pressure::Pressure;
use crate::refusal::NotProven;
use crate::residual::Residual;
use crate::scalar::Scalar;
use crate::size::Size;

/// Data for computing a moment in exact equilibrium with the loads: the claimed solution, and the nodes that divide
/// the beam into cells.
pub(crate) struct Balance<'a, S> {
    pub frame: &'a Frame<S>,
    pub surface: &'a Surface<S>,
    pub pressures: &'a [Pressure<S>],
    pub residual: &'a Residual<S>,
    /// Indices of the nodes at which the beam is cut, including the first and the last node.
    pub cuts: Vec<usize>,
    /// Factor B of the additional transverse force Bλ′ of the axial tension, with the relative correction λ of the
    /// pressure; 0 without this force.
    pub carrier: f64,
}

/// Relative correction λ of the contact pressures, and changes of moments, that restore exact equilibrium with the
/// loads.
#[derive(Debug)]
pub(crate) struct Balanced<S> {
    /// Indices of the nodes at which the beam is cut.
    pub cuts: Vec<usize>,
    /// Factor B of the additional transverse force Bλ′ of the axial tension, with the relative correction λ of the
    /// pressure; 0 without this force.
    pub carrier: f64,
    /// Relative correction λ at each node. Contact pressures and contact forces are multiplied by 1 + λ.
    pub factors: Vec<S>,
    pub pieces: Vec<BalancedPiece<S>>,
}

/// Changes of moment and shear force on one piece that restore exact equilibrium.
#[derive(Debug, Clone, Copy)]
pub(crate) struct BalancedPiece<S> {
    /// Absolute slope |λ′| in the cell that contains the piece, where λ is the relative correction of the contact
    /// pressure.
    pub steepness: Size,
    /// Correction of the claimed moment at both ends of the piece. It does not include the moment that the
    /// corrections of contact pressures and reactions cause.
    pub moments: [S; 2],
    /// Correction of the claimed shear force at both ends of the piece. It does not include the shear force that the
    /// corrections of contact pressures and reactions cause.
    pub shears: [S; 2],
    /// Bounds of the moment and of the shear force that the corrections of contact pressures and reactions cause in
    /// the cell.
    pub added: [Size; 2],
    /// Absolute value of the transverse force that the proof adds to the transverse force of the axial tension.
    pub drawn: Size,
}

impl<S: Scalar> Balanced<S> {
    /// Returns the largest |λ| on a piece, where λ is the relative correction of the contact pressure.
    pub fn factor(&self, piece: usize) -> Size {
        Size::of(self.factors[piece].size()).worst(Size::of(self.factors[piece + 1].size()))
    }
}

/// The cell between two neighbouring cuts.
struct Cell<S> {
    pieces: std::ops::Range<usize>,
    ends: [S; 2],
    length: S,
}

/// Tridiagonal system of equations for the values of λ, the relative correction of the contact pressure, at the
/// nodes that divide the beam into cells.
struct System<S> {
    rows: Vec<Row<S>>,
}

/// The equation of one cut.
#[derive(Clone, Copy)]
struct Row<S> {
    diagonal: S,
    /// Matrix entry that couples the equation of this cut with that of the next cut.
    beside: S,
    right: S,
}

impl<S: Scalar> System<S> {
    fn of(cuts: usize) -> Self {
        let zero = S::zero();
        System { rows: vec![Row { diagonal: zero, beside: zero, right: zero }; cuts] }
    }

    /// Solves the system by Gaussian elimination. Returns `None` if a pivot may be zero or negative.
    fn solved(mut self) -> Option<Vec<S>> {
        let rows = &mut self.rows;
        if rows.iter().all(|row| row.right == S::zero()) {
            // No residual force acts at the nodes that divide the beam into cells, so the contact pressure needs no
            // correction. All unknowns of the system are zero.
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

    /// Returns the force at a node per unit of the relative correction λ: contact force, reaction of a one-way support,
    /// and freely chosen positive weights of two-way supports.
    fn carried_at(&self, node: usize) -> S {
        let weights = &self.frame.nodes[node].weights;
        self.surface.nodes[node].force
            + S::of(weights.rigid)
            + S::of(weights.spring)
            + self.residual.pushing[node]
    }

    /// Returns the sum of the weights of clamps and rotational springs in a cell and at its left end. The last cell
    /// includes its right end.
    fn turned_in(&self, cell: &Cell<S>) -> S {
        let nodes = &self.frame.nodes;
        let last = cell.pieces.end + 1 == nodes.len();
        let all = cell.pieces.start..cell.pieces.end + usize::from(last);
        let weights = nodes[all].iter().map(|node| &node.weights);
        weights.fold(S::zero(), |sum, weights| sum + S::of(weights.clamp) + S::of(weights.turning))
    }

    /// Returns the correction of the claimed bending moment just inside the two ends of a cell.
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

    /// Computes the corrections of moment and shear force on the pieces of a cell. Returns the corrections of the shear
    /// force at the ends of the cell.
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

    /// Adds the terms of a cell to the equations (6) of docs/proof.md. The intervals also enclose the coefficients
    /// without tensile pressure.
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
            // The closure `mass` computes the integral of p(a + bt)(c + dt) over the piece, where p is the pressure
            // and t is the local coordinate of the piece.
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

    /// Computes the relative correction λ of the pressure along a cell. Bounds the moment and the shear force of all
    /// corrections by (7) and (9a) of docs/proof.md.
    fn give_back(&self, cell: &Cell<S>, ends: [S; 2], balanced: &mut Balanced<S>) {
        let per_length = S::one().div(cell.length);
        let slope = (ends[1] - ends[0]) * per_length;
        for i in cell.pieces.start..=cell.pieces.end {
            let x = self.frame.nodes[i].x;
            // The second hat function is not computed as 1 minus the first, because this difference has a large
            // relative rounding error where it is small.
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
    use crate::given_claim::{balanced, with_fields};
    use crate::scalar::Scalar;
    use crate::size::Size;
    use crate::wide::Wide;
    use serde_json::json;

    /// The claimed pressure x − 0.1 is tensile for x < 0.1, with the resultant 0.005. The bounds of the added moment
    /// and shear force must cover the omitted tension and the correction.
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

    /// The relative correction λ of the contact pressure is linear in a cell. If λ is ⅓ at the left end and ⅐ at the
    /// right end of the cell, it is ⅔·⅓ + ⅓·⅐ at a third of the cell length.
    #[test]
    fn the_factor_is_exact_at_the_cuts_and_linear_between_them() {
        let text = "[beam]\nlength = 1.5\nEI = 1\n[foundation]\nk = 1\n";
        let piece = |x: [f64; 2]| json!({"x": x, "half": 0.5 * (x[1] - x[0]), "touches": true, "deflection": [1]});
        let document = json!({"pieces": [piece([0.0, 0.5]), piece([0.5, 1.5])]});
        with_fields(text, &document, |fields| {
            let Fields { frame, surface, pressures, residual, .. } = fields;
            let cuts = vec![0, 2];
            let balance = Balance { frame, surface, pressures, residual, cuts, carrier: 0.0 };
            let mut balanced = balanced(2);
            let ends = [3.0, 7.0].map(|n| Wide::one().div(Wide::of(n)));
            balance.give_back(&balance.cell(0), ends, &mut balanced);
            let [left, between, right] = balanced.factors[..] else { panic!("three nodes") };
            assert_eq!([left, right], ends);
            let exact = Wide::of(17.0).div(Wide::of(63.0));
            assert!((between - exact).size() < 1e-29, "{between:?}");
        });
    }
}
