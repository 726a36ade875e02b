//! Compares the bounds of docs/proof.md with exact values for random test functions, ground out of contact and compressed beams.

#![cfg(test)]

mod beam;
mod contact;
mod ground;
mod stability;

use crate::answer::{Answer, Force, Piece};
use crate::ball::Ball;
use crate::frame::Frame;
use crate::given::frame;
use crate::model::{Action, Beam, Course, Extent, Ground, GroundEnd, GroundSegment, Load, Model};
use crate::scalar::Scalar;

/// Number of points of a numerical integral.
const COUNT: usize = 2000;

/// Length, k and μ of a stretch of ground.
type Stretch = [f64; 3];

/// Returns a beam with the bending stiffness `bending`. The ground under the beam consists of the stretches `ground`,
/// and it extends to infinity beyond both ends of the beam.
fn beam(bending: f64, ground: &[Stretch]) -> Model<Ball> {
    let mut to = 0.0;
    let segment = |[length, k, mu]: &Stretch| {
        let from = to;
        to += length;
        let [spring, shear] = [*k, *mu].map(|x| Course::Constant(Ball::of(x)));
        GroundSegment { from: Ball::of(from), to: Ball::of(to), spring, shear }
    };
    let segments = ground.iter().map(segment).collect();
    Model {
        beam: Beam {
            length: Ball::of(to),
            bending_stiffness: Ball::of(bending),
            shear_stiffness: None,
            segments: Vec::new(),
            axial_force: Ball::zero(),
        },
        ground: Ground {
            spring: Ball::one(),
            shear: Ball::one(),
            segments,
            ends: [GroundEnd::Endless; 2],
        },
        loads: Vec::new(),
        supports: Vec::new(),
        hinges: Vec::new(),
        gap: Vec::new(),
    }
}

/// Returns a load on the beam between two positions. The load is linear between its values at these positions.
fn load([from, to]: [f64; 2], [start, end]: [f64; 2]) -> Load<Ball> {
    let [from, to, start, end] = [from, to, start, end].map(Ball::of);
    let extent = Extent::Distributed { from, to, start, end };
    Load { action: Action::Force, extent, on_ground: false }
}

fn force(at: f64, size: f64) -> Load<Ball> {
    let extent = Extent::Point { at: Ball::of(at), size: Ball::of(size) };
    Load { action: Action::Force, extent, on_ground: false }
}

/// Returns a claimed solution with one piece for each stretch of ground. `pieces` contains the contact and the
/// coefficients of w in t, and `forces` the positions of contact forces.
fn claim(ground: &[Stretch], pieces: &[(bool, Vec<f64>)], forces: &[f64]) -> Answer {
    let mut to = 0.0;
    let piece = |([length, ..], (touches, deflection)): (&Stretch, &(bool, Vec<f64>))| {
        let from = to;
        to += length;
        let half = 0.5 * (to - from);
        Piece {
            x: [from, to],
            half,
            touches: *touches,
            deflection: deflection.clone(),
            ..Piece::default()
        }
    };
    let pieces = ground.iter().zip(pieces).map(piece).collect();
    let forces = forces.iter().map(|x| Force { x: *x, force: 1.0 }).collect();
    Answer { pieces, forces, reactions: Vec::new() }
}

fn framed(model: &Model<Ball>, answer: &Answer) -> Frame<Ball> {
    frame(model, answer, None, &[]).expect("a claim that can be read")
}

fn polynomial(c: &[f64], x: f64) -> f64 {
    c.iter().rev().fold(0.0, |sum, c| sum * x + c)
}

/// Integrates a function over 0 ≤ x ≤ `length` by the midpoint rule.
fn integral(length: f64, of: impl Fn(f64) -> f64) -> f64 {
    let h = length / COUNT as f64;
    (0..COUNT).map(|i| h * of((i as f64 + 0.5) * h)).sum()
}
