//! Represents one field of several solutions by polynomials on common intervals.

use crate::ground::link::{self, settled};
use crate::numeric::polynomial::{Coefficients, derivative, rescale};
use crate::solution::field::Field;
use crate::solution::fields::SolutionPiece;
use crate::solution::solution::Solution;

/// One field of several solutions, and the intervals on which the field of every solution is a polynomial.
pub(super) struct Forms<'a> {
    solutions: &'a [&'a Solution],
    field: Field,
    /// Ends of the intervals on which every solution has one closed form.
    joints: Vec<f64>,
}

impl<'a> Forms<'a> {
    pub fn of(solutions: &'a [&'a Solution], field: Field) -> Self {
        let mut joints = Vec::new();
        for piece in solutions.iter().flat_map(|solution| solution.pieces()) {
            joints.extend(piece.x);
            if matches!(field, Field::Settlement | Field::Gap) && is_exponential(piece) {
                let decay = (piece.cell.shear_layer / piece.cell.subgrade).sqrt();
                link::cut(piece.x, decay, &mut joints);
            }
        }
        joints.sort_by(f64::total_cmp);
        joints.dedup();
        Forms { solutions, field, joints }
    }

    /// Calls `visit` for each interval from left to right, with the ends of the interval and with the
    /// coefficients of each solution's polynomial in s ∈ \[−1, 1\].
    pub fn each_interval(&self, mut visit: impl FnMut([f64; 2], &mut Vec<Coefficients>)) {
        let mut at = vec![0; self.solutions.len()];
        for ends in self.joints.windows(2) {
            let ends = [ends[0], ends[1]];
            let mut curves = Vec::with_capacity(at.len());
            for (solution, at) in self.solutions.iter().zip(&mut at) {
                let pieces = solution.pieces();
                while *at + 1 < pieces.len() && pieces[*at].x[1] <= ends[0] {
                    *at += 1;
                }
                curves.push(
                    pieces.get(*at).map_or(Coefficients::zeros(1), |s| form(s, self.field, ends)),
                );
            }
            visit(ends, &mut curves);
        }
    }
}

/// Returns the position x of the coordinate s ∈ \[−1, 1\] in an interval.
pub(super) fn position([from, to]: [f64; 2], s: f64) -> f64 {
    let half = 0.5 * (to - from);
    if s <= 0.0 { from + half * (1.0 + s) } else { to - half * (1.0 - s) }
}

/// Whether the ground displacement on this piece of a solution is a sum of exponentials instead of a polynomial.
fn is_exponential(piece: &SolutionPiece) -> bool {
    let moves = piece.open.is_some_and(|ends| ends != [0.0, 0.0]);
    moves && piece.settlement.is_empty() && piece.cell.shear_layer > 0.0
}

/// Returns the polynomial of a field on a part of a piece, in the local coordinate of the part.
fn form(piece: &SolutionPiece, field: Field, [from, to]: [f64; 2]) -> Coefficients {
    let [a, b] = [from, to].map(|x| piece.local(x));
    let part = |c: &[f64]| rescale(c, 0.5 * (a + b), 0.5 * (b - a));
    let per_length =
        |c: &[f64]| -> Coefficients { derivative(c).iter().map(|c| c / piece.half).collect() };
    let [left, right] = piece.cell.gap;
    let clearance = part(&[0.5 * (left + right), 0.5 * (right - left)]);
    match field {
        Field::Deflection => part(&piece.deflection),
        Field::Rotation if !piece.rotation.is_empty() => part(&piece.rotation),
        Field::Slope | Field::Rotation => part(&per_length(&piece.deflection)),
        Field::Moment => part(&piece.moment),
        Field::ShearForce => part(&per_length(&piece.moment)),
        Field::Pressure => part(&piece.pressure),
        Field::Settlement => match piece.open {
            None => sum(&part(&piece.deflection), &clearance, -1.0),
            Some(_) => open_ground(piece, [a, b]),
        },
        Field::Gap if piece.open.is_none() => Coefficients::zeros(1),
        Field::Gap => {
            let over_ground = sum(&open_ground(piece, [a, b]), &clearance, 1.0);
            sum(&over_ground, &part(&piece.deflection), -1.0)
        }
    }
}

/// Returns the polynomial of the ground displacement u between two points of a piece on which beam and ground are not
/// in contact.
fn open_ground(piece: &SolutionPiece, ends: [f64; 2]) -> Coefficients {
    let pressed = pressed_ground(piece, ends);
    if !piece.cell.has_free_field() {
        return pressed;
    }
    let [a, b] = ends;
    sum(&pressed, &rescale(&piece.cell.free_field(), 0.5 * (a + b), 0.5 * (b - a)), 1.0)
}

/// Returns the ground displacement due to contact pressure on the adjacent ground, as a polynomial between two points
/// of a piece out of contact.
fn pressed_ground(piece: &SolutionPiece, [a, b]: [f64; 2]) -> Coefficients {
    if !piece.settlement.is_empty() {
        return rescale(&piece.settlement, 0.5 * (a + b), 0.5 * (b - a));
    }
    if !is_exponential(piece) {
        return Coefficients::zeros(1);
    }
    let (k, mu) = (piece.cell.subgrade, piece.cell.shear_layer);
    let half = 0.5 * (b - a) * piece.half;
    // Ground out of contact is cut into short pieces near its ends. So the displacement of a long piece is zero to
    // rounding error.
    if 2.0 * half > 1.5 * link::PIECE * (mu / k).sqrt() {
        return Coefficients::zeros(1);
    }
    let ends = piece.open.unwrap_or_default();
    settled(&[k], &[mu], half, [a, b].map(|s| piece.pressed(s, ends)[0]))
}

/// Returns f + factor·g.
fn sum(f: &[f64], g: &[f64], factor: f64) -> Coefficients {
    let at = |c: &[f64], i: usize| c.get(i).copied().unwrap_or(0.0);
    (0..f.len().max(g.len())).map(|i| at(f, i) + factor * at(g, i)).collect()
}
