//! A field of several solutions as polynomials on common intervals.

use crate::ground::link::{self, settled};
use crate::numeric::polynomial::{Coefficients, derivative, rescale};
use crate::solution::field::Field;
use crate::solution::fields::Stretch;
use crate::solution::solution::Solution;

/// One field of several solutions, ready to be cut.
pub(super) struct Forms<'a> {
    solutions: &'a [&'a Solution],
    field: Field,
    /// Ends of the intervals on which every solution has one closed form.
    joints: Vec<f64>,
}

impl<'a> Forms<'a> {
    pub fn of(solutions: &'a [&'a Solution], field: Field) -> Self {
        let mut joints = Vec::new();
        for stretch in solutions.iter().flat_map(|solution| solution.stretches()) {
            joints.extend(stretch.x);
            if matches!(field, Field::Settlement | Field::Gap) && is_exponential(stretch) {
                let decay = (stretch.cell.shear / stretch.cell.spring).sqrt();
                link::cut(stretch.x, decay, &mut joints);
            }
        }
        joints.sort_by(f64::total_cmp);
        joints.dedup();
        Forms { solutions, field, joints }
    }

    /// Goes through the intervals from left to right: ends, and of each solution the coefficients of its
    /// polynomial in s ∈ \[−1, 1\].
    pub fn each_interval(&self, mut visit: impl FnMut([f64; 2], &mut Vec<Coefficients>)) {
        let mut at = vec![0; self.solutions.len()];
        for ends in self.joints.windows(2) {
            let ends = [ends[0], ends[1]];
            let mut curves = Vec::with_capacity(at.len());
            for (solution, at) in self.solutions.iter().zip(&mut at) {
                let stretches = solution.stretches();
                while *at + 1 < stretches.len() && stretches[*at].x[1] <= ends[0] {
                    *at += 1;
                }
                curves.push(
                    stretches
                        .get(*at)
                        .map_or(Coefficients::zeros(1), |s| form(s, self.field, ends)),
                );
            }
            visit(ends, &mut curves);
        }
    }
}

/// The position of s ∈ \[−1, 1\] in an interval.
pub(super) fn position([from, to]: [f64; 2], s: f64) -> f64 {
    let half = 0.5 * (to - from);
    if s <= 0.0 { from + half * (1.0 + s) } else { to - half * (1.0 - s) }
}

/// Whether u is a sum of exponentials here, not a polynomial.
fn is_exponential(stretch: &Stretch) -> bool {
    let moves = stretch.open.is_some_and(|ends| ends != [0.0, 0.0]);
    moves && stretch.settlement.is_empty() && stretch.cell.shear > 0.0
}

/// A field on a part of a stretch, in the part's own coordinate.
fn form(stretch: &Stretch, field: Field, [from, to]: [f64; 2]) -> Coefficients {
    let [a, b] = [from, to].map(|x| stretch.local(x));
    let part = |c: &[f64]| rescale(c, 0.5 * (a + b), 0.5 * (b - a));
    let per_length =
        |c: &[f64]| -> Coefficients { derivative(c).iter().map(|c| c / stretch.half).collect() };
    let [left, right] = stretch.cell.gap;
    let clearance = part(&[0.5 * (left + right), 0.5 * (right - left)]);
    match field {
        Field::Deflection => part(&stretch.deflection),
        Field::Rotation if !stretch.rotation.is_empty() => part(&stretch.rotation),
        Field::Slope | Field::Rotation => part(&per_length(&stretch.deflection)),
        Field::Moment => part(&stretch.moment),
        Field::ShearForce => part(&per_length(&stretch.moment)),
        Field::Pressure => part(&stretch.pressure),
        Field::Settlement => match stretch.open {
            None => sum(&part(&stretch.deflection), &clearance, -1.0),
            Some(_) => open_ground(stretch, [a, b]),
        },
        Field::Gap if stretch.open.is_none() => Coefficients::zeros(1),
        Field::Gap => {
            let over_ground = sum(&open_ground(stretch, [a, b]), &clearance, 1.0);
            sum(&over_ground, &part(&stretch.deflection), -1.0)
        }
    }
}

/// u between two points of a stretch off the ground.
fn open_ground(stretch: &Stretch, ends: [f64; 2]) -> Coefficients {
    let pressed = pressed_ground(stretch, ends);
    if !stretch.cell.is_sunk() {
        return pressed;
    }
    let [a, b] = ends;
    sum(&pressed, &rescale(&stretch.cell.settled(), 0.5 * (a + b), 0.5 * (b - a)), 1.0)
}

/// What the beam's pressure elsewhere adds to it.
fn pressed_ground(stretch: &Stretch, [a, b]: [f64; 2]) -> Coefficients {
    if !stretch.settlement.is_empty() {
        return rescale(&stretch.settlement, 0.5 * (a + b), 0.5 * (b - a));
    }
    if !is_exponential(stretch) {
        return Coefficients::zeros(1);
    }
    let (k, mu) = (stretch.cell.spring, stretch.cell.shear);
    let half = 0.5 * (b - a) * stretch.half;
    // A piece this long lies far from both ends.
    if 2.0 * half > 1.5 * link::PIECE * (mu / k).sqrt() {
        return Coefficients::zeros(1);
    }
    let ends = stretch.open.unwrap_or_default();
    settled(&[k], &[mu], half, [a, b].map(|s| stretch.pressed(s, ends)[0]))
}

/// f + factor·g.
fn sum(f: &[f64], g: &[f64], factor: f64) -> Coefficients {
    let at = |c: &[f64], i: usize| c.get(i).copied().unwrap_or(0.0);
    (0..f.len().max(g.len())).map(|i| at(f, i) + factor * at(g, i)).collect()
}
