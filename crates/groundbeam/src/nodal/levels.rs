//! Sequence of grids, from coarse to fine, on which the contact zones are found.

use super::grid::{Grid, Ground};
use crate::model::Model;

/// Elements per 1/(wave number) on the coarsest grid that resolves every wave of the beam.
const COARSEST: f64 = 1.5;
/// Grids for a required grid that barely resolves the waves of the beam, or does not resolve them: ratio
/// between the element counts of successive grids, and minimum number of elements of a grid.
const STEP: f64 = 4.0;
const FEWEST: f64 = 20.0;
/// The grid before the required one may be refined to locate the contact edges to a fraction of a node. Upper limits of
/// its element count: relative to that of the required grid, and relative to the count for √(h/wave).
const SHARE: f64 = 0.3;
const SHARPEST: f64 = 6.0;
/// Minimum factor on the element count for which this refinement is worth its solves.
const SHARP: f64 = 4.0;
/// Maximum ratio of the element count of the next grid to that of a rough grid.
const FEW: f64 = 3.5;

/// Writes the grids from the coarsest, on which a few elements resolve every wave of the beam, to the
/// required one. Newton's method converges quadratically. The refinement is chosen so that it needs one or
/// two steps per grid. Where the required grid itself is too coarse for the beam, EI is raised on the grids
/// before it.
pub(crate) fn grids(model: &Model, elements: usize, ground: Ground, grids: &mut Vec<Grid>) {
    grids.clear();
    let fine = Grid::new(model, elements, ground);
    let waves = model.beam.length * fine.wave_number();
    let coarser = coarser(elements as f64, waves);
    let coarse = |elements: &f64| Grid::stiffened(model, *elements as usize, ground);
    grids.extend(coarser.iter().rev().map(coarse));
    grids.push(fine);
    for i in 1..grids.len() {
        grids[i - 1].rough = is_rough(&grids[i - 1], &grids[i], waves);
    }
}

/// Element counts of the grids before the required one, from fine to coarse.
fn coarser(wanted: f64, waves: f64) -> Vec<f64> {
    let coarsest = (waves * COARSEST).ceil().max(8.0);
    let mut coarser = Vec::new();
    let mut last = wanted;
    loop {
        // h → √(h/wave): on the finer grid the contact edges are then off by one or two nodes. If the coarser
        // grid has a few times more elements, the edges are at the right nodes, and one solve is sufficient.
        let mut next = (last * waves).sqrt();
        let sharper = (SHARE * last / next).min(SHARPEST);
        if coarser.is_empty() && sharper > SHARP {
            next *= sharper;
        }
        if next >= 0.7 * last || next < coarsest {
            break;
        }
        coarser.push(next);
        last = next;
    }
    if last > 2.0 * coarsest {
        coarser.push(coarsest);
    }
    if coarser.is_empty() {
        while last >= STEP * FEWEST {
            last /= STEP;
            coarser.push(last);
        }
    }
    coarser
}

/// Whether a grid resolves all waves and the next one is only a few times finer.
fn is_rough(grid: &Grid, next: &Grid, waves: f64) -> bool {
    let [elements, finer] = [grid, next].map(|grid| grid.last() as f64);
    elements >= waves * COARSEST && finer < FEW * elements
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn element_counts_decrease_to_a_few_elements_per_wave() {
        for (elements, waves) in [(1e6, 100.0), (1e4, 100.0), (100.0, 3.0), (100.0, 1e4)] {
            let coarser = coarser(elements, waves);
            let steps = [elements].into_iter().chain(coarser.iter().copied()).zip(&coarser);
            for (finer, elements) in steps {
                assert!(*elements <= 0.7 * finer, "{elements} {finer}");
            }
            let coarsest = coarser.last().copied().unwrap_or(elements);
            let few = 2.0 * COARSEST * waves;
            assert!(coarsest <= few.max(STEP * FEWEST), "{coarsest} of {waves}");
        }
    }
}
