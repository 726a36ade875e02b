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

use crate::deflection::Deflection;
use crate::frame::{Frame, Span};
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

/// The nodes at which the beam is cut: both ends and free hinges.
pub(crate) fn fewest_cuts<S: Scalar>(frame: &Frame<S>) -> Vec<usize> {
    let last = frame.spans.len();
    (0..=last).filter(|i| *i == 0 || *i == last || frame.nodes[*i].is_free_hinge()).collect()
}

/// As [`fewest_cuts`], with additional cuts. A cut is added after more than two wave lengths of contact since
/// the last cut (one wave length at the end of a contact zone), if more than one wave length of contact
/// follows.
pub(crate) fn more_cuts<S: Scalar>(frame: &Frame<S>) -> Vec<usize> {
    let last = frame.spans.len();
    let waves: Vec<f64> = frame
        .spans
        .iter()
        .map(|span| {
            let wave = (4.0 * span.bending.middle() / span.spring.middle()).sqrt().sqrt();
            if span.touches { span.h.middle() / wave } else { 0.0 }
        })
        .collect();
    let mut ahead: f64 = waves.iter().sum();
    let mut passed = 0.0;
    let mut cuts = vec![0];
    for i in 1..last {
        (passed, ahead) = (passed + waves[i - 1], ahead - waves[i - 1]);
        let ends = waves[i - 1] > 0.0 && waves[i] == 0.0;
        let enough = (passed > 2.0 || (ends && passed > 1.0)) && ahead > 1.0;
        if enough || frame.nodes[i].is_free_hinge() {
            cuts.push(i);
            passed = 0.0;
        }
    }
    cuts.push(last);
    cuts
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
        let mut pulls = Size::ZERO;
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
            pulls += self.pressures[i].pull();
        }
        for k in [j, j + 1] {
            system.rows[k].diagonal = system.rows[k].diagonal.widened(pulls.value());
            system.rows[k].right = system.rows[k].right.widened(pulls.value());
        }
        system.rows[j].beside = system.rows[j].beside.widened(pulls.value());
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
            load += (Size::of(1.0) + factor) * pressure.pull();
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

    /// ‖δ‖² = Σ∫δ²/EI.
    pub fn bending(&self, balanced: &Balanced<S>) -> Size {
        let of = |i: usize| {
            let (span, piece) = (&self.frame.spans[i], &self.residual.pieces[i]);
            let load = (piece.constant, piece.rest);
            let norm =
                moment_norm(span.h, balanced.pieces[i].moments, load, balanced.pieces[i].added[0]);
            norm.square().over(span.bending.low())
        };
        (0..self.frame.spans.len()).map(of).sum()
    }

    /// Σβ²h/P, the complementary energy of the transverse force in the tension.
    pub fn drawn(&self, balanced: &Balanced<S>) -> Size {
        let Some(tension) = self.frame.tension else { return Size::ZERO };
        let pieces = self.frame.spans.iter().zip(&balanced.pieces);
        let of = |(span, piece): (&Span<S>, &BalancedPiece<S>)| {
            (span.length() * piece.drawn.square()).over(tension.low())
        };
        pieces.map(of).sum()
    }

    /// ‖Gδp‖²: δp = λp̄ with |λ| ≤ γ, and the kernel of G is positive. In a layer ⟨δp, Gδp⟩ ≤ Σγ²∫p̄ Gp̄ with
    /// Gp̄ ≤ û + |c| + √g‖ū − G(p̄ + q)‖; on Winkler ground it is ∫(δp)²/k.
    pub fn ground(&self, balanced: &Balanced<S>, deflection: &Deflection<S>, missed: Size) -> Size {
        let mut sum = Size::ZERO;
        for (i, span) in self.frame.spans.iter().enumerate().filter(|(_, span)| span.touches) {
            let pressure = &self.pressures[i];
            let per_load = if span.layered {
                let settled = pressure.obstacle + deflection.pieces[i].bounds[0];
                settled + self.surface.pieces[i].flexibility * missed
            } else {
                pressure.field.size(span.tau).over(span.spring.low())
            };
            sum += balanced.factor(i).square() * pressure.pressing() * per_load;
        }
        sum + self.ground_at_nodes(balanced, missed)
    }

    fn ground_at_nodes(&self, balanced: &Balanced<S>, missed: Size) -> Size {
        let of = |node: usize| {
            let force = Size::of(self.surface.nodes[node].force.size());
            if !self.surface.touches[node] || force.value() == 0.0 {
                return Size::ZERO;
            }
            let factor = Size::of(balanced.factors[node].size());
            let settled = Size::of(self.surface.nodes[node].settlement.size());
            let missed = self.surface.flexibility_at(node) * missed;
            factor.square() * force * (settled + missed)
        };
        (0..self.frame.nodes.len()).map(of).sum()
    }
}

/// (∫δ²)^½ on a piece of length h. δ is A and B at the ends, and δ″ = −r with |r − r₀| ≤ R; a further moment
/// is at most |Δδ|. δ is the sum of a chord, a parabola and a part of at most Rx(h − x)/2, so the bound is
///
/// ```text
/// |h(A² + AB + B²)/3 + r₀h³(A + B)/12 + r₀²h⁵/120|^½ + (h⁵/120)^½ R + h^½ |Δδ|.
/// ```
fn moment_norm<S: Scalar>(h: S, [a, b]: [S; 2], (r, rest): (S, Size), added: Size) -> Size {
    let cube = h * h * h;
    let chord = h.div(S::of(3.0)) * (a * a + a * b + b * b);
    let mixed = r * cube * (a + b).div(S::of(12.0));
    let parabola = (r * r * cube * h * h).div(S::of(120.0));
    let long = Size::of(h.high());
    let fifth = (long.square().square() * long).over(120.0).root();
    Size::of((chord + mixed + parabola).size()).root() + fifth * rest + long.root() * added
}

#[cfg(test)]
mod tests {
    use super::moment_norm;
    use crate::ball::Ball;
    use crate::random::numbers;
    use crate::scalar::Scalar;
    use crate::size::Size;

    /// δ for r = c₀ + c₁t + c₂t² + c₃t³ on |t| ≤ 1, h = 2 half, by integrating twice.
    fn moment(c: &[f64; 4], half: f64, [a, b]: [f64; 2], t: f64) -> f64 {
        let twice = |t: f64| {
            let terms = c.iter().enumerate();
            terms.map(|(j, c)| c * t.powi(j as i32 + 2) / ((j + 1) * (j + 2)) as f64).sum::<f64>()
        };
        let (left, right) = (twice(-1.0), twice(1.0));
        let chord = |left: f64, right: f64| 0.5 * (left + right) + 0.5 * (right - left) * t;
        chord(a, b) + half * half * (chord(left, right) - twice(t))
    }

    #[test]
    fn the_norm_of_the_moment_is_a_bound_and_sharp_without_a_rest() {
        let mut random = numbers();
        for case in 0..500 {
            let half = 10.0_f64.powf(2.0 * random());
            let mut c = [random(), random(), random(), random()];
            if case % 2 == 0 {
                c = [c[0], 0.0, 0.0, 0.0];
            }
            let ends = [random(), random()].map(|x| x * half * half);
            let steps = 2000;
            let square =
                |i: i32| moment(&c, half, ends, -1.0 + (f64::from(i) + 0.5) / 1000.0).powi(2);
            let exact = ((0..steps).map(square).sum::<f64>() * half / 1000.0).sqrt();
            let rest = Size::of(c[1].abs() + c[2].abs() + c[3].abs());
            let load = (Ball::of(c[0]), rest);
            let norm = moment_norm(Ball::of(2.0 * half), ends.map(Ball::of), load, Size::ZERO);
            assert!(exact <= norm.value() * (1.0 + 1e-6), "{exact} {norm:?}");
            if case % 2 == 0 {
                assert!(norm.value() <= exact * (1.0 + 1e-5), "{exact} {norm:?} is not sharp");
            }
        }
    }
}
