//! Writes an answer and its certificate as text, with one line for each quantity and all bits of each number.

use crate::proven::proven_bounds;
use groundbeam::{Error, Existence, Field, Outcome, Solution, Verdict, solution::Side};
use std::fmt::Write;

/// Number of equal steps along the beam. The fields are evaluated at the ends of the steps.
pub const STEPS: usize = 40;
/// Number of steps along the beam between consecutive positions whose values are written, if `in_full` is false.
const COARSE: usize = 10;

/// Returns the lines of an answer. They contain the fields at all positions if `in_full` is true, otherwise at five
/// positions. A digest covers the values at all positions.
pub fn text(outcome: &Result<Outcome, Error>, in_full: bool) -> String {
    match outcome {
        Ok(Outcome::Equilibrium(solution)) => {
            "outcome equilibrium\n".to_owned() + &of_solution(solution, in_full)
        }
        Ok(Outcome::NoEquilibrium(existence)) => {
            "outcome no-equilibrium\n".to_owned() + &verdict(existence)
        }
        Err(Error::Invalid(_)) => "outcome invalid\n".to_owned(),
        Err(Error::NotConverged(_)) => "outcome not-converged\n".to_owned(),
        Err(_) => "outcome unsupported\n".to_owned(),
    }
}

fn of_solution(solution: &Solution, in_full: bool) -> String {
    let contact = solution.contact().iter().flat_map(|zone| [zone.from, zone.to]);
    verdict(solution.existence())
        + &line("contact", &contact.collect::<Vec<_>>())
        + &forces(solution)
        + &of_fields(solution, in_full)
}

/// Returns lines of text that list the contact forces, the reactions and the hinges.
pub fn forces(solution: &Solution) -> String {
    let ends = solution.end_forces();
    let forces = solution.concentrated_forces().iter().flat_map(|force| [force.at, force.force]);
    let reactions = solution.reactions().iter().flat_map(|r| [r.at, r.force, r.moment]);
    let hinges = solution.hinges();
    let turns = hinges.iter().flat_map(|hinge| [hinge.at, hinge.rotation, hinge.moment]);
    line("end_forces", &[ends.left, ends.right])
        + &line("concentrated_forces", &forces.collect::<Vec<_>>())
        + &line("reactions", &reactions.collect::<Vec<_>>())
        + &line("hinges", &turns.collect::<Vec<_>>())
}

fn of_fields(solution: &Solution, in_full: bool) -> String {
    let mut text = String::new();
    let mut add = |key: &str, values: &[f64]| text += &line(key, values);
    // The stored reference answers list the rotation after all other fields.
    let (last, first): (Vec<_>, Vec<_>) =
        Field::of(&solution.model().beam).partition(|field| *field == Field::Rotation);
    let listed = first.into_iter().chain(last);
    for field in listed.clone() {
        let range = solution.range(field);
        let values = [range.min.x, range.min.value, range.max.x, range.max.value];
        add(&format!("extremes_{}", field.name()), &values);
    }
    let l = solution.model().beam.length;
    let at = |i: usize| solution.at(l * (i as f64 / STEPS as f64), Side::Right);
    let fields: Vec<_> = (0..=STEPS).map(at).collect();
    let mut digest = Digest::default();
    for field in listed {
        let values: Vec<f64> = fields.iter().map(|at| at.get(field)).collect();
        digest.add(&values);
        let step = if in_full { 1 } else { COARSE };
        let some: Vec<f64> = values.iter().copied().step_by(step).collect();
        add(&format!("fields_{}", field.name()), &some);
    }
    text + &format!("fields_digest {:016x}\n", digest.0)
}

/// Returns lines of text that state the verdict on the existence of an equilibrium, and the static reactions.
pub fn verdict(existence: &Existence) -> String {
    let verdict = match existence.verdict {
        Verdict::Unique => line("verdict unique", &[]),
        Verdict::NotUnique(motion) | Verdict::None(motion) => {
            let word = match existence.verdict {
                Verdict::None(_) => "verdict none",
                _ => "verdict not-unique",
            };
            let lifted = motion.lifted.into_iter().flatten();
            let values = [motion.left, motion.right, motion.work].into_iter().chain(lifted);
            line(word, &values.collect::<Vec<_>>())
        }
        Verdict::Local(local) => {
            line("verdict local", &[local.stability_margin, local.critical_compression])
        }
        Verdict::Buckles(mode) => line(
            "verdict buckles",
            &[mode.critical_compression, mode.at, mode.left, mode.right, mode.work],
        ),
    };
    verdict + &line("static_reactions", &existence.static_reactions)
}

/// Returns the lines of a certificate.
pub fn certificate(solution: &Solution) -> String {
    let proof = solution.certificate();
    let energies = [proof.primal_energy(), proof.dual_energy(), proof.gap(), proof.relative_gap()];
    let [settlement, moment, _] = proven_bounds(solution);
    line("energies", &energies) + &line("bounds", &[settlement, moment])
}

/// Returns a line with a key and numbers. Each number is the shortest decimal that reads back to the same bits.
fn line(key: &str, values: &[f64]) -> String {
    let mut line = key.to_owned();
    for value in values {
        write!(line, " {value:?}").expect("text");
    }
    line + "\n"
}

/// The FNV-1a hash of the bits of numbers.
struct Digest(u64);

impl Default for Digest {
    fn default() -> Self {
        Digest(0xcbf2_9ce4_8422_2325)
    }
}

impl Digest {
    fn add(&mut self, values: &[f64]) {
        for byte in values.iter().flat_map(|value| value.to_bits().to_le_bytes()) {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3);
        }
    }
}
