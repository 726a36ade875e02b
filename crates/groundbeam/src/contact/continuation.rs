//! Continuation in EI, or in S: an initial guess of the exact method.
//!
//! Solve with EI·2ⁿ on a coarse mesh that resolves the waves of this stiff beam, then lower n to 0. For a beam that
//! shears, start from the beam that only bends and lower S.
//!
//! Newton's method on edges converges for moves up to about one wave length. Where the pressure of a zone is
//! small, an edge moves by hundreds of wave lengths while EI falls by one per cent. Each beam therefore starts
//! from edges extrapolated from the two beams before. If it does not converge, the step is halved.

use crate::cancel::Cancel;
use crate::contact::bonded::Bonded;
use crate::contact::intervals::Interval;
use crate::contact::levels;
use crate::contact::refine::{Goal, InitialGuess, refine};
use crate::contact::state::{ContactState, Unconverged, edges_not_converged};
use crate::element::operator::{Operator, ZoneKind};
use crate::mesh::cell::Cell;
use crate::mesh::mesh::Mesh;
use crate::model::Model;
use crate::options::Pressure;

/// Cells of the first coarse mesh per wave length of the beam on its ground.
const COARSE: f64 = 1.0;
/// The most wave lengths of the beam between two nodes of the model on the first coarse mesh.
const MOST_WAVES: f64 = 32.0;
/// Largest continuation step in log₂ EI.
const STEP: f64 = 2.0;
/// Smallest continuation step in log₂ EI; below it the continuation fails.
const LEAST_STEP: f64 = 2e-4;
/// Continuation in S: the first log₂ of the factor on S, and its largest step.
const MOST_DOUBLINGS: f64 = 40.0;
const SHEAR_STEP: f64 = 4.0;
/// Limit on the number of beams.
const MOST_BEAMS: usize = 400;

/// A deflection of the beam itself, or of one of nearly its stiffness; its edges are not converged.
pub(crate) fn start(
    model: &Model,
    level: u32,
    cancel: &Cancel,
) -> Result<ContactState, Unconverged> {
    let axial = model.beam.axial_force;
    let waves = |cell: &Cell| {
        Operator::of(cell, axial, ZoneKind::Contact).wave_number() * cell.length() / MOST_WAVES
    };
    let cells = Mesh::build(model, &[], |_| 1).cells;
    // |r| falls at least like EI^(−1/4).
    let most = cells.iter().map(waves).fold(1.0, f64::max);
    // If the continuation fails at one level, the next starts from a fine mesh of the beam itself.
    let stiffest = if level % 2 == 1 { 0.0 } else { most.powi(4).log2() };
    let per_wave = COARSE * 3_f64.powi(level as i32);
    let model_of = |doublings: f64| {
        let mut model = model.clone();
        model.beam = model.beam.stiffened(doublings.exp2());
        model
    };
    // A mesh of cubic elements does not shear.
    let mut stiff = model_of(stiffest);
    stiff.beam = stiff.beam.without_shear();
    let meshes = levels::coarse_meshes(&stiff, per_wave);
    let found = levels::solve(meshes, Pressure::Distributed, cancel)?;
    let steps = (stiffest * f64::from(level + 1) / STEP).ceil();
    follow(found, stiffest, stiffest / steps.max(1.0), cancel, model_of)
}

/// The same from the beam that only bends, by beams ever less stiff against shear.
pub(crate) fn from_bending(
    model: &Model,
    cancel: &Cancel,
    solve: impl FnOnce(&Model) -> Result<ContactState, Unconverged>,
) -> Result<ContactState, Unconverged> {
    let bending = Model { beam: model.beam.clone().without_shear(), ..model.clone() };
    let found = solve(&bending)?;
    let model_of = |doublings: f64| {
        let beam = model.beam.clone().stiffened_in_shear(doublings.exp2());
        Model { beam, ..model.clone() }
    };
    follow(found, MOST_DOUBLINGS, SHEAR_STEP, cancel, model_of)
}

/// From the deflection of a beam that is 2^`doublings` times as stiff to that of the beam itself, in steps of
/// no more than `longest`.
fn follow(
    mut found: ContactState,
    mut doublings: f64,
    longest: f64,
    cancel: &Cancel,
    model_of: impl Fn(f64) -> Model,
) -> Result<ContactState, Unconverged> {
    let mut step = longest;
    // The beam before, and its contact.
    let mut before: Option<(f64, Vec<Interval>)> = None;
    for _ in 0..MOST_BEAMS {
        if doublings == 0.0 {
            return Ok(found);
        }
        // The last step is not followed by what rounding leaves.
        let next = if doublings > 1.001 * step { doublings - step } else { 0.0 };
        let softer = model_of(next);
        let mut start = InitialGuess::of_contact_set(found.clone());
        let here = start.intervals.clone();
        if let Some((stiffer, intervals)) = &before {
            let part = (doublings - next) / (stiffer - doublings);
            let l = softer.beam.length;
            start.intervals = ahead(intervals, &here, part, l).unwrap_or(start.intervals);
        }
        match refine(&mut Bonded::new(&softer, cancel), start, Goal::Start, &mut |_| f64::INFINITY)
        {
            Ok(settled) => {
                before = Some((doublings, here));
                (found, doublings) = (settled, next);
                step = longest.min(2.0 * step);
            }
            Err(stalled) if step < LEAST_STEP || cancel.is_cancelled() => return Err(stalled),
            Err(_) => step *= 0.5,
        }
    }
    Err(edges_not_converged(0, f64::NAN))
}

/// Extrapolates the edges from `before` to `here` by a `part` of this move, on a beam of length l. `None` if the number of
/// zones changed or two zones would meet.
fn ahead(before: &[Interval], here: &[Interval], part: f64, l: f64) -> Option<Vec<Interval>> {
    let further = |a: f64, b: f64| (b + part * (b - a)).clamp(0.0, l);
    let pairs = before.iter().zip(here);
    let ahead: Vec<Interval> = pairs.map(|(a, b)| [0, 1].map(|i| further(a[i], b[i]))).collect();
    (before.len() == here.len() && ahead.as_flattened().is_sorted()).then_some(ahead)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edges_go_on_as_they_went() {
        let (before, here) = ([[0.0, 0.3], [0.6, 0.9]], [[0.0, 0.34], [0.6, 1.0]]);
        let next = ahead(&before, &here, 0.5, 1.0).expect("as many zones");
        assert!((next[0][1] - 0.36).abs() < 1e-15);
        assert_eq!([next[0][0], next[1][0], next[1][1]], [0.0, 0.6, 1.0]);
        assert_eq!(ahead(&before[..1], &here, 0.5, 1.0), None);
        assert_eq!(ahead(&before, &here, 10.0, 1.0), None);
    }
}
