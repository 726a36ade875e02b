//! Hinges: where shear is handed on, and no moment, or only what a spring carries.
//!
//! At a free hinge the moment of loads and pressures from the left must vanish. What rounding leaves of it
//! is given back to all that carries the beam, by a factor 1 + λ(x) that is linear between hinges and
//! continuous at them, as are the motions of the beam's pieces when they do not bend. The equilibrium of all
//! pieces with each other asks for one number at each end and hinge:
//!
//! > ∫ λ φ_j dc = −r_j,
//!
//! where φ_j is 1 at the j-th of them, 0 at all others and linear between, c is what carries the beam and
//! r_j what remains of force and moment of the two pieces there. The hinges' shears follow from it.

use super::balance::{Carriers, GivenBack, LARGEST, Remains, Segment};
use crate::model::{Hinge, Model};

pub(super) struct Hinges<'a> {
    /// From right to left; the next one is the last.
    ahead: Vec<&'a Hinge>,
    near: f64,
    none_is_free: bool,
    /// The beam from one free hinge to the next.
    pub pieces: Vec<Segment>,
}

impl<'a> Hinges<'a> {
    pub fn new(model: &'a Model) -> Self {
        let mut ahead: Vec<&Hinge> = model.hinges.iter().collect();
        ahead.sort_by(|a, b| b.at.total_cmp(&a.at));
        let none_is_free = ahead.iter().all(|hinge| !hinge.is_free());
        let near = super::NEAR * model.beam.length;
        Hinges { ahead, near, none_is_free, pieces: Vec::new() }
    }

    pub fn none_is_free(&self) -> bool {
        self.none_is_free
    }

    /// The hinge at a position.
    pub fn at(&mut self, x: f64) -> Option<&'a Hinge> {
        self.ahead.pop_if(|hinge| hinge.at <= x + self.near)
    }
}

/// Gives back what remains of all pieces, each of which ends at a free hinge or with the beam.
pub(super) fn give(pieces: &[Segment], given_back: &mut GivenBack) {
    let sum = |of: &dyn Fn(&Remains) -> f64| pieces.iter().map(|piece| of(&piece.remains)).sum();
    let lost = Remains {
        force: sum(&|remains| remains.force.abs()),
        moment: sum(&|remains| remains.moment.abs()),
        force_noise: 0.0,
        moment_noise: 0.0,
    };
    let Some(factors) = factors(pieces) else {
        given_back.lost = Some(lost);
        return;
    };
    for (piece, ends) in pieces.iter().zip(factors.windows(2)) {
        // Of a linear λ: no more than this anywhere, and no more than twice this from one end to the other.
        let most = ends[0].max(ends[1]);
        let Carriers { pressure, supports, sunk, stored, .. } = &piece.carriers;
        if pressure.sum > 0.0 && most > LARGEST {
            given_back.lost = Some(lost);
        }
        let length = piece.to - piece.from;
        let forces = most * (pressure.sum + supports.sum);
        let turned = 2.0 * most * piece.turning() / length;
        // Zero at both hinges but for what remains, and the shear at the left one makes it so.
        let moment = piece.unbalanced() + 2.0 * forces * length + turned + piece.moment;
        given_back.pressure = given_back.pressure.max(most);
        given_back.sunk += most * most * sunk;
        given_back.supports += 4.0 * most * most * (stored + piece.axial);
        let sheared = piece.sheared(moment / length + forces + piece.forces, 2.0 * most);
        let bent = moment * moment * piece.flexibility;
        given_back.bent += bent + sheared * (sheared + 2.0 * bent.sqrt());
    }
}

/// Bounds of |λ| at the ends and the hinges; none if something moves that nothing carries.
fn factors(pieces: &[Segment]) -> Option<Vec<f64>> {
    let count = pieces.len() + 1;
    let (mut diagonal, mut beside) = (vec![0.0; count], vec![0.0; count]);
    let mut remains = vec![0.0; count];
    for (i, piece) in pieces.iter().enumerate() {
        let length = piece.to - piece.from;
        let mut all = piece.carriers.pressure;
        all.add(piece.carriers.supports);
        let at = (all.centre - piece.from) / length;
        let turning = (all.spread + piece.turning()) / (length * length);
        diagonal[i] += all.sum * (1.0 - at) * (1.0 - at) + turning;
        diagonal[i + 1] += all.sum * at * at + turning;
        beside[i] = all.sum * at * (1.0 - at) - turning;
        let tilt = piece.unbalanced() / length;
        let Remains { force, force_noise, .. } = piece.remains;
        remains[i] += tilt;
        remains[i + 1] += tilt + force.abs() + force_noise;
    }
    // LDLᵀ; then one column of the inverse after the other, since no sign is known.
    let mut pivots = diagonal.clone();
    for i in 1..count {
        pivots[i] -= beside[i - 1] * (beside[i - 1] / pivots[i - 1]);
        if pivots[i].is_nan() || pivots[i] <= SINGULAR * diagonal[i] {
            return None;
        }
    }
    let mut bounds = vec![0.0; count];
    let mut column = vec![0.0; count];
    for (from, remains) in remains.iter().enumerate().filter(|(_, remains)| **remains > 0.0) {
        column.fill(0.0);
        column[from] = *remains;
        for i in from + 1..count {
            column[i] = -column[i - 1] * (beside[i - 1] / pivots[i - 1]);
        }
        for i in (0..count).rev() {
            let next = if i + 1 < count { beside[i] * column[i + 1] } else { 0.0 };
            column[i] = (column[i] - next) / pivots[i];
            bounds[i] += column[i].abs();
        }
    }
    bounds.iter().all(|bound| bound.is_finite()).then_some(bounds)
}

/// A pivot that has lost all its digits.
const SINGULAR: f64 = 1e-13;
