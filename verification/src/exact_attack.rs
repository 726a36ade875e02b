//! Compares the errors of wrong answers with proven error bounds. The exact answers come from `reference/answers`.

use crate::attack::{Attack, Target};
use crate::reference::Answer as Exact;
use groundbeam::proof::{ContactSet, Proof, prove};

/// Rounding error of a comparison, relative to the largest value of a field. The true values have 20 digits, but
/// claimed fields are evaluated in doubles with 16 digits.
const ROUNDING: f64 = 1e-12;

/// The comparison of a wrong answer with the exact answer.
pub struct Judged {
    /// Whether the answer is proven.
    pub proven: bool,
    /// Ratios of error to bound, each with the name of its quantity.
    pub ratios: Vec<(&'static str, f64)>,
    /// Description of the difference, if a proven contact set differs from the exact contact set.
    pub fault: Option<String>,
}

/// Compares the errors of a wrong answer with its proven bounds; `None` if nothing is proven about the answer.
pub fn judge(target: &Target, attack: &Attack, exact: &Exact) -> Option<Judged> {
    let proof = prove(&target.given, &attack.answer).ok()?;
    let mut ratios = fields(target, attack, exact, &proof);
    ratios.extend(reactions(target, attack, exact, &proof));
    let mut fault = None;
    if let Ok(contact) = &proof.contact {
        let length = target.solution.model().beam.length;
        fault = wrong_contact(contact, exact, length);
        ratios.extend(forces(contact, exact, length));
    }
    Some(Judged { proven: proof.shortfall().is_none(), ratios, fault })
}

/// Returns the ratios of error to bound of all fields, at the stations where no field jumps.
fn fields(
    target: &Target,
    attack: &Attack,
    exact: &Exact,
    proof: &Proof,
) -> Vec<(&'static str, f64)> {
    let sides = exact.stations["side"].as_array().expect("a list of sides");
    let mut ratios = Vec::new();
    for (i, x) in exact.numbers("x").into_iter().enumerate().filter(|(i, _)| sides[*i] == "") {
        let Some(piece) = attack.answer.pieces.iter().find(|piece| x <= piece.x[1]) else {
            continue;
        };
        for (field, value, bound) in target.fields(piece, x, proof) {
            let name = field.name();
            let error = (value - exact.numbers(name)[i]).abs() - ROUNDING * exact.largest[name];
            ratios.push((name, error.max(0.0) / bound));
        }
    }
    ratios
}

fn reactions(
    target: &Target,
    attack: &Attack,
    exact: &Exact,
    proof: &Proof,
) -> Vec<(&'static str, f64)> {
    let mut ratios = Vec::new();
    for (i, (support, bound)) in
        target.solution.model().supports.iter().zip(&proof.reactions).enumerate()
    {
        let claimed = attack.answer.reactions.iter().find(|claimed| claimed.support == i);
        let [force, moment] = claimed.map_or([0.0; 2], |r| [r.force, r.moment]);
        let truth = exact.reactions.iter().find(|truth| truth.at == support.at);
        let truth = truth.expect("a reaction of every support");
        let off = |a: f64, b: f64| ((a - b).abs() - f64::EPSILON * b.abs()).max(0.0);
        ratios.push(("reaction", off(force, truth.force) / bound.force.error));
        ratios.push(("moment of a support", off(moment, -truth.moment) / bound.moment.error));
    }
    ratios
}

/// Returns the distances of the exact concentrated forces from the midpoints of their proven intervals, relative to
/// half the lengths of the intervals.
fn forces(contact: &ContactSet, exact: &Exact, length: f64) -> Vec<(&'static str, f64)> {
    let mut truth = vec![(0.0, exact.end_forces["left"]), (length, exact.end_forces["right"])];
    truth.extend(exact.inner_forces.iter().map(|force| (force.x, force.force)));
    let ratio = |(x, force): (f64, f64)| {
        let near = contact.forces.iter().find(|found| (found.x - x).abs() <= 1e-14 * length);
        let [low, high] = near.map_or([0.0; 2], |found| found.force);
        let off = ((force - 0.5 * (low + high)).abs() - 4.0 * f64::EPSILON * force.abs()).max(0.0);
        ("concentrated force", if off == 0.0 { 0.0 } else { off / (0.5 * (high - low)) })
    };
    truth.into_iter().map(ratio).collect()
}

/// Describes the difference between a contact set and the exact contact set; `None` if they agree.
fn wrong_contact(contact: &ContactSet, exact: &Exact, length: f64) -> Option<String> {
    let mut shown: Vec<[[f64; 2]; 2]> = Vec::new();
    for region in &contact.regions {
        match shown.last_mut() {
            // The proof splits a contact region where a shear layer ends. The adjacent parts are joined again here.
            Some(last) if last[1] == region.from => last[1] = region.to,
            _ => shown.push([region.from, region.to]),
        }
    }
    let near = 4.0 * f64::EPSILON * length;
    let holds = |[low, high]: [f64; 2], x: f64| low - near <= x && x <= high + near;
    let same = shown.len() == exact.contact.len()
        && shown.iter().zip(&exact.contact).all(|(a, b)| holds(a[0], b[0]) && holds(a[1], b[1]));
    (!same).then(|| format!("contact regions {shown:?}, but {:?} is correct", exact.contact))
}
