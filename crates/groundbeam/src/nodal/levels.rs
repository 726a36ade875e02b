//! The grids on which contact is looked for, one after the other.

use super::grid::{Grid, Ground};
use crate::model::Model;

/// Grids from one on which every wave of the beam is a few elements long to the wanted one; each finer
/// one is as much finer as Newton's method, which squares errors, can make good in a step or two.
pub(super) fn grids(model: &Model, elements: usize, ground: Ground, grids: &mut Vec<Grid>) {
    grids.clear();
    let fine = Grid::new(model, elements, ground);
    let l = model.beam.length;
    let wave = fine.wave_number();
    let coarsest = (l * wave * COARSEST).ceil().max(8.0);
    let mut wanted = elements as f64;
    grids.push(fine);
    loop {
        // h → √(h/wave).
        let next = (wanted * l * wave).sqrt() * FINER;
        if next >= 0.7 * wanted || next < coarsest {
            if wanted > 2.0 * coarsest {
                grids.push(Grid::new(model, coarsest as usize, ground));
            }
            break;
        }
        wanted = next;
        grids.push(Grid::new(model, wanted as usize, ground));
    }
    grids.reverse();
}

/// Elements per 1/wave number on the coarsest grid.
const COARSEST: f64 = 1.5;
/// How much finer than √(h/wave) each grid is.
const FINER: f64 = 1.0;
