//! Sequence of grids, from coarse to fine, on which the contact zones are found.

use super::grid::{Grid, Ground};
use crate::model::Model;

/// Number of elements per length 1/λ on the coarsest grid, with the largest wave number λ of the beam.
const COARSEST: f64 = 1.5;
/// Ratio of the element counts of successive grids. It applies if the finest grid barely resolves the waves of the
/// deflection, or does not resolve them.
const STEP: f64 = 4.0;
/// Minimum number of elements of a coarse grid whose element count follows from the ratio `STEP`.
const FEWEST: f64 = 20.0;
/// Maximum element count of the finest coarse grid, relative to the element count of the required grid.
const SHARE: f64 = 0.3;
/// Maximum factor by which a refinement increases the element count of the finest coarse grid.
const SHARPEST: f64 = 6.0;
/// The finest coarse grid is refined only if its element count grows by more than this factor. A smaller refinement
/// would cost more solves than it saves.
const SHARP: f64 = 4.0;
/// Maximum ratio of the element counts of two successive grids for which the coarser grid counts as `rough`.
const FEW: f64 = 3.5;

/// Writes the grids, from coarse grids with stiffened beams to the required grid. See sections 5 and 10 of
/// docs/methods.md.
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

/// Element counts of the grids coarser than the required grid, from the finest to the coarsest.
fn coarser(wanted: f64, waves: f64) -> Vec<f64> {
    let coarsest = (waves * COARSEST).ceil().max(8.0);
    let mut coarser = Vec::new();
    let mut last = wanted;
    loop {
        // The next coarser grid has the element length √(h/λ), with the present element length h and the wave number λ.
        // Its contact edges are then accurate to one or two nodes of the present grid.
        let mut next = (last * waves).sqrt();
        // A finer coarse grid gives the contact edges at the correct nodes of the required grid.
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

/// Whether the iteration on a grid may stop while one node per contact zone still changes. `waves` is the beam length
/// times the largest wave number of the beam.
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
