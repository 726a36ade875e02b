//! Computes an initial guess for Newton's method on the contact edges of a long soft beam by continuation in the stiffness EI.
//!
//! Nodal forces (phase A) and Newton's method (phase B) find the contact of a stiffened beam. The stiffness then
//! decreases in steps to that of the model. Each step extrapolates the edges of the two preceding steps. See *The
//! start* in `docs/methods.md`.

use crate::cancel::Cancel;
use crate::contact::bonded::Bonded;
use crate::contact::edges::{Start, edges};
use crate::contact::intervals::{Interval, longest_difference, positions};
use crate::contact::nodes;
use crate::contact::obstacle;
use crate::contact::state::{ContactState, Unconverged, edges_not_converged};
use crate::contact::stopping::{
    CORRECTOR_STEPS, FEW_STEPS, LEVELS, LONGEST_STEP, MOST_BEAMS, MOST_STEPS, ROUGH, SEARCHED_STEP,
    SHORTEST_STEP, STALE_STEPS, STIFF_WAVES,
};
use crate::contact::undecided::differ_by_rounding;
use crate::element::operator::{Operator, ZoneKind};
use crate::error::NotConverged;
use crate::mesh::cell::Cell;
use crate::mesh::mesh::Mesh;
use crate::model::Model;
use crate::nodal::edges::{Coarse, coarse};
use crate::numeric::elementary::{exp2, log2, power};

/// Computes the initial guess for Newton's method on the contact edges. Levels 0, 1 and 2 have increasingly fine
/// meshes. Level 1 does not stiffen the beam.
pub(crate) fn follow(model: &Model, level: u32, cancel: &Cancel) -> Result<Start, Unconverged> {
    let longest = LONGEST_STEP / f64::from(level + 1);
    let mut doublings = if level == 1 { 0.0 } else { stiffening(model) };
    let softened = |doublings: f64| {
        let beam = model.beam.clone().stiffened(exp2(doublings));
        Model { beam, ..model.clone() }
    };
    let stiff = softened(doublings);
    let start = phase_a(&stiff, level, cancel);
    if doublings == 0.0 {
        // A zone much shorter than an element may have no nodes. Newton's method on the contact edges then
        // starts from contact along the whole beam.
        let whole = |_| Start::on(vec![[0.0, model.beam.length]]);
        return Ok(start.unwrap_or_else(whole));
    }
    let mut found = edges(&mut Bonded::new(&stiff, cancel), start?, MOST_STEPS, &mut |_| 0.0)?;
    let mut contact = asked(&found);
    let mut step = longest;
    // The preceding, stiffer beam of the continuation: log₂ of its stiffness factor, and its contact set.
    let mut before: Option<(f64, Vec<Interval>)> = None;
    let mut beams = 0;
    while doublings > 0.0 {
        beams += 1;
        if beams > MOST_BEAMS {
            return Err(edges_not_converged(beams, step));
        }
        // The last step is up to 0.1 % longer, so that no further step of the size of rounding error follows.
        let next = if doublings > 1.001 * step { doublings - step } else { 0.0 };
        let predicted = before.as_ref().and_then(|(stiffer, edges)| {
            let part = (doublings - next) / (stiffer - doublings);
            secant(edges, &contact, part, model.beam.length)
        });
        let softer = softened(next);
        let bonded = &mut Bonded::new(&softer, cancel);
        let trial = predicted.unwrap_or_else(|| contact.clone());
        match correct(bonded, trial) {
            Some(corrected) => {
                let own = asked(&corrected);
                before = Some((doublings, std::mem::replace(&mut contact, own)));
                (found, doublings) = (corrected, next);
                step = longest.min(2.0 * step);
            }
            None if cancel.is_cancelled() => return Err(edges_not_converged(0, f64::NAN)),
            None if step > SEARCHED_STEP => step *= 0.5,
            None => {
                let is_shortest = step <= SHORTEST_STEP;
                let limit = if is_shortest { MOST_STEPS } else { FEW_STEPS };
                match edges(bonded, Start::of(found.clone()), limit, &mut |_| 0.0) {
                    Ok(corrected) => {
                        found = corrected;
                        (contact, doublings, before, step) = (asked(&found), next, None, longest);
                    }
                    Err(stalled) if is_shortest => return Err(stalled),
                    Err(_) => step *= 0.5,
                }
            }
        }
    }
    Ok(Start { contact, now: Some(found), near: false })
}

/// Computes the contact set from nodal ground forces, on meshes from coarse to fine (phase A). At the last level, the
/// contact set is that of the obstacle problem for the computed deflection.
fn phase_a(model: &Model, level: u32, cancel: &Cancel) -> Result<Start, Unconverged> {
    // Shear deformation is omitted here, because it requires elements with power series, which take ten times as
    // long.
    let bending = Model { beam: model.beam.clone().without_shear(), ..model.clone() };
    let unsettled = Unconverged { iterations: 0, why: NotConverged::Nodes };
    let per_wave = power(3.0, level as usize);
    let Coarse { grid, workspace, edges } = coarse(&bending, per_wave, cancel).ok_or(unsettled)?;
    let found = nodes::Solved::new(grid, workspace).state();
    // The nodal forces keep a contact edge at a hinge exactly at the hinge. The obstacle problem may move this edge.
    let contact = if level + 1 < LEVELS {
        edges
    } else {
        positions(&found.mesh, &obstacle::contact(&found.deflection()), &[])
    };
    Ok(Start { contact, now: Some(found), near: false })
}

/// Returns log₂ of the factor on EI that limits the product of wave number and node distance to [`STIFF_WAVES`]. The
/// wave number decreases at least as fast as EI^(−1/4).
fn stiffening(model: &Model) -> f64 {
    let axial = model.beam.axial_force;
    let waves = |cell: &Cell| {
        let wave_number = Operator::of(cell, axial, ZoneKind::Contact).wave_number();
        wave_number * cell.length() / STIFF_WAVES
    };
    let cells = Mesh::build(model, &[], |_| 1).cells;
    4.0 * log2(cells.iter().map(waves).fold(1.0, f64::max))
}

/// Corrects the edges by Newton's method without a line search. Returns `None` if it does not converge in a few
/// steps.
pub(crate) fn correct(bonded: &mut Bonded, mut contact: Vec<Interval>) -> Option<ContactState> {
    let mut least = f64::INFINITY;
    let mut stale = 0;
    for _ in 0..CORRECTOR_STEPS {
        let found = bonded.solve_on(&contact).ok()?;
        let asked = obstacle::contact(&found.deflection());
        let next = positions(&found.mesh, &asked, &[]);
        let moved = longest_difference(&contact, &next) / bonded.model.beam.length;
        if moved <= ROUGH {
            return Some(ContactState { zones: asked, ..found });
        }
        stale = if moved <= 0.5 * least { 0 } else { stale + 1 };
        if stale >= STALE_STEPS {
            let is_rounding =
                moved.is_finite() && differ_by_rounding(&found, &contact, &asked, &[]);
            return is_rounding.then_some(ContactState { zones: asked, ..found });
        }
        least = least.min(moved);
        contact = next;
    }
    None
}

/// Returns the contact set of a deflection.
fn asked(found: &ContactState) -> Vec<Interval> {
    positions(&found.mesh, &found.zones, &[])
}

/// Extrapolates each contact edge by `part` times its move from `before` to `here`, within the beam of length `l`.
/// Returns `None` if the number of zones changed or zones would overlap.
pub(crate) fn secant(
    before: &[Interval],
    here: &[Interval],
    part: f64,
    l: f64,
) -> Option<Vec<Interval>> {
    let further = |a: f64, b: f64| (b + part * (b - a)).clamp(0.0, l);
    let pairs = before.iter().zip(here);
    let ahead: Vec<Interval> = pairs.map(|(a, b)| [0, 1].map(|i| further(a[i], b[i]))).collect();
    (before.len() == here.len() && ahead.as_flattened().is_sorted()).then_some(ahead)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edges_are_extrapolated_linearly() {
        let (before, here) = ([[0.0, 0.3], [0.6, 0.9]], [[0.0, 0.34], [0.6, 1.0]]);
        let next = secant(&before, &here, 0.5, 1.0).expect("as many zones");
        assert!((next[0][1] - 0.36).abs() < 1e-15);
        assert_eq!([next[0][0], next[1][0], next[1][1]], [0.0, 0.6, 1.0]);
        assert_eq!(secant(&before[..1], &here, 0.5, 1.0), None);
        assert_eq!(secant(&before, &here, 10.0, 1.0), None);
    }
}
