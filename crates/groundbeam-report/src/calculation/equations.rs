//! The equations of beam, ground and contact for the report, with their domains and equation numbers.

use super::content::{Block, Equation};
use super::formulas::{self, Formula};

/// Equations of beam, ground and contact, numbered as in Kikuchi's paper. If `shears` is true, the beam
/// equations are those of a Timoshenko beam.
pub(super) fn problem(shears: bool) -> Block {
    let (beam, number, ends) = match shears {
        true => (formulas::SHEARING_BEAM, "", formulas::SHEARING_ENDS),
        false => (formulas::BEAM, "(2.11)", formulas::ENDS),
    };
    Block::Equations {
        lines: vec![
            line(beam, "beam, 0 < x < l", number),
            line(formulas::GROUND, "ground, all x", "(2.2)"),
            line(formulas::CONTACT, "contact, 0 < x < l", "(2.10)"),
            line(ends, "free ends x = 0 and x = l", "(2.13)"),
        ],
    }
}

/// Equation for the static reactions of a free beam.
pub(super) fn static_reactions() -> Block {
    Block::Equations { lines: vec![line(formulas::REACTIONS, "", "(4.25)")] }
}

/// The inequality between the error energy of a solution and the difference of its potential and dual energies.
pub(super) fn energy_gap() -> Block {
    Block::Equations { lines: vec![line(formulas::ENERGY_GAP, "energy gap", "")] }
}

fn line(formula: Formula, words: &'static str, number: &'static str) -> Equation {
    Equation { formula, words, number }
}
