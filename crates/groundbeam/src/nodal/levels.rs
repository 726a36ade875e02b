//! The grids on which contact is looked for, one after the other.

use super::grid::{Grid, Ground};
use crate::model::Model;

/// Elements per 1/wave number on the coarsest grid that shows every wave of the beam.
const COARSEST: f64 = 1.5;
/// By how much a grid of a beam that is too soft for it is coarser than the next, and the fewest elements it has.
const STEP: f64 = 4.0;
const FEWEST: f64 = 20.0;

/// Grids from one on which every wave of the beam is a few elements long to the wanted one; each finer
/// one is as much finer as Newton's method, which squares errors, can make good in a step or two. Where the
/// wanted one itself is too coarse for the beam, those before it are of stiffer beams.
pub(super) fn grids(model: &Model, elements: usize, ground: Ground, grids: &mut Vec<Grid>) {
    grids.clear();
    let fine = Grid::new(model, elements, ground);
    let waves = model.beam.length * fine.wave_number();
    let coarsest = (waves * COARSEST).ceil().max(8.0);
    let mut wanted = elements as f64;
    let mut coarser = Vec::new();
    loop {
        // h → √(h/wave).
        let next = (wanted * waves).sqrt();
        if next >= 0.7 * wanted || next < coarsest {
            break;
        }
        coarser.push(next);
        wanted = next;
    }
    if wanted > 2.0 * coarsest {
        coarser.push(coarsest);
    }
    if coarser.is_empty() {
        while wanted >= STEP * FEWEST {
            wanted /= STEP;
            coarser.push(wanted);
        }
    }
    grids.extend(coarser.iter().rev().map(|elements| fine.coarser(*elements as usize)));
    grids.push(fine);
}
