//! Makes wrong answers by random changes of correct answers, and compares their errors with the proven bounds.

use crate::carried;
use crate::claims::{error_bound, holds_at};
use crate::random::{Family, model};
use groundbeam::proof::{Answer, ContactSet, Force, Model as Given, Piece, Proof, Wide, prove};
use groundbeam::{Field, Model, Outcome, Solution, solve};
use rand::seq::IndexedRandom;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// Number of kinds of random models that are tested.
pub const KINDS: u64 = Family::ALL.len() as u64 + 2;

/// Returns a random model and its name. `kind` selects one of the families of random models, or beams whose axial
/// tension balances the loads.
pub fn random(kind: u64, number: u64) -> (String, Model) {
    let families = Family::ALL.into_iter().chain([Family::Shearing]);
    match families.into_iter().nth(kind as usize) {
        Some(family) => (format!("{family:?} {number}"), model(family, number)),
        None => (format!("Carried {number}"), carried::model(number)),
    }
}

/// Rounding error allowed in the comparison with the correct answer, relative to the largest value of the field or to
/// the reaction.
const ROUNDING: f64 = 1e-12;

/// A model with its solution and the proof of this solution.
pub struct Target {
    /// The solution.
    pub solution: Solution,
    pub(crate) given: Given<Wide>,
    right: Answer,
    proof: Proof,
}

/// A wrong answer.
pub struct Attack {
    /// Name of the change.
    pub change: &'static str,
    pub(crate) answer: Answer,
}

/// The comparison of a wrong answer with the true solution.
pub struct Verdict {
    /// Whether the answer is proven.
    pub proven: bool,
    /// Largest ratio of error to bound, over all quantities.
    pub ratio: f64,
    /// Ratios of error to bound, each with the name of its quantity.
    pub ratios: Vec<(&'static str, f64)>,
    /// A false statement of the proof, if there is one.
    pub fault: Option<String>,
}

impl Target {
    /// Solves a model and proves error bounds of its solution. Returns `None` if there is no solution or no proven
    /// bound.
    pub fn of(model: &Model) -> Option<Self> {
        let Ok(Outcome::Equilibrium(solution)) = solve(model) else { return None };
        let (given, right) = solution.claim::<Wide>();
        let proof = prove(&given, &right).ok()?;
        Some(Target { solution: *solution, given, right, proof })
    }

    /// Returns the correct answer with one or two random changes. A number always gives the same changes.
    pub fn attack(&self, number: u64) -> Attack {
        let mut rng = ChaCha8Rng::seed_from_u64(number);
        let mut answer = self.right.clone();
        let mut change = CHANGES.choose(&mut rng).expect("changes");
        (change.1)(&mut answer, &mut rng, self);
        if rng.random_bool(0.2) {
            let first = change.0;
            change = CHANGES.choose(&mut rng).expect("changes");
            (change.1)(&mut answer, &mut rng, self);
            return Attack {
                change: if first == change.0 { first } else { "two changes" },
                answer,
            };
        }
        Attack { change: change.0, answer }
    }

    /// Compares the errors of a wrong answer with its proven bounds; `None` if nothing is proven about the answer.
    pub fn judge(&self, attack: &Attack) -> Option<Verdict> {
        let proof = prove(&self.given, &attack.answer).ok()?;
        let (ratios, mut fault) = self.errors(&attack.answer, &proof);
        if let (Ok(claimed), Ok(exact)) = (&proof.contact, &self.proof.contact) {
            fault = fault.or_else(|| differing(claimed, exact));
        }
        let ratio = ratios.iter().fold(0.0, |most: f64, (_, ratio)| most.max(*ratio));
        Some(Verdict { proven: proof.shortfall().is_none(), ratio, ratios, fault })
    }

    /// Returns the ratios of error to bound for every field and every reaction, and a description of the last ratio
    /// above 1.
    fn errors(&self, answer: &Answer, proof: &Proof) -> (Vec<(&'static str, f64)>, Option<String>) {
        let (mut ratios, mut fault) = (Vec::new(), None);
        let mut judge = |name: &'static str, error: f64, bound: f64| {
            let ratio = error / bound;
            if ratio > 0.0 {
                ratios.push((name, ratio));
            }
            if ratio > 1.0 {
                fault = Some(format!("{name}: error {error:.3e}, bound {bound:.3e}"));
            }
        };
        for i in 0..61 {
            let x = self.solution.model().beam.length * (0.0021 + 0.016_33 * f64::from(i));
            let Some(piece) = answer.pieces.iter().find(|piece| x <= piece.x[1]) else { continue };
            for (field, value, bound) in self.fields(piece, x, proof) {
                let range = self.solution.range(field);
                let largest = range.max.value.abs().max(range.min.value.abs());
                let own = error_bound(&self.proof, field).unwrap_or(0.0);
                let error = (value - self.solution.value(field, x)).abs();
                judge(field.name(), error - own - ROUNDING * largest, bound);
            }
        }
        for (i, bound) in proof.reactions.iter().enumerate() {
            let claimed = answer.reactions.iter().find(|claimed| claimed.support == i);
            let [force, moment] = claimed.map_or([0.0; 2], |r| [r.force, r.moment]);
            let (exact, own) = (&self.solution.reactions()[i], &self.proof.reactions[i]);
            let off = |a: f64, b: f64, own: f64| (a - b).abs() - own - ROUNDING * b.abs();
            judge("reaction", off(force, exact.force, own.force.error), bound.force.error);
            let error = off(moment, exact.moment, own.moment.error);
            judge("moment of a support", error, bound.moment.error);
        }
        (ratios, fault)
    }

    /// Returns, for each field, its value in a wrong answer at the position x and the proven error bound of this value.
    /// `piece` is the piece of the answer that contains x.
    pub(crate) fn fields(&self, piece: &Piece, x: f64, proof: &Proof) -> Vec<(Field, f64, f64)> {
        let (model, bounds) = (self.solution.model(), &proof.bounds);
        let w = derivatives(piece, &piece.deflection, x);
        // Where two segments meet, the stiffness is that of the segment that contains the piece.
        let inside = x.min(piece.x[1] - 1e-12 * model.beam.length);
        let stiffness = model.beam.bending_stiffness_at(inside);
        let truth = |field| self.solution.value(field, x);
        let mut said = vec![
            (Field::Deflection, w[0], bounds.deflection.error),
            (Field::Slope, w[1], bounds.slope.error),
        ];
        let turned = match piece.rotation.is_empty() {
            true => [w[1], w[2], w[3]],
            false => {
                let turned = derivatives(piece, &piece.rotation, x);
                said.push((Field::Rotation, turned[0], bounds.rotation.error));
                [turned[0], turned[1], turned[2]]
            }
        };
        // Imposed curvatures and distributed moments cancel in the difference between the claimed and the correct answer.
        let right = self.right.pieces.iter().find(|piece| x <= piece.x[1]);
        let right = right.expect("the pieces cover the whole beam");
        let exact = match right.rotation.is_empty() {
            true => derivatives(right, &right.deflection, x),
            false => {
                let turned = derivatives(right, &right.rotation, x);
                [0.0, turned[0], turned[1], turned[2]]
            }
        };
        let moment = truth(Field::Moment) - stiffness * (turned[1] - exact[2]);
        said.push((Field::Moment, moment, bounds.moment.error));
        if model.beam.segments.iter().all(|segment| segment.bending_stiffness.is_constant()) {
            let shear = truth(Field::ShearForce) - stiffness * (turned[2] - exact[3]);
            said.push((Field::ShearForce, shear, bounds.shear_force.error));
        }
        let settled = match piece.touches {
            true => Some(w[0] - clearance(model, x)),
            false if piece.settlement.is_empty() => None,
            false => Some(derivatives(piece, &piece.settlement, x)[0]),
        };
        said.extend(settled.map(|u| (Field::Settlement, u, bounds.settlement.error)));
        if holds_at(proof, Field::Pressure, x) {
            let pressure = match piece.pressure.is_empty() {
                true => 0.0,
                false => derivatives(piece, &piece.pressure, x)[0],
            };
            said.push((Field::Pressure, pressure, bounds.pressure.error));
        }
        said
    }
}

/// Returns the initial gap g₀ at x.
fn clearance(model: &Model, x: f64) -> f64 {
    let gap = &model.gap;
    let after = gap.partition_point(|corner| corner.at < x);
    match (after.checked_sub(1).map(|i| gap[i]), gap.get(after)) {
        (None, None) => 0.0,
        (Some(one), None) => one.value,
        (None, Some(one)) => one.value,
        (Some(a), Some(b)) => a.value + (b.value - a.value) * (x - a.at) / (b.at - a.at),
    }
}

/// Returns the value of a polynomial of a piece at x and its first three derivatives with respect to x.
fn derivatives(piece: &Piece, coefficients: &[f64], x: f64) -> [f64; 4] {
    let t = (x - 0.5 * (piece.x[0] + piece.x[1])) / piece.half;
    let mut c = coefficients.to_vec();
    let mut found = [0.0; 4];
    for value in &mut found {
        *value = c.iter().rev().fold(0.0, |sum, c| sum * t + c);
        let derived = c.iter().enumerate().skip(1);
        c = derived.map(|(j, c)| j as f64 * c / piece.half).collect();
    }
    found
}

/// Describes the difference between two contact sets that are both proven for one model; `None` if they agree.
fn differing(claimed: &ContactSet, exact: &ContactSet) -> Option<String> {
    let meet = |a: [f64; 2], b: [f64; 2]| a[0] <= b[1] && b[0] <= a[1];
    let same = claimed.regions.len() == exact.regions.len()
        && claimed
            .regions
            .iter()
            .zip(&exact.regions)
            .all(|(a, b)| meet(a.from, b.from) && meet(a.to, b.to));
    if !same {
        return Some(format!(
            "contact regions {:?}, but the correct answer has {:?}",
            claimed.regions, exact.regions
        ));
    }
    let force = |set: &ContactSet, x: f64| {
        let near =
            |force: &&groundbeam::proof::ContactForce| (force.x - x).abs() <= 1e-12 * x.abs();
        set.forces.iter().find(near).map_or([0.0; 2], |force| force.force)
    };
    let differs = |x: f64| !meet(force(claimed, x), force(exact, x));
    let places = claimed.forces.iter().chain(&exact.forces).map(|force| force.x);
    let wrong = places.into_iter().find(|x| differs(*x))?;
    Some(format!(
        "contact force {:?}, but the correct answer has {:?}",
        force(claimed, wrong),
        force(exact, wrong)
    ))
}

type Change = (&'static str, fn(&mut Answer, &mut ChaCha8Rng, &Target));

/// Returns 10ⁿ with a random sign, where n is uniformly distributed between −15 and −1.
fn tiny(rng: &mut ChaCha8Rng) -> f64 {
    let size = 10.0_f64.powf(rng.random_range(-15.0..-1.0));
    if rng.random_bool(0.5) { size } else { -size }
}

/// Returns the largest absolute deflection.
fn largest(target: &Target) -> f64 {
    let range = target.solution.range(Field::Deflection);
    range.max.value.abs().max(range.min.value.abs())
}

/// Returns the index of a random piece.
fn any(answer: &Answer, rng: &mut ChaCha8Rng) -> usize {
    rng.random_range(0..answer.pieces.len())
}

const CHANGES: [Change; 14] = [
    ("an edge moved", move_edge),
    ("a bump", |answer, rng, target| {
        let (i, size) = (any(answer, rng), tiny(rng) * largest(target));
        // The polynomial (1 − t²)³ and its first two derivatives are zero at both ends of the piece.
        add(&mut answer.pieces[i], &[1.0, 0.0, -3.0, 0.0, 3.0, 0.0, -1.0], size);
    }),
    ("one coefficient", |answer, rng, _| {
        let i = any(answer, rng);
        let c = &mut answer.pieces[i].deflection;
        let j = rng.random_range(0..c.len());
        c[j] *= 1.0 + tiny(rng);
    }),
    ("a rigid motion", |answer, rng, target| {
        let length = target.solution.model().beam.length;
        let [shift, turn] = [0, 1].map(|_| tiny(rng) * largest(target));
        for piece in &mut answer.pieces {
            let middle = 0.5 * (piece.x[0] + piece.x[1]);
            add(piece, &[shift + turn * middle / length, turn * piece.half / length], 1.0);
        }
    }),
    ("everything scaled", |answer, rng, _| {
        let factor = 1.0 + tiny(rng);
        for piece in &mut answer.pieces {
            for c in piece.deflection.iter_mut().chain(&mut piece.rotation) {
                *c *= factor;
            }
        }
    }),
    ("contact claimed elsewhere", |answer, rng, _| {
        let i = any(answer, rng);
        answer.pieces[i].touches ^= true;
    }),
    ("a force added", |answer, rng, target| {
        let i = any(answer, rng);
        let force = tiny(rng) * target.proof.scales.force;
        answer.forces.push(Force { x: answer.pieces[i].x[0], force });
    }),
    ("a force left out", |answer, rng, _| {
        if !answer.forces.is_empty() {
            answer.forces.remove(rng.random_range(0..answer.forces.len()));
        }
    }),
    ("a reaction changed", |answer, rng, target| {
        if !answer.reactions.is_empty() {
            let i = rng.random_range(0..answer.reactions.len());
            let off = tiny(rng) * target.proof.scales.force;
            match rng.random_range(0..4) {
                0 => drop(answer.reactions.remove(i)),
                1 => answer.reactions[i].moment += off,
                _ => answer.reactions[i].force += off,
            }
        }
    }),
    ("another half length", |answer, rng, _| {
        let i = any(answer, rng);
        let factor = [1.0 + tiny(rng), 0.75, 1.25, 0.5, 1e-3, -1.0][rng.random_range(0..6)];
        let piece = &mut answer.pieces[i];
        piece.half *= factor;
        if rng.random_bool(0.5) {
            for c in [&mut piece.deflection, &mut piece.rotation, &mut piece.pressure] {
                let powers = c.iter_mut().enumerate();
                powers.for_each(|(j, c)| *c *= factor.powi(j as i32));
            }
        }
    }),
    ("another pressure", |answer, rng, _| {
        let i = any(answer, rng);
        if let Some(c) = answer.pieces[i].pressure.first_mut() {
            *c *= 1.0 + tiny(rng);
        }
    }),
    ("another settlement", |answer, rng, _| {
        // Only pieces out of contact where k or μ varies store the settlement of the ground.
        let stored: Vec<_> =
            answer.pieces.iter_mut().filter(|piece| !piece.settlement.is_empty()).collect();
        let count = stored.len();
        if let Some(piece) = stored.into_iter().nth(rng.random_range(0..count.max(1))) {
            let j = rng.random_range(0..piece.settlement.len());
            piece.settlement[j] *= 1.0 + tiny(rng);
        }
    }),
    ("a piece cut", |answer, rng, _| {
        let i = any(answer, rng);
        let piece = answer.pieces[i].clone();
        let part = rng.random_range(0.01..0.99);
        let at = piece.x[0] + part * (piece.x[1] - piece.x[0]);
        if piece.x[0] < at && at < piece.x[1] {
            let mut right = on(&piece, [at, piece.x[1]]);
            right.touches ^= rng.random_bool(0.7);
            answer.pieces[i] = on(&piece, [piece.x[0], at]);
            answer.pieces.insert(i + 1, right);
        }
    }),
    ("the answer of a neighbour", |answer, rng, target| {
        let mut model = target.solution.model().clone();
        let factor = 1.0 + tiny(rng);
        match rng.random_range(0..4) {
            0 => model.beam.bending_stiffness *= factor,
            1 => model.foundation = model.foundation.clone().scaled(factor, 1.0),
            2 => model.foundation = model.foundation.clone().scaled(1.0, factor),
            _ => model = model.with_loads_scaled(factor),
        }
        if let Ok(Outcome::Equilibrium(other)) = solve(&model) {
            *answer = other.claim::<Wide>().1;
        }
    }),
];

/// Moves a contact edge. The polynomials of the two adjacent pieces are extended or cut to the new edge.
fn move_edge(answer: &mut Answer, rng: &mut ChaCha8Rng, target: &Target) {
    let pieces = &answer.pieces;
    let is_edge = |i: &usize| pieces[*i].touches != pieces[*i - 1].touches;
    let edges: Vec<usize> = (1..pieces.len()).filter(is_edge).collect();
    let Some(&i) = edges.choose(rng) else { return };
    let at = pieces[i].x[0] + tiny(rng) * target.solution.model().beam.length;
    if pieces[i - 1].x[0] < at && at < pieces[i].x[1] {
        let [left, right] = [&pieces[i - 1], &pieces[i]];
        let (left, right) = (on(left, [left.x[0], at]), on(right, [at, right.x[1]]));
        (answer.pieces[i - 1], answer.pieces[i]) = (left, right);
    }
}

/// Adds the polynomial with the coefficients `terms`, times `size`, to the deflection, and its slope to the rotation.
fn add(piece: &mut Piece, terms: &[f64], size: f64) {
    let grow = |c: &mut Vec<f64>, j: usize, by: f64| {
        if c.len() <= j {
            c.resize(j + 1, 0.0);
        }
        c[j] += by;
    };
    for (j, term) in terms.iter().enumerate() {
        grow(&mut piece.deflection, j, size * term);
        if j > 0 && !piece.rotation.is_empty() {
            grow(&mut piece.rotation, j - 1, size * term * j as f64 / piece.half);
        }
    }
}

/// Returns a piece on the stretch `x` with the same functions of position as `piece`.
fn on(piece: &Piece, x: [f64; 2]) -> Piece {
    let half = 0.5 * (x[1] - x[0]);
    let offset = (0.5 * (x[0] + x[1]) - 0.5 * (piece.x[0] + piece.x[1])) / piece.half;
    let ratio = half / piece.half;
    // `moved` computes the coefficients of the polynomial p(offset + ratio t) in t from those of p, by Horner's rule.
    let moved = |c: &[f64]| {
        c.iter().rev().fold(Vec::new(), |sum: Vec<f64>, c| {
            let mut next = vec![0.0; sum.len() + 1];
            for (j, s) in sum.iter().enumerate() {
                next[j] += s * offset;
                next[j + 1] += s * ratio;
            }
            next[0] += c;
            while next.len() > 1 && next.last() == Some(&0.0) {
                next.pop();
            }
            next
        })
    };
    Piece {
        x,
        half,
        touches: piece.touches,
        deflection: moved(&piece.deflection),
        rotation: moved(&piece.rotation),
        pressure: moved(&piece.pressure),
        open: None,
        settlement: Vec::new(),
    }
}
